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
#include "instructionSets.H"
#include "sweepData.H"

#include <gtest/gtest.h>

using namespace styxTest;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

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

//- The same with other laws, and with what their pairs read; alike, if the
//  materials are to be of the same kind
std::string otherLaws(const std::string& instructions, const bool alike)
{
    std::string dict = pairsThatHit
    (
        "instructions " + instructions + "; normal hooke;"
        " tangential coulomb; damping critical; pulling no;"
        " rolling constant; torsion constant; cohesion simplifiedJKR;"
    );
    const auto change = [&](const std::string& from, const std::string& to)
    {
        const size_t at = dict.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        dict.replace(at, from.size(), to);
    };
    const std::string first
    (
        "dampingRatio 0.1; normalStiffness 2e4; rollingFriction 0.1;"
        " torsionalFriction 0.05; cohesionEnergyDensity 1e4; friction 0.3;"
    );
    const std::string second
    (
        "dampingRatio 0.3; normalStiffness 1e4; rollingFriction 0.02;"
        " torsionalFriction 0.1; cohesionEnergyDensity 1e5; friction 0.5;"
    );
    change("restitution 0.8; friction 0.3;", first);
    change("restitution 0.6; friction 0.5;", alike ? first : second);
    change("restitution 0.4; friction 0.1;", first);
    if (alike)
    {
        change
        (
            "b { density 1200; youngsModulus 3e6; poissonsRatio 0.2; }",
            "b { density 2500; youngsModulus 1e7; poissonsRatio 0.3; }"
        );
    }
    return dict;
}


//- Largest difference of two states, of a radius, 1 m/s and 100 rad/s
scalar difference(demCase& c, demCase& d)
{
    scalar worst = 0;
    for (label b = 0; b < c.state().size(); ++b)
    {
        worst = std::max
        (
            {
                worst,
                mag(c.state().x[b] - d.state().x[b])/0.002,
                mag(c.state().v[b] - d.state().v[b]),
                mag(c.state().omega[b] - d.state().omega[b])/100
            }
        );
    }
    return worst;
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
        EXPECT_GT(mag(expected.state().L(b)), 0);
        EXPECT_GT(expected.state().v[b].z(), b % 2 ? -0.95 : -0.45) << b;
    }

    for (const std::string name : {"avx2", "avx512", "auto"})
    {
        if (!processorHas(name))
        {
            std::cout << "no " << name << " here" << std::endl;
            continue;
        }
        demCase c(pairsThatHit("instructions " + name + ";"), gravity);
        c.run(0.008);

        figure
        (
            "sweep_" + name,
            difference(c, expected),
            0,
            1e-9,
            "of radius, 1 m/s, 100 rad/s",
            "the same with sse2"
        );
    }
}


TEST(demSweep, wayLeft)
{
    // Each of so many spheres in turn is the one that is nearest to its end,
    // in any lane and behind the last whole vector
    for (const std::string name : {"sse2", "avx2", "avx512"})
    {
        if (!processorHas(name))
        {
            std::cout << "no " << name << " here" << std::endl;
            continue;
        }
        const Foam::dem::sweepSet& sweeps =
            name == "sse2" ? Foam::dem::sweepSse2
          : name == "avx2" ? Foam::dem::sweepAvx2
          : Foam::dem::sweepAvx512;
        scalar off = 0;
        for (int k = 4; k < 4*140; ++k)
        {
            const int n = k/4;
            const bool shifted = k % 2, grouped = k/2 % 2;
            constexpr int nInGroup = Foam::dem::placesBefore::nInGroup;
            std::vector<Foam::dem::quadPair> xv(n);
            std::vector<double> from(3*n), first(3*(n/nInGroup + 1));
            std::vector<float> inGroup(3*n), offset(3*n), may(n, 10);
            const auto place = [](const int s)
            {
                return point(s, -0.375*s, 0.125*s);
            };
            for (int s = 0; s < n; ++s)
            {
                const int g = s/nInGroup;
                const point x0(place(s)), begin(place(g*nInGroup));
                const point x(x0 + 0.5*(1 + s % 3)*vector(2, -3, 6)/7);
                xv[s] = {{x.x(), x.y(), x.z(), 1e9}, {1e9, 1e9, 1e9, 1e9}};
                for (int d = 0; d < 3; ++d)
                {
                    const int i = s + d*n;
                    offset[i] = 0.25*(d + s % 2);
                    from[i] = x0[d] - shifted*offset[i];
                    first[3*g + d] = begin[d];
                    inGroup[i] = from[i] - begin[d];
                }
            }
            const Foam::dem::placesBefore before
            {
                grouped ? nullptr : from.data(),
                inGroup.data(),
                first.data(),
                shifted ? offset.data() : nullptr,
                may.data()
            };
            for (int s = 0; s < n; s += n < 40 ? 1 : 7)
            {
                may[s] = 1;
                const double left = sweeps.wayLeft(xv.data(), before, n);
                off = Foam::max(off, Foam::mag(left - 1 + 0.5*(1 + s % 3)));
                may[s] = 10;
            }
            EXPECT_GT(sweeps.wayLeft(xv.data(), before, 0), 1e100);
        }
        figure
        (
            "wayLeft_" + name, off, 0, 1e-13, "m", "2, 3, 6 are 7 long"
        );
    }
}


TEST(demSweep, otherLaws)
{
    // All that stages may do, with lanes of different pairs of materials
    demCase expected(otherLaws("sse2", false), gravity);
    expected.run(0.008);
    for (const std::string name : {"avx2", "avx512"})
    {
        if (!processorHas(name))
        {
            std::cout << "no " << name << " here" << std::endl;
            continue;
        }
        demCase c(otherLaws(name, false), gravity);
        c.run(0.008);
        figure
        (
            "sweepOfStages_" + name,
            difference(c, expected),
            0,
            1e-9,
            "of radius, 1 m/s, 100 rad/s",
            "the same with sse2"
        );
    }

    // Two materials that are alike are as good as one
    const std::string two = otherLaws("auto", true);
    std::string one = two;
    for (size_t at; (at = one.find("material b")) != std::string::npos;)
    {
        one.replace(at, 10, "material a");
    }
    for (const char* pair : {"a-b", "b-b"})
    {
        const size_t at = one.find(pair);
        one.erase(at, one.find("}", at) + 1 - at);
    }
    const size_t at = one.find("b { density");
    one.erase(at, one.find("}", at) + 1 - at);

    demCase c(two, gravity), d(one, gravity);
    c.run(0.008);
    d.run(0.008);
    figure
    (
        "sweepOfOneMaterial",
        difference(c, d),
        0,
        1e-12,
        "of radius, 1 m/s, 100 rad/s",
        "the same as of two that are alike"
    );
}


// ************************************************************************* //
