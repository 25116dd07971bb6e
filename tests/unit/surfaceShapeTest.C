/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Test
    surfaceShape

Description
    Shapes whose geometry is a closed surface: the signed distance against
    closed forms, the volume in cells of each kind against the surface's own,
    cell by cell against points.

\*---------------------------------------------------------------------------*/

#include "bodies.H"
#include "bodyGeometry.H"
#include "cellBins.H"
#include "demCase.H"
#include "figure.H"
#include "mathematicalConstants.H"
#include "OSspecific.H"
#include "placedBody.H"
#include "Random.H"
#include "testMeshes.H"
#include "testSurfaces.H"
#include "volumeFraction.H"

#include <cmath>

using namespace Foam;
using namespace styxTest;

using constant::mathematical::pi;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Signed distance to a box about a centre
scalar boxDistance(const point& p, const point& centre, const vector& edges)
{
    const vector q = cmptMag(p - centre) - 0.5*edges;
    return mag(max(q, vector(Zero))) + min(cmptMax(q), scalar(0));
}


//- A shape with one sphere and a surface that is written to a file
dem::shape withSurface(const word& name, const triSurface& surface)
{
    const fileName dir("surfaceShape");
    mkDir(dir);
    surface.write(dir/name + ".obj");
    return dem::shape
    (
        name,
        dictionaryOf
        (
            "type multisphere; spheres ( ((0 0 0) 0.001) );"
            " geometry surface; surface \"" + name + ".obj\";"
        ),
        dir
    );
}


//- Largest error of the volume [-] at some places on a kind of mesh; of cells
//  against 13^3 points if there is a closed form of the distance
void onMesh
(
    const blockMesh::kind kind,
    const std::string& name,
    const dem::shape& form,
    const vector* edges
)
{
    PtrList<dem::shape> shapes(1);
    shapes.set(0, new dem::shape(form));
    const scalar h = 0.012/10;
    const blockMesh mesh(kind, 24*h, 24);
    const coupling::cellBins bins(mesh());
    const coupling::volumeFraction fraction(mesh());
    Random random(7);
    scalar volumeError = 0, cellError = 0;

    for (label k = 0; k < 4; ++k)
    {
        const dem::bodies state(placed(shapes, h, random));
        const coupling::bodyGeometry body(state, 0, vector::one);
        const tensor toBox = state.userOrientation(0).R().T();
        scalar volume = 0;
        bins.forEach
        (
            state.x[0],
            form.fluidRadius(),
            [&](const label c)
            {
                const scalar beta = fraction(body, c, bins.radius(c));
                volume += beta*mesh().cellVolumes()[c];
                if (!edges || kind != blockMesh::kind::hex || k)
                {
                    return;
                }
                label in = 0;
                const label n = 13;
                for (label i = 0; i < n*n*n; ++i)
                {
                    const vector at(i % n, (i/n) % n, i/(n*n));
                    const point p =
                        mesh().cellCentres()[c]
                      + h*((at + 0.5*vector::one)/n - 0.5*vector::one);
                    in +=
                        boxDistance(toBox & (p - state.x[0]), Zero, *edges)
                      < 0;
                }
                cellError = max(cellError, mag(beta - in/scalar(n*n*n)));
            }
        );
        volumeError = max(volumeError, mag(volume/form.fluidVolume() - 1));
    }

    figure("surfaceShape_" + name + "_volume", 100*volumeError, 0, 0.2, "%",
        "the surface's own volume; issue 6");
    if (cellError > 0)
    {
        figure("surfaceShape_" + name + "_cell", 100*cellError, 0, 2, "%",
            "2197 points a cell, which are right within 1.5 %");
    }
}


const vector edges(0.012, 0.009, 0.007);

dem::shape brick()
{
    return withSurface
    (
        "brick",
        moved
        (
            box(edges, 3),
            [](const point& p) { return p - 0.5*edges; }
        )
    );
}


dem::shape egg()
{
    return withSurface("egg", ellipsoid(vector(0.006, 0.005, 0.004), 3));
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(surfaceShape, distance)
{
    // A box with a cavity: its surface has edges and corners of both kinds
    const vector outer(3, 2, 1.5), inner(1.2, 1, 0.7);
    const point at(0.2, -0.1, 0.1);
    const triSurface surface
    (
        joined
        (
            moved
            (
                box(outer, 2),
                [&](const point& p) { return p - 0.5*outer; }
            ),
            turned
            (
                moved
                (
                    box(inner, 3),
                    [&](const point& p) { return p - 0.5*inner + at; }
                )
            )
        )
    );
    const dem::surfaceDistance distance("hollow", surface);

    Random random(1);
    scalar worst = 0, worstLocal = 0;
    for (label k = 0; k < 20000; ++k)
    {
        const point p = 4*(random.sample01<vector>() - 0.5*vector::one);
        const scalar exact = max
        (
            boxDistance(p, Zero, outer),
            -boxDistance(p, at, inner)
        );
        const auto hit = distance(p);
        worst = max(worst, mag(hit.phi - exact));
        const auto local = distance(p, distance.within(p, mag(exact) + 0.1));
        worstLocal = max(worstLocal, mag(local.phi - exact));
    }
    figure("surfaceShape_distance", worst, 0, 1e-12, "m",
        "closed form of a box with a cavity");
    figure("surfaceShape_distance_near", worstLocal, 0, 1e-12, "m",
        "the same, of the triangles that are near");
    EXPECT_TRUE(distance.plane());
    EXPECT_NE(distance.face(0), distance.face(surface.size() - 1));
}


TEST(surfaceShape, mass)
{
    const dem::shape s(brick());
    const scalar V = edges.x()*edges.y()*edges.z();
    figureNear("surfaceShape_mass", s.volume(), V, 1e-6, "m3",
        "of the surface, not of the sphere in it");
    EXPECT_NEAR(s.fluidVolume()/V, 1, 1e-6);
    EXPECT_NEAR(s.fluidRadius()/(0.5*mag(edges)), 1, 1e-6);
    EXPECT_FALSE(s.isSphere());

    const dem::shape twice(s.scaled("twice", 2));
    EXPECT_NEAR(twice.fluidVolume()/(8*V), 1, 1e-6);
    EXPECT_NEAR(twice.fluidRadius()/mag(edges), 1, 1e-6);
}


TEST(surfaceShape, hex)
{
    onMesh(blockMesh::kind::hex, "hex", brick(), &edges);
    onMesh(blockMesh::kind::hex, "hex_egg", egg(), nullptr);
}


TEST(surfaceShape, tet)
{
    onMesh(blockMesh::kind::tet, "tet", brick(), nullptr);
}


TEST(surfaceShape, refined)
{
    onMesh(blockMesh::kind::refined, "refined", brick(), nullptr);
}


// ************************************************************************* //
