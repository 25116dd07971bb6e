/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "packedBodies.H"
#include "quadRecords.H"

using Foam::dem::quadRecords::record;
using Foam::dem::quadRecords::vectorOf;

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::packedBodies::unpackAsleep(bodies& state) const
{
    for (label b = 0; b < nBodies_; ++b)
    {
        if (!asleep_.has(b))
        {
            continue;
        }
        const label p = place_[b];
        vector F, T;
        if (p >= 0)
        {
            collect(now_, p, clumps_[p], F, T);
        }
        else
        {
            const label s = -1 - p;
            F = vectorOf(now_.f(s));
            T = radius(s)*vectorOf(now_.t(s));
        }
        state.force[b] = F + state.mass[b]*g_;
        state.torque[b] = T;
        state.v[b] = Zero;
        state.setL(b, Zero);
        if (!given_.given.empty())
        {
            state.dragGiven[b] = given_.given[b];
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::packedBodies::setAsleep(const UList<bool>& asleep)
{
    // Who was pushed by one awake has the impulse of the same steps as this
    // one; others start from rest now
    for (label b = 0; b < nBodies_ && asleep_.any(); ++b)
    {
        const bool wakes = asleep_.has(b) && !(asleep.size() && asleep[b]);
        const label first = state_->firstSphere[b];
        const label last = state_->firstSphere[b + 1];
        if (wakes && !asleep_.pushed(now_, first, last))
        {
            const vector v = -pending_*undragged(b);
            if (place_[b] >= 0)
            {
                clumps_[place_[b]].v = v;
            }
            for (label s = first; s < last; ++s)
            {
                now_.v(s) = record(v, now_.v(s).w);
            }
        }
    }

    asleep_.set(asleep, state_->sphereBody, held_);
    for (const int s : asleep_.spheres())
    {
        now_.v(s) = record(Zero, now_.v(s).w);
        now_.w[s] = record(Zero, now_.w[s].w);
    }

    ownClump_.clear();
    for (std::size_t k = 0; k < clumps_.size(); ++k)
    {
        clump& c = clumps_[k];
        if (asleep_.has(c.body))
        {
            c.v = c.L = c.omega = Zero;
        }
        else if (!c.copied)
        {
            ownClump_.push_back(int(k));
        }
    }

    allSingle_ =
        !asleep_.any() && nSpheres_ == nBodies_ && state_->isCopy.empty();
    single_.clear();
    singleBody_.clear();
    for (label b = 0; b < nBodies_ && !allSingle_; ++b)
    {
        if (place_[b] < 0 && owns(b) && !asleep_.has(b))
        {
            single_.push_back(-1 - place_[b]);
            singleBody_.push_back(b);
        }
    }
}


Foam::scalar Foam::dem::packedBodies::unrest(const label b) const
{
    const label p = place_[b];
    scalar turning;
    if (p >= 0)
    {
        const clump& c = clumps_[p];
        vector F, T;
        collect(now_, p, c, F, T);
        turning = mag(T)/(c.mass*c.radius);
    }
    else
    {
        turning = now_.x(-1 - p).w*mag(vectorOf(now_.t(-1 - p)));
    }
    return mag(acceleration(b)) + turning;
}


// ************************************************************************* //
