/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    The list of neighbours: complete, without doubles, for any mixture of
    sizes and for clusters; histories survive its rebuilding.

\*---------------------------------------------------------------------------*/

#include "demCase.H"

#include "verletList.H"

#include <cmath>
#include <random>
#include <set>

using namespace styxTest;
using namespace Foam::dem;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

typedef std::set<std::pair<label, label>> pairSet;


//- Spheres of five sizes, 1:50, and two clusters
Foam::PtrList<shape> shapes()
{
    Foam::PtrList<shape> list(7);
    const scalar diameters[] = {0.02, 0.05, 0.11, 0.3, 1};
    for (label i = 0; i < 5; ++i)
    {
        list.set(i, new shape(shape::sphere("s", diameters[i])));
    }

    Foam::List<shape::sphereData> rod(6);
    for (label i = 0; i < 6; ++i)
    {
        rod[i] = shape::sphereData(point(0.03*i, 0, 0), 0.02 + 0.004*i);
    }
    list.set(5, new shape("rod", rod));

    Foam::List<shape::sphereData> big(2);
    big[0] = shape::sphereData(point(0, 0, 0), 0.3);
    big[1] = shape::sphereData(point(0.5, 0, 0), 0.02);
    list.set(6, new shape("big", big));
    return list;
}


//- Bodies at random places of a box about the origin
void fill(bodies& state, const label n, std::mt19937& random)
{
    const auto uniform = [&]() { return random()/2147483648.0 - 1; };
    for (label i = 0; i < n; ++i)
    {
        newBody b;
        // Many small ones
        b.shapeI =
            i % 40 == 0 ? 4 : i % 10 == 0 ? 3 : i % 7 == 0 ? 6
          : i % 5 == 0 ? 5 : i % 3;
        b.materialI = 0;
        b.density = 1000;
        b.position = vector(uniform(), 0.7*uniform(), 1.3*uniform());
        b.orientation = Foam::quaternion
        (
            vector(uniform(), uniform(), 1.01),
            3*uniform()
        );
        b.orientation = unit(b.orientation);
        state.append(b);
    }
}


pairSet bruteForce(const bodies& state, const scalar skin)
{
    pairSet pairs;
    for (label j = 0; j < state.nSpheres(); ++j)
    {
        for (label i = 0; i < j; ++i)
        {
            if
            (
                state.sphereBody[i] != state.sphereBody[j]
             && mag(state.sphereX()[i] - state.sphereX()[j])
              < state.sphereR[i] + state.sphereR[j] + skin
            )
            {
                pairs.insert(std::make_pair(i, j));
            }
        }
    }
    return pairs;
}


