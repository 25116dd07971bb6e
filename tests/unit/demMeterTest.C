/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    Meters: mass that goes through a plane, also through one that repeats
    itself, and the coordination number of packings that are known.

\*---------------------------------------------------------------------------*/

#include "demCase.H"
#include "coordination.H"
#include "massFlow.H"

#include <cmath>

using namespace styxTest;
using namespace Foam::dem;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

std::string properties(const std::string& bodies, const std::string& more = "")
{
    return
        "demSolver hades;\n"
        "materials { stuff { density 1000; youngsModulus 1e6;"
        " poissonsRatio 0.3; } }\n"
        "pairs { stuff-stuff { restitution 0.5; friction 0; } }\n"
        "stepControl { type hades; }\n"
        "shapes { ball { type sphere; diameter 0.01; } }\n"
        "bodies {\n" + bodies + "}\n" + more;
}


std::string ball
(
    const std::string& name,
    const point& x,
    const vector& v = Foam::Zero
)
{
    return
        name + " { shape ball; material stuff; position " + text(x)
      + "; velocity " + text(v) + "; }\n";
}


periodicity everyMetre(const bool two = false)
{
    periodicity p;
    p.append(periodicity::seam{vector(1, 0, 0), 0, vector(1, 0, 0)});
    if (two)
    {
        p.append(periodicity::seam{vector(0, 1, 0), 0, vector(0, 1, 0)});
    }
    return p;
}

const scalar ballMass = 1000*M_PI/6*1e-6;

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(demMeter, massFlow)
{
    // Three fall through, one rises, one stays, one starts beyond
    demCase c
    (
        properties
        (
            ball("a", point(0, 0, 0.1), vector(0, 0, -1))
          + ball("b", point(0.1, 0, 0.2), vector(0, 0, -1))
          + ball("c", point(0.2, 0, 0.3), vector(0, 0, -1))
          + ball("d", point(0.3, 0, -0.1), vector(0, 0, 1))
          + ball("e", point(0.4, 0, 0.1))
          + ball("f", point(0.5, 0, -0.1), vector(0, 0, -1))
        )
    );
    massFlow down("down",
        dictionaryOf("type massFlow; point (9 9 0); normal (0 0 -2);"),
        periodicity());

    const label expected[] = {0, 0, 0, 1, 2, 2};
    for (int i = 0; i < 6; ++i)
    {
        // The first goes through with the one that rises
        EXPECT_EQ(down.number(), expected[i]) << i;
        down.begin(c.solver());
        c.run(0.08);
        down.end(c.solver(), 0.08);
    }
    figureNear("massFlow_number", down.number(), 2, 0, "bodies",
        "three down, one up");
    figureNear("massFlow_mass", down.mass(), 2*ballMass, 1e-12, "kg",
        "two balls");

    // Goes on from what was saved
    Foam::dictionary saved;
    down.write(saved);
    massFlow again("down",
        dictionaryOf("type massFlow; point (9 9 0); normal (0 0 -2);"),
        periodicity());
    again.read(saved);
    EXPECT_EQ(again.number(), 2);
    EXPECT_EQ(again.mass(), down.mass());
}


TEST(demMeter, massFlowThroughSeam)
{
    // 0.3 m a step through a domain of 1 m: the plane is passed once a period
    demCase c
    (
        properties
        (
            ball("a", point(0.5, 0, 0), vector(3, 0, 0))
          + ball("b", point(0.2, 0.3, 0), vector(-2, 0, 0))
        ),
        Foam::Zero,
        Foam::List<corners>(),
        [](demInput& input) { input.period = everyMetre(); }
    );
    massFlow along("along",
        dictionaryOf("type massFlow; point (0.9 0 0); normal (1 0 0);"),
        everyMetre());
    for (int i = 0; i < 100; ++i)
    {
        along.begin(c.solver());
        c.run(0.1);
        along.end(c.solver(), 0.1);
    }
    // 0.5 + 30 m and 0.2 - 20 m: the planes at 0.9, 1.9 ... and -0.1, -1.1 ...
    figureNear("massFlow_seam", along.number(), 30 - 20, 0, "bodies",
        "ways of 30 and 20 periods");
}


TEST(demMeter, coordination)
{
    // A square and a fifth ball on top, one ball that is alone, one that hangs
    // on the square; neighbours overlap by 0.01 %
    const scalar d = 0.0099995;
    demCase c
    (
        properties
        (
            ball("a", point(0, 0, 0.05))
          + ball("b", point(d, 0, 0.05))
          + ball("c", point(0, d, 0.05))
          + ball("d", point(d, d, 0.05))
          + ball("e", point(0.5*d, 0.5*d, 0.05 + std::sqrt(0.5)*d))
          + ball("f", point(0.1, 0, 0.05))
          + ball("g", point(-d, 0, 0.05))
          + ball("h", point(0.2, 0, 0.0049999)),
            "walls { floor { type plane; point (0 0 0); normal (0 0 1);"
            " material stuff; } }\n"
        )
    );
    c.run(1e-9);
    coordination z("z", dictionaryOf("type coordination;"), periodicity());
    z.end(c.solver(), 1);

    // 4 sides, 4 to the top, 1 that hangs on; rattlers are f and g
    figureNear("coordination", z.Z(), 2*9/8.0, 1e-14, "-", "counted");
    figureNear("coordination_backbone", z.zBackbone(), 2*8/6.0, 1e-14, "-",
        "counted: without the two rattlers");
    EXPECT_EQ(z.nRattlers(), 2);
    EXPECT_EQ(z.nWalls(), 1);
}


TEST(demMeter, wrongInput)
{
    const auto expect =
        [](const std::string& m, const std::string& word, const bool two)
        {
            const std::string said = messageOf
            (
                [&]()
                {
                    meter::New("m", dictionaryOf(m), everyMetre(two));
                }
            );
            EXPECT_NE(said.find(word), std::string::npos) << m << said;
        };
    const std::string flow("type massFlow; point (0 0 0); ");
    expect("type volumeFlow;", "coordination massFlow", false);
    expect("type coordination; every 3;", "every", false);
    expect(flow, "normal", false);
    expect(flow + "normal (0 0 0);", "length", false);
    expect(flow + "normal (0 0 1); radius 1;", "radius", false);
    expect(flow + "normal (1 1 0);", "all cyclic patches but one", true);
}


// ************************************************************************* //
