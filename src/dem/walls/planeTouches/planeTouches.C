/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "planeTouches.H"
#include "pairRuns.H"
#include "wall.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::planeTouches::activate(const label nLanes, const bool slips)
{
    active_ = true;
    blocks_.setLanes(nLanes);
    blocks_.setMemory(slips, true, false);
}


void Foam::dem::planeTouches::setWalls(const PtrList<wall>& walls)
{
    if (label(first_.size()) == walls.size() + 1)
    {
        return;
    }
    planes_.clear();
    first_.assign(1, 0);
    forAll(walls, w)
    {
        plane k{w, Zero, Zero};
        for (label e = 0; walls[w].plane(e, k.p, k.n); ++e)
        {
            planes_.push_back(k);
        }
        first_.push_back(label(planes_.size()));
    }
}


Foam::label Foam::dem::planeTouches::planeOf(const wallTouch& t) const
{
    for (label k = first_[t.wallI]; k < first_[t.wallI + 1]; ++k)
    {
        if (planes_[k].n == t.n)
        {
            return k;
        }
    }
    return -1;
}


void Foam::dem::planeTouches::order
(
    UList<wallTouch>& touches,
    const label first,
    const label last
) const
{
    if (!active_)
    {
        return;
    }
    for (label t = first; t < last; ++t)
    {
        if (planeOf(touches[t]) < 0)
        {
            return;
        }
    }
    std::sort
    (
        touches.begin() + first,
        touches.begin() + last,
        [&](const wallTouch& a, const wallTouch& b)
        {
            return planeOf(a) < planeOf(b);
        }
    );
}


void Foam::dem::planeTouches::clear()
{
    pairs_.clear();
    kept_.clear();
    blocks_.clear();
}


void Foam::dem::planeTouches::append
(
    const label sphere,
    const label planeI,
    const wallTouch* before
)
{
    pairs_.push_back(contactBlocks::spherePair(sphere, planeI));
    if (before)
    {
        memory m;
        m.pair = size() - 1;
        m.xi = before->xi;
        std::copy(before->rate, before->rate + 4, m.rate);
        kept_.append(m);
    }
}


void Foam::dem::planeTouches::set()
{
    if (pairs_.empty())
    {
        return;
    }
    const contactBlocks::spherePair filler(pairs_[0].i, 0);
    pairRuns pairs;
    for (const contactBlocks::spherePair& p : pairs_)
    {
        pairs.add(p);
    }
    blocks_.setPairs(pairs, filler);
    for (const memory& m : kept_)
    {
        contactBlocks::pairHistory h;
        h.pair = pairs_[m.pair];
        h.xi = m.xi;
        std::copy(m.rate, m.rate + 4, h.rate);
        blocks_.setTouching(m.pair, h);
    }
    kept_.clearStorage();

    const label n = blocks_.nLanes();
    const label W = blocks_.nInBlock();
    wall_.assign(n, 0);
    normal_.assign(3*n, 0);
    accepted_.assign(n, 0);
    overlap_.assign(n, 0);
    for (label k = 0; k < size(); ++k)
    {
        const plane& p = planes_[pairs_[k].j];
        wall_[k] = p.wallI;
        for (direction d = 0; d < 3; ++d)
        {
            normal_[3*(k - k % W) + d*W + k % W] = p.n[d];
        }
    }
}


void Foam::dem::planeTouches::find(const packedBodies& state)
{
    for (label k = 0; k < size(); ++k)
    {
        const contactBlocks::spherePair& pair = pairs_[k];
        const plane& p = planes_[pair.j];
        const scalar d = (state.centre(pair.i) - p.p) & p.n;
        overlap_[k] = state.radius(pair.i) - d;
    }
}


Foam::dem::touchList Foam::dem::planeTouches::touches() const
{
    touchList found;
    label n = 0;
    blocks_.forEachTouching([&](const label) { ++n; });
    found.accepted.reserve(n);
    for (label k = 0; k < size(); ++k)
    {
        if (!blocks_.touches(k))
        {
            continue;
        }
        const contactBlocks::pairHistory h = blocks_.history(k);
        wallTouch t = {};
        t.sphere = h.pair.i;
        t.wallI = wall_[k];
        t.n = planes_[h.pair.j].n;
        t.overlap = accepted_[k];
        t.xi = h.xi;
        t.likeness = 1;
        std::copy(h.rate, h.rate + 4, t.rate);
        found.accepted.append(t);
    }
    return found;
}


void Foam::dem::planeTouches::give(sweepData& data, const bool onTrial)
{
    data.nPlaneBlocks = 0;
    if (pairs_.empty())
    {
        return;
    }
    sweepData pairs;
    blocks_.give(pairs, onTrial);
    data.nPlaneBlocks = pairs.nBlocks;
    data.planeSphere = pairs.i;
    data.ofPlanes = pairs.ofPairs;
    data.planeWall = wall_.data();
    data.planeNormal = normal_.data();
    data.planeOverlap = overlap_.data();
}


// ************************************************************************* //
