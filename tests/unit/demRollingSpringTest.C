/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    Rolling and torsional friction with a spring that remembers, against
    closed forms.

\*---------------------------------------------------------------------------*/

#include "demCase.H"

#include <cmath>

using namespace styxTest;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const scalar r = 0.005;
const scalar EStar = 1e7/(2*(1 - 0.09));
const scalar mass = 1200*4.0/3.0*M_PI*r*r*r;

//- Overlap [m] with which a ball rests under so much of its weight
scalar restOverlap(const scalar cosine)
{
    return std::pow
    (
        mass*9.81*cosine/(4.0/3.0*EStar*std::sqrt(r)), 2.0/3.0
    );
}

//- Stiffness of the normal law there [N/m]
scalar stiffness(const scalar cosine)
{
    return 2*EStar*std::sqrt(r*restOverlap(cosine));
}

//- demCloudProperties of a ball that lies on a plane
std::string ball
(
    const std::string& laws,
    const std::string& pair,
    const std::string& motion = "",
    const std::string& control = "type hades;"
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
        "stepControl { " + control + " }\n"
        "bodies { it { material rock; shape ball; position (0 0 "
      + text(r - 0.9*restOverlap(1)) + "); " + motion + " } }\n";
}

vector tilted(const scalar angle)
{
    return 9.81*vector(std::sin(angle), 0, -std::cos(angle));
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(demRollingSpring, slope)
{
    const std::string dict =
        ball("rolling elasticPlastic;", "rollingFriction 0.1;");
    {
        // Steeper than the coefficient
        const scalar angle = 0.3;
        demCase c(dict, tilted(angle));
        c.run(0.1);
        const scalar v1 = c.state().v[0].x();
        c.run(0.4);
        figureNear
        (
            "rollingSpring_slope",
            (c.state().v[0].x() - v1)/0.4,
            5.0/7.0*9.81*(std::sin(angle) - 0.1*std::cos(angle)),
            0.01,
            "m/s2",
            "closed form 5/7 g (sin - mu_r cos)"
        );
    }

    // Less steep: the springs of rolling and of slip hold the weight
    const scalar angle = 0.05;
    demCase c(dict, tilted(angle));
    c.run(1);
    const scalar x1 = c.state().x[0].x();
    c.run(1);
    figure
    (
        "rollingSpring_creep", std::abs(c.state().x[0].x() - x1)/r, 0, 1e-9,
        "radii in 1 s", "at rest below mu_r"
    );
    const scalar kn = stiffness(std::cos(angle));
    const scalar k = 2.25*kn*0.01*r*r;
    const scalar kt = kn*2*0.7/1.7;
    figureNear
    (
        "rollingSpring_rests",
        c.state().x[0].x(),
        mass*9.81*std::sin(angle)*(r*r/k + 1/kt),
        0.01,
        "m",
        "closed form m g sin (r^2/k + 1/k_t), k of Ai et al. 2011"
    );
}


TEST(demRollingSpring, flat)
{
    const scalar v0 = 0.2, mu = 0.05;
    const std::string dict = ball
    (
        "rolling elasticPlastic;",
        "rollingFriction 0.05;",
        "velocity (0.2 0 0); angularVelocity (0 40 0);"
    );
    demCase c(dict, tilted(0));
    const scalar stops = 7*v0/(5*mu*9.81);
    c.run(0.5*stops);
    figureNear
    (
        "rollingSpringFlat_halfWay", c.state().v[0].x(), 0.5*v0, 0.01, "m/s",
        "closed form v0 - 5/7 mu_r g t"
    );

    // The spring rolls it back a little, once
    int turns = 0;
    scalar last = 1;
    for (int n = 0; n < 1000; ++n)
    {
        c.run(1.5e-3*stops);
        const scalar v = c.state().v[0].x();
        turns += v*last < 0 && std::abs(v) > 1e-9*v0;
        last = v;
    }
    const scalar back = mu*mass*9.81*r*r/(2.25*stiffness(1)*mu*mu*r*r);
    figureNear
    (
        "rollingSpringFlat_distance", c.state().x[0].x() + back,
        7*v0*v0/(10*mu*9.81), 0.01, "m",
        "closed form 7 v0^2/(10 mu_r g), less the angle of the spring"
    );
    figure
    (
        "rollingSpringFlat_turns", turns, 1, 1, "times it rolls back",
        "no oscillation; Ai et al. 2011, type C"
    );
    figure
    (
        "rollingSpringFlat_rests", mag(c.state().v[0])/v0, 0, 1e-9, "of v0",
        "comes to rest"
    );
}


TEST(demRollingSpring, period)
{
    // Without its dashpot the ball swings on the spring
    const scalar mu = 0.02;
    const scalar k = 2.25*stiffness(1)*mu*mu*r*r;
    const scalar omega = std::sqrt(k/(1.4*mass*r*r));
    const scalar speed = 0.1*mu*mass*9.81*r*omega/k*r;
    demCase c
    (
        ball
        (
            "rolling elasticPlastic;",
            "rollingFriction 0.02; rollingDampingRatio 0;",
            "velocity (" + text(speed) + " 0 0); angularVelocity (0 "
          + text(speed/r) + " 0);"
        ),
        tilted(0)
    );
    std::vector<scalar> zeros;
    scalar last = speed;
    const scalar dt = 0.002*2*M_PI/omega;
    for (int n = 0; n < 1600; ++n)
    {
        c.run(dt);
        const scalar v = c.state().v[0].x();
        if (v*last < 0)
        {
            zeros.push_back(c.time() - dt*v/(v - last));
        }
        last = v;
    }
    ASSERT_GE(zeros.size(), 5u);
    figureNear
    (
        "rollingSpring_period", 0.5*(zeros[4] - zeros[0]), 2*M_PI/omega, 0.01,
        "s", "closed form 2 pi sqrt(7/5 m r^2/k)"
    );
}


TEST(demRollingSpring, torsion)
{
    const scalar spin = 100, mu = 0.05;
    demCase c
    (
        ball
        (
            "torsion elasticPlastic;",
            "torsionalFriction 0.05;",
            "angularVelocity (0 0 100);"
        ),
        tilted(0)
    );
    const scalar stops = spin*2*r/(5*mu*9.81);
    c.run(0.5*stops);
    figureNear
    (
        "torsionSpring_halfWay", c.state().omega[0].z(), 0.5*spin, 0.01,
        "rad/s", "closed form omega0 - 5 mu_t g t/(2 r)"
    );
    c.run(stops);
    figure
    (
        "torsionSpring_rests", mag(c.state().omega[0])/spin, 0, 1e-9,
        "of the spin", "comes to rest"
    );

    // Holds half of the limit for good
    demCase d
    (
        ball("torsion elasticPlastic;", "torsionalFriction 0.05;"),
        tilted(0)
    );
    const scalar torque = 0.5*mu*r*mass*9.81;
    d.state().fluidTorque[0] = vector(0, 0, torque);
    scalar angle = 0, first = 0;
    for (int n = 0; n < 10000; ++n)
    {
        // A single sphere has no orientation to look at
        first = n == 5000 ? angle : first;
        angle += 0.5e-4*d.state().omega[0].z();
        d.run(1e-4);
        angle += 0.5e-4*d.state().omega[0].z();
    }
    figureNear
    (
        "torsionSpring_holds", angle,
        torque/(2.25*stiffness(1)*mu*mu*r*r), 0.01, "rad",
        "closed form T/k, k of Ai et al. 2011"
    );
    figure
    (
        "torsionSpring_creep", std::abs(angle - first), 0, 1e-9,
        "rad in 0.5 s", "none"
    );
}


TEST(demRollingSpring, pairs)
{
    // Two balls pressed together that roll on each other, and twist
    const scalar spin = 100, F = 0.05;
    demCase c
    (
        "demSolver hades;\n"
        "contact { rolling elasticPlastic; torsion elasticPlastic; }\n"
        "materials { rock { density 1200; youngsModulus 1e7;"
        " poissonsRatio 0.3; } }\n"
        "pairs { rock-rock { restitution 0.1; friction 0.5;"
        " rollingFriction 0.005; torsionalFriction 0.002; } }\n"
        "shapes { ball { type sphere; diameter 0.01; } }\n"
        "stepControl { type hades; }\n"
        "bodies { a { material rock; shape ball; position (0 0 0.005);"
        " angularVelocity (100 0 40); }\n"
        "b { material rock; shape ball; position (0 0 -0.005);"
        " angularVelocity (-100 0 -40); } }\n"
    );
    c.state().fluidForce[0] = vector(0, 0, -F);
    c.state().fluidForce[1] = vector(0, 0, F);
    const scalar inertia = c.state().inertia(0).x();
    const scalar t = 0.5*spin*inertia/(0.005*0.0025*F);
    c.run(t);
    figureNear
    (
        "rollingSpringPair_spin", c.state().omega[0].x(), 0.5*spin, 0.01,
        "rad/s", "closed form: spin - mu_r R* F t/I"
    );
    figureNear
    (
        "torsionSpringPair_spin", c.state().omega[0].z(), 40 - 20, 0.01,
        "rad/s", "closed form: spin - mu_t R* F t/I"
    );
    EXPECT_NEAR(c.state().omega[1].x(), -c.state().omega[0].x(), 1e-9*spin);

    c.run(9*t);
    figure
    (
        "rollingSpringPair_rests", mag(c.state().omega[0])/spin, 0, 1e-9,
        "of the spin", "comes to rest"
    );
}


TEST(demRollingSpring, stages)
{
    // Integrators in stages take the memory along: the same rest
    const std::string laws("rolling elasticPlastic;");
    const std::string pair("rollingFriction 0.1;");
    const scalar angle = 0.05;
    demCase leaps(ball(laws, pair), tilted(angle));
    demCase stages
    (
        ball(laws, pair) + "integrator rk4;\n",
        tilted(angle)
    );
    leaps.run(0.5);
    stages.run(0.5);
    figureNear
    (
        "rollingSpring_rk4", stages.state().x[0].x(),
        leaps.state().x[0].x(), 1e-4, "m", "the same with stormerVerlet"
    );
}


// ************************************************************************* //
