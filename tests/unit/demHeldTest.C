/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    Forces of the fluid take no memory until there is one, and go with the
    bodies; what contacts remember stays when it grows and moves.

\*---------------------------------------------------------------------------*/

#include "figure.H"
#include "laneNumbers.H"
#include "bodies.H"

#include <gtest/gtest.h>

using Foam::label;
using Foam::scalar;
using Foam::vector;
using namespace Foam::dem;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(demHeld, forcesOfTheFluid)
{
    Foam::PtrList<shape> shapes(1);
    shapes.set(0, new shape(shape::sphere("ball", 1)));
    bodies state(shapes);
    for (label b = 0; b < 5; ++b)
    {
        newBody n = {};
        n.density = 1;
        n.position = vector(3*b, 0, 0);
        state.append(n);
    }
    const bodies& read = state;
    EXPECT_EQ(read.fluidForce.size(), 5);
    EXPECT_EQ(read.fluidForce[4], vector::zero);
    state.setState(2, state.record(2));
    state.take(Foam::labelList({4, 3, 2, 1}));
    EXPECT_TRUE(state.fluidForce.none());
    EXPECT_TRUE(state.fluidTorque.none());

    state.fluidForce[1] = vector(0, 1, 0);
    EXPECT_FALSE(state.fluidForce.none());
    EXPECT_EQ(read.fluidForce[0], vector::zero);
    bodyRecord other = state.record(0);
    other.fluidForce = vector(0, 2, 0);
    other.fluidTorque = vector(0, 0, 3);
    state.take
    (
        Foam::labelList({1, 4, 0}),
        Foam::List<bodyRecord>(1, other)
    );
    EXPECT_EQ
    (
        read.fluidForce.list(),
        Foam::List<vector>({{0, 1, 0}, {0, 2, 0}, {0, 0, 0}})
    );
    EXPECT_EQ
    (
        read.fluidTorque.list(),
        Foam::List<vector>({{0, 0, 0}, {0, 0, 3}, {0, 0, 0}})
    );
}


//- How many numbers of lanes are lost
template<class Number>
static label lostNumbers()
{
    const label W = 4, n = 3;
    laneNumbers<Number> numbers;
    label lost = 0;
    const auto check = [&](const label lane, const scalar value)
    {
        scalar got[n];
        numbers.get(got, n, lane, W);
        for (label k = 0; k < n; ++k)
        {
            lost += got[k] != value + k;
        }
    };

    // From a few to more than a page, so that it moves and grows in place
    label before = 0;
    for (const label nLanes : {4, 8, 400, 40000, 4000000})
    {
        numbers.setSize(n*nLanes);
        EXPECT_EQ(reinterpret_cast<std::size_t>(numbers.data()) % 64, 0u);
        for (label lane = before; lane < nLanes; ++lane)
        {
            scalar zero[n];
            numbers.get(zero, n, lane, W);
            lost += zero[0] != 0 || zero[n - 1] != 0;
            const scalar value[n] =
                {scalar(lane), scalar(lane + 1), scalar(lane + 2)};
            numbers.put(value, n, lane, W);
        }
        before = nLanes;
        for (label lane = 0; lane < nLanes; ++lane)
        {
            check(lane, lane);
        }
    }
    numbers.move(399, n, 5, W);
    check(5, 399);
    check(4, 4);
    check(6, 6);
    return lost;
}


TEST(demHeld, memoryOfContacts)
{
    const label lost = lostNumbers<double>() + lostNumbers<float>();
    styxTest::figure
    (
        "laneNumbers_lost", lost, 0, 0, "numbers", "what was written"
    );
}


// ************************************************************************* //
