/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    The order of bodies in memory: beam by beam; a new order in the middle of
    collisions changes nothing but round-off.

\*---------------------------------------------------------------------------*/

#include "demCase.H"
#include "figure.H"

#include "dictionary.H"
#include "spatialOrder.H"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <random>

using namespace styxTest;
using namespace Foam::dem;
using Foam::mag;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Bodies in each direction, and the distance between them [m]
constexpr label n = 16;
constexpr scalar pitch = 0.0108;


//- Contacts that remember all that there is to remember
const std::string allLaws
(
    "contact { rolling elasticPlastic; torsion elasticPlastic; }\n"
    "pairs { gum-gum { restitution 0.6; friction 0.4;"
    " rollingFriction 0.1; torsionalFriction 0.1; } }\n"
);


//- A gas of balls and pairs, cyclic in two directions, between a floor and
//  nothing
std::unique_ptr<demCase> gas
(
    const bool mayReorder,
    const std::string& laws = allLaws
)
{
    auto c = std::make_unique<demCase>
    (
        "demSolver hades;\n"
        "materials { gum { density 1000; youngsModulus 1e5;"
        " poissonsRatio 0.3; } }\n" + laws +
        "shapes { ball { type sphere; diameter 0.01; }"
        " pair { type multisphere; spheres (((-0.001 0 0) 0.004)"
        " ((0.001 0.0005 0) 0.0035)); } }\n"
        "stepControl { type fixed; deltaT 1e-4; }\n"
        "walls { floor { type plane; point (0 0 0); normal (0 0 1);"
        " material gum; } }\n"
        "sleeping { speed 0.02; time 0.005; }\n",
        gravity,
        Foam::List<corners>(),
        [=](demInput& input)
        {
            input.mayReorder = mayReorder;
            for (Foam::direction d = 0; d < 2; ++d)
            {
                periodicity::seam s;
                s.normal = Foam::Zero;
                s.normal[d] = 1;
                s.low = 0;
                s.separation = Foam::Zero;
                s.separation[d] = n*pitch;
                input.period.append(s);
            }
        }
    );

    std::mt19937 random(3);
    const auto uniform = [&]() { return random()/2147483648.0 - 1; };
    std::vector<label> place(n*n*n);
    std::iota(place.begin(), place.end(), 0);
    std::shuffle(place.begin(), place.end(), random);
    for (const label k : place)
    {
        newBody b;
        b.shapeI = k % 3 == 0;
        b.materialI = 0;
        b.density = 1000;
        b.position = pitch*vector(k % n, k/n % n, k/n/n)
          + vector(0.5*pitch, 0.5*pitch, 0.5*pitch);
        b.velocity = 0.5*vector(uniform(), uniform(), uniform());
        b.angularVelocity = 50*vector(uniform(), uniform(), uniform());
        c->state().append(b);
    }
    return c;
}


//- What contacts remember, by the ids of the bodies
std::map<std::array<label, 5>, std::vector<scalar>> memory(demCase& c)
{
    std::map<std::array<label, 5>, std::vector<scalar>> all;
    const bodies& state = c.state();
    const contactHistory history(c.solver().history());
    for (const verletList::pairHistory& h : history.pairs)
    {
        const label i = state.sphereBody[h.pair.i];
        const label j = state.sphereBody[h.pair.j];
        EXPECT_LT(state.id[i], state.id[j]);
        std::vector<scalar>& m = all
        [{
            state.id[i], h.pair.i - state.firstSphere[i],
            state.id[j], h.pair.j - state.firstSphere[j], h.pair.image
        }];
        m.assign(h.xi.cdata(), h.xi.cdata() + 3);
        m.insert(m.end(), h.rate, h.rate + 4);
        m.insert(m.end(), h.rolled, h.rolled + 4);
    }
    for (const wallTouch& t : history.walls)
    {
        const label b = state.sphereBody[t.sphere];
        std::vector<scalar>& m =
            all[{state.id[b], t.sphere - state.firstSphere[b], -1, 0, 0}];
        m.assign(t.xi.cdata(), t.xi.cdata() + 3);
        m.insert(m.end(), t.rate, t.rate + 4);
    }
    return all;
}


