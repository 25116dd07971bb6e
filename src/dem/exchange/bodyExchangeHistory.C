/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "bodyExchange.H"
#include "rankMail.H"

#include "SubList.H"

#include <algorithm>

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::dem;

//- In the order of the blocks, bridges behind all contacts
bool before(const verletList::pairHistory& a, const verletList::pairHistory& b)
{
    return
        a.bridge != b.bridge
      ? b.bridge
      : contactBlocks::before(a.pair, b.pair);
}


bool same(const verletList::pairHistory& a, const verletList::pairHistory& b)
{
    return !before(a, b) && !before(b, a);
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::dem::sphereName Foam::dem::bodyExchange::nameOf
(
    const label sphere
) const
{
    const label b = all_->sphereBody[sphere];
    return sphereName{all_->id[b], sphere - all_->firstSphere[b]};
}


Foam::label Foam::dem::bodyExchange::find(const sphereName& s) const
{
    const label b = all_->find(s.body);
    return
        b >= 0 && s.sphere >= 0
     && s.sphere < all_->firstSphere[b + 1] - all_->firstSphere[b]
      ? all_->firstSphere[b] + s.sphere : -1;
}


bool Foam::dem::bodyExchange::concerns(const namedPair& p) const
{
    const label i = all_->find(p.i.body);
    const label j = all_->find(p.j.body);
    return
        (i >= 0 && all_->owns(i))
     || (j >= 0 && all_->owns(j));
}


Foam::DynamicList<Foam::dem::namedPair> Foam::dem::bodyExchange::pairsOf
(
    const verletList& list
)
{
    DynamicList<namedPair> pairs(std::move(saved_));
    for (const verletList::pairHistory& h : list.histories())
    {
        pairs.append(namedPair{nameOf(h.pair.i), nameOf(h.pair.j), h});
    }
    for (const verletList::pairHistory& h : list.bridges())
    {
        pairs.append(namedPair{nameOf(h.pair.i), nameOf(h.pair.j), h});
        pairs.last().memory.bridge = true;
    }
    return pairs;
}


Foam::DynamicList<Foam::dem::namedTouch> Foam::dem::bodyExchange::touchesOf
(
    const wallSet& walls
)
{
    DynamicList<namedTouch> touches(std::move(savedTouches_));
    const touchList all(walls.together());
    forAll(all.accepted, k)
    {
        const wallTouch& t = all.accepted[k];
        namedTouch n;
        n.i = nameOf(t.sphere);
        n.memory = t;
        if (all.rolls)
        {
            n.rolled = all.rolled[k];
        }
        touches.append(n);
    }
    for (const wallTouch& t : walls.bridges())
    {
        namedTouch n;
        n.i = nameOf(t.sphere);
        n.memory = t;
        n.bridge = true;
        touches.append(n);
    }
    return touches;
}


void Foam::dem::bodyExchange::tell(DynamicList<namedPair>& pairs) const
{
    // Bodies that touch are within reach: the owner of either has a copy of
    // the other
    List<DynamicList<namedPair>> out(send_.size());
    for (const namedPair& p : pairs)
    {
        for (const label id : {p.i.body, p.j.body})
        {
            const label b = all_->find(id);
            if (b >= 0 && rank_[b] != Pstream::myProcNo())
            {
                out[rank_[b]].append(p);
            }
        }
    }
    for (const auto& part : swapRecords(out))
    {
        pairs.append(part);
    }
}


void Foam::dem::bodyExchange::remember
(
    const UList<namedPair>& pairs,
    const UList<namedTouch>& touches,
    const bool all,
    verletList& list,
    wallSet& walls
) const
{
    DynamicList<verletList::pairHistory> found(pairs.size());
    for (const namedPair& p : pairs)
    {
        verletList::pairHistory h(p.memory);
        const label i = find(p.i);
        const label j = find(p.j);
        if (i >= 0 && j >= 0)
        {
            const bool mine =
                all_->owns(all_->sphereBody[i])
             || all_->owns(all_->sphereBody[j]);
            if (mine)
            {
                h.renumber(i, j);
                found.append(h);
            }
        }
        else if (all && concerns(p))
        {
            FatalErrorInFunction
                << "The contact of body " << p.i.body << " with body "
                << p.j.body << " in the files of the restart cannot be: they"
                << " are not there, or too far from each other."
                << exit(FatalError);
        }
    }
    // Sorted by number, as to move a memory takes longer than to compare
    labelList order(identity(found.size()));
    std::sort
    (
        order.begin(),
        order.end(),
        [&](const label a, const label b) { return before(found[a], found[b]); }
    );
    order.setSize
    (
        std::unique
        (
            order.begin(),
            order.end(),
            [&](const label a, const label b)
            {
                return same(found[a], found[b]);
            }
        ) - order.begin()
    );
    label nTouching = 0;
    while (nTouching < order.size() && !found[order[nTouching]].bridge)
    {
        ++nTouching;
    }
    const label nBridged = order.size() - nTouching;
    list.setHistories
    (
        List<verletList::pairHistory>
        (
            found, SubList<label>(order, nTouching)
        ),
        List<verletList::pairHistory>
        (
            found, SubList<label>(order, nBridged, nTouching)
        )
    );

    DynamicList<namedTouch> here(touches.size());
    for (const namedTouch& t : touches)
    {
        const label s = find(t.i);
        if (s >= 0)
        {
            here.append(t);
            here.last().memory.sphere = s;
        }
    }
    std::stable_sort
    (
        here.begin(),
        here.end(),
        [](const namedTouch& a, const namedTouch& b)
        {
            return a.memory.sphere < b.memory.sphere;
        }
    );
    DynamicList<wallTouch> atWalls, bridged;
    DynamicList<wallRolled> rolled;
    for (const namedTouch& t : here)
    {
        (t.bridge ? bridged : atWalls).append(t.memory);
        if (!t.bridge)
        {
            rolled.append(t.rolled);
        }
    }
    walls.setTouches(atWalls, rolled, bridged);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::bodyExchange::setSaved
(
    const UList<namedPair>& pairs,
    const UList<namedTouch>& touches
)
{
    saved_ = pairs;
    savedTouches_ = touches;
    changed_ = true;
}


// ************************************************************************* //
