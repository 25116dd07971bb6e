/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "wallSet.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::wallSet::findNear
(
    const label sphere,
    const label image,
    const point& centre,
    const scalar reach,
    DynamicList<label>& elements
)
{
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
            all_.append(neighbour{sphere, w, e, image});
        }
    }
}


void Foam::dem::wallSet::release()
{
    if (planes_.size())
    {
        touchList ofPlanes(planes_.touches());
        planes_.clear();
        if (contacts_.accepted.empty())
        {
            contacts_.accepted.transfer(ofPlanes.accepted);
        }
        else
        {
            contacts_.add(ofPlanes);
        }
    }
}


bool Foam::dem::wallSet::arePlanes(const label first) const
{
    if (!planes_.active() || first == near_.size())
    {
        return false;
    }
    for (label k = first; k < near_.size(); ++k)
    {
        const neighbour& n = near_[k];
        const label p = planes_.planeOf(n.wallI, n.element);
        if (p < 0 || n.image != periodicity::original)
        {
            return false;
        }
        for (label j = first; j < k; ++j)
        {
            const neighbour& m = near_[j];
            if (!planes_.apart(p, planes_.planeOf(m.wallI, m.element)))
            {
                return false;
            }
        }
    }
    return true;
}


void Foam::dem::wallSet::toPlanes
(
    const label first,
    const label begin,
    const label end
)
{
    for (label k = first; k < near_.size(); ++k)
    {
        const neighbour& n = near_[k];
        const label p = planes_.planeOf(n.wallI, n.element);
        const wallTouch* before = nullptr;
        scalar best = touchList::likeEnough;
        for (label t = begin; t < end; ++t)
        {
            const scalar cosine =
                contacts_.accepted[t].n & planes_.normal(p);
            if (cosine > best)
            {
                best = cosine;
                before = &contacts_.accepted[t];
            }
        }
        planes_.append(n.sphere, p, before);
    }
    near_.setSize(first);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::wallSet::build
(
    const packedBodies& state,
    const std::vector<float>& allowed,
    const scalar own
)
{
    release();
    planes_.setWalls(walls_);
    all_.clear();
    narrowed_ = false;
    builtT_ = t_;
    renewed_ = false;

    // A wall that begins to move makes them outdated
    own_ = speed_ > 0 ? own : 0;

    DynamicList<label> elements;
    for (label s = 0; s < state.nSpheres(); ++s)
    {
        if (!state.owns(state.bodyOf(s)))
        {
            continue;
        }
        const point c = state.centre(s);
        const scalar r = state.radius(s);
        const scalar reach =
            r + allowed[s] + own_ + (reaches() ? reachOf(r) : 0);

        findNear(s, periodicity::original, c, reach, elements);
        period_.forEachImage
        (
            c,
            reach,
            [&](const label image)
            {
                const point x = c + period_.shift(image);
                findNear(s, image, x, reach, elements);
            }
        );
    }
}


void Foam::dem::wallSet::narrow
(
    const packedBodies& state,
    const std::vector<float>& allowed
)
{
    release();
    near_.clear();
    narrowed_ = true;

    DynamicList<wallTouch>& before = contacts_.accepted;
    label old = 0, nKept = 0;
    point p;
    vector n;
    for (label k = 0; k < all_.size();)
    {
        const label sphere = all_[k].sphere;
        const label first = near_.size();
        const scalar r = state.radius(sphere);
        const scalar reach =
            r + allowed[sphere] + own_ + (reaches() ? reachOf(r) : 0);
        for (; k < all_.size() && all_[k].sphere == sphere; ++k)
        {
            const neighbour& e = all_[k];
            point x = state.centre(sphere);
            if (e.image != periodicity::original)
            {
                x += period_.shift(e.image);
            }
            if
            (
                !sleeps(sphere)
             && walls_[e.wallI].nearest(x, e.element, p, n) < reach
            )
            {
                near_.append(e);
            }
        }
        if (!arePlanes(first))
        {
            continue;
        }

        // The other accepted contacts stay, in their order
        for (; old < before.size() && before[old].sphere < sphere; ++old)
        {
            before[nKept++] = before[old];
        }
        const label begin = old;
        while (old < before.size() && before[old].sphere == sphere)
        {
            ++old;
        }
        toPlanes(first, begin, old);
    }
    if (planes_.size())
    {
        for (; old < before.size(); ++old)
        {
            before[nKept++] = before[old];
        }
        before.setSize(nKept);
        before.shrink();
        contacts_.trial.clearStorage();
        planes_.set();
    }
}


void Foam::dem::wallSet::setAsleep(const UList<bool>& asleep)
{
    spheresAsleep_ = asleep;
    narrowed_ = false;
    release();

    // Some may have woken up, others fallen asleep
    contacts_.add(asleep_);
    asleep_.accepted = contacts_.accepted;
    asleep_.rolled = contacts_.rolled;
    contacts_.keep(spheresAsleep_, false);
    asleep_.keep(spheresAsleep_, true);
    for (wallTouch& t : asleep_.accepted)
    {
        // They stand still
        std::fill_n(t.rate, 4, 0);
    }
}


void Foam::dem::wallSet::findAsleep(const packedBodies& state)
{
    DynamicList<neighbour> near;
    for (const neighbour& k : all_)
    {
        if (sleeps(k.sphere))
        {
            near.append(k);
        }
    }
    find(state, near, false, asleep_);
}


void Foam::dem::wallSet::markMoved(UList<bool>& spheres) const
{
    for (const neighbour& k : all_)
    {
        const wall& w = walls_[k.wallI];
        if (w.moving() && w.speed() > 0)
        {
            spheres[k.sphere] = true;
        }
    }
}


Foam::dem::touchList Foam::dem::wallSet::together() const
{
    touchList both(contacts_);
    both.add(planes_.touches());
    both.add(asleep_);
    return both;
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


bool Foam::dem::wallSet::isNear
(
    const label wallI,
    const label firstSphere,
    const label lastSphere
) const
{
    for (const neighbour& n : all_)
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


// ************************************************************************* //