Foam::labelList looksAtRest(demCase& c)
{
    Foam::dictionary dict;
    c.solver().writeCounters(dict);
    return dict.subDict("sleeping").get<Foam::labelList>("looksAtRest");
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(demOrder, beams)
{
    // A mean radius of 0.3 m makes cubes of 0.5 m, 64 of them a slice of a beam
    // of 4 m
    const spatialOrder order(0.3);
    const point corner(3, -8, 8);
    for (label k = 0; k < 128; ++k)
    {
        const vector cube(k/64, k % 8, k/8 % 8);
        const point x(corner + 0.5*cube + vector(0.1, 0.2, 0.4));
        EXPECT_EQ(order.keyOf(x), order.keyOf(corner) + k);
    }

    // The whole beam, then the next one in y, then that in z
    const point next[] =
    {
        {3, -4.1, 11.9}, {1e4, -7.9, 8.1}, {-1e4, -3.9, 8.1}, {-1e4, -9, 12.1}
    };
    for (label k = 0; k < 3; ++k)
    {
        EXPECT_LT(order.keyOf(next[k]), order.keyOf(next[k + 1])) << k;
    }

    // Beyond the last cube
    EXPECT_EQ(order.keyOf({1e9, 0, 0}), order.keyOf({1e12, 0, 0}));
    EXPECT_EQ(order.keyOf({-1e9, 0, 0}), order.keyOf({-1e300, 0, 0}));

    // Bodies in one cube are in the order of their ids
    const Foam::List<point> x({{5, 5, 5}, {0, 0, 0}, {5.1, 5, 5}, {0, 0, 0.1}});
    EXPECT_EQ
    (
        order.order(x, Foam::labelList({7, 9, 3, 8})),
        Foam::labelList({3, 1, 2, 0})
    );
}


TEST(demOrder, disorder)
{
    const auto c = gas(true);
    const bodies& state = c->state();
    const spatialOrder order(0.005);
    figure("order_disorderRandom", order.disorder(state.x), 0.45, 0.5, "",
        "two bodies at random: a half, less those in one cube");

    c->solver().order();
    figure("order_disorderAfter", order.disorder(state.x), 0, 0, "", "exact");

    // A body is found by its id in any order
    label nLost = 0;
    forAll(state.id, b)
    {
        nLost += state.find(state.id[b]) != b;
    }
    nLost += state.find(n*n*n) != -1;
    figure("order_lost", nLost, 0, 0, "bodies", "exact");
    EXPECT_FALSE(c->solver().order());
}


TEST(demOrder, fewStay)
{
    const auto c = gas(true);
    Foam::boolList marked(c->state().size(), false);
    std::fill(marked.begin() + 2000, marked.end(), true);
    c->solver().remove(marked);
    EXPECT_FALSE(c->solver().order());
    EXPECT_FALSE(gas(false)->solver().order());
}


TEST(demOrder, inCollisions)
{
    const auto ordered = gas(true);
    const auto asGiven = gas(false);
    scalar worst = 0;
    label nContacts = 0, nOrders = 0;
    for (label step = 0; step < 4; ++step)
    {
        ordered->run(0.006);
        asGiven->run(0.006);

        // From step to step as a restart would, or as bodies have moved
        const auto before = memory(*ordered);
        const Foam::labelList rest(looksAtRest(*ordered));
        nOrders += ordered->solver().order();
        const auto after = memory(*ordered);
        nContacts = label(before.size());
        EXPECT_TRUE(before == after);
        EXPECT_EQ(rest, looksAtRest(*ordered));

        const bodies& a = ordered->state();
        const bodies& b = asGiven->state();
        forAll(b.x, k)
        {
            worst = std::max(worst, mag(a.x[a.find(b.id[k])] - b.x[k]));
        }
    }
    figure("order_contacts", nContacts, 500, noBar, "contacts",
        "so many keep their memory");
    figure("order_orders", nOrders, 4, 4, "", "after each saving");
    figure("order_path", worst/0.01, 0, 1e-9, "diameters",
        "the same without an order");
}


TEST(demOrder, restart)
{
    // Torques of rolling are added in groups that depend on the list, so that
    // their round-off is not the same after a restart
    const std::string laws
    (
        "pairs { gum-gum { restitution 0.6; friction 0.4; } }\n"
    );
    const auto whole = gas(true, laws);
    whole->solver().order();
    whole->run(0.006);
    whole->solver().order();
    whole->run(0.006);

    // What a restart has: bodies in the order of their ids
    Foam::dictionary counters;
    whole->solver().writeCounters(counters);
    contactHistory history(whole->solver().history());
    const bodies& all = whole->state();
    const auto second = gas(true, laws);
    bodies& state = second->state();
    state.clear();
    Foam::DynamicList<bodyRecord> records;
    for (const label b : all.byId())
    {
        records.append(all.record(b));
    }
    state.take(Foam::identity(records.size()), records);
    const auto number = [&](const label s)
    {
        const label b = all.sphereBody[s];
        return state.firstSphere[all.id[b]] + s - all.firstSphere[b];
    };
    for (verletList::pairHistory& h : history.pairs)
    {
        h.pair.i = number(h.pair.i);
        h.pair.j = number(h.pair.j);
    }
    for (wallTouch& t : history.walls)
    {
        t.sphere = number(t.sphere);
    }
    second->solver().setHistory(history);
    second->solver().readCounters(counters);

    scalar worst = 0;
    for (demCase* c : {whole.get(), second.get()})
    {
        EXPECT_TRUE(c->solver().order());
        c->solver().advance(0.012, 0.018);
    }
    forAll(all.x, b)
    {
        EXPECT_EQ(all.id[b], state.id[b]);
        worst = std::max(worst, mag(all.x[b] - state.x[b]));
    }
    figure("order_restart", worst, 0, 0, "m", "exact");
}


TEST(demOrder, removal)
{
    const auto c = gas(true);
    c->run(0.006);
    c->solver().order();
    const auto before = memory(*c);

    // Every third, by id
    bodies& state = c->state();
    Foam::boolList marked(state.size());
    forAll(marked, b)
    {
        marked[b] = state.id[b] % 3 == 0;
    }
    c->solver().remove(marked);
    const auto after = memory(*c);

    label nWrong = 0, nLeft = 0;
    for (const auto& m : before)
    {
        const bool stays = m.first[0] % 3
         && (m.first[2] < 0 || m.first[2] % 3);
        nLeft += stays;
        const auto found = after.find(m.first);
        nWrong += stays != (found != after.end())
         || (stays && found->second != m.second);
    }
    figure("order_removal", nWrong, 0, 0, "contacts", "exact");
    EXPECT_GT(nLeft, 100);
    EXPECT_EQ(label(after.size()), nLeft);
    c->run(0.006);
}


// ************************************************************************* //
