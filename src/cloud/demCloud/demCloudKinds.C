/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "demCloud.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::demCloud::checkKinds() const
{
    const bool both = dict_.found("forces") && dict_.found("immersed");
    if (dict_.found("resolved"))
    {
        if (coupling_ != "twoWay" || !both)
        {
            dem::badEntry
            (
                dict_,
                "resolved",
                "says which bodies are points to the fluid and which fill its"
                " cells, in a run with both: coupling twoWay, forces and"
                " immersed; take it out, or add what is missing"
            );
        }
        if (effects_.automatic && !chosen_.found("resolved"))
        {
            dem::badEntry
            (
                dict_,
                "effects",
                "auto says itself which bodies are resolved; take resolved"
                " out, or name the effects"
            );
        }
    }
    else if (actsOnFluid() && both)
    {
        dem::badEntry
        (
            dict_,
            "forces",
            "does not go with coupling " + coupling_ + " and immersed: bodies"
            " are either points to the fluid (forces, voidFraction) or fill its"
            " cells (immersed).\n"
            "    Take one of them out, or say which bodies are which:"
            " resolved { shapes { ... } }"
        );
    }
}


void Foam::demCloud::readKinds()
{
    if (!dict_.found("resolved"))
    {
        kinds_.setAll(immersedBodies());
        return;
    }
    wordList names;
    for (const dem::shape& s : dem_->shapes())
    {
        names.append(s.name());
    }
    kinds_.read(dict_.subDict("resolved"), names);
}


void Foam::demCloud::findKinds()
{
    const labelList changed
    (
        kinds_.update(mesh_, cells_, dem_->state())
    );
    kindsChanged_ = kindsChanged_ || changed.size();
    for (const label b : changed)
    {
        // Points get theirs when the fluid is sampled
        if (kinds_.resolved(b))
        {
            startForce(b);
        }
        Info<< "    Body " << dem_->state().id[b] << " is "
            << (kinds_.resolved(b) ? "resolved" : "a point to the fluid")
            << " from now on" << endl;
    }
}


void Foam::demCloud::startForce(const label b)
{
    dem::bodies& state = dem_->state();
    state.fluidForce[b] = immersed_->startForce(b, coupling_ == "twoWay");
    state.fluidTorque[b] = Zero;
}


void Foam::demCloud::startForces(const label firstNew)
{
    // Buoyancy and, for the first step, the inertia of the fluid around
    for (label b = firstNew; b < dem_->state().size(); ++b)
    {
        if (kinds_.resolved(b))
        {
            startForce(b);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::demCloud::addImmersed(fvMatrix<vector>& eqn)
{
    if (immersed_.valid())
    {
        ledger::entry e(ledger_, "forcing of the fluid");
        immersed_->addTo(eqn);
    }
}


void Foam::demCloud::correctImmersed(vectorField& H)
{
    if (immersed_.valid() && immersed_->asksSolver())
    {
        ledger::entry e(ledger_, "forcing of the fluid");
        immersed_->correctForcing(H);
    }
}


Foam::label Foam::demCloud::imposes() const
{
    return immersed_.valid() ? immersed_->imposes() : 0;
}


void Foam::demCloud::impose(volVectorField& U)
{
    ledger::entry e(ledger_, "forcing of the fluid");
    immersed_->impose(U);
}


bool Foam::demCloud::exchanges() const
{
    return exchanged_.valid();
}


bool Foam::demCloud::fillsCells() const
{
    return immersed_.valid();
}


// ************************************************************************* //
