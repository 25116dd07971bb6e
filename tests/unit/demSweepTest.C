/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    The sweep over the contacts with each set of instructions that this
    processor has: balls and clumps of two materials that hit each other and
    a floor, obliquely and with friction.

\*---------------------------------------------------------------------------*/

#include "demCase.H"
#include "figure.H"

#include <gtest/gtest.h>

using namespace styxTest;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

bool has(const std::string& instructions)
{
    return
        instructions == "avx512"
      ? __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")
     && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw")
      : instructions == "avx2"
      ? __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")
      : true;
}


//- Seven pairs, so that no number of lanes divides the number of contacts
std::string pairsThatHit(const std::string& laws)
{
    std::string dict =
        "demSolver hades;\n"
        "materials\n{\n"
        "    a { density 2500; youngsModulus 1e7; poissonsRatio 0.3; }\n"
        "    b { density 1200; youngsModulus 3e6; poissonsRatio 0.2; }\n}\n"
        "pairs\n{\n"
        "    a-a { restitution 0.8; friction 0.3; }\n"
        "    a-b { restitution 0.6; friction 0.5; }\n"
        "    b-b { restitution 0.4; friction 0.1; }\n}\n"
        "shapes\n{\n"
        "    ball { type sphere; diameter 0.004; }\n"
        "    pair { type multisphere; spheres"
        " (((-0.001 0 0) 0.002) ((0.001 0 0) 0.0015)); }\n}\n"
        "contact { " + laws + " }\n"
        "walls { floor { type plane; point (0 0 0); normal (0 0 1);"
        " material b; } }\n"
        "stepControl { type hades; }\nbodies\n{\n";

    for (int n = 0; n < 7; ++n)
    {
        const std::string k = std::to_string(n);
        const point low(0.02*n, 0.0003*n, 0.003);
        const point high = low + vector(0.0007*n, 0.0002, 0.006 + 0.0003*n);
        dict +=
            "l" + k + " { shape " + (n % 2 ? "ball" : "pair")
          + "; material " + (n % 3 ? "a" : "b") + "; position " + text(low)
          + "; velocity (0.1 0 -0.5); angularVelocity (10 " + k + " 5); }\n"
            "h" + k + " { shape " + (n % 3 ? "ball" : "pair")
          + "; material " + (n % 2 ? "a" : "b") + "; position " + text(high)
          + "; velocity (0 0.2 -1); }\n";
    }
    return dict + "}\n";
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(demSweep, instructions)
{
    const std::string plain("instructions sse2;");
    demCase expected(pairsThatHit(plain), gravity);
    expected.run(0.008);

    // What it is worth: all have hit something, and no longer fall freely
    for (label b = 0; b < expected.state().size(); ++b)
    {
        EXPECT_GT(mag(expected.state().L[b]), 0);
        EXPECT_GT(expected.state().v[b].z(), b % 2 ? -0.95 : -0.45) << b;
    }

    for (const std::string name : {"avx2", "avx512", "auto"})
    {
        if (!has(name))
        {
            std::cout << "no " << name << " here" << std::endl;
            continue;
        }
        demCase c(pairsThatHit("instructions " + name + ";"), gravity);
        c.run(0.008);

        scalar worst = 0;
        for (label b = 0; b < c.state().size(); ++b)
        {
            worst = std::max
            (
                {
                    worst,
                    mag(c.state().x[b] - expected.state().x[b])/0.002,
                    mag(c.state().v[b] - expected.state().v[b]),
                    mag(c.state().omega[b] - expected.state().omega[b])/100
                }
            );
        }
        figure
        (
            "sweep_" + name,
            worst,
            0,
            1e-9,
            "of radius, 1 m/s, 100 rad/s",
            "the same with sse2"
        );
    }
}


// ************************************************************************* //
