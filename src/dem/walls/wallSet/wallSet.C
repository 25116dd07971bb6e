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

void Foam::dem::wallSet::findNear
(
    const label sphere,
    const label image,
    const point& centre,
    const scalar reach
)
{
    DynamicList<label> elements;
    forAll(walls_, w)
    {
        // What does not end is there anyway
        if (image != periodicity::original && !walls_[w].bounded())
        {
            continue;
        }
        elements.clear();
        walls_[w].candidates(centre, reach, elements);
        for (const label e : elements)
        {
            near_.append(neighbour{sphere, w, e, image});
        }
    }
}


void Foam::dem::wallSet::select
(
    DynamicList<wallTouch>& found,
    const scalar radius
)
{
    std::sort
    (
        found.begin(),
        found.end(),
        [](const wallTouch& a, const wallTouch& b)
        {
            return a.overlap > b.overlap;
        }
    );

    const label first = trial_.size();

    for (const wallTouch& t : found)
    {
        bool standsOut = true;
        for (label k = first; k < trial_.size() && standsOut; ++k)
        {
            // The tolerance is above the round-off of coordinates in a
            // surface file, and far below what a corner stands out
            standsOut =
                ((t.p - trial_[k].p) & trial_[k].n) > 1e-4*radius;
        }
        if (standsOut)
        {
            trial_.append(t);
        }
    }
}


void Foam::dem::wallSet::inherit()
{
    label first = 0;
    for (label t = 0; t < trial_.size();)
    {
        const label sphere = trial_[t].sphere;
        label end = t;
        while (end < trial_.size() && trial_[end].sphere == sphere)
        {
            ++end;
        }
        while (first < touches_.size() && touches_[first].sphere < sphere)
        {
            ++first;
        }
        for
        (
            label k = first;
            k < touches_.size() && touches_[k].sphere == sphere;
            ++k
        )
        {
            bequeath(touches_[k], t, end);
        }
        t = end;
    }
}


void Foam::dem::wallSet::bequeath
(
    const wallTouch& old,
    const label begin,
    const label end
)
{
    label heir = -1;
    scalar best = 0.8;
    for (label t = begin; t < end; ++t)
    {
        const scalar cosine = trial_[t].n & old.n;
        if (cosine > best)
        {
            best = cosine;
            heir = t;
        }
    }

    // An heir of two keeps what the nearer one left
    if (heir >= 0 && best > trial_[heir].likeness)
    {
        trial_[heir].likeness = best;
        trial_[heir].xi = old.xi;
        std::copy(old.rate, old.rate + 4, trial_[heir].rate);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::wallSet::build(const packedBodies& state, const scalar skin)
{
    near_.clear();
    builtT_ = t_;
    renewed_ = false;

    for (label s = 0; s < state.nSpheres(); ++s)
    {
        const point c = state.centre(s);
        const scalar reach = state.radius(s) + skin;

        findNear(s, periodicity::original, c, reach);
        period_.forEachImage
        (
            c,
            reach,
            [&](const label image)
            {
                findNear(s, image, c + period_.shift(image), reach);
            }
        );
    }
}


void Foam::dem::wallSet::touching
(
    const point& centre,
    const scalar radius,
    DynamicList<label>& elements
) const
{
    for (const wall& w : walls_)
    {
        w.candidates(centre, radius, elements);
        if (!w.bounded())
        {
            continue;
        }
        period_.forEachImage
        (
            centre,
            radius,
            [&](const label image)
            {
                w.candidates(centre + period_.shift(image), radius, elements);
            }
        );
    }
}


void Foam::dem::wallSet::findTouches(const packedBodies& state)
{
    trial_.clear();

    DynamicList<wallTouch> found;
    forAll(near_, k)
    {
        const neighbour& n = near_[k];
        const wall& w = walls_[n.wallI];
        const bool isImage = n.image != periodicity::original;
        const vector shift = isImage ? period_.shift(n.image) : vector(Zero);

        wallTouch t;
        t.sphere = n.sphere;
        t.wallI = n.wallI;
        t.xi = Zero;
        t.likeness = 0;
        const scalar d = w.nearest
        (
            state.centre(n.sphere) + shift,
            n.element,
            t.p,
            t.n
        );
        t.overlap = state.radius(n.sphere) - d;
        if (t.overlap > 0)
        {
            if (w.moving())
            {
                t.u = w.velocity(n.element, t.p);
                t.spin = w.spin(n.element, t.n);
            }
            t.p -= shift;
            found.append(t);
        }

        if (k + 1 == near_.size() || near_[k + 1].sphere != n.sphere)
        {
            if (found.size())
            {
                select(found, state.radius(n.sphere));
            }
            found.clear();
        }
    }

    inherit();
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
        for (const wallTouch& t : trial_)
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


bool Foam::dem::wallSet::isNear
(
    const label wallI,
    const label firstSphere,
    const label lastSphere
) const
{
    for (const neighbour& n : near_)
    {
        if
        (
            n.wallI == wallI
         && n.sphere >= firstSphere
         && n.sphere < lastSphere
        )
        {
            return true;
        }
    }
    return false;
}


void Foam::dem::wallSet::renumber(const labelUList& newIndex)
{
    label n = 0;
    for (const wallTouch& t : touches_)
    {
        if (newIndex[t.sphere] >= 0)
        {
            touches_[n] = t;
            touches_[n++].sphere = newIndex[t.sphere];
        }
    }
    touches_.setSize(n);
    near_.clear();
}


// ************************************************************************* //
