/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "pointForces.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::coupling::pointForces::findNeeds()
{
    unsigned needs = alsoSampled_;
    followsBody_ = drag_.valid();
    for (const pointForce& f : forces_)
    {
        needs |= f.needs();
        followsBody_ = followsBody_ || f.addsMass();
    }
    sampler_->setNeeds(needs);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::coupling::pointForces::watch(const unsigned fields)
{
    watched_ = true;
    alsoSampled_ = fields;
    findNeeds();
}


void Foam::coupling::pointForces::setForce
(
    const word& name,
    const dictionary& forces
)
{
    PtrList<pointForce> all;
    autoPtr<pointForce> changed(pointForce::New(name, dem_.g(), forces));

    // The wake of a body changes what the others see and stays the first; the
    // rest are sorted, as in a restart
    for (label i = 0; i < forces_.size(); ++i)
    {
        const word& type = forces_[i].type();
        if (changed.valid() && type > name && type != "undisturbedVelocity")
        {
            all.append(changed);
        }
        if (type != name)
        {
            all.append(forces_.set(i, nullptr));
        }
    }
    if (changed.valid())
    {
        all.append(changed);
    }
    forces_.transfer(all);
    findNeeds();
}


void Foam::coupling::pointForces::setDrag(const dictionary& forces)
{
    drag_ = dragLaw::New(forces);
    outside_.clear();
    saidRange_ = false;
    findNeeds();
}


// ************************************************************************* //
