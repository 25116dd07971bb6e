/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "contactShares.H"

#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::contactShares::shareOut
(
    const label nLanes,
    std::vector<double>& shares
)
{
    shares.assign(nLanes, 1);
    std::sort(contacts_.begin(), contacts_.end());

    const size_t n = contacts_.size();
    for (size_t first = 0, last; first < n; first = last)
    {
        last = first + 1;
        while (last < n && contacts_[last].sameBodies(contacts_[first]))
        {
            ++last;
        }
        for (size_t k = first; k < last; ++k)
        {
            scalar sum = 0;
            for (size_t j = first; j < last; ++j)
            {
                sum +=
                    contacts_[j].overlap
                   *max(contacts_[k].normal & contacts_[j].normal, scalar(0));
            }
            shares[contacts_[k].lane] = contacts_[k].overlap/sum;
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::contactShares::find
(
    const packedBodies& state,
    const verletList& list,
    const contactBlocks& blocks,
    const UList<wallTouch>& atWalls,
    const label nLanes
)
{
    contacts_.clear();
    for (label lane = 0; lane < blocks.nLanes(); ++lane)
    {
        const verletList::spherePair p = blocks.pairInLane(lane);
        if (p.i >= state.nSpheres())
        {
            // Fills up a block
            continue;
        }
        const label a = state.bodyOf(p.i), b = state.bodyOf(p.j);
        if (state.isSingle(a) && state.isSingle(b))
        {
            continue;
        }
        const vector d =
            state.centre(p.i) - state.centre(p.j) - list.shiftOf(p);
        const scalar distance = mag(d);
        const scalar overlap =
            state.radius(p.i) + state.radius(p.j) - distance;
        if (overlap > 0)
        {
            contacts_.push_back
            (
                {a, b, p.image, lane, overlap, d/max(distance, VSMALL)}
            );
        }
    }
    shareOut(blocks.nLanes(), ofPairs_);

    contacts_.clear();
    forAll(atWalls, lane)
    {
        const wallTouch& t = atWalls[lane];
        const label a = state.bodyOf(t.sphere);
        if (!state.isSingle(a))
        {
            contacts_.push_back({a, -1, 0, lane, t.overlap, t.n});
        }
    }
    shareOut((atWalls.size()/nLanes + 1)*nLanes, ofWalls_);
}


void Foam::dem::contactShares::find
(
    const std::vector<contact>& pairs,
    const label nPairLanes,
    const std::vector<contact>& atWalls,
    const label nWallLanes
)
{
    contacts_ = pairs;
    shareOut(nPairLanes, ofPairs_);
    contacts_ = atWalls;
    shareOut(nWallLanes, ofWalls_);
}


// ************************************************************************* //
