/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "hadesSolver.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::hadesSolver::readSleeping()
{
    const dictionary& dict = input_.dict;
    if (!dict.found("sleeping"))
    {
        return;
    }
    const contactLaws& laws = materials_.laws();
    string why;
    if (!integrator_->leaps())
    {
        why =
            "is for the integrator stormerVerlet: others go through stages in"
            " which bodies asleep would have to take part";
    }
    else if
    (
        laws.coheres("capillary")
     || laws.coheres("vanDerWaals")
     || laws.coheres("electrostatic")
     || laws.film.acts()
    )
    {
        why =
            "is not for forces between bodies that do not touch, which change"
            " without a contact that could wake anybody: cohesion capillary,"
            " vanDerWaals and electrostatic, and lubrication";
    }
    else if (walls_.walls().empty())
    {
        why = "needs walls: without them there is nothing to rest on";
    }
    if (why.size())
    {
        badEntry(dict, "sleeping", why);
    }
    sleepers_.reset(new sleepers(dict.subDict("sleeping"), mag(g())));
}


void Foam::dem::hadesSolver::layDown()
{
    const boolList asleep(sleepers_->asleep());
    boolList spheres(asleep.size() ? packed_.nSpheres() : 0);
    forAll(spheres, s)
    {
        spheres[s] = asleep[packed_.bodyOf(s)];
    }
    packed_.setAsleep(asleep);
    list_.asleep().set(spheres);
    walls_.setAsleep(spheres);
}


void Foam::dem::hadesSolver::beginSleep()
{
    sleepers_->setSize(state_.size());
    sleepers_->wakeMoving(state_);
    if (sleepers_->nAsleep() || list_.asleep().any())
    {
        layDown();
    }
}


void Foam::dem::hadesSolver::countWoken()
{
    // The next step must resolve their contacts, too
    if (summary_.asleepFrequency10 > summary_.frequency10)
    {
        summary_.frequency10 = summary_.asleepFrequency10;
        summary_.duration = 1/pow(summary_.frequency10, 0.1);
        summary_.stiffA = summary_.stiffB = -1;
    }
    layDown();
}


bool Foam::dem::hadesSolver::wakeForWalls(const scalar dt)
{
    if (sleepers_->nAsleep() && walls_.untilChanges() <= dt)
    {
        sleepers_->wakeAll();
        countWoken();
        return true;
    }
    return false;
}


void Foam::dem::hadesSolver::sleep(const scalar t, const scalar dt)
{
    const bool all = packed_.asleep().takeFresh();
    if (sleepers_->nAsleep() && sleepers_->wake(packed_, list_, walls_, all))
    {
        countWoken();
    }
    if
    (
        dt > 0
     && sleepers_->looks(t, dt)
     && sleepers_->look(packed_, list_, walls_)
    )
    {
        layDown();
    }
}


// ************************************************************************* //
