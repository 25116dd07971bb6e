/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    Mass properties of closed surfaces, and the surfaces that are refused.

\*---------------------------------------------------------------------------*/

#include "closedSurface.H"
#include "figure.H"
#include "mathematicalConstants.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "testSurfaces.H"

#include <fstream>
#include <limits>

using namespace Foam;
using namespace Foam::dem;
using namespace styxTest;

using constant::mathematical::pi;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

std::string refusal(const triSurface& surface)
{
    return errorOf([&]() { closedSurface body("test", surface); });
}


std::string fileRefusal(const fileName& file)
{
    return errorOf([&]() { closedSurface body(file); });
}


scalar relative(const symmTensor& J, const symmTensor& expected)
{
    return mag(J - expected)/mag(expected);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(closedSurface, boxIntegrals)
{
    // Far from the origin, so that round-off would show
    const vector e(1, 2, 3), away(100, -200, 300);
    const triSurface surface
    (
        moved(box(e, 3), [&](const point& p) { return p + away; })
    );
    const massProperties body(closedSurface("box", surface).properties());
    const symmTensor J
    (
        6.0/12*symmTensor(4 + 9, 0, 0, 1 + 9, 0, 1 + 4)
    );

    figureNear("boxVolume", body.volume, 6, 1e-10, "m3", "closed form");
    figure
    (
        "boxCentroid",
        mag(body.centroid - away - 0.5*e),
        0,
        1e-9,
        "m",
        "closed form"
    );
    figure("boxInertia", relative(body.inertia, J), 0, 1e-9, "-", "same");
}


TEST(closedSurface, tetrahedronIntegrals)
{
    const scalar a = 1, b = 2, c = 3, V = a*b*c/6;
    const massProperties body
    (
        closedSurface("tetrahedron", tetrahedron(a, b, c)).properties()
    );

    // About the right-angled corner: int x^2 = V a^2/10, int xy = V ab/20;
    // minus V times the centroid's a^2/16, ab/16
    const symmTensor S
    (
        V*3.0/80*symmTensor(a*a, 0, 0, b*b, 0, c*c)
      - V/80*symmTensor(0, a*b, a*c, 0, b*c, 0)
    );
    const symmTensor J(tr(S)*symmTensor::I - S);

    figureNear("tetVolume", body.volume, V, 1e-12, "m3", "closed form");
    figure("tetInertia", relative(body.inertia, J), 0, 1e-12, "-", "same");
}


TEST(closedSurface, ellipsoidIntegrals)
{
    const scalar a = 1, b = 2, c = 3, V = 4*pi/3*a*b*c;
    const symmTensor J
    (
        V/5*symmTensor(b*b + c*c, 0, 0, a*a + c*c, 0, a*a + b*b)
    );

    // The flat triangles cut off a part that falls with the square of their
    // size: two sizes give the limit
    const massProperties coarse
    (
        closedSurface("ellipsoid", ellipsoid(vector(a, b, c), 4)).properties()
    );
    const massProperties fine
    (
        closedSurface("ellipsoid", ellipsoid(vector(a, b, c), 5)).properties()
    );
    const scalar limit = fine.volume + (fine.volume - coarse.volume)/3;
    const symmTensor limitJ(fine.inertia + (fine.inertia - coarse.inertia)/3);

    figureNear("ellipsoidVolume", limit, V, 1e-5, "m3", "closed form, limit");
    figure("ellipsoidInertia", relative(limitJ, J), 0, 1e-5, "-", "same");
}


TEST(closedSurface, refusesWhatIsNotABody)
{
    const triSurface cube(box(vector::one, 3));
    List<labelledTri> faces(cube);
    const pointField points(cube.points());

    faces.setSize(faces.size() - 1);
    EXPECT_NE(refusal(triSurface(faces, points)).find("open"), size_t(-1));
    EXPECT_NE(refusal(triSurface(faces, points)).find("3 found"), size_t(-1));

    EXPECT_NE(refusal(turned(cube)).find("inverted"), size_t(-1));

    faces = cube;
    faces[4] = labelledTri(faces[4][1], faces[4][0], faces[4][2], 0);
    EXPECT_NE
    (
        refusal(triSurface(faces, points)).find("inconsistent orientation"),
        size_t(-1)
    );

    faces = cube;
    faces.append(labelledTri(faces[0]));
    EXPECT_NE
    (
        refusal(triSurface(faces, points)).find("non-manifold"),
        size_t(-1)
    );

    faces = cube;
    faces[0] = labelledTri(faces[0][0], faces[0][0], faces[0][1], 0);
    EXPECT_NE
    (
        refusal(triSurface(faces, points)).find("degenerate"),
        size_t(-1)
    );

    const scalar nan = std::numeric_limits<scalar>::quiet_NaN();
    pointField spoilt(points);
    spoilt[5].y() = nan;
    faces = cube;
    EXPECT_NE(refusal(triSurface(faces, spoilt)).find("NaN"), size_t(-1));

    EXPECT_EQ(refusal(cube), "");
}


TEST(closedSurface, refusesPiercedParts)
{
    const triSurface cube(box(vector::one, 3));
    auto shifted = [&](const scalar s, const vector& d)
    {
        return moved(cube, [=](const point& p) { return point(s*p + d); });
    };

    // Two cubes that overlap, also with edges that meet diagonals exactly
    for (const scalar d : {0.4, 0.5, 2.0/3, 0.37})
    {
        EXPECT_NE
        (
            refusal(joined(cube, shifted(1, d*vector::one)))
           .find("self-intersecting"),
            size_t(-1)
        );
    }

    // One inside the other: counted twice; turned it is a cavity
    const triSurface inner(shifted(0.3, 0.3*vector::one));
    EXPECT_NE(refusal(joined(cube, inner)).find("inside others"), size_t(-1));
    EXPECT_EQ(refusal(joined(cube, turned(inner))), "");

    // Two apart: a body of two parts; not if one is turned
    const triSurface apart(shifted(0.3, 3*vector::one));
    EXPECT_EQ(refusal(joined(cube, apart)), "");
    EXPECT_NE
    (
        refusal(joined(cube, turned(apart))).find("inverted"),
        size_t(-1)
    );

    // A face pushed through the opposite one
    const triSurface pushed
    (
        moved
        (
            cube,
            [](const point& p)
            {
                const bool inner =
                    p.z() > 0.9 && mag(p.x() - 0.4) < 0.2
                 && mag(p.y() - 0.4) < 0.2;
                return inner ? point(p - vector(0, 0, 1.5)) : p;
            }
        )
    );
    EXPECT_NE(refusal(pushed).find("self-intersecting"), size_t(-1));
}


TEST(closedSurface, refusesFiles)
{
    const fileName dir(Foam::cwd()/"closedSurfaceTest");
    mkDir(dir);

    OFstream(dir/"junk.stl")() << "this is no surface" << nl;
    OFstream(dir/"some.xyz")() << "this neither" << nl;

    EXPECT_NE(fileRefusal(dir/"none.stl").find("missing"), size_t(-1));
    EXPECT_NE(fileRefusal(dir/"junk.stl").find("junk.stl"), size_t(-1));
    EXPECT_NE(fileRefusal(dir/"junk.stl").find("unreadable"), size_t(-1));
    // Binary, but without the triangles that it promises
    std::string head(84, 'x');
    head[80] = 9;
    head[81] = head[82] = head[83] = 0;
    std::ofstream(dir/"torn.stl", std::ios::binary) << head;
    EXPECT_NE(fileRefusal(dir/"torn.stl").find("unreadable"), size_t(-1));

    // Text that starts like one of its kind
    OFstream(dir/"half.stl")() << "solid a" << nl << "facet normal 0 0 1" << nl;
    EXPECT_NE(fileRefusal(dir/"half.stl").find("'outer loop'"), size_t(-1));

    // A corner that is not there
    OFstream(dir/"far.obj")()
        << "v 0 0 0" << nl << "v 1 0 0" << nl << "v 0 1 0" << nl
        << "f 1 2 9" << nl;
    EXPECT_NE(fileRefusal(dir/"far.obj").find("corner number 8"), size_t(-1));

    EXPECT_NE(fileRefusal(dir/"some.xyz").find("cannot read"), size_t(-1));

    // What was written is read again, in other units
    box(vector(1, 2, 3), 2).write(dir/"box.obj");
    figureNear
    (
        "boxScaled",
        closedSurface(dir/"box.obj", 0.001).properties().volume,
        6e-9,
        1e-6,
        "m3",
        "closed form"
    );

    rmDir(dir);
}


// ************************************************************************* //