pairSet pairsOf(const verletList& list)
{
    pairSet pairs;
    list.pairs().forEach([&](const verletList::spherePair& p)
    {
        EXPECT_LT(p.i, p.j);
        EXPECT_TRUE(pairs.insert(std::make_pair(p.i, p.j)).second)
            << "twice: " << p.i << ' ' << p.j;
    });
    return pairs;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(demNeighbours, bruteForce)
{
    std::mt19937 random(7);
    label nDifferent = 0;
    label nPairs = 0;

    for (int trial = 0; trial < 20; ++trial)
    {
        const Foam::PtrList<shape> list(shapes());
        bodies state(list);
        fill(state, 30*trial + 1, random);

        // Far away, and many cells from the origin
        for (point& x : state.x)
        {
            x += 100.0*trial*vector(1, -1, 0.5);
        }
        state.update();

        verletList neighbours(trial % 2 ? 0.1 : 1.5);
        neighbours.build(packedBodies(state));

        const pairSet found = pairsOf(neighbours);
        const pairSet exact = bruteForce(state, neighbours.skin());
        nPairs += exact.size();
        nDifferent += found != exact;
    }

    EXPECT_GT(nPairs, 10000);
    figure
    (
        "neighboursBruteForce",
        nDifferent,
        0,
        0,
        "lists that differ, of 20 with sizes 1:50",
        "brute force"
    );
}


TEST(demNeighbours, nothingMissed)
{
    // What touches is in the list until the list says that it is outdated
    std::mt19937 random(3);
    const Foam::PtrList<shape> list(shapes());
    bodies state(list);
    fill(state, 200, random);

    verletList neighbours(0.3);
    EXPECT_TRUE(neighbours.outdated(packedBodies(state)));
    neighbours.build(packedBodies(state));
    EXPECT_FALSE(neighbours.outdated(packedBodies(state)));

    const auto uniform = [&]() { return random()/2147483648.0 - 1; };
    Foam::vectorField v(state.size());
    for (vector& w : v)
    {
        w = vector(uniform(), uniform(), uniform());
    }

    for (int step = 0; step < 1000; ++step)
    {
        for (label b = 0; b < state.size(); ++b)
        {
            state.x[b] += 2e-4*v[b];
        }
        state.update();
        neighbours.moved(2e-4*std::sqrt(3.0));
        if (neighbours.outdated(packedBodies(state)))
        {
            neighbours.build(packedBodies(state));
        }
        const pairSet found = pairsOf(neighbours);
        if (step % 20 == 0)
        {
            for (const auto& p : bruteForce(state, 0))
            {
                EXPECT_TRUE(found.count(p)) << p.first << ' ' << p.second;
            }
        }
    }
    EXPECT_GT(neighbours.nBuilds(), 3);
    EXPECT_LT(neighbours.nBuilds(), 100);
}


TEST(demNeighbours, histories)
{
    // Each pair's slip carries the ids of its bodies
    std::mt19937 random(5);
    const Foam::PtrList<shape> list(shapes());
    bodies state(list);
    fill(state, 300, random);

    const auto slipOf = [&](const verletList::spherePair& p)
    {
        return vector
        (
            state.id[state.sphereBody[p.i]],
            state.id[state.sphereBody[p.j]],
            p.i - state.firstSphere[state.sphereBody[p.i]]
          + 100*(p.j - state.firstSphere[state.sphereBody[p.j]])
        );
    };
    const auto touches = [&](const verletList::spherePair& p)
    {
        return
            mag(state.sphereX()[p.i] - state.sphereX()[p.j])
          < state.sphereR[p.i] + state.sphereR[p.j];
    };

    verletList neighbours(0.5);
    neighbours.build(packedBodies(state));
    std::vector<verletList::pairHistory> slips;
    neighbours.pairs().forEach([&](const verletList::spherePair& p)
    {
        if (touches(p))
        {
            slips.push_back({p, slipOf(p)});
        }
    });
    Foam::List<verletList::pairHistory> saved(slips.size());
    std::copy(slips.begin(), slips.end(), saved.begin());
    neighbours.setHistories(saved, {});
    neighbours.build(packedBodies(state));

    const auto check = [&]()
    {
        const auto found = neighbours.histories();
        label n = 0;
        neighbours.pairs().forEach
        (
            [&](const verletList::spherePair& p) { n += touches(p); }
        );
        EXPECT_EQ(found.size(), n);
        for (const verletList::pairHistory& h : found)
        {
            EXPECT_EQ(h.xi, slipOf(h.pair));
        }
        return n;
    };

    const label before = check();
    EXPECT_GT(before, 100);
    neighbours.build(packedBodies(state));
    EXPECT_EQ(check(), before);

    // Remove every third body
    Foam::boolList marked(state.size(), false);
    Foam::labelList newIndex(state.nSpheres(), -1);
    for (label b = 0; b < state.size(); b += 3)
    {
        marked[b] = true;
    }
    label n = 0;
    for (label s = 0; s < state.nSpheres(); ++s)
    {
        if (!marked[state.sphereBody[s]])
        {
            newIndex[s] = n++;
        }
    }
    state.remove(marked);
    neighbours.renumber(newIndex);
    EXPECT_TRUE(neighbours.outdated(packedBodies(state)));
    neighbours.build(packedBodies(state));
    const label left = check();
    EXPECT_GT(left, 40);

    // Any order of the bodies: what a contact remembers is seen from the other
    // sphere where that is the lower one now
    Foam::labelList order(Foam::identity(state.size()));
    std::shuffle(order.begin(), order.end(), random);
    const Foam::labelList first(state.firstSphere.list());
    state.take(order);
    neighbours.renumber(state.sphereMap(first, order));
    const auto found = neighbours.histories();
    EXPECT_EQ(found.size(), left);
    label nTurned = 0;
    for (label k = 0; k < found.size(); ++k)
    {
        const verletList::spherePair& p = found[k].pair;
        const verletList::spherePair other(p.j, p.i);
        EXPECT_TRUE(p.i < p.j && touches(p));
        EXPECT_TRUE
        (
            found[k].xi == slipOf(p) || found[k].xi == -slipOf(other)
        );
        nTurned += found[k].xi != slipOf(p);
        EXPECT_TRUE
        (
            k == 0
         || Foam::dem::contactBlocks::before(found[k - 1].pair, p)
        );
    }
    EXPECT_GT(nTurned, 10);
    EXPECT_LT(nTurned, left - 10);
    neighbours.build(packedBodies(state));
    EXPECT_EQ(neighbours.histories().size(), left);
}


// ************************************************************************* //
