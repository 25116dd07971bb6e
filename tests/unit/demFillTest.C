/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    Bodies that come in many at once: batches, regions that are filled, and the
    grid that finds room for them.

\*---------------------------------------------------------------------------*/

#include "demCase.H"
#include "roomGrid.H"

#include <chrono>
#include <cmath>
#include <random>

using namespace styxTest;
using namespace Foam::dem;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const std::string ball("shapes { ball { type sphere; diameter 0.01; } }\n");

//- A case with one generator
std::string properties
(
    const std::string& generator,
    const std::string& shapes = ball,
    const std::string& walls = ""
)
{
    return
        "demSolver hades;\n"
        "materials { stuff { density 2500; youngsModulus 1e7;"
        " poissonsRatio 0.3; } }\n"
        "pairs { stuff-stuff { restitution 0.5; friction 0.3; } }\n"
        "stepControl { type hades; }\n"
      + shapes + walls
      + "generators { source { material stuff; " + generator + " } }\n";
}


void enter(demCase& c, const scalar t)
{
    testing::internal::CaptureStdout();
    c.solver().enter(t);
    testing::internal::GetCapturedStdout();
}


//- A domain that repeats itself after 1 m along x
periodicity everyMetre()
{
    periodicity p;
    p.append(periodicity::seam{vector(1, 0, 0), 0, vector(1, 0, 0)});
    return p;
}


