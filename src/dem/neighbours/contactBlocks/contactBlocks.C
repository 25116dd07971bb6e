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
#include "pairRuns.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::contactBlocks::setRoom(memory& m, const label nBlocks) const
{
    const label n = nBlocks*nLanes_;
    m.xi.setSize(slips_ ? 3*n : 0);
    m.rate.setSize(moves_ ? 4*n : 0);
    m.rolled.setSize(rolls_ ? 4*n : 0);
}


void Foam::dem::contactBlocks::setSize(memory& m, const label nBlocks) const
{
    setRoom(m, nBlocks);
    m.touched.assign(nBlocks, 0);
}


void Foam::dem::contactBlocks::move(const label from, const label to)
{
    if (slips_)
    {
        now_.xi.move(from, 3, to, nLanes_);
    }
    if (moves_)
    {
        now_.rate.move(from, 4, to, nLanes_);
    }
    if (rolls_)
    {
        now_.rolled.move(from, 4, to, nLanes_);
    }
}


Foam::label Foam::dem::contactBlocks::layOut
(
    const label nPlain,
    const label nImages
)
{
    const label W = nLanes_;
    nPlain_ = nPlain;
    nImages_ = nImages;
    nPlainBlocks_ = (nPlain_ + W - 1)/W;
    return nPlainBlocks_ + (nImages_ + W - 1)/W;
}


template<class ForEach>
void Foam::dem::contactBlocks::place
(
    const ForEach& forEach,
    const label nBlocks,
    const spherePair& filler
)
{
    const label W = nLanes_;
    i_.assign(nBlocks*W, 8*filler.i);
    j_.assign(nBlocks*W, 8*filler.j);
    image_.assign(nImages_ ? nBlocks*W : 0, periodicity::original);
    onTrial_ = false;

    label p = 0;
    forEach([&](const spherePair& pair)
    {
        const label k = slot(p++);
        i_[k] = 8*pair.i;
        j_[k] = 8*pair.j;
        if (nImages_)
        {
            image_[k] = pair.image;
        }
    });
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
    label nPlain = touching.size();
    while
    (
        nPlain && touching[nPlain - 1].pair.image != periodicity::original
    )
    {
        --nPlain;
    }
    const label nBlocks = layOut(nPlain, touching.size() - nPlain);
    place
    (
        [&](const auto& visit)
        {
            for (const pairHistory& h : touching)
            {
                visit(h.pair);
            }
        },
        nBlocks,
        filler
    );
    setSize(now_, nBlocks);
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
    const pairRuns& pairs,
    const spherePair& filler
)
{
    const std::vector<label>& from = touching();
    const label nBlocks = layOut(pairs.nPlain(), pairs.nImages());
    const auto lane = [&](const label t) { return slot(pairs.touching()[t]); };

    // It goes there in place: as the order is the same, what goes down from
    // the first to the last, and then what goes up from the last to the first,
    // never meets what has yet to go
    const label nTouching = label(pairs.touching().size());
    setRoom(now_, max(nBlocks, label(now_.touched.size())));
    for (label t = 0; t < nTouching; ++t)
    {
        if (lane(t) < from[t])
        {
            move(from[t], lane(t));
        }
    }
    for (label t = nTouching - 1; t >= 0; --t)
    {
        if (lane(t) > from[t])
        {
            move(from[t], lane(t));
        }
    }

    setSize(now_, nBlocks);
    for (const label p : pairs.touching())
    {
        const label k = slot(p);
        now_.touched[k/nLanes_] |= 1 << (k % nLanes_);
    }
    place
    (
        [&](const auto& visit) { pairs.forEach(visit); }, nBlocks, filler
    );
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
    forEachTouching([&](const label lane) { found[n++] = history(lane); });
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
