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
#include <cstdio>
#include <fstream>

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
                    mag(state.sphereX()[i] - state.sphereX()[j]),
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


TEST(demGenerator, fileOfBodies)
{
    // Names in the first line, comments, several separators, a clump that is
    // turned, sizes
    std::ofstream("bodies.csv")
        << "# made by hand\n"
           "x, y, z, vx, vy, vz, shape, diameter, ax, ay, az, angle, -\n"
           "0, 0, 10, 1, 2, 3, ball, 4, 0, 0, 1, 0, one   # as it is\n"
           "\n"
           "10;20;30; 0;0;0; rod; 2; 0;0;1; 90; two\n";
    const std::string head =
        "demSolver hades;\nmaterials { s { density 1000; youngsModulus 1e7;"
        " poissonsRatio 0.3; } w { youngsModulus 1e7; poissonsRatio 0.3; } }\n"
        "pairs { s-s { restitution 0.5; friction 0; }"
        " s-w { restitution 0.5; friction 0; } }\n"
        "shapes { ball { type sphere; diameter 0.001; }"
        " rod { type multisphere; spheres (((0 0 0) 0.001)"
        " ((0.002 0 0) 0.001)); } }\nstepControl { type contact; }\n";
    const std::string file =
        "generators { bed { type file; file \"bodies.csv\"; material s;"
        " scale 1e-3; start 1; } }\n";
    demCase c(head + file);
    c.solver().enter(0);
    EXPECT_EQ(c.state().size(), 0);
    c.solver().enter(1);
    ASSERT_EQ(c.state().size(), 2);
    c.solver().enter(2);
    EXPECT_EQ(c.state().size(), 2);

    const Foam::dem::bodies& b = c.state();
    const scalar volume = Foam::constant::mathematical::pi/6*8e-9;
    figure
    (
        "generatorFile",
        mag(b.x[0] - point(0, 0, 0.01)) + mag(b.x[1] - point(0.01, 0.02, 0.03))
      + mag(b.v[0] - vector(1, 2, 3)) + std::abs(b.sphereR[0] - 0.002)
      + std::abs(b.mass[1]/(1000*volume) - 1)
      + std::abs((b.sphereX()[2] - b.sphereX()[1]).x()),
        0,
        1e-12,
        "SI",
        "places, velocity, size, mass and rotation as in the file"
    );
    EXPECT_GT((b.sphereX()[2] - b.sphereX()[1]).y(), 0);

    const auto says = [&](const std::string& lines, const std::string& entries)
    {
        std::ofstream("bodies.csv") << lines;
        return messageOf([&]()
        {
            demCase bad
            (
                head + "generators { bed { type file; file \"bodies.csv\"; "
              + entries + " } }\n"
            );
            bad.solver().enter(0);
        });
    };
    const std::string both = "shape ball; material s;";
    struct
    {
        std::string lines, entries;
        std::vector<std::string> parts;
    } const wrong[] =
    {
        {"0 0 0\n0 0 1 2\n", both, {"bodies.csv, line 2", "4 words", "x y z"}},
        {"0 0 0\n0 0 nan\n", both, {"line 2", "column z", "'nan'"}},
        {"0 0 0\n0 zero 1\n", both, {"line 2", "column y", "'zero'"}},
        {"x y z u\n0 0 0 1\n", both, {"line 1", "named u", "vx"}},
        {"x y z x\n0 0 0 1\n", both, {"line 1", "x stands twice"}},
        {"x y vx\n0 0 0\n", both, {"line 1", "all of x y z"}},
        {"x y z vx\n0 0 0 1\n", both, {"line 1", "all of vx vy vz"}},
        {"x y z shape\n0 0 0 egg\n", "material s;", {"line 2", "egg", "rod"}},
        {"x y z material\n0 0 0 w\n", "shape ball;",
            {"line 2", "no material w with a density"}},
        {"x y z diameter\n0 0 0 -1\n", both, {"line 2", "diameter"}},
        {"x y z ax ay az angle\n0 0 0 0 0 0 5\n", both, {"line 2", "axis"}},
        {"0 0 0\n", "shape ball;", {"material", "missing"}},
        {"x y z shape\n0 0 0 ball\n", both, {"shape", "too"}},
        {"# none\n", both, {"holds no body"}},
        {"0 0 0\n0 0 0.0005\n", both, {"line 2", "overlaps", "start relax"}},
        {"0 0 0\n", both + " number 5;", {"number"}}
    };
    for (const auto& w : wrong)
    {
        const std::string said = says(w.lines, w.entries);
        for (const std::string& part : w.parts)
        {
            EXPECT_NE(said.find(part), std::string::npos)
                << part << '\n' << said;
        }
    }
    EXPECT_EQ(says("0 0 0\n0 0 0.0009995\n", both), "");
    std::remove("bodies.csv");
    const std::string said = messageOf([&]()
    {
        demCase bad
        (
            head + "generators { bed { type file; file \"none.csv\"; " + both
          + " } }\n"
        );
    });
    EXPECT_NE(said.find("cannot be read"), std::string::npos) << said;
}


TEST(demGenerator, fileIsRelaxed)
{
    std::ofstream("bodies.csv") << "0 0 0\n0 0 0.0005\n";
    demCase c
    (
        "start relax;\ndemSolver hades;\nmaterials { s { density 1000;"
        " youngsModulus 1e7; poissonsRatio 0.3; } }\n"
        "pairs { s-s { restitution 0.5; friction 0; } }\n"
        "shapes { ball { type sphere; diameter 0.001; } }\n"
        "stepControl { type contact; }\ngenerators { bed { type file;"
        " file \"bodies.csv\"; shape ball; material s; } }\n"
    );
    c.solver().enter(0);
    figure("generatorFileRelaxed", mag(c.state().x[0] - c.state().x[1]),
        0.001, 0.0010006, "m", "two that overlapped by half touch");
    std::remove("bodies.csv");
}


// ************************************************************************* //
