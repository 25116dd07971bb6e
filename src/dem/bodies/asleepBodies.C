/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "asleepBodies.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::asleepBodies::set
(
    const UList<bool>& body,
    const heldPlaces& sphereBody,
    const std::vector<quadPair>& fluid
)
{
    body_ = body;
    fluid_ = &fluid;
    spheres_.clear();
    border_.clear();
    place_.assign(any() ? sphereBody.size() : 0, -1);
    forAll(sphereBody, s)
    {
        if (has(sphereBody[s]))
        {
            place_[s] = int(spheres_.size());
            spheres_.push_back(s);
        }
    }
    held_.assign(spheres_.size(), quadPair{{0, 0, 0, 0}, {0, 0, 0, 0}});
    due_ = any();
    stale_ = true;
}


void Foam::dem::asleepBodies::clear(packedRecords& r) const
{
    for (const int s : spheres_)
    {
        r.ft[s] =
            fluid_->empty()
          ? quadPair{{0, 0, 0, 0}, {0, 0, 0, 0}}
          : (*fluid_)[s];
    }
}


void Foam::dem::asleepBodies::hold(const packedRecords& r)
{
    for (std::size_t k = 0; k < spheres_.size(); ++k)
    {
        held_[k] = r.ft[spheres_[k]];
    }
    due_ = false;
    fresh_ = true;
    stale_ = true;
}


bool Foam::dem::asleepBodies::pushed
(
    const packedRecords& r,
    const label first,
    const label last
) const
{
    bool any = false;
    for (label s = first; s < last; ++s)
    {
        const quad& now = r.f(s);
        const quad& held = held_[place_[s]].first;
        any =
            any || now.x != held.x || now.y != held.y || now.z != held.z;
    }
    return any;
}


void Foam::dem::asleepBodies::reset(packedRecords& r) const
{
    for (std::size_t k = 0; k < spheres_.size(); ++k)
    {
        r.ft[spheres_[k]] = held_[k];
    }
}


void Foam::dem::asleepBodies::meet
(
    const std::vector<label>& border,
    packedRecords& r
)
{
    // Who has left the border has been added to in the last step
    const bool same = border == border_;
    if (!same)
    {
        for (const label s : border_)
        {
            r.ft[s] = held_[place_[s]];
        }
        border_ = border;
        stale_ = true;
    }
    for (const label s : border_)
    {
        r.ft[s] = held_[place_[s]];
    }
}


// ************************************************************************* //
