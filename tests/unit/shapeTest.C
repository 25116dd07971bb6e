/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    The principal frame of a shape, and templates that are refused.

\*---------------------------------------------------------------------------*/

#include "figure.H"
#include "Fstream.H"
#include "mathematicalConstants.H"
#include "OSspecific.H"
#include "quaternion.H"
#include "shape.H"
#include "StringStream.H"
#include "testSurfaces.H"

#include <cmath>

using namespace Foam;
using namespace Foam::dem;
using namespace styxTest;

using constant::mathematical::pi;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

dictionary dictOf(const std::string& text)
{
    IStringStream is(text);
    return dictionary(is);
}


std::string refusal(const std::string& text)
{
    return errorOf([&]() { shape s("test", dictOf(text), "."); });
}


bool says(const std::string& text, const std::string& part)
{
    return refusal(text).find(part) != std::string::npos;
}


massProperties body(const tensor& axes, const vector& moments)
{
    massProperties b;
    b.volume = 1;
    b.inertia = symm
    (
        axes & tensor(moments.x(), 0, 0, 0, moments.y(), 0, 0, 0, moments.z())
      & axes.T()
    );
    return b;
}


// How far axes and moments are from diagonalising the body's inertia with a
// proper rotation
scalar frameError(const massProperties& b)
{
    tensor R;
    vector m;
    b.principalAxes(R, m);

    const tensor back
    (
        R & tensor(m.x(), 0, 0, 0, m.y(), 0, 0, 0, m.z()) & R.T()
    );
    return
        mag(back - b.inertia)/mag(b.inertia)
      + mag((R & R.T()) - tensor::I) + mag(det(R) - 1);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(shape, sphere)
{
    const scalar d = 0.02, V = pi/6*pow3(d);
    const shape s(shape::sphere("ball", d));

    EXPECT_TRUE(s.isSphere());
    EXPECT_EQ(s.centres()[0], vector::zero);
    figureNear("sphereVolume", s.volume(), V, 1e-12, "m3", "closed form");
    figureNear
    (
        "sphereInertia",
        s.inertiaPerDensity().z(),
        V*sqr(d)/10,
        1e-12,
        "m5",
        "2/5 V r^2"
    );
    figureNear("sphereDiameter", s.equivalentDiameter(), d, 1e-12, "m", "d");
}


TEST(shape, principalFrame)
{
    const quaternion turn(vector(1, -2, 0.5)/std::sqrt(5.25), 0.7);
    const quaternion far(vector(0.3, 1, 0.2)/std::sqrt(1.13), 2.6);

    scalar worst = 0;
    for (const quaternion& q : {turn, far})
    {
        for
        (
            const vector& m :
            {
                vector(1, 2, 2.5), vector(2, 2, 1), vector(2, 2, 3),
                vector(2, 1, 2), vector(1, 1, 1), vector(1, 1 + 1e-7, 1.2)
            }
        )
        {
            worst = max(worst, frameError(body(q.R(), m)));
        }
    }
    figure("principalFrame", worst, 0, 1e-8, "-", "R m R^T = J, det R = 1");

    // A small turn is found again, moments named as the user's axes are
    tensor R;
    vector m;
    body(turn.R(), vector(2.5, 1, 2)).principalAxes(R, m);
    figure("frameTurned", mag(R - turn.R()), 0, 1e-8, "-", "the turn put in");
    figure("frameMoments", mag(m - vector(2.5, 1, 2)), 0, 1e-8, "-", "same");

    // Round-off does not turn a cube, nor a rod about its axis
    const symmTensor noise(0, 1e-12, -2e-12, 1e-12, 3e-12, 0);
    massProperties cube(body(tensor::I, vector::one));
    cube.inertia += noise;
    cube.principalAxes(R, m);
    figure("frameCube", mag(R - tensor::I), 0, 0, "-", "user's axes");

    massProperties rod(body(turn.R(), vector(3, 3, 1)));
    tensor R2;
    vector m2;
    rod.principalAxes(R, m);
    rod.inertia += noise;
    rod.principalAxes(R2, m2);
    figure("frameRod", mag(R - R2), 0, 1e-9, "-", "the same frame");
}


TEST(shape, clumpFrame)
{
    // Two spheres on a slanting line, far from the origin
    const vector u(vector(2, 1, 1)/std::sqrt(6.0)), o(10, 20, 30);
    const shape s
    (
        "pair",
        List<shape::sphereData>
        ({
            shape::sphereData(o - 0.5*u, 1),
            shape::sphereData(o + 0.5*u, 1)
        })
    );

    scalar worst = mag(s.centreOfMass() - o);
    forAll(s.centres(), i)
    {
        const point back(s.centreOfMass() + (s.toUser() & s.centres()[i]));
        worst = max(worst, mag(back - (o + (i - 0.5)*u)));
    }

    figure("clumpFrame", worst, 0, 1e-8, "m", "centres put in");
    figureNear("clumpRadius", s.boundingRadius(), 1.5, 1e-9, "m", "1 + 1/2");
    EXPECT_FALSE(s.isSphere());
}


TEST(shape, fromFile)
{
    const fileName dir(Foam::cwd()/"shapeTest");
    mkDir(dir);

    OFstream(dir/"rock")()
        << "FoamFile { version 2.0; format ascii; class dictionary;"
        << " object rock; }" << nl
        << "volume 5; centreOfMass (1 0 0); inertiaPerDensity (1 0 0 2 0 2.5);"
        << nl << "spheres ( ((0 0 0) 1) ((1 0 0) 0.5) );" << nl;

    const shape s("rock", dictOf("type multisphere; file \"rock\";"), dir);
    rmDir(dir);

    EXPECT_EQ(s.volume(), 5);
    EXPECT_EQ(s.inertiaPerDensity(), vector(1, 2, 2.5));
    EXPECT_EQ(s.centres()[0], point(-1, 0, 0));
    EXPECT_EQ(s.boundingRadius(), 2);
}


TEST(shape, refusesBadTemplates)
{
    const std::string many("type multisphere; spheres ( ((0 0 0) 1) ); ");

    EXPECT_TRUE(says("type sphere; diametre 1;", "'diametre'"));
    EXPECT_TRUE(says("type sphere; diametre 1;", "did you mean 'diameter'?"));
    EXPECT_TRUE(says("type sphere; diametre 1;", "diameter type"));
    EXPECT_TRUE(says("type sphere; diameter 1; density 2;", "'density'"));
    EXPECT_TRUE(says("type blob;", "ellipsoid multisphere sphere"));
    EXPECT_TRUE(says("type sphere; diameter 0;", "greater than zero"));
    EXPECT_TRUE(says("type sphere; diameter -1;", "greater than zero"));
    EXPECT_TRUE(says("type sphere; diameter nan;", "nan"));
    EXPECT_TRUE(says("type multisphere;", "'file' and 'spheres'"));
    EXPECT_TRUE(says("type multisphere; spheres ();", "zero volume"));
    EXPECT_TRUE
    (
        says("type multisphere; spheres ( ((0 0 0) 0) );", "place 0")
    );
    EXPECT_TRUE(says("type multisphere; file \"none\";", "missing"));
    EXPECT_TRUE(says(many + "volume 1;", "centreOfMass"));
    EXPECT_TRUE
    (
        says
        (
            many + "volume 0; centreOfMass (0 0 0);"
            "inertiaPerDensity (1 0 0 1 0 1);",
            "'volume'"
        )
    );
    EXPECT_TRUE
    (
        says
        (
            many + "volume 1; centreOfMass (0 0 0);"
            "inertiaPerDensity (1 0 0 1 0 5);",
            "no solid has"
        )
    );
    EXPECT_EQ(refusal(many), "");
}


TEST(shape, namesTheLine)
{
    const fileName file(Foam::cwd()/"shapeLines");
    OFstream(file)() << "type sphere;" << nl << nl << "diametre 1;" << nl;
    IFstream is(file);
    const dictionary dict(is);
    rm(file);

    try
    {
        shape s("test", dict, ".");
        ADD_FAILURE() << "accepted";
    }
    catch (const IOerror& e)
    {
        EXPECT_EQ(e.ioStartLineNumber(), 3);
        EXPECT_NE(e.ioFileName().find("shapeLines"), std::string::npos);
    }
}


// ************************************************************************* //
