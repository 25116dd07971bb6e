/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    Added mass and inertia of ellipsoids against Lamb's closed forms.

\*---------------------------------------------------------------------------*/

#include "addedMass.H"
#include "figure.H"
#include "mathematicalConstants.H"

#include <cmath>

using namespace Foam;
using namespace styxTest;

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

const scalar pi = constant::mathematical::pi;

scalar volumeOf(const vector& axes)
{
    return 4*pi/3*cmptProduct(axes);
}

coupling::addedMass ellipsoid(const vector& axes)
{
    const vector a2 = cmptMultiply(axes, axes);
    const scalar V = volumeOf(axes);
    return coupling::addedMass
    (
        V,
        V/5*vector(a2.y() + a2.z(), a2.z() + a2.x(), a2.x() + a2.y())
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(addedMass, carlson)
{
    // A complete integral: R_D(0, 2, 1) is known to 13 digits
    figureNear
    (
        "addedMass_RD", coupling::addedMass::RD(0, 2, 1), 1.7972103521034,
        1e-12, "-", "Carlson 1995"
    );
}


TEST(addedMass, sphere)
{
    const coupling::addedMass m(ellipsoid(vector(3, 3, 3)));
    figureNear
    (
        "addedMass_sphere", m.mass().x(), 0.5, 1e-12, "-", "closed form"
    );
    EXPECT_EQ(m.inertia(), vector(Zero));
}


TEST(addedMass, prolate)
{
    // Elementary functions of the eccentricity
    const coupling::addedMass m(ellipsoid(vector(2, 1, 1)));
    const scalar e = std::sqrt(0.75);
    const scalar log = std::log((1 + e)/(1 - e));
    const scalar alpha = 2*(1 - sqr(e))/pow3(e)*(log/2 - e);
    const scalar beta = 1/sqr(e) - (1 - sqr(e))/(2*pow3(e))*log;

    figureNear
    (
        "addedMass_along", m.mass().x(), alpha/(2 - alpha), 1e-10, "-",
        "Lamb, article 114"
    );
    figureNear
    (
        "addedMass_broadside", m.mass().y(), beta/(2 - beta), 1e-10, "-",
        "Lamb, article 114"
    );
    figureNear
    (
        "addedMass_tumbling",
        m.inertia().y(),
        pow4(e)*(beta - alpha)
       /((2 - sqr(e))*(2*sqr(e) - (2 - sqr(e))*(beta - alpha))),
        1e-9,
        "-",
        "Lamb, article 115"
    );
    EXPECT_NEAR(m.inertia().x(), 0, 1e-12);
}


TEST(addedMass, disc)
{
    // 8/3 a^3 and 16/45 a^5 of the density, the limits of a thin disc
    const scalar c = 0.02;
    const vector axes(1, 1, c);
    const coupling::addedMass m(ellipsoid(axes));
    const scalar V = volumeOf(axes);

    figureNear
    (
        "addedMass_disc", m.mass().z()*V, 8.0/3, 0.02, "m3",
        "thin disc, Lamb, article 102"
    );
    figureNear
    (
        "addedMass_discTumbling", m.inertia().x()*V*(1 + sqr(c))/5, 16.0/45,
        0.02, "m5", "thin disc, Lamb, article 115"
    );
}


TEST(addedMass, frictionOfSphere)
{
    // Stokes' drag with Basset's layer at the frequency 1/dt, over the
    // displaced mass; of the layer half goes in the next step, as the powers
    // of z of sqrt(1 - z) begin with 1 - z/2
    const scalar a = 3;
    const coupling::addedMass m(ellipsoid(vector(a, a, a)));
    for (const scalar nuDt : {1e-4, 1.0, 1e4})
    {
        const scalar lambda = a/std::sqrt(nuDt);
        figureNear
        (
            "addedMass_friction", m.frictionMass(nuDt).y(),
            4.5*(1 + lambda)/sqr(lambda), 1e-12, "-", "Basset, closed form"
        );
        figureNear
        (
            "addedMass_passing", m.passingMass(nuDt).y(), 2.25/lambda, 1e-12,
            "-", "of sqrt(1 - z)"
        );
        figureNear
        (
            "addedMass_frictionSpin", m.frictionInertia(nuDt).y(),
            15/sqr(lambda)*(1 + sqr(lambda)/(3*(1 + lambda))), 1e-12, "-",
            "Kim & Karrila, closed form"
        );

        // s dK/ds, by a difference; the factor before it is without s
        const auto K = [&](const scalar x)
        {
            return m.frictionInertia(x).y()/x;
        };
        const scalar step = 1e-5;
        figureNear
        (
            "addedMass_passingSpin", m.passingInertia(nuDt).y(),
            -nuDt*(K(nuDt*(1 + step)) - K(nuDt*(1 - step)))/(2*step), 1e-6,
            "-", "derivative of the above"
        );
    }
    EXPECT_EQ(m.frictionMass(0), vector(Zero));
    EXPECT_EQ(m.frictionInertia(0) + m.passingInertia(0), vector(Zero));
}


TEST(addedMass, frictionOfDisc)
{
    // Creeping flow, in which the layer is far wider than the disc: 16 mu a
    // broadside, 32/3 mu a edgewise, 32/3 mu a^3 about any axis
    const scalar nuDt = 1e8;
    const vector axes(1, 1, 1e-2);
    const coupling::addedMass m(ellipsoid(axes));
    const scalar V = volumeOf(axes);
    figureNear
    (
        "addedMass_discBroadside", m.frictionMass(nuDt).z()*V/nuDt, 16, 0.01,
        "m", "Kim & Karrila, disc"
    );
    figureNear
    (
        "addedMass_discEdgewise", m.frictionMass(nuDt).x()*V/nuDt, 32.0/3,
        0.01, "m", "Kim & Karrila, disc"
    );
    figureNear
    (
        "addedMass_discTurns", m.frictionInertia(nuDt).x()*V/5/nuDt, 32.0/3,
        0.01, "m3", "Kim & Karrila, disc"
    );
}


TEST(addedMass, needlesAndPlatesAreFinite)
{
    const coupling::addedMass rod(1, vector(0, 1, 1));
    const coupling::addedMass disc(1, vector(1, 1, 2));
    for (const coupling::addedMass* m : {&rod, &disc})
    {
        EXPECT_TRUE(std::isfinite(cmptSum(m->mass() + m->inertia())));
        EXPECT_GT(cmptMin(m->mass()), 0);
        EXPECT_GE(cmptMin(m->inertia()), -1e-12);
        EXPECT_TRUE
        (
            std::isfinite
            (
                cmptSum(m->frictionMass(1) + m->frictionInertia(1))
            )
        );
    }
}


// ************************************************************************* //
