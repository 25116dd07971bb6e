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
) const
{
    List<DynamicList<bodyRecord>> records(Pstream::nProcs());
    List<DynamicList<namedPair>> pairsTo(Pstream::nProcs());
    List<DynamicList<namedTouch>> touchesTo(Pstream::nProcs());
    forAll(to, b)
    {
        records[to[b]].append(own.record(b));
    }
    for (const namedPair& p : pairs)
    {
        const label i = own.find(p.i.body);
        const label j = own.find(p.j.body);
        const label first = i >= 0 ? to[i] : -1;
        const label second = j >= 0 ? to[j] : -1;
        if (first >= 0)
        {
            pairsTo[first].append(p);
        }
        if (second >= 0 && second != first)
        {
            pairsTo[second].append(p);
        }
    }
    for (const namedTouch& t : touches)
    {
        const label b = own.find(t.i.body);
        if (b >= 0)
        {
            touchesTo[to[b]].append(t);
        }
    }

    DynamicList<bodyRecord> mine;
    for (const auto& part : swapRecords(records))
    {
        mine.append(part);
    }
    std::sort
    (
        mine.begin(),
        mine.end(),
        [](const bodyRecord& a, const bodyRecord& b) { return a.id < b.id; }
    );
    const label nextId = own.nextId();
    own.clear();
    for (const bodyRecord& r : mine)
    {
        own.append(r);
    }
    own.setNextId(nextId);

    pairs.clear();
    touches.clear();
    for (const auto& part : swapRecords(pairsTo))
    {
        pairs.append(part);
    }
    for (const auto& part : swapRecords(touchesTo))
    {
        touches.append(part);
    }
}


Foam::labelList Foam::dem::bodyExchange::arrange
(
    const UList<bodyRecord>& own,
    const UList<DynamicList<label>>& toRanks
)
{
    List<DynamicList<bodyRecord>> out(toRanks.size());
    forAll(toRanks, rank)
    {
        for (const label k : toRanks[rank])
        {
            out[rank].append(own[k]);

            // Its owner has what acts on it
            out[rank].last().fluidForce = Zero;
            out[rank].last().fluidTorque = Zero;
        }
    }
    const List<List<bodyRecord>> in(swapRecords(out));

    // Which of its rank's records it is
    struct place
    {
        spatialOrder::key key;
        const bodyRecord* record;
        label rank, k;
    };
    const spatialOrder space(max(meanRadius_, VSMALL));
    DynamicList<place> places(own.size());
    const auto add = [&](const UList<bodyRecord>& records, const label rank)
    {
        forAll(records, k)
        {
            const bodyRecord& r = records[k];
            places.append(place{isMany_ ? space.keyOf(r.x) : 0, &r, rank, k});
        }
    };
    add(own, Pstream::myProcNo());
    forAll(in, rank)
    {
        add(in[rank], rank);
    }
    std::sort
    (
        places.begin(),
        places.end(),
        [](const place& a, const place& b)
        {
            return a.key != b.key ? a.key < b.key : a.record->id < b.record->id;
        }
    );

    autoPtr<bodies> former(std::move(all_));
    all_.reset(new bodies(shapes_));
    all_->isCopy.setSize(places.size());
    rank_.setSize(places.size());
    own_.setSize(own.size());
    send_.setSize(in.size());
    receive_.setSize(in.size());
    labelList source(places.size());
    forAll(in, rank)
    {
        receive_[rank].setSize(in[rank].size());
    }
    forAll(places, b)
    {
        const label rank = places[b].rank;
        all_->append(*places[b].record);
        rank_[b] = rank;
        all_->isCopy[b] = rank != Pstream::myProcNo();
        source[b] = former->find(places[b].record->id);
        (all_->isCopy[b] ? receive_[rank] : own_)[places[b].k] = b;
    }
    forAll(toRanks, rank)
    {
        send_[rank].setSize(toRanks[rank].size());
        forAll(send_[rank], k)
        {
            send_[rank][k] = own_[toRanks[rank][k]];
        }
    }
    mostOwn_ = max(mostOwn_, own.size());
    mostCopies_ = max(mostCopies_, all_->size() - own.size());
    return source;
}


void Foam::dem::bodyExchange::findRadii(const bodies& own)
{
    scalar least = GREAT, sum = 0;
    for (const scalar r : own.sphereR)
    {
        least = min(least, r);
        sum += r;
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
    const UList<scalar>& radius
) const
{
    scalar largest = 0;
    for (const scalar r : radius)
    {
        largest = max(largest, r);
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
    wallSet& walls
)
{
    stopwatch watch(seconds_);
    const rankGroup group(true);
    const bool changed = group.any(changed_ || !list.valid());
    if (!changed && !owner_->strict())
    {
        return;
    }

    const labelList to(owner_->owners(own));
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

    scalarList radius(own.size());
    DynamicList<bodyRecord> records(own.size());
    forAll(radius, b)
    {
        radius[b] = own.shapeOf(b).boundingRadius();
        records.append(own.record(b));
    }
    const scalar reach = reachOf(list, own.sphereR);
    arrange(records, nearRanks(own.x, radius, reach, period_));

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
    DynamicList<bodyRecord> records(n);
    labelList ownIndex(all_->size(), -1);
    forAll(own_, k)
    {
        const label b = own_[k];
        ownIndex[b] = k;
        x[k] = packed.position(b);
        radius[k] = all_->shapeOf(b).boundingRadius();
        records.append(all_->record(b));
    }
    const scalar reach = reachOf(list, all_->sphereR);
    List<DynamicList<label>> toRanks(nearRanks(x, radius, reach, period_));

    for (const auto& histories : {list.histories(), list.bridges()})
    {
        for (const auto& h : histories)
        {
            const label a = all_->sphereBody[h.pair.i];
            const label b = all_->sphereBody[h.pair.j];
            if (rank_[a] != rank_[b])
            {
                const bool first = ownIndex[a] >= 0;
                toRanks[rank_[first ? b : a]].append(ownIndex[first ? a : b]);
            }
        }
    }
    for (DynamicList<label>& bodies : toRanks)
    {
        std::sort(bodies.begin(), bodies.end());
        bodies.setSize
        (
            label(std::unique(bodies.begin(), bodies.end()) - bodies.begin())
        );
    }

    const labelList formerFirst(all_->firstSphere);
    const labelList source(arrange(records, toRanks));
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


void Foam::dem::bodyExchange::take(const bodies& own)
{
    forAll(own_, k)
    {
        all_->setState(own_[k], own.record(k));
    }
}


void Foam::dem::bodyExchange::giveBack(bodies& own) const
{
    forAll(own_, k)
    {
        own.setState(k, all_->record(own_[k]));
    }
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
