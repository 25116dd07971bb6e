/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "bodyExchange.H"
#include "nearRanks.H"
#include "rankMail.H"
#include "rankSum.H"
#include "spatialOrder.H"

#include <algorithm>
#include <chrono>
#include <vector>

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Adds the time of a block to a sum
class stopwatch
{
    typedef std::chrono::steady_clock clock;

    scalar& sum_;
    const clock::time_point start_;

public:

    explicit stopwatch(scalar& sum)
    :
        sum_(sum),
        start_(clock::now())
    {}

    ~stopwatch()
    {
        sum_ += std::chrono::duration<scalar>(clock::now() - start_).count();
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::bodyExchange::migrate
(
    bodies& own,
    const labelUList& to,
    DynamicList<namedPair>& pairs,
    DynamicList<namedTouch>& touches
)
{
    const label here = Pstream::myProcNo();
    List<DynamicList<namedPair>> pairsTo(Pstream::nProcs());
    List<DynamicList<namedTouch>> touchesTo(Pstream::nProcs());
    const auto ownerOf = [&](const sphereName& s)
    {
        const label b = own.find(s.body);
        return b >= 0 ? to[b] : -1;
    };

    label nKept = 0;
    for (const namedPair& p : pairs)
    {
        const label i = ownerOf(p.i), j = ownerOf(p.j);
        for (const label rank : {i, j != i ? j : -1})
        {
            if (rank >= 0 && rank != here)
            {
                pairsTo[rank].append(p);
            }
        }
        if (i == here || j == here)
        {
            pairs[nKept++] = p;
        }
    }
    pairs.setSize(nKept);
    nKept = 0;
    for (const namedTouch& t : touches)
    {
        const label i = ownerOf(t.i);
        if (i == here)
        {
            touches[nKept++] = t;
        }
        else if (i >= 0)
        {
            touchesTo[i].append(t);
        }
    }
    touches.setSize(nKept);

    List<DynamicList<bodyRecord>> records(Pstream::nProcs());
    DynamicList<label> are(to.size());
    forAll(to, b)
    {
        if (to[b] == here)
        {
            are.append(b);
        }
        else
        {
            records[to[b]].append(own.record(b));
            moved_[to[b]].append(own.id[b]);
        }
    }
    DynamicList<bodyRecord> come;
    for (const auto& part : swapRecords(records))
    {
        come.append(part);
    }
    forAll(come, k)
    {
        are.append(to.size() + k);
    }
    const auto idOf = [&](const label k)
    {
        return k < to.size() ? own.id[k] : come[k - to.size()].id;
    };
    std::sort
    (
        are.begin(),
        are.end(),
        [&](const label a, const label b) { return idOf(a) < idOf(b); }
    );
    own.take(are, come);

    for (const auto& part : swapRecords(pairsTo))
    {
        pairs.append(part);
    }
    for (const auto& part : swapRecords(touchesTo))
    {
        touches.append(part);
    }
}


Foam::Map<Foam::label> Foam::dem::bodyExchange::copiesById() const
{
    Map<label> place;
    forAll(all_->isCopy, b)
    {
        if (all_->isCopy[b])
        {
            place.insert(all_->id[b], b);
        }
    }
    return place;
}


Foam::labelList Foam::dem::bodyExchange::arrange
(
    const UList<DynamicList<label>>& toRanks
)
{
    List<DynamicList<bodyRecord>> out(toRanks.size());
    forAll(toRanks, rank)
    {
        for (const label k : toRanks[rank])
        {
            out[rank].append(all_->record(own_[k]));

            // Its owner has what acts on it
            out[rank].last().fluidForce = Zero;
            out[rank].last().fluidTorque = Zero;
        }
    }
    const List<List<bodyRecord>> in(swapRecords(out));

    // Former copies are left out, and those of now stand behind all others
    struct place
    {
        spatialOrder::key key;
        label id, b, rank, k;
    };
    const label nFormer = all_->size();
    const Map<label> formerCopies(copiesById());
    const spatialOrder space(max(meanRadius_, VSMALL));
    std::vector<place> places;
    places.reserve(2*nFormer);
    const auto keyOf = [&](const point& x)
    {
        return isMany_ ? space.keyOf(x) : 0;
    };
    forAll(own_, k)
    {
        const label b = own_[k];
        const label here = Pstream::myProcNo();
        places.push_back({keyOf(all_->x[b]), all_->id[b], b, here, k});
    }
    DynamicList<bodyRecord> copies;
    forAll(in, rank)
    {
        forAll(in[rank], k)
        {
            const bodyRecord& r = in[rank][k];
            const label b = nFormer + copies.size();
            places.push_back({keyOf(r.x), r.id, b, rank, k});
            copies.append(r);
        }
    }

    // Own ones mostly are in order already
    const auto before = [](const place& a, const place& b)
    {
        return a.key != b.key ? a.key < b.key : a.id < b.id;
    };
    const auto middle = places.begin() + own_.size();
    if (!std::is_sorted(places.begin(), middle, before))
    {
        std::sort(places.begin(), middle, before);
    }
    std::sort(middle, places.end(), before);
    std::inplace_merge(places.begin(), middle, places.end(), before);

    const label n = label(places.size());
    labelList order(n), source(n);
    all_->isCopy.setSize(n);
    rank_.setSize(n);
    send_.setSize(in.size());
    receive_.setSize(in.size());
    forAll(in, rank)
    {
        receive_[rank].setSize(in[rank].size());
    }
    forAll(order, b)
    {
        const place& p = places[b];
        order[b] = p.b;
        source[b] = p.b < nFormer ? p.b : formerCopies.lookup(p.id, -1);
        rank_[b] = p.rank;
        all_->isCopy[b] = p.rank != Pstream::myProcNo();
        (all_->isCopy[b] ? receive_[p.rank] : own_)[p.k] = b;
    }
    all_->take(order, copies);
    forAll(toRanks, rank)
    {
        send_[rank].setSize(toRanks[rank].size());
        forAll(send_[rank], k)
        {
            send_[rank][k] = own_[toRanks[rank][k]];
        }
    }
    mostOwn_ = max(mostOwn_, own_.size());
    mostCopies_ = max(mostCopies_, n - own_.size());
    return source;
}


void Foam::dem::bodyExchange::findRadii(const bodies& own)
{
    scalar least = GREAT, sum = 0;
    for (label s = 0; s < own.nSpheres(); ++s)
    {
        least = min(least, own.sphereR[s]);
        sum += own.sphereR[s];
    }
    const rankGroup group(true);
    const scalar n = group.sum(scalar(own.nSpheres()));
    minRadius_ = n > 0 ? group.min(least) : 0;
    meanRadius_ = n > 0 ? group.sum(sum)/n : 0;
    isMany_ = n >= spatialOrder::few;
}


Foam::scalar Foam::dem::bodyExchange::reachOf
(
    const verletList& list,
    const bodies& all
) const
{
    scalar largest = 0;
    for (label s = 0; s < all.nSpheres(); ++s)
    {
        largest = max(largest, all.sphereR[s]);
    }
    return rankGroup(true).max
    (
        list.skinOf(meanRadius_) + list.reachOf(largest)
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::bodyExchange::bodyExchange
(
    const PtrList<shape>& shapes,
    autoPtr<bodyOwner> owner,
    const periodicity& period
)
:
    shapes_(shapes),
    owner_(std::move(owner)),
    period_(period),
    all_(new bodies(shapes))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::bodyExchange::shareOut
(
    bodies& own,
    verletList& list,
    wallSet& walls,
    const bool stay
)
{
    stopwatch watch(seconds_);
    const rankGroup group(true);
    moved_ = List<DynamicList<label>>(Pstream::nProcs());
    const bool changed = group.any(changed_ || !list.valid());
    if (!changed && !owner_->strict())
    {
        return;
    }

    const labelList to
    (
        stay
      ? labelList(own.size(), Pstream::myProcNo())
      : owner_->owners(own)
    );
    bool moves = false;
    for (const label rank : to)
    {
        moves = moves || rank != Pstream::myProcNo();
    }
    if (!group.any(moves) && !changed)
    {
        return;
    }

    const bool restarted = group.any(saved_.size());
    DynamicList<namedPair> pairs(pairsOf(list));
    DynamicList<namedTouch> touches(touchesOf(walls));
    migrate(own, to, pairs, touches);
    findRadii(own);

    all_.reset(new bodies(own));
    all_->drag = nullptr;
    own_ = identity(own.size());
    scalarList radius(own.size());
    forAll(radius, b)
    {
        radius[b] = own.shapeOf(b).boundingRadius();
    }
    const scalar reach = reachOf(list, own);
    arrange(nearRanks(own.x, radius, reach, period_));

    if (restarted)
    {
        tell(pairs);
    }
    remember(pairs, touches, restarted, list, walls);
    changed_ = false;
    fresh_ = true;
}


void Foam::dem::bodyExchange::reachOut
(
    packedBodies& packed,
    verletList& list,
    wallSet& walls
)
{
    stopwatch watch(seconds_);
    const label n = own_.size();
    pointField x(n);
    scalarList radius(n);
    labelList ownIndex(all_->size(), -1);
    forAll(own_, k)
    {
        const label b = own_[k];
        ownIndex[b] = k;
        x[k] = packed.position(b);
        radius[k] = all_->shapeOf(b).boundingRadius();
    }
    const scalar reach = reachOf(list, *all_);
    List<DynamicList<label>> toRanks(nearRanks(x, radius, reach, period_));

    const auto tellBoth = [&](const verletList::spherePair& p)
    {
        const label a = all_->sphereBody[p.i];
        const label b = all_->sphereBody[p.j];
        if (rank_[a] != rank_[b])
        {
            const bool first = ownIndex[a] >= 0;
            toRanks[rank_[first ? b : a]].append(ownIndex[first ? a : b]);
        }
    };
    list.forEachTouching
    (
        [&](const verletList::spherePair& p, const vector&) { tellBoth(p); }
    );
    for (const verletList::pairHistory& h : list.bridges())
    {
        tellBoth(h.pair);
    }
    for (DynamicList<label>& bodies : toRanks)
    {
        std::sort(bodies.begin(), bodies.end());
        bodies.setSize
        (
            label(std::unique(bodies.begin(), bodies.end()) - bodies.begin())
        );
    }

    const labelList formerFirst(all_->firstSphere.list());
    const labelList source(arrange(toRanks));
    if (drag_.acts())
    {
        drag_.move(own_, all_->size());
    }
    const labelList newSphere(all_->sphereMap(formerFirst, source));
    list.renumber(newSphere);
    walls.renumber(newSphere);

    packed.rearrange(*all_, source);
    setMessages(packed);
    post(packed);
    collect(packed);
    forAll(source, b)
    {
        if (source[b] < 0)
        {
            packed.settle(b);
        }
    }
}


void Foam::dem::bodyExchange::send(const packedBodies& packed)
{
    stopwatch watch(seconds_);
    post(packed);
}


void Foam::dem::bodyExchange::receive(packedBodies& packed)
{
    stopwatch watch(seconds_);
    collect(packed);
}


void Foam::dem::bodyExchange::introduce(packedBodies& packed)
{
    packed.setGroup(rankGroup(true), minRadius_, meanRadius_);
    setMessages(packed);
}


void Foam::dem::bodyExchange::combine
(
    packedBodies& packed,
    bool& due,
    bool& nearDue,
    bool& overstepped
)
{
    stopwatch watch(seconds_);
    const label n = packedBodies::nBounds;
    List<scalar> largest(n + 3);
    packed.putBounds(largest);
    largest[n] = due;
    largest[n + 1] = nearDue;
    largest[n + 2] = overstepped;
    maxOverRanks(largest);
    packed.setBounds(largest);
    due = largest[n] > 0;
    nearDue = largest[n + 1] > 0;
    overstepped = largest[n + 2] > 0;
}


// ************************************************************************* //
