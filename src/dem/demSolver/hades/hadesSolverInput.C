/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "hadesSolver.H"
#include "allowedKeys.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::hadesSolver::readGenerators()
{
    if (!input_.dict.found("generators"))
    {
        return;
    }

    const dictionary& dict = input_.dict.subDict("generators");
    for (const word& name : dict.toc())
    {
        generators_.append
        (
            generator::New(name, dict.subDict(name), shapes_, materials_).ptr()
        );
    }
}


void Foam::dem::hadesSolver::checkOverlaps()
{
    if (!state_.size())
    {
        return;
    }

    packed_.pack(state_, g());
    computeForces(0, 0, true);
    report_.overlap = summary_.overlap;

    if (summary_.overlap > 1e-3)
    {
        FatalIOErrorInFunction(input_.dict.subDict("bodies"))
            << nameOf(summary_.overlapA).c_str() << " and "
            << nameOf(summary_.overlapB).c_str() << " overlap at the start, by "
            << 100*summary_.overlap << " % of the smaller radius." << nl
            << "    Bodies may start with 0.1 % at most: move them apart."
            << exit(FatalIOError);
    }
}


bool Foam::dem::hadesSolver::hasRoom(const newBody& body) const
{
    bodies trial(shapes_);
    trial.append(body);

    // No sphere of the body may touch one that is there, or an image of it
    const auto touches = [this](const point& x, const scalar r)
    {
        forAll(state_.sphereX, j)
        {
            if (magSqr(x - state_.sphereX[j]) < sqr(r + state_.sphereR[j]))
            {
                return true;
            }
        }
        return false;
    };

    const periodicity& period = input_.period;
    forAll(trial.sphereX, i)
    {
        const point& x = trial.sphereX[i];
        const scalar r = trial.sphereR[i];
        bool full = touches(x, r);
        period.forEachImage
        (
            x,
            GREAT,
            [&](const label image)
            {
                full = full || touches(x + period.shift(image), r);
            }
        );

        DynamicList<label> elements;
        walls_.touching(x, r, elements);
        if (full || elements.size())
        {
            return false;
        }
    }
    return true;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::List<Foam::dem::generatorPlan> Foam::dem::hadesSolver::plans() const
{
    List<generatorPlan> all(generators_.size());
    forAll(generators_, i)
    {
        all[i] = generators_[i].plan();
    }
    return all;
}


bool Foam::dem::hadesSolver::hasRoomFor(const label i) const
{
    newBody body;
    return generators_[i].make
    (
        generators_[i].nEntered(),
        [this](const newBody& n) { return hasRoom(n); },
        body
    );
}


// ************************************************************************* //
