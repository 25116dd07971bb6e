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
#include "stressMeter.H"

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


TEST(demMeter, contactForces)
{
    // Balls that slide over each other and the floor, without damping: each
    // by itself, and all of a body together
    std::string dict = properties
    (
        ball("a", point(0, 0, 0.00499), vector(0.1, 0, 0))
      + ball("b", point(0.00999, 0, 0.00499), vector(0, 0.1, 0))
      + ball("c", point(0.005, 0.0002, 0.0135), vector(0, 0, -0.1)),
        "contact { damping none; }\nwalls { floor { type plane;"
        " point (0 0 0); normal (0 0 1); material stuff; } }\n"
        "start relax;\n"
    );
    const std::string pair("restitution 0.5; friction 0");
    dict.replace(dict.find(pair), pair.size(), "friction 0.5");
    demCase c(dict, gravity);
    c.run(2e-3);
    c.run(1e-3);

    const Foam::List<contactForce> all(c.solver().contacts());
    figure("contactForces_number", all.size(),
        c.solver().report().nContacts, c.solver().report().nContacts,
        "contacts", "those of the step");
    EXPECT_GE(all.size(), 2);

    Foam::vectorField sum(3, vector(Foam::Zero));
    scalar largest = 0, across = 0;
    for (const contactForce& f : all)
    {
        sum[f.a] += f.force;
        if (f.b >= 0)
        {
            sum[f.b] -= f.force;
        }
        largest = std::max(largest, mag(f.force));
        across = std::max(across, f.tangential());
        EXPECT_LE(f.tangential(), 0.5*f.normal()*(1 + 1e-9));
        EXPECT_GT(f.normal(), 0);
    }
    EXPECT_GT(across, 0.05*largest);
    scalar worst = 0;
    for (label b = 0; b < 3; ++b)
    {
        worst = std::max
        (
            worst,
            mag(sum[b] + ballMass*gravity - c.state().force[b])/largest
        );
    }
    figure("contactForces_sum", worst, 0, 1e-9, "-",
        "their sum and the weight against the force on the body");
}


TEST(demMeter, stressOfColumn)
{
    // Ten balls upon each other at rest: ball k from below bears N - k of them
    const label N = 10;
    const scalar r = 0.005;
    std::string bodies;
    for (label k = 0; k < N; ++k)
    {
        bodies += ball("b" + std::to_string(k), point(0, 0, r + 2*r*k));
    }
    std::string stiff = properties
    (
        bodies,
        "walls { floor { type plane; point (0 0 0); normal (0 0 1);"
        " material stuff; } }\n"
    );
    stiff.replace(stiff.find("1e6"), 3, "1e9");
    demCase c(stiff, gravity);
    c.run(0.2);
    Foam::dictionary dict
    (
        dictionaryOf("type stress; region { box (-1 -1 0) (1 1 1); }")
    );
    stressMeter meter("column", dict, periodicity());
    meter.end(c.solver(), 1);
    figureNear
    (
        "stress_column",
        meter.stress().zz(),
        ballMass*9.81*r*N*N/4,
        0.01,
        "Pa",
        "m g r N^2/V"
    );
    EXPECT_LT(std::abs(meter.stress().xx()), 1e-6*meter.stress().zz());
}


TEST(demMeter, stressOfBox)
{
    // A cubic lattice under an overlap that is the same everywhere, with the
    // force of Hertz: F/pitch^2 in all directions, and no shear
    const scalar r = 0.005, delta = 9e-4*r, pitch = 2*r - delta;
    const scalar inWall = delta*std::cbrt(0.5);
    const label n = 6;
    std::string bodies;
    for (label k = 0; k < n*n*n; ++k)
    {
        const vector cell(k % n, k/n % n, k/n/n);
        bodies += ball("b" + std::to_string(k), pitch*cell);
    }
    const scalar low = -(r - inWall), high = pitch*(n - 1) - low;
    demCase c
    (
        properties
        (
            bodies,
            "walls { box { type box; min " + text(vector(low, low, low))
          + "; max " + text(vector(high, high, high))
          + "; side inside; material stuff; } }\n"
        )
    );
    c.run(1e-6);
    const scalar a = 0.5*pitch, b = pitch*(n - 1.5);
    Foam::dictionary dict
    (
        dictionaryOf
        (
            "type stress; region { box " + text(vector(a, a, a)) + " "
          + text(vector(b, b, b)) + "; }"
        )
    );
    stressMeter meter("box", dict, periodicity());
    meter.end(c.solver(), 1);
    const scalar E = 1e6/(2*(1 - 0.09));
    const scalar F = 4.0/3.0*E*std::sqrt(0.5*r)*std::pow(delta, 1.5);
    const Foam::symmTensor s = meter.stress()/(F/pitch/pitch);
    figure
    (
        "stress_box",
        mag(s - Foam::symmTensor::I),
        0,
        1e-6,
        "-",
        "isotropic, F/pitch^2"
    );

    // Two that fly apart: no contact, 2 m v^2/V
    demCase gas
    (
        properties
        (
            ball("a", point(0.2, 0, 0), vector(2, 0, 0))
          + ball("b", point(-0.2, 0, 0), vector(-2, 0, 0))
        )
    );
    Foam::dictionary all
    (
        dictionaryOf("type stress; region { box (-1 -1 -1) (1 1 1); }")
    );
    stressMeter flying("gas", all, periodicity());
    flying.end(gas.solver(), 1);
    figureNear("stress_motion", flying.motion().xx(), 2*ballMass*4/8, 1e-12,
        "Pa", "2 m v^2/V");
}


TEST(demMeter, stressWrongInput)
{
    const auto says = [](const std::string& entries)
    {
        return messageOf([&]()
        {
            Foam::dictionary dict(dictionaryOf("type stress; " + entries));
            stressMeter meter("bad", dict, periodicity());
        });
    };
    EXPECT_NE(says("region { box (0 0 0) (1 1 0); }").find("no volume"),
        std::string::npos);
    EXPECT_NE(says("region { box (0 0 0) (1 1 1); } where here;").find("where"),
        std::string::npos);
    EXPECT_NE(says("").find("region"), std::string::npos);
}


// ************************************************************************* //
