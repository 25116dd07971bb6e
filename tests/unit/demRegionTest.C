/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    Regions: volume, what is inside, and points that are uniform in them.

\*---------------------------------------------------------------------------*/

#include "demCase.H"
#include "region.H"

#include <cmath>
#include <random>

using namespace styxTest;
using namespace Foam::dem;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

Foam::autoPtr<region> regionOf(const std::string& s)
{
    return region::New(dictionaryOf(s));
}


//- Mean of the squares of the distances to the mean, along each axis, and the
//  share of the bounding box that is inside, of many points
struct moments
{
    vector mean = Foam::Zero;
    vector square = Foam::Zero;
    scalar share = 0;
};


moments momentsOf(const region& r)
{
    std::mt19937_64 dice(5);
    std::uniform_real_distribution<scalar> u(0, 1);
    const label n = 200000;
    moments m;
    for (label i = 0; i < n; ++i)
    {
        vector a, b;
        for (int d = 0; d < 3; ++d)
        {
            a[d] = u(dice);
            b[d] = u(dice);
        }
        const point p = r.at(a);
        EXPECT_TRUE(r.contains(p, -1e-12));
        m.mean += p/n;
        m.square += cmptMultiply(p, p)/n;
        m.share += scalar
        (
            r.contains(r.low() + cmptMultiply(b, r.high() - r.low()), 0)
        )/n;
    }
    m.square -= cmptMultiply(m.mean, m.mean);
    return m;
}


void check
(
    const std::string& name,
    const std::string& dict,
    const point& centre,
    const vector& square
)
{
    const Foam::autoPtr<region> r = regionOf(dict);
    const moments m = momentsOf(*r);
    const scalar box = cmptProduct(r->high() - r->low());

    EXPECT_NEAR(mag(m.mean - centre), 0, 0.005*std::sqrt(cmptSum(square)));
    figure("region_" + name + "_variance",
        cmptMax(cmptMag(cmptDivide(m.square, square) - vector::one)), 0, 0.015,
        "-", "uniform in volume");
    figureNear("region_" + name + "_volume", box*m.share, r->volume(), 0.01,
        "m3", "share of points of the box around it");
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(demRegion, uniform)
{
    check("box", "box (1 2 3) (2 4 6);", point(1.5, 3, 4.5),
        vector(1, 4, 9)/12.0);

    // Of a ball r^2/5; of a cylinder r^2/4 across and l^2/12 along
    check("sphere", "sphere (1 2 3) 2;", point(1, 2, 3), 0.8*vector::one);
    check("cylinder", "cylinder (1 2 3) (1 2 9) 2;", point(1, 2, 6),
        vector(1, 1, 3));

    // With the axis n a share n_i^2 of what is along, the rest of that across
    check("leaningCylinder", "cylinder (0 0 0) (2 2 1) 0.5;",
        point(1, 1, 0.5),
        vector
        (
            0.75*4/9.0 + 0.0625*5/9.0,
            0.75*4/9.0 + 0.0625*5/9.0,
            0.75/9.0 + 0.0625*8/9.0
        ));
}


TEST(demRegion, wholeBalls)
{
    const auto box = regionOf("box (0 0 0) (1 1 1);");
    EXPECT_TRUE(box->contains(point(0.5, 0.5, 0.3), 0.3));
    EXPECT_FALSE(box->contains(point(0.5, 0.5, 0.3), 0.31));

    const auto ball = regionOf("sphere (0 0 0) 1;");
    EXPECT_TRUE(ball->contains(point(0.36, 0.48, 0), 0.4));
    EXPECT_FALSE(ball->contains(point(0.36, 0.48, 0), 0.401));
    EXPECT_FALSE(ball->contains(point(0, 0, 0), 1.1));

    const auto tube = regionOf("cylinder (0 0 0) (0 0 2) 1;");
    EXPECT_TRUE(tube->contains(point(0.36, 0.48, 0.4), 0.399));
    EXPECT_FALSE(tube->contains(point(0.36, 0.48, 0.4), 0.401));
    EXPECT_FALSE(tube->contains(point(0, 0, 0.3), 0.31));
    EXPECT_FALSE(tube->contains(point(0, 0, 1.7), 0.31));
    EXPECT_TRUE(tube->contains(point(0, 0, 1.7), 0.29));
}


TEST(demRegion, wrongInput)
{
    const auto said = [](const std::string& s)
    {
        return messageOf([&]() { regionOf(s); });
    };
    const auto expect = [&](const std::string& s, const std::string& word)
    {
        EXPECT_NE(said(s).find(word), std::string::npos) << s << said(s);
    };
    expect("cube (0 0 0) (1 1 1);", "box cylinder sphere");
    expect("", "box cylinder sphere");
    expect("sphere (0 0 0) 1; box (0 0 0) (1 1 1);", "here are 2");
    expect("box (0 0 0) (1 1 -1);", "smallest");
    expect("box (0 0 0) (1 1 nan);", "nan");
    expect("box (0 0 0) (1 1 1e300);", "finite");
    expect("box (0 0 0) (1 1 1) 2;", "more numbers");
    expect("box (0 0 0);", "box");
    expect("sphere (0 0 0) 0;", "radius");
    expect("sphere (0 0 0) -1;", "radius");
    expect("sphere (0 0 0);", "sphere");
    expect("cylinder (0 0 1) (0 0 1) 1;", "axis without length");
    expect("cylinder (0 0 1) (0 0 2) 0;", "radius");
}


// ************************************************************************* //
