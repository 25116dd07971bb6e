/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    Friction: sliding that turns into rolling, a cube of spheres that stays on
    a slope, a sphere that rolls down it.

\*---------------------------------------------------------------------------*/

#define STYX_LANES 2
#define STYX_INSTRUCTIONS sse2

#include "demCase.H"

#include "dampingLaws.H"
#include "hertz.H"
#include "tangentialLaws.H"

#include <cfenv>
#include <cmath>

using namespace styxTest;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- demCloudProperties of one body on a plane with its foot at the origin
std::string onPlane
(
    const std::string& shapes,
    const std::string& body,
    const scalar friction,
    const scalar slope
)
{
    const vector normal(-std::sin(slope), 0, std::cos(slope));
    return
        "demSolver hades;\n"
        "materials\n{\n"
        "rock { density 1200; youngsModulus 1e7; poissonsRatio 0.3; }\n"
        "board { youngsModulus 1e7; poissonsRatio 0.3; }\n}\n"
        "pairs { rock-rock { restitution 0.3; friction 0.5; }"
        " rock-board { restitution 0.3; friction " + text(friction)
      + "; } }\n" + shapes
      + "walls { board { type plane; point (0 0 0); normal " + text(normal)
      + "; material board; } }\n"
        "stepControl { type hades; }\n"
        "bodies { it { material rock; " + body + " } }\n";
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(demFriction, slidingToRolling)
{
    const scalar r = 0.005;
    const scalar v0 = 0.2;
    const scalar mu = 0.3;

    demCase c
    (
        onPlane
        (
            "shapes { ball { type sphere; diameter 0.01; } }\n",
            "shape ball; position (0 0 " + text(r) + "); velocity ("
          + text(v0) + " 0 0);",
            mu,
            0
        ),
        gravity
    );

    // Twice as long as the sliding lasts
    const scalar rolls = 2*v0/(7*mu*9.81);
    c.run(0.5*rolls);
    figureNear
    (
        "slidingToRolling_halfWay",
        c.state().v[0].x(),
        v0*6.0/7.0,
        0.005,
        "m/s",
        "closed form v0 - mu g t"
    );
    c.run(1.5*rolls);
    figureNear
    (
        "slidingToRolling",
        c.state().v[0].x(),
        5.0/7.0*v0,
        0.005,
        "m/s",
        "closed form 5/7 v0"
    );
    figureNear
    (
        "slidingToRolling_spin",
        c.state().omega[0].y(),
        5.0/7.0*v0/r,
        0.005,
        "rad/s",
        "closed form 5/7 v0/r"
    );
}


TEST(demFriction, slipTurns)
{
    // A pair that turns as a whole takes the slip along, about any axis
    using namespace Foam::dem;

    using namespace Foam::dem::sse2;

    pairProperties pair;
    pair.elasticity = 1e6;
    pair.shearRatio = 0.8;
    pair.friction = 100;

    contactLanes c;
    c.touches = fromBits(3);
    c.overlap = all(1e-5);
    c.rStar = all(0.005);
    c.mStar = all(1e-3);
    c.contactRadius = sqrt(c.rStar*c.overlap);
    c.un = all(0);
    c.ut = c.way = vec{};
    const pairLanes pairs = sameInAll(pair);
    c.pair = &pairs;

    for (const vector& axis : {vector(0, 0, 1), vector(1, 2, 0.5)})
    {
        const vector w = axis/mag(axis);
        const label n = 1000;
        vec xi = {all(1e-6), all(0), all(0)};
        vec F = {};
        mask slides = {};
        vector normal;
        for (label k = 1; k <= n; ++k)
        {
            const Foam::quaternion q(w, scalar(k)/n);
            normal = q.transform(vector(0, 0, 1));
            c.n = vec{all(normal.x()), all(normal.y()), all(normal.z())};
            c.turn = all((w & normal)/n);
            F = tangentialLaws::mindlin::force<dampingLaws::none>
            (
                c,
                normalLaws::hertz::stiffness(c),
                all(1),
                xi,
                slides
            );
        }
        EXPECT_EQ(bits(slides), 0u);
        const vector expected =
            Foam::quaternion(w, scalar(1)).transform(vector(1e-6, 0, 0));
        const vector slip(xi.x[1], xi.y[1], xi.z[1]);
        EXPECT_LT(mag(slip - expected), 2e-3*1e-6);
        EXPECT_LT(std::abs(slip & normal), 1e-15*1e-6);
        EXPECT_NEAR
        (
            std::sqrt((F & F)[1]),
            1.6*pair.elasticity*c.contactRadius[1]*1e-6,
            1e-12
        );
    }
}


TEST(demFriction, clumpSlope)
{
    const scalar mu = 0.5;
    const scalar slope = 0.8*std::atan(mu);
    const scalar half = 0.0032 + 0.00365;

    const vector normal(-std::sin(slope), 0, std::cos(slope));
    demCase c
    (
        onPlane
        (
            cubeOfNine,
            "shape cube; position " + text(half*normal)
          + "; rotation ((0 1 0) " + text(-slope*180/M_PI) + ");",
            mu,
            slope
        ),
        gravity
    );

    c.run(2);
    const point x = c.state().x[0];
    const Foam::quaternion q = c.state().q[0];
    const label before = c.nSteps;

    for (int n = 0; n < 100; ++n)
    {
        c.run(0.1);
    }

    // The way of its corners: that of the centre and that of the turn
    const scalar turned = 2*mag((q*conjugate(c.state().q[0])).v());
    const scalar way = mag(c.state().x[0] - x) + turned*0.0104;

    std::cout
        << c.nSteps - before << " steps, " << c.nRejected << " rejected"
        << std::endl;
    EXPECT_EQ(c.solver().report().nContacts, 4);
    figure
    (
        "clumpSlope",
        way/0.012,
        0,
        1e-6,
        "edges in 10 s",
        "at rest below atan(mu)"
    );

    // And it slides on a slope that is too steep
    const scalar slip = 0.3;
    const scalar steep = 1.5*std::atan(slip);
    const vector n2(-std::sin(steep), 0, std::cos(steep));
    demCase d
    (
        onPlane
        (
            cubeOfNine,
            "shape cube; position " + text(half*n2)
          + "; rotation ((0 1 0) " + text(-steep*180/M_PI) + ");",
            slip,
            steep
        ),
        gravity
    );
    d.run(0.2);
    const scalar v1 = mag(d.state().v[0]);
    d.run(0.2);
    figureNear
    (
        "clumpSlope_slides",
        (mag(d.state().v[0]) - v1)/0.2,
        9.81*(std::sin(steep) - slip*std::cos(steep)),
        0.005,
        "m/s2",
        "closed form g (sin - mu cos)"
    );
}


TEST(demFriction, sphereSlope)
{
    const scalar mu = 0.5;
    const scalar slope = 0.8*std::atan(mu);
    const scalar r = 0.006;
    const vector normal(-std::sin(slope), 0, std::cos(slope));

    demCase c
    (
        onPlane
        (
            "shapes { ball { type sphere; diameter 0.012; } }\n",
            "shape ball; position " + text(r*normal) + ";",
            mu,
            slope
        ),
        gravity
    );
    c.run(0.1);
    const vector v1 = c.state().v[0];
    c.run(0.4);
    figureNear
    (
        "sphereSlope",
        mag(c.state().v[0] - v1)/0.4,
        5.0/7.0*9.81*std::sin(slope),
        0.005,
        "m/s2",
        "closed form 5/7 g sin"
    );
}


TEST(demFriction, hardHits)
{
    // A ball that falls straight, with a force of 80 kN, beside one that
    // slides: no lane of the sweep divides a large number by nothing
    for (const char* tangential : {"mindlin", "coulomb"})
    {
        demCase c
        (
            "demSolver hades;\n"
            "materials { steel { density 7800; youngsModulus 7e10;"
            " poissonsRatio 0.3; } }\n"
            "pairs { steel-steel { restitution 0.5; friction 0.5; } }\n"
            "shapes { ball { type sphere; diameter 0.1; } }\n"
            "contact { tangential " + std::string(tangential) + "; }\n"
            "walls { floor { type plane; point (0 0 0); normal (0 0 1);"
            " material steel; } }\n"
            "stepControl { type hades; }\n"
            "bodies\n{\n"
            "straight { material steel; shape ball; position (0 0 0.0501);"
            " velocity (0 0 -5); }\n"
            "slides { material steel; shape ball; position (1 0 0.0501);"
            " velocity (20 0 -5); }\n}\n"
        );
        const int wrong = FE_OVERFLOW | FE_DIVBYZERO | FE_INVALID;
        std::feclearexcept(FE_ALL_EXCEPT);
        c.run(0.001);
        const bool raised = std::fetestexcept(wrong);

        const std::string name = "hardHits_" + std::string(tangential);
        figure(name + "_exceptions", raised, 0, 0, "-", "none");
        figureNear
        (
            name, c.state().v[0].z(), 2.5, 0.01, "m/s",
            "restitution of the ball that falls straight"
        );
        figureNear
        (
            name + "_slides", c.state().v[1].x(), 20 - 0.5*1.5*5, 0.01,
            "m/s", "closed form v0 - mu (1 + e) v_n"
        );
    }
}


// ************************************************************************* //
