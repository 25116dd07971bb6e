/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    Of many bodies some things are kept shorter and given back sooner than of
    few: that must not be seen. Tiles of a few bodies side by side, of which
    each has the same neighbours, move as one of them does alone.

\*---------------------------------------------------------------------------*/

#include "demCase.H"
#include "areMany.H"
#include "figure.H"
#include "heldVectors.H"
#include "placement.H"

#include <algorithm>
#include <numeric>
#include <random>

using namespace styxTest;
using namespace Foam::dem;
using Foam::mag;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Balls in each direction of a tile, and the distance between them [m]
constexpr label n = 16;
constexpr scalar pitch = 0.0096;


//- Tiles in each of three directions, which are cyclic, of balls that push each
//  other apart. Balls k of all tiles have ids that follow each other
std::unique_ptr<demCase> tiles(const label nTiles)
{
    auto c = std::make_unique<demCase>
    (
        "demSolver hades;\n"
        "materials { gum { density 1000; youngsModulus 1e5;"
        " poissonsRatio 0.3; } }\n"
        "pairs { gum-gum { restitution 0.6; friction 0.4; } }\n"
        "shapes { ball { type sphere; diameter 0.01; } }\n"
        "stepControl { type fixed; deltaT 1e-4; }\n",
        vector(Foam::Zero),
        Foam::List<corners>(),
        [=](demInput& input)
        {
            input.mayReorder = true;
            for (Foam::direction d = 0; d < 3; ++d)
            {
                periodicity::seam s;
                s.normal = Foam::Zero;
                s.normal[d] = 1;
                s.low = 0;
                s.separation = Foam::Zero;
                s.separation[d] = nTiles*n*pitch;
                input.period.append(s);
            }
        }
    );

    std::mt19937 random(3);
    const auto uniform = [&]() { return random()/2147483648.0 - 1; };
    const auto any = [&]() { return vector(uniform(), uniform(), uniform()); };
    std::vector<label> place(n*n*n);
    std::iota(place.begin(), place.end(), 0);
    std::shuffle(place.begin(), place.end(), random);
    for (const label k : place)
    {
        newBody b;
        b.shapeI = 0;
        b.materialI = 0;
        b.density = 1000;
        b.velocity = 0.02*any();
        b.angularVelocity = 20*any();
        const vector inTile
        (
            pitch*vector(k % n + 0.5, k/n % n + 0.5, k/n/n + 0.5) + 2e-4*any()
        );
        for (label i = 0; i < nTiles*nTiles*nTiles; ++i)
        {
            // Not one beside the other: they are out of order
            const label t = 10*i % (nTiles*nTiles*nTiles);
            const vector tile
            (
                t % nTiles, t/nTiles % nTiles, t/nTiles/nTiles
            );
            b.position = inTile + n*pitch*tile;
            c->state().append(b);
        }
    }
    return c;
}


//- The largest difference of vectors of the bodies of many tiles from those of
//  one, over the largest of these
scalar worst
(
    const bodies& one,
    const bodies& many,
    const std::function<vector(const bodies&, label)>& of
)
{
    const label nTiles = many.size()/one.size();
    scalar off = 0, largest = 0;
    for (label b = 0; b < many.size(); ++b)
    {
        const vector v(of(one, one.find(many.id[b]/nTiles)));
        off = std::max(off, mag(of(many, b) - v));
        largest = std::max(largest, mag(v));
    }
    return off/largest;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(demMany, asFew)
{
    const auto few = tiles(1);
    const auto many = tiles(3);
    EXPECT_FALSE(areMany(few->state().nSpheres()));
    EXPECT_TRUE(areMany(many->state().nSpheres()));

    label nTwice = 0, nOrders = 0, nContacts = 0;
    scalar moved = 0, pushed = 0, turned = 0;
    for (label i = 0; i < 6; ++i)
    {
        for (demCase* c : {few.get(), many.get()})
        {
            nOrders += c->solver().order();
            c->solver().advance(i*1e-3, (i + 1)*1e-3);
        }
        const advanceReport& a = few->solver().report();
        const advanceReport& b = many->solver().report();
        EXPECT_EQ(27*a.nContacts, b.nContacts);
        EXPECT_EQ(a.nTwice, b.nTwice);
        EXPECT_EQ(a.nBack + b.nBack, 0);
        nTwice += b.nTwice;
        nContacts = b.nContacts;

        const auto largest = [&](scalar& off, const auto& of)
        {
            off = std::max(off, worst(few->state(), many->state(), of));
        };
        largest(moved, [](const bodies& s, label b) { return s.v[b]; });
        largest(pushed, [](const bodies& s, label b) { return s.force[b]; });
        largest(turned, [](const bodies& s, label b) { return s.torque[b]; });
    }

    // Where an advance is gone back over, slips have seven digits
    figure("many_contacts", nContacts, 1e5, noBar, "contacts", "");
    figure("many_twice", nTwice, 1, noBar, "advances made twice", "of 6");
    figure("many_orders", nOrders, 1, noBar, "", "of many");
    figure("many_velocity", moved, 0, 1e-7, "of the largest", "one tile");
    figure("many_force", pushed, 0, 1e-7, "of the largest", "one tile");
    figure("many_torque", turned, 0, 1e-6, "of the largest", "one tile");
}


TEST(demMany, places)
{
    // How far a ball has gone from where it was is seen to a thousandth of how
    // far it may go
    const auto c = tiles(3);
    packedBodies packed(c->state());
    placement far, near;
    const scalar may = 5e-4;
    far.start(packed, may, 1, 0.02);
    far.setPlaces(packed);
    EXPECT_TRUE(far.x.empty());
    near.start(packed, 0.1*may, 1, 0.25);
    near.setPlaces(packed, far);

    const label nBalls = packed.nSpheres();
    const label balls[] = {0, 63, 64, nBalls/2, nBalls - 1};
    scalar off = 0;
    for (const label s : balls)
    {
        for (const auto* p : {&far, &near})
        {
            const scalar whole = p == &far ? may : 0.1*may;
            packed.shift(s, vector(0, 0.3*whole, -0.4*whole));
            placement moved(*p);
            moved.moved = moved.left + whole;
            EXPECT_FALSE(moved.over(packed, far));
            off = std::max(off, mag(moved.left/whole - 0.5));
            packed.shift(s, vector(0, 0.3*whole, -0.4*whole));
            moved.moved = moved.left + whole;
            EXPECT_TRUE(moved.over(packed, far));
            packed.shift(s, -2*vector(0, 0.3*whole, -0.4*whole));
        }
    }
    figure("many_places", off, 0, 1e-3, "of the way", "moved by half of it");
}


TEST(demMany, equal)
{
    // What is the same for all takes no memory, until one is not
    heldSame<scalar> mass;
    for (label i = 0; i < 3; ++i)
    {
        mass.append(2.5);
    }
    EXPECT_TRUE(mass.same());
    EXPECT_EQ(mass.size(), 3);
    EXPECT_EQ(mass[2], 2.5);
    mass.append(1.5);
    EXPECT_FALSE(mass.same());
    EXPECT_EQ(mass.list(), Foam::List<scalar>({2.5, 2.5, 2.5, 1.5}));
    mass.clear();
    mass.append(1.5);
    EXPECT_TRUE(mass.same());
    EXPECT_EQ(mass.list(), Foam::List<scalar>({1.5}));
}


// ************************************************************************* //
