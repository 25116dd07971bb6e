/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    Ellipsoids as clusters: mass properties, and the distance of the surfaces.

\*---------------------------------------------------------------------------*/

#include "demCase.H"
#include "ellipsoidSpheres.H"

#include <cmath>
#include <random>

using namespace styxTest;
using namespace Foam::dem;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

shape shapeOf(const std::string& dict)
{
    return shape("egg", dictionaryOf("type ellipsoid; " + dict), ".");
}


//- The largest distance of random points of the whole surface to the spheres
//  of a template, over the equivalent diameter
scalar distance(const shape& s, const vector& axes)
{
    std::mt19937_64 dice(3);
    std::normal_distribution<scalar> u;
    scalar worst = 0;
    for (label i = 0; i < 20000; ++i)
    {
        vector e(u(dice), u(dice), u(dice));
        e /= mag(e);
        const point p = cmptMultiply(e, axes);
        scalar nearest = Foam::GREAT;
        forAll(s.centres(), k)
        {
            const point c = s.toUser() & s.centres()[k];
            nearest = Foam::min(nearest, mag(p - c) - s.radii()[k]);
        }
        worst = Foam::max(worst, Foam::mag(nearest));
    }
    return worst/s.equivalentDiameter();
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(ellipsoid, massProperties)
{
    const vector axes(0.008, 0.0125, 0.01);
    const shape s = shapeOf("semiAxes (0.008 0.0125 0.01); spheres 30;");
    const scalar V = 4*M_PI/3*1e-6;

    figureNear("ellipsoid_volume", s.volume(), V, 1e-12, "m3", "4/3 pi a b c");
    figureNear("ellipsoid_unionVolume", s.unionVolume(), V, 1e-7, "m3",
        "that of the spheres");

    // Axes in the order of the moments do not matter here: the trace does,
    // and the largest, about the shortest axis
    figureNear("ellipsoid_inertia", cmptMax(s.inertiaPerDensity()),
        V/5*(0.0125*0.0125 + 0.01*0.01), 1e-12, "m5", "V/5 (a^2 + b^2)");
    figureNear("ellipsoid_inertiaSum", cmptSum(s.inertiaPerDensity()),
        2*V/5*magSqr(axes), 1e-12, "m5", "2 V/5 (a^2 + b^2 + c^2)");
    EXPECT_EQ(s.centreOfMass(), point::zero);
    EXPECT_LE(s.radii().size(), 30);

    // Every sphere has its mirror images
    forAll(s.centres(), i)
    {
        for (int d = 0; d < 3; ++d)
        {
            point image(s.centres()[i]);
            image[d] = -image[d];
            scalar nearest = Foam::GREAT;
            forAll(s.centres(), k)
            {
                nearest = Foam::min(nearest, mag(s.centres()[k] - image));
            }
            EXPECT_LT(nearest, 1e-9);
        }
    }
}


TEST(ellipsoid, error)
{
    // Centres in an ellipse, so the error falls with the number
    scalar errors[2];
    label i = 0;
    for (const label n : {30, 100})
    {
        const ellipsoidSpheres cluster(vector(1.25, 1, 0.8), n);
        const shape s = shapeOf
        (
            "semiAxes (1.25 1 0.8); spheres " + std::to_string(n) + ";"
        );
        const scalar found = distance(s, vector(1.25, 1, 0.8));
        errors[i++] = found;
        figure("ellipsoid_error" + std::to_string(n), 100*found, 0,
            n == 30 ? 2 : 0.6, "%",
            "largest distance of the surfaces, 1.25:1:0.8");
        EXPECT_NEAR(cluster.error()/found, 1, 0.03) << n;
        EXPECT_EQ(cluster.size(), s.radii().size());
    }

    figure("ellipsoid_orderFlat",
        std::log(errors[0]/errors[1])/std::log(100/30.0), 0.8, 1.4, "-",
        "30 and 100 spheres: 1");

    // A long one: centres on a line, so the error falls with the square
    const scalar few = ellipsoidSpheres(vector(3, 1, 1), 17).error();
    const scalar many = ellipsoidSpheres(vector(3, 1, 1), 65).error();
    figure("ellipsoid_order", std::log(few/many)/std::log(65.0/17), 1.5, 2.5,
        "-", "3:1:1, 17 and 65 spheres: 2");

    const ellipsoidSpheres asked(vector(2, 1, 1), 0.005, 100);
    EXPECT_LE(asked.error(), 0.005);
    EXPECT_LT(asked.size(), 40);
}


TEST(ellipsoid, sphere)
{
    const shape s = shapeOf("semiAxes (0.01 0.01 0.01); spheres 20;");
    EXPECT_TRUE(s.isSphere());
    EXPECT_NEAR(s.radii()[0], 0.01, 1e-12);
}


TEST(ellipsoid, wrongInput)
{
    const auto expect = [](const std::string& dict, const std::string& word)
    {
        const std::string said = messageOf([&]() { shapeOf(dict); });
        EXPECT_NE(said.find(word), std::string::npos) << dict << said;
    };
    expect("semiAxes (1 1 2);", "neither");
    expect("semiAxes (1 1 2); spheres 3; surfaceError 0.1;", "both");
    expect("semiAxes (1 1 0); spheres 3;", "greater than zero");
    expect("semiAxes (1 -1 1); spheres 3;", "greater than zero");
    expect("semiAxes (1 1 21); spheres 3;", "20 times");
    expect("semiAxes (1 1 2); spheres 0;", "1 or greater");
    expect("semiAxes (1 1 2); spheres 101;", "100 at most");
    expect("semiAxes (1 1 2); surfaceError 1e-6;", "takes more than 100");
    expect("spheres 3;", "semiAxes");
    expect("semiAxes (1 1 2); spheres 3; radius 1;", "radius");
}


// ************************************************************************* //