//- The smallest distance of surfaces of different bodies over the sum of
//  their radii; from all pairs, and from those of images beyond a seam
scalar smallestGap(const bodies& state, const periodicity& period)
{
    scalar gap = Foam::GREAT;
    for (label i = 0; i < state.nSpheres(); ++i)
    {
        for (label j = 0; j < i; ++j)
        {
            if (state.sphereBody[i] == state.sphereBody[j])
            {
                continue;
            }
            const scalar sum = state.sphereR[i] + state.sphereR[j];
            const vector way = state.sphereX()[i] - state.sphereX()[j];
            gap = Foam::min(gap, mag(way)/sum - 1);
            period.forEachImage
            (
                state.sphereX()[i],
                Foam::GREAT,
                [&](const label image)
                {
                    gap = Foam::min
                    (
                        gap,
                        mag(way + period.shift(image))/sum - 1
                    );
                }
            );
        }
    }
    return gap;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(demFill, batch)
{
    demCase c
    (
        properties
        (
            "type batch; shape ball; region { box (0 0 0) (1 1 1); }"
            " times (0.1 0.3 1); number 7;"
        )
    );
    const scalar times[] = {0, 0.09, 0.1, 0.29, 0.3 - 1e-13, 0.99, 1, 9};
    const label sizes[] = {0, 0, 7, 7, 14, 14, 21, 21};
    for (int i = 0; i < 8; ++i)
    {
        c.solver().enter(times[i]);
        EXPECT_EQ(c.state().size(), sizes[i]) << times[i];
    }
    EXPECT_EQ(c.solver().plans()[0].total, 21);
}


TEST(demFill, fraction)
{
    // Spheres alone, in a domain that repeats itself along x
    demCase c
    (
        properties
        (
            "type fill; shape ball; fraction 0.25;"
            " region { box (-0.01 0 0) (1.01 0.1 0.1); }"
        ),
        Foam::Zero,
        Foam::List<corners>(),
        [](demInput& input) { input.period = everyMetre(); }
    );
    enter(c, 0);
    const generator& g = c.solver().generators()[0];
    EXPECT_EQ(g.nLeftOut(), 0);
    EXPECT_EQ(c.state().size(), g.nEntered());

    scalar volume = 0;
    for (label b = 0; b < c.state().size(); ++b)
    {
        volume += c.state().mass[b]/2500;
        const point& x = c.state().x[b];
        EXPECT_GE(Foam::min(x.y(), x.z()), 0.005);
        EXPECT_LE(Foam::max(x.y(), x.z()), 0.095);
    }
    figureNear("fillFraction", volume/(1.02*0.1*0.1), 0.25, 1e-3, "-",
        "asked for; half a body is 1e-4 of it");
    figure("fillGap", smallestGap(c.state(), everyMetre()), 0, noBar, "radii",
        "no body touches another or its image");

    // Nothing more comes
    enter(c, 1);
    EXPECT_EQ(c.state().size(), g.nEntered());
}


TEST(demFill, jammed)
{
    // More than random places can have: it says so and goes on
    demCase c
    (
        properties
        (
            "type fill; shape ball; number 2000;"
            " region { cylinder (0 0 0) (0 0 0.2) 0.05; }"
        )
    );
    testing::internal::CaptureStdout();
    c.solver().enter(0);
    const std::string said = testing::internal::GetCapturedStdout();
    const generator& g = c.solver().generators()[0];
    EXPECT_EQ(g.nEntered(), 2000);
    EXPECT_EQ(g.nEntered() - g.nLeftOut(), c.state().size());
    EXPECT_GT(g.nLeftOut(), 0);
    EXPECT_NE
    (
        said.find
        (
            "generator source: " + std::to_string(c.state().size())
          + " bodies of 2000 found room"
        ),
        std::string::npos
    ) << said;

    // The centres are a radius inside
    figure("fillJammed",
        c.state().size()*5.236e-7/(3.1416*0.045*0.045*0.19), 0.33, 0.45, "-",
        "random sequential addition: 0.382 of the volume of the centres");
    EXPECT_GE(smallestGap(c.state(), periodicity()), 0);
}


TEST(demFill, clumps)
{
    demCase c
    (
        properties
        (
            "type fill; shape cube; number 200;"
            " region { sphere (0 0 0.08) 0.08; }",
            cubeOfNine,
            "walls { floor { type plane; point (0 0 0.05); normal (0 0 1);"
            " material stuff; } }\n"
        )
    );
    enter(c, 0);
    const bodies& state = c.state();
    EXPECT_EQ(state.size(), 200);
    for (label s = 0; s < state.nSpheres(); ++s)
    {
        const scalar r = state.sphereR[s];
        const point& x = state.sphereX()[s];
        EXPECT_LE(mag(x - point(0, 0, 0.08)), 0.08 - r + 1e-12);
        EXPECT_GE(x.z(), 0.05 + r - 1e-12);
    }
    EXPECT_GE(smallestGap(state, periodicity()), 0);
}


TEST(demFill, roomGrid)
{
    // Radii from 1 to 300, and a domain that repeats itself
    demCase c
    (
        properties
        (
            "type batch; shape b0; number 1; region { box (0 0 0) (1 1 1); }",
            "shapes { b0 { type sphere; diameter 0.001; }"
            " b1 { type sphere; diameter 0.02; }"
            " b2 { type sphere; diameter 0.3; } }\n"
        ),
        Foam::Zero,
        Foam::List<corners>(),
        [](demInput& input) { input.period = everyMetre(); }
    );
    bodies& state = c.state();
    const periodicity period = everyMetre();
    const wallSet walls;
    std::mt19937_64 dice(2);
    std::uniform_real_distribution<scalar> u(0, 1);

    roomGrid grid(state, walls, period);
    label n[2] = {0, 0};
    label nWrong = 0;
    for (label i = 0; i < 6000; ++i)
    {
        newBody b;
        b.shapeI = i < 3 ? 2 : i < 200 ? 1 : 0;
        b.shapeI = i % 1000 == 999 ? 2 : b.shapeI;
        b.materialI = 0;
        b.density = 1;
        b.position = point(u(dice), u(dice), u(dice));

        const scalar r = c.solver().shapes()[b.shapeI].maxRadius();
        bool free = true;
        for (label j = 0; j < state.size(); ++j)
        {
            for (int image = -1; image <= 1; ++image)
            {
                const vector way =
                    b.position + vector(image, 0, 0) - state.x[j];
                free = free && mag(way) >= r + state.sphereR[j];
            }
        }
        nWrong += free != grid.hasRoom(b);
        ++n[free];
        if (free)
        {
            grid.add(state.append(b));
        }
    }
    figure("roomGrid", nWrong, 0, 0, "answers",
        "the same as of all pairs, 6000 questions");
    EXPECT_GT(n[0], 200);
    EXPECT_GT(n[1], 5000);
}


TEST(demFill, speedFull)
{
    demCase c
    (
        properties
        (
            "type fill; shape ball; number 100000;"
            " region { box (0 0 0) (0.6 0.6 0.49); }"
        )
    );
    const auto start = std::chrono::steady_clock::now();
    enter(c, 0);
    const scalar time = std::chrono::duration<scalar>
    (
        std::chrono::steady_clock::now() - start
    ).count();
    EXPECT_EQ(c.state().size(), 100000);
    figure("fillTime", time, 0, 10, "s", "100,000 spheres, 0.3 of the volume");
}


TEST(demFill, wrongInput)
{
    const auto expect = [](const std::string& g, const std::string& word)
    {
        const std::string dict = properties("shape ball; " + g);
        const std::string said = messageOf([&]() { demCase c(dict); });
        EXPECT_NE(said.find(word), std::string::npos) << g << said;
    };
    const std::string box(" region { box (0 0 0) (1 1 1); }");
    expect("type batch; number 3; times (0 1 1);" + box, "increase");
    expect("type batch; number 3; times ();" + box, "no time");
    expect("type batch; number 3; times (nan);" + box, "nan");
    expect("type batch; number 0;" + box, "1 or greater");
    expect("type batch; times (0);" + box, "number");
    expect("type batch; number 3; rate 1;" + box, "rate");
    expect("type batch; number 3;", "region");
    expect("type batch; number 1000000000; times (0 1 2);" + box, "counted");
    expect("type fill;" + box, "neither");
    expect("type fill; number 3; fraction 0.1;" + box, "both");
    expect("type fill; fraction 0.8;" + box, "from 0 to 0.74");
    expect("type fill; fraction -0.1;" + box, "greater than zero");
    expect("type fill; fraction 1e-9;" + box, "less than one body");
    expect("type fill; number 3; tries 0;" + box, "1 or greater");
    expect("type fill; number 3; region { box (0 0 0) (1 1 0); }",
        "no volume");
    expect("type fill; number 3; region { sphere (0 0 0) 0.006; }",
        "densest packing");
    expect("type fill; number 3; region { ball (0 0 0) 1; }", "sphere");
    expect("type pour; number 3;" + box, "batch file fill rate");
}


// ************************************************************************* //
