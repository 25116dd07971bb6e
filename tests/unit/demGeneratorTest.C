/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description

Description
    Generators: the same numbers whenever they are asked for, uniform
    orientations, and no body where there is no room.

\*---------------------------------------------------------------------------*/

#include "demCase.H"

#include <cmath>

using namespace styxTest;
using namespace Foam::dem;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

std::string properties(const std::string& keys, const std::string& bodies = "")
{
    return
        "demSolver hades;\n"
        "materials { stuff { density 2500; youngsModulus 1e7;"
        " poissonsRatio 0.3; } }\n"
        "pairs { stuff-stuff { restitution 0.5; friction 0.3; } }\n"
      + cubeOfNine
      + "stepControl { type hades; }\n"
        "walls { floor { type plane; point (0 0 0); normal (0 0 1);"
        " material stuff; } }\n"
      + bodies
      + "generators { pipe { type rate; shape cube; material stuff;\n"
        "region { box (0 0 1) (0.1 0.2 1.3); } rate 10; total 1000;\n"
      + keys + " } }\n";
}


//- Body number n where there is room everywhere
newBody made(const generator& g, const label n)
{
    newBody b;
    EXPECT_TRUE(g.make(n, [](const newBody&) { return true; }, b));
    return b;
}


bool equal(const newBody& a, const newBody& b)
{
    return
        a.position == b.position && a.velocity == b.velocity
     && a.orientation == b.orientation && a.shapeI == b.shapeI;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(demGenerator, deterministic)
{
    demCase a(properties("seed 3; velocity (0 0 -1);"));
    demCase b(properties("seed 3; velocity (0 0 -1);"));
    demCase other(properties("seed 4;"));

    const generator& first = a.solver().generators()[0];
    const generator& second = b.solver().generators()[0];

    // In any order, as after a restart
    for (const label n : {7, 0, 999, 3, 7})
    {
        EXPECT_TRUE(equal(made(first, n), made(second, n)));
    }
    EXPECT_FALSE(equal(made(first, 1), made(first, 2)));
    EXPECT_NE
    (
        made(first, 1).position,
        made(other.solver().generators()[0], 1).position
    );
    EXPECT_EQ(made(first, 5).velocity, vector(0, 0, -1));
}


TEST(demGenerator, uniform)
{
    demCase c(properties(""));
    const generator& g = c.solver().generators()[0];

    vector axis(Foam::Zero);
    Foam::tensor square(Foam::Zero);
    vector place(Foam::Zero);
    const label n = 2000;
    for (label i = 0; i < n; ++i)
    {
        const newBody b = made(g, i);
        EXPECT_NEAR(mag(b.orientation), 1, 1e-14);

        const vector e = b.orientation.transform(vector(0, 0, 1));
        axis += e/n;
        square += e*e/n;
        place += b.position/n;
    }

    // Four standard deviations
    EXPECT_LT(mag(place - vector(0.05, 0.1, 1.15)), 0.01);
    EXPECT_LT(mag(axis), 4/std::sqrt(scalar(n)));
    figure
    (
        "generatorOrientation",
        mag(square - Foam::tensor::I/3),
        0,
        4*std::sqrt(2.0/3.0/n),
        "-",
        "uniform over all rotations"
    );
}


TEST(demGenerator, inTime)
{
    demCase c(properties("start 0.5;"));
    demSolver& solver = c.solver();

    const scalar times[] = {0, 0.49, 0.5, 0.59, 0.6, 0.7, 1};
    const label sizes[] = {0, 0, 1, 1, 2, 3, 6};
    for (int i = 0; i < 7; ++i)
    {
        solver.enter(times[i]);
        EXPECT_EQ(solver.state().size(), sizes[i]) << times[i];
        EXPECT_EQ
        (
            solver.report().nEntered,
            sizes[i] - (i ? sizes[i - 1] : 0)
        );
    }
    EXPECT_EQ(c.solver().generators()[0].nEntered(), 6);

    // The same bodies, if it starts again after three
    demCase again(properties("start 0.5;"));
    again.solver().generators()[0].setEntered(3);
    again.solver().enter(1);
    ASSERT_EQ(again.state().size(), 3);
    for (label i = 0; i < 3; ++i)
    {
        EXPECT_EQ(again.state().x[i], c.state().x[i + 3]);
    }
}


TEST(demGenerator, waitsForRoom)
{
    // Bodies in the way, and a region that is too small for two of them
    demCase c
    (
        properties
        (
            "",
            "bodies { inTheWay { shape cube; material stuff;"
            " position (0.05 0.1 1.15); } }\n"
        )
    );
    c.solver().enter(3);
    bodies& state = c.state();
    EXPECT_EQ(state.size(), 32);
    for (label j = 0; j < state.nSpheres(); ++j)
    {
        for (label i = 0; i < j; ++i)
        {
            if (state.sphereBody[i] != state.sphereBody[j])
            {
                EXPECT_GE
                (
                    mag(state.sphereX[i] - state.sphereX[j]),
                    state.sphereR[i] + state.sphereR[j]
                );
            }
        }
    }

    std::string tight = properties("");
    const std::string box("(0 0 1) (0.1 0.2 1.3)");
    tight.replace
    (
        tight.find(box),
        box.size(),
        "(0 0 1) (0.001 0.001 1.001)"
    );
    demCase one(tight);
    testing::internal::CaptureStdout();
    one.solver().enter(3);
    testing::internal::GetCapturedStdout();
    EXPECT_EQ(one.state().size(), 1);
    EXPECT_EQ(one.solver().generators()[0].nEntered(), 1);

    // It comes when the first has left
    one.solver().remove(Foam::boolList(1, true));
    testing::internal::CaptureStdout();
    one.solver().enter(3);
    testing::internal::GetCapturedStdout();
    EXPECT_EQ(one.solver().generators()[0].nEntered(), 2);
    EXPECT_EQ(one.state().id[0], 1);
}


// ************************************************************************* //
