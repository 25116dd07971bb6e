/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    Rolling and torsional friction and cohesion against closed forms.

\*---------------------------------------------------------------------------*/

#include "demCase.H"

#include <cmath>

using namespace styxTest;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const scalar r = 0.005;

//- demCloudProperties of a ball on a plane
std::string ball
(
    const std::string& laws,
    const std::string& pair,
    const std::string& motion,
    const scalar height = r
)
{
    return
        "demSolver hades;\ncontact { " + laws + " }\n"
        "materials { rock { density 1200; youngsModulus 1e7;"
        " poissonsRatio 0.3; } }\n"
        "pairs { rock-rock { restitution 0.3; friction 0.5; " + pair
      + " } }\n"
        "shapes { ball { type sphere; diameter " + text(2*r) + "; } }\n"
        "walls { board { type plane; point (0 0 0); normal (0 0 1);"
        " material rock; } }\n"
        "stepControl { type hades; }\n"
        "bodies { it { material rock; shape ball; position (0 0 "
      + text(height) + "); " + motion + " } }\n";
}

vector tilted(const scalar angle)
{
    return 9.81*vector(std::sin(angle), 0, -std::cos(angle));
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(demRolling, slope)
{
    // Figures "rollingSlope_mindlin_hertz", ...
    for (const std::string friction : {"mindlin", "coulomb"})
    for (const std::string normal : {"hertz", "hooke"})
    {
        const scalar angle = 0.3, mu = 0.1;
        demCase c
        (
            ball
            (
                "rolling constant; tangential " + friction + "; normal "
              + normal + ";",
                "rollingFriction 0.1;"
              + std::string(normal == "hooke" ? "normalStiffness 2e4;" : ""),
                ""
            ),
            tilted(angle)
        );
        c.run(0.1);
        const scalar v1 = c.state().v[0].x();
        c.run(0.4);
        figureNear
        (
            "rollingSlope_" + friction + "_" + normal,
            (c.state().v[0].x() - v1)/0.4,
            5.0/7.0*9.81*(std::sin(angle) - mu*std::cos(angle)),
            0.01,
            "m/s2",
            "closed form 5/7 g (sin - mu_r cos)"
        );
    }

    // Less steep than the coefficient
    demCase c
    (
        ball("rolling constant;", "rollingFriction 0.1;", ""),
        tilted(0.05)
    );
    c.run(1);
    figure
    (
        "rollingSlope_rests",
        mag(c.state().v[0]),
        0,
        0.002,
        "m/s",
        "at rest below mu_r, but for the creep"
    );
}


TEST(demRolling, flat)
{
    const scalar v0 = 0.2, mu = 0.05;
    const std::string dict = ball
    (
        "rolling constant;",
        "rollingFriction 0.05;",
        "velocity (0.2 0 0); angularVelocity (0 40 0);"
    );
    demCase c(dict, tilted(0));
    const scalar stops = 7*v0/(5*mu*9.81);
    c.run(0.5*stops);
    figureNear
    (
        "rollingFlat_halfWay", c.state().v[0].x(), 0.5*v0, 0.01, "m/s",
        "closed form v0 - 5/7 mu_r g t"
    );
    c.run(1.5*stops);
    figureNear
    (
        "rollingFlat_distance", c.state().x[0].x(),
        7*v0*v0/(10*mu*9.81), 0.01, "m", "closed form 7 v0^2/(10 mu_r g)"
    );
    figure
    (
        "rollingFlat_rests", mag(c.state().v[0])/v0, 0, 1e-6, "of v0",
        "comes to rest"
    );
}


TEST(demRolling, pairs)
{
    // Two balls pressed together that roll on each other: spins about x of
    // opposite sign, which friction does not see; the torque turns both down
    const scalar spin = 100, F = 0.05;
    demCase c
    (
        "demSolver hades;\ncontact { rolling constant; }\n"
        "materials { rock { density 1200; youngsModulus 1e7;"
        " poissonsRatio 0.3; } }\n"
        "pairs { rock-rock { restitution 0.1; friction 0.5;"
        " rollingFriction 0.005; } }\n"
        "shapes { ball { type sphere; diameter 0.01; } }\n"
        "stepControl { type hades; }\n"
        "bodies { a { material rock; shape ball; position (0 0 0.005);"
        " angularVelocity (" + text(spin) + " 0 0); }\n"
        "b { material rock; shape ball; position (0 0 -0.005);"
        " angularVelocity (" + text(-spin) + " 0 0); } }\n"
    );
    c.state().fluidForce[0] = vector(0, 0, -F);
    c.state().fluidForce[1] = vector(0, 0, F);
    const scalar inertia = c.state().inertia(0).x();
    const scalar t = 0.5*spin*inertia/(0.005*0.0025*F);
    c.run(t);
    figureNear
    (
        "rollingPair_spin", c.state().omega[0].x(), 0.5*spin, 0.01, "rad/s",
        "closed form: spin - mu_r R* F t/I"
    );
    EXPECT_NEAR(c.state().omega[1].x(), -c.state().omega[0].x(), 1e-9*spin);
}


TEST(demRolling, torsion)
{
    const scalar spin = 100, mu = 0.05;
    const std::string dict = ball
    (
        "torsion constant; rolling constant;",
        "rollingFriction 0.3; torsionalFriction 0.05;",
        "angularVelocity (0 0 100);"
    );
    demCase c(dict, tilted(0));
    const scalar stops = spin*2*r/(5*mu*9.81);
    c.run(0.5*stops);
    figureNear
    (
        "torsion_halfWay", c.state().omega[0].z(), 0.5*spin, 0.01, "rad/s",
        "closed form omega0 - 5 mu_t g t/(2 r)"
    );
    c.run(stops);
    figure
    (
        "torsion_rests", mag(c.state().omega[0])/spin, 0, 1e-3,
        "of the spin", "comes to rest"
    );

    // And nothing slows it down if it is not named
    demCase d(ball("", "", "angularVelocity (0 0 100);"), tilted(0));
    d.run(0.1);
    EXPECT_NEAR(d.state().omega[0].z(), spin, 1e-9);
}


TEST(demCohesion, simplifiedJKR)
{
    // A ball that hangs: k d^(3/2) - c d = -F, up to a pull of 4/27 c^3/k^2
    const scalar EStar = 1e7/(2*(1 - 0.09));
    const scalar k = 4.0/3.0*EStar*std::sqrt(r);
    const scalar d0 = 5e-4*r;
    const scalar density = k*std::sqrt(d0)/(2*M_PI*r);
    const scalar slope = k*std::sqrt(d0);
    const scalar most = 4.0/27.0*k*d0*std::sqrt(d0);

    demCase c
    (
        ball
        (
            "cohesion simplifiedJKR;",
            "cohesionEnergyDensity " + text(density) + ";",
            "",
            r - d0
        )
    );
    const auto pull = [&](const scalar F, const scalar t)
    {
        c.state().fluidForce[0] = vector(0, 0, F);
        c.run(t);
    };
    pull(0, 0.01);
    figureNear
    (
        "cohesion_rests", r - c.state().x[0].z(), d0, 0.001, "m",
        "closed form (2 pi R K/k)^2"
    );

    for (int n = 1; n <= 50; ++n)
    {
        pull(0.01*n*most, 0.002);
    }
    pull(0.5*most, 0.05);
    scalar low = 4.0/9.0*d0, high = d0;
    for (int n = 0; n < 60; ++n)
    {
        const scalar d = 0.5*(low + high);
        (slope*d - k*d*std::sqrt(d) > 0.5*most ? low : high) = d;
    }
    figureNear
    (
        "cohesion_hangs", r - c.state().x[0].z(), low, 0.001, "m",
        "closed form k d^1.5 - c d = -F"
    );
    for (int n = 51; n <= 98; ++n)
    {
        pull(0.01*n*most, 0.002);
    }
    pull(0.98*most, 0.02);
    figure
    (
        "cohesion_holds", (r - c.state().x[0].z())/d0, 0.4, 0.6,
        "of the overlap without load", "4/27 c^3/k^2 holds"
    );
    pull(1.02*most, 0.05);
    figure
    (
        "cohesion_comesOff", (r - c.state().x[0].z())/d0, Foam::scalar(-1e9),
        0, "of the overlap without load", "4/27 c^3/k^2 holds"
    );
}


// ************************************************************************* //
