/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "contactBlocks.H"
#include "nearPairs.H"
#include "pairRuns.H"
#include "setFresh.H"

#include <algorithm>
#include <numeric>

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


void Foam::dem::contactBlocks::put(const label lane, const pairHistory& h)
{
    i_[lane] = 8*h.pair.i;
    j_[lane] = 8*h.pair.j;
    if (!image_.empty())
    {
        image_[lane] = h.pair.image;
    }
    if (slips_)
    {
        now_.xi.put(h.xi.cdata(), 3, lane, nLanes_);
    }
    if (moves_)
    {
        now_.rate.put(h.rate, 4, lane, nLanes_);
    }
    if (rolls_)
    {
        now_.rolled.put(h.rolled, 4, lane, nLanes_);
    }
}


std::vector<Foam::label> Foam::dem::contactBlocks::orderOf
(
    const label n
) const
{
    const auto sooner = [&](const label a, const label b)
    {
        return before(pairInLane(a), pairInLane(b));
    };
    label last = -1;
    bool sorted = true;
    for (label k = 0; k < n; ++k)
    {
        last = max(last, i_[k]/8);
        sorted = sorted && (k == 0 || !sooner(k, k - 1));
    }
    std::vector<label> order;
    if (sorted)
    {
        return order;
    }

    // Into buckets by the first sphere, those through seams into the last one
    std::vector<label> begin(last + 3, 0);
    const auto bucket = [&](const label k)
    {
        return
            image_.empty() || image_[k] == periodicity::original
          ? i_[k]/8 : last + 1;
    };
    for (label k = 0; k < n; ++k)
    {
        ++begin[bucket(k) + 1];
    }
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    order.resize(n);
    for (label k = 0; k < n; ++k)
    {
        order[begin[bucket(k)]++] = k;
    }

    // Where a bucket began is now where it ends
    label from = 0;
    for (label b = 0; b <= last + 1; ++b)
    {
        std::sort(order.begin() + from, order.begin() + begin[b], sooner);
        from = begin[b];
    }
    return order;
}


void Foam::dem::contactBlocks::reorder(std::vector<label>& order)
{
    // Round by round: each lane takes what belongs there, and what was in the
    // first one goes to the last
    for (label k = 0; k < label(order.size()); ++k)
    {
        if (order[k] == k)
        {
            continue;
        }
        const pairHistory first(history(k));
        label to = k;
        for (label from = order[to]; from != k; from = order[to])
        {
            put(to, history(from));
            order[to] = to;
            to = from;
        }
        put(to, first);
        order[to] = to;
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
    setFresh(i_, nBlocks*W);
    setFresh(j_, nBlocks*W);
    setFresh(image_, nImages_ ? nBlocks*W : 0);
    std::fill(i_.begin(), i_.end(), 8*filler.i);
    std::fill(j_.begin(), j_.end(), 8*filler.j);
    std::fill(image_.begin(), image_.end(), periodicity::original);
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
    place([](const auto&) {}, nBlocks, filler);
    setSize(now_, nBlocks);
    forAll(touching, p)
    {
        setTouching(p, touching[p]);
    }
}


void Foam::dem::contactBlocks::setTouching
(
    const label p,
    const pairHistory& h
)
{
    const label k = slot(p);
    put(k, h);
    now_.touched[k/nLanes_] |= 1 << (k % nLanes_);
}


void Foam::dem::contactBlocks::keepTouching
(
    const std::function<bool(pairHistory&)>& change
)
{
    // Those that stay go to the first lanes, as many as there are, and into
    // their order there
    image_.resize(i_.size(), periodicity::original);
    trial_ = memory();
    onTrial_ = false;
    label n = 0;
    forEachTouching([&](const label k)
    {
        pairHistory h(history(k));
        if (change(h))
        {
            put(n++, h);
        }
    });
    std::vector<label> order(orderOf(n));
    reorder(order);

    // Then those through seams, which are the last, begin a block
    label nPlain = n;
    while (nPlain && image_[nPlain - 1] != periodicity::original)
    {
        --nPlain;
    }
    const label nBlocks = layOut(nPlain, n - nPlain);
    const label nRoom = max(nLanes(), nBlocks*nLanes_);
    i_.resize(nRoom);
    j_.resize(nRoom);
    image_.resize(nRoom);
    setRoom(now_, nRoom/nLanes_);
    for (label p = n - 1; p >= nPlain; --p)
    {
        put(slot(p), history(p));
    }
    i_.resize(nBlocks*nLanes_);
    j_.resize(nBlocks*nLanes_);
    image_.resize(nImages_ ? nBlocks*nLanes_ : 0);
    now_.touched.assign(nBlocks, 0);
    for (label p = 0; p < n; ++p)
    {
        now_.touched[slot(p)/nLanes_] |= 1 << (slot(p) % nLanes_);
    }
}


template<class Pairs>
void Foam::dem::contactBlocks::setPairs
(
    const Pairs& pairs,
    const spherePair& filler
)
{
    const label nBlocks = layOut(pairs.nPlain(), pairs.nImages());

    // It goes there in place: as the order is the same, what goes down from
    // the first to the last, and then what goes up from the last to the first,
    // never meets what has yet to go
    setRoom(now_, max(nBlocks, label(now_.touched.size())));
    std::vector<unsigned char> touched(nBlocks, 0);
    touchedLanes up(now_.touched, nLanes_);
    pairs.forEachTouching([&](const label p)
    {
        up.next();
        const label k = slot(p);
        touched[k/nLanes_] |= 1 << (k % nLanes_);
        if (k < up.lane())
        {
            move(up.lane(), k);
        }
    });
    touchedLanes down(now_.touched, nLanes_, true);
    pairs.forEachTouchingBackwards([&](const label p)
    {
        down.previous();
        if (slot(p) > down.lane())
        {
            move(down.lane(), slot(p));
        }
    });

    now_.touched.swap(touched);
    place
    (
        [&](const auto& visit) { pairs.forEach(visit); }, nBlocks, filler
    );
}


template void Foam::dem::contactBlocks::setPairs
(
    const pairRuns&,
    const spherePair&
);

template void Foam::dem::contactBlocks::setPairs
(
    const nearPairs&,
    const spherePair&
);


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
