/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Class

\*---------------------------------------------------------------------------*/

#include "contactBlocks.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::contactBlocks::setSize(memory& m, const label nBlocks) const
{
    const label n = nBlocks*nLanes_;
    m.xi.setSize(slips_ ? 3*n : 0);
    m.rate.setSize(moves_ ? 4*n : 0);
    m.rolled.setSize(rolls_ ? 4*n : 0);
    m.touched.assign(nBlocks, 0);
}


template<class Pairs>
void Foam::dem::contactBlocks::place
(
    const Pairs& pairs,
    const label n,
    const spherePair& filler
)
{
    const label W = nLanes_;
    nPlain_ = n;
    while (nPlain_ && pairs(nPlain_ - 1).image != periodicity::original)
    {
        --nPlain_;
    }
    nImages_ = n - nPlain_;
    nPlainBlocks_ = (nPlain_ + W - 1)/W;
    const label nBlocks = nPlainBlocks_ + (nImages_ + W - 1)/W;

    i_.assign(nBlocks*W, 8*filler.i);
    j_.assign(nBlocks*W, 8*filler.j);
    image_.assign(nImages_ ? nBlocks*W : 0, periodicity::original);
    setSize(now_, nBlocks);
    onTrial_ = false;

    for (label p = 0; p < n; ++p)
    {
        const spherePair& pair = pairs(p);
        const label k = slot(p);
        i_[k] = 8*pair.i;
        j_[k] = 8*pair.j;
        if (nImages_)
        {
            image_[k] = pair.image;
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::contactBlocks::pairHistory::turnRound()
{
    Swap(pair.i, pair.j);
    pair.image = periodicity::opposite(pair.image);

    // The velocity along the normal and the angle about it are the same from
    // either side
    xi = -xi;
    for (direction d = 0; d < 3; ++d)
    {
        rate[d] = -rate[d];
        rolled[d] = -rolled[d];
    }
}


void Foam::dem::contactBlocks::set
(
    const UList<pairHistory>& touching,
    const spherePair& filler
)
{
    place
    (
        [&](const label p) -> const spherePair& { return touching[p].pair; },
        touching.size(),
        filler
    );
    forAll(touching, p)
    {
        const pairHistory& h = touching[p];
        const label k = slot(p);
        if (slips_)
        {
            now_.xi.put(h.xi.cdata(), 3, k, nLanes_);
        }
        if (moves_)
        {
            now_.rate.put(h.rate, 4, k, nLanes_);
        }
        if (rolls_)
        {
            now_.rolled.put(h.rolled, 4, k, nLanes_);
        }
        now_.touched[k/nLanes_] |= 1 << (k % nLanes_);
    }
}


void Foam::dem::contactBlocks::set
(
    const std::vector<spherePair>& pairs,
    const spherePair& filler
)
{
    // Which pairs had which memory
    const std::vector<label>& lanes = touching();
    old_.clear();
    for (const label lane : lanes)
    {
        old_.push_back(pairInLane(lane));
    }
    std::swap(now_, trial_);

    const label n = label(pairs.size());
    place
    (
        [&](const label p) -> const spherePair& { return pairs[p]; },
        n,
        filler
    );

    std::size_t next = 0;
    for (label p = 0; p < n && next < lanes.size(); ++p)
    {
        if (before(pairs[p], old_[next]))
        {
            continue;
        }
        const label k = slot(p);
        const label from = lanes[next++];
        if (slips_)
        {
            now_.xi.take(trial_.xi, from, 3, k, nLanes_);
        }
        if (moves_)
        {
            now_.rate.take(trial_.rate, from, 4, k, nLanes_);
        }
        if (rolls_)
        {
            now_.rolled.take(trial_.rolled, from, 4, k, nLanes_);
        }
        now_.touched[k/nLanes_] |= 1 << (k % nLanes_);
    }
}


const std::vector<Foam::label>& Foam::dem::contactBlocks::touching()
{
    touching_.clear();
    for (label block = 0; block < label(now_.touched.size()); ++block)
    {
        for (unsigned left = now_.touched[block]; left; left &= left - 1)
        {
            touching_.push_back(block*nLanes_ + __builtin_ctz(left));
        }
    }
    return touching_;
}


Foam::dem::contactBlocks::pairHistory Foam::dem::contactBlocks::history
(
    const label lane
) const
{
    pairHistory h;
    h.pair = pairInLane(lane);
    if (slips_)
    {
        now_.xi.get(h.xi.data(), 3, lane, nLanes_);
    }
    if (moves_)
    {
        now_.rate.get(h.rate, 4, lane, nLanes_);
    }
    if (rolls_)
    {
        now_.rolled.get(h.rolled, 4, lane, nLanes_);
    }
    return h;
}


Foam::List<Foam::dem::contactBlocks::pairHistory>
Foam::dem::contactBlocks::histories() const
{
    label n = 0;
    for (label p = 0; p < nPlain_ + nImages_; ++p)
    {
        n += touches(slot(p));
    }

    List<pairHistory> found(n);
    n = 0;
    for (label p = 0; p < nPlain_ + nImages_; ++p)
    {
        if (touches(slot(p)))
        {
            found[n++] = history(slot(p));
        }
    }
    return found;
}


void Foam::dem::contactBlocks::give(sweepData& data, const bool onTrial)
{
    if (onTrial && trial_.touched.size() != now_.touched.size())
    {
        setSize(trial_, label(now_.touched.size()));
    }
    onTrial_ = onTrial;
    memory& next = onTrial ? trial_ : now_;

    data.nBlocks = label(now_.touched.size());
    data.firstImage = nPlainBlocks_;
    data.i = i_.data();
    data.j = j_.data();
    data.image = image_.data();
    data.ofPairs.xiOld = now_.xi.data();
    data.ofPairs.xi = next.xi.data();
    data.ofPairs.rateOld = now_.rate.data();
    data.ofPairs.rate = next.rate.data();
    data.ofPairs.rolledOld = now_.rolled.data();
    data.ofPairs.rolled = next.rolled.data();
    data.ofPairs.touchedOld = now_.touched.data();
    data.ofPairs.touched = next.touched.data();
}


// ************************************************************************* //
