/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "wallSet.H"

#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

inline bool Foam::dem::wallSet::touches
(
    const neighbour& n,
    const point& x,
    const scalar r,
    const scalar reach,
    wallTouch& t
) const
{
    const wall& w = walls_[n.wallI];
    const bool isImage = n.image != periodicity::original;
    const scalar d = w.nearest
    (
        isImage ? x + period_.shift(n.image) : x,
        n.element,
        t.p,
        t.n
    );
    if (d >= r + reach)
    {
        return false;
    }

    t.sphere = n.sphere;
    t.wallI = n.wallI;
    t.overlap = r - d;
    t.xi = Zero;
    t.likeness = 0;
    t.u = Zero;
    t.spin = 0;
    if (w.moving())
    {
        t.u = w.velocity(n.element, t.p);
        t.spin = w.spin(n.element, t.n);
    }
    if (isImage)
    {
        t.p -= period_.shift(n.image);
    }
    return true;
}


inline Foam::label Foam::dem::wallSet::select
(
    UList<wallTouch>& trial,
    const label first,
    const label last,
    const scalar radius
) const
{
    if (last < first + 2)
    {
        return last;
    }
    std::sort
    (
        trial.begin() + first,
        trial.begin() + last,
        [](const wallTouch& a, const wallTouch& b)
        {
            return a.overlap > b.overlap;
        }
    );

    label end = first;
    for (label t = first; t < last; ++t)
    {
        bool standsOut = true;
        for (label k = first; k < end && standsOut; ++k)
        {
            // The tolerance is above the round-off of coordinates in a
            // surface file, and far below what a corner stands out
            standsOut =
                ((trial[t].p - trial[k].p) & trial[k].n) > 1e-4*radius;
        }
        if (standsOut)
        {
            trial[end++] = trial[t];
        }
    }
    if (end > first + 1)
    {
        planes_.order(trial, first, end);
    }
    return end;
}


void Foam::dem::wallSet::find
(
    const packedBodies& state,
    const UList<neighbour>& near,
    const bool reaching,
    touchList& list
) const
{
    // Contacts are made where they stay, and the room for them is there
    list.trial.setSize(near.size());

    label end = 0;
    label old = 0;
    for (label k = 0; k < near.size();)
    {
        const label sphere = near[k].sphere;
        const point x = state.centre(sphere);
        const scalar r = state.radius(sphere);
        const scalar reach = reaching ? reachOf(r) : 0;

        const label begin = end;
        for (; k < near.size() && near[k].sphere == sphere; ++k)
        {
            if (touches(near[k], x, r, reach, list.trial[end]))
            {
                ++end;
            }
        }
        end = select(list.trial, begin, end, r);
        if (list.rolls)
        {
            list.trialRolled.setSize(begin);
            list.trialRolled.setSize(end, wallRolled());
        }

        // Both lists are sorted by sphere
        const UList<wallTouch>& before = list.accepted;
        while (old < before.size() && before[old].sphere < sphere)
        {
            ++old;
        }
        for (; old < before.size() && before[old].sphere == sphere; ++old)
        {
            // What was within reach only has nothing to leave
            if (!reaching || before[old].likeness > 0)
            {
                list.bequeath(old, begin, end);
            }
        }
    }
    list.trial.setSize(end);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::wallSet::findTouches(const packedBodies& state)
{
    const UList<neighbour>& near = narrowed_ ? near_ : all_;
    find(state, near, false, contacts_);
    planes_.find(state);
    if (reaches())
    {
        find(state, near, true, reached_);
    }
}


void Foam::dem::wallSet::renew()
{
    renewed_ = true;
    speed_ = 0;
    timed_ = false;
    for (const wall& w : walls_)
    {
        speed_ = max(speed_, w.speed());
        timed_ = timed_ || w.timed();
    }
}


void Foam::dem::wallSet::beginAdvance(const scalar t0, const scalar t1)
{
    if (!timed_)
    {
        return;
    }
    const scalar old = speed_;
    speed_ = 0;
    for (wall& w : walls_)
    {
        w.beginAdvance(t0, t1);
        speed_ = max(speed_, w.speed());
    }
    renewed_ = renewed_ || speed_ != old;
}


void Foam::dem::wallSet::moveTo(const scalar t)
{
    if (timed_)
    {
        forAll(walls_, i)
        {
            wall& w = walls_[i];
            const bool there = w.present();
            w.moveTo(t);
            if (w.present() == there)
            {
                continue;
            }

            renewed_ = true;
            if (placed_ && w.present() && t > t_)
            {
                appeared_.insert(i);
            }
            else
            {
                appeared_.erase(i);
            }
        }
    }
    t_ = t;
    placed_ = true;
}


const Foam::dem::wallTouch* Foam::dem::wallSet::inTheWay
(
    const UList<scalar>& radius,
    const scalar part
) const
{
    const wallTouch* deepest = nullptr;
    if (appeared_.size())
    {
        scalar most = part;
        for (const wallTouch& t : contacts_.trial)
        {
            const scalar depth = t.overlap/radius[t.sphere];
            if (depth > most && appeared_.found(t.wallI))
            {
                most = depth;
                deepest = &t;
            }
        }
    }
    return deepest;
}


void Foam::dem::wallSet::renumber(const labelUList& newIndex)
{
    release();
    contacts_.renumber(newIndex);
    asleep_.renumber(newIndex);
    reached_.renumber(newIndex);
    all_.clear();
    narrowed_ = false;
}


Foam::List<Foam::dem::wallTouch> Foam::dem::wallSet::bridges() const
{
    DynamicList<wallTouch> found;
    for (const wallTouch& t : reached_.accepted)
    {
        if (t.likeness > 0)
        {
            found.append(t);
        }
    }
    return List<wallTouch>(std::move(found));
}


void Foam::dem::wallSet::setTouches
(
    const UList<wallTouch>& touches,
    const UList<wallRolled>& rolled,
    const UList<wallTouch>& bridged
)
{
    planes_.clear();
    contacts_.accepted = touches;
    contacts_.rolled = contacts_.rolls ? rolled : UList<wallRolled>();
    asleep_.accepted.clear();
    asleep_.rolled.clear();
    reached_.accepted = bridged;
    for (wallTouch& t : reached_.accepted)
    {
        t.likeness = 1;
    }
}


// ************************************************************************* //
