/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.


Description
    The volume of bodies in the cells of a mesh: hexahedra, tetrahedra, and
    refined cells beside such with hanging nodes.

\*---------------------------------------------------------------------------*/

#include "bodies.H"
#include "bodyGeometry.H"
#include "cellBins.H"
#include "demCase.H"
#include "figure.H"
#include "mathematicalConstants.H"
#include "placedBody.H"
#include "Random.H"
#include "testMeshes.H"
#include "volumeFraction.H"

#include <algorithm>
#include <cmath>

using namespace Foam;
using namespace styxTest;

using constant::mathematical::pi;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Diameter of the sphere and edge of the cube of thesis 8.1 [m]
const scalar d = 0.012;

const scalar latticeEdge = 1.7*d;

//- Barycentric coordinates of points that fill a tetrahedron evenly: the
//  sorted coordinates of a point of the unit cube cut the unit length in four
List<FixedList<scalar, 4>> evenPoints(const label n)
{
    const scalar g = 1.22074408460575947536;
    List<FixedList<scalar, 4>> all(n);
    forAll(all, k)
    {
        scalar u[3];
        for (label i = 0; i < 3; ++i)
        {
            const scalar x = 0.5 + (k + 1)*std::pow(g, -(i + 1));
            u[i] = x - std::floor(x);
        }
        std::sort(u, u + 3);
        all[k] = FixedList<scalar, 4>
        ({
            u[0], u[1] - u[0], u[2] - u[1], 1 - u[2]
        });
    }
    return all;
}


//- The fraction of a cell in the spheres of body 0, by points in the tetrahedra
//  between the cell's centre, its faces' centres and their edges
scalar sampled
(
    const dem::bodies& state,
    const polyMesh& mesh,
    const label cell,
    const List<FixedList<scalar, 4>>& points
)
{
    const point& a = mesh.cellCentres()[cell];
    scalar in = 0, all = 0;
    for (const label f : mesh.cells()[cell])
    {
        const face& corners = mesh.faces()[f];
        const point& b = mesh.faceCentres()[f];
        forAll(corners, e)
        {
            const point& c = mesh.points()[corners[e]];
            const point& g = mesh.points()[corners.nextLabel(e)];
            const scalar V = mag(((b - a) ^ (c - a)) & (g - a));
            label n = 0;
            for (const FixedList<scalar, 4>& w : points)
            {
                const point p = w[0]*a + w[1]*b + w[2]*c + w[3]*g;
                for (label s = 0; s < state.nSpheres(); ++s)
                {
                    if
                    (
                        magSqr(p - state.sphereX()[s]) < sqr(state.sphereR[s])
                    )
                    {
                        ++n;
                        break;
                    }
                }
            }
            in += V*n;
            all += V*points.size();
        }
    }
    return in/all;
}


struct errors
{
    //- Of the volume, over the body's [-]
    scalar volume = 0;

    //- Of the worst cell, over the cell's volume [-]
    scalar cell = 0;

    void add(const errors& e)
    {
        volume = max(volume, e.volume);
        cell = max(cell, e.cell);
    }
};


//- Body 0 on the mesh; the cells are looked at if there are points
errors errorsOf
(
    const dem::bodies& state,
    const polyMesh& mesh,
    const coupling::cellBins& bins,
    const scalar exact,
    const List<FixedList<scalar, 4>>& points
)
{
    const coupling::volumeFraction fraction(mesh);
    const coupling::bodyGeometry body(state, 0, vector::one);

    errors e;
    scalar volume = 0;
    bins.forEach
    (
        state.x[0],
        state.shapeOf(0).boundingRadius(),
        [&](const label c)
        {
            const scalar beta = fraction(body, c, bins.radius(c));
            volume += beta*mesh.cellVolumes()[c];
            const scalar phi = body.distance(mesh.cellCentres()[c]);
            if (points.size() && mag(phi) < bins.radius(c))
            {
                e.cell = max
                (
                    e.cell,
                    mag(beta - sampled(state, mesh, c, points))
                );
            }
        }
    );
    e.volume = mag(volume/exact - 1);
    return e;
}


PtrList<dem::shape> oneShape(const dem::shape& s)
{
    PtrList<dem::shape> shapes(1);
    shapes.set(0, new dem::shape(s));
    return shapes;
}


dem::shape nineSpheres()
{
    return dem::shape
    (
        "cube",
        dictionaryOf(cubeOfNine).subDict("shapes").subDict("cube"),
        "."
    );
}


//- A body at many places, turned at random, on one kind of mesh with 8 and 12
//  cells over d; the cells are looked at for the first place
void onMesh
(
    const blockMesh::kind kind,
    const dem::shape& shape,
    const label nPlaces,
    const std::string& name,
    const std::string& source
)
{
    // Tetrahedra of a cell: edges of all its faces
    const label tets = kind == blockMesh::kind::tet ? 12 : 24;
    const List<FixedList<scalar, 4>> none;
    const List<FixedList<scalar, 4>> points = evenPoints(20000/tets);

    const PtrList<dem::shape> shapes = oneShape(shape);
    Random random(3);
    errors e;

    for (const label cells : {8, 12})
    {
        const scalar h = d/cells;
        const label n = label(std::ceil(latticeEdge/h));
        const blockMesh mesh(kind, n*h, n);
        const coupling::cellBins bins(mesh());

        for (label k = 0; k < nPlaces; ++k)
        {
            e.add
            (
                errorsOf
                (
                    placed(shapes, h, random),
                    mesh(),
                    bins,
                    shapes[0].unionVolume(),
                    k ? none : points
                )
            );
        }
    }

    figure("volumeFraction_" + name + "_volume", 100*e.volume, 0, 0.2, "%",
        source + "; issue 2");
    figure("volumeFraction_" + name + "_cell", 100*e.cell, 0, 1, "%",
        "20,000 points a cell; issue 2");
}


void sphereOn(const blockMesh::kind kind, const std::string& name)
{
    onMesh(kind, dem::shape::sphere("ball", d), 30, name, "pi d^3/6");
}


void clumpOn(const blockMesh::kind kind, const std::string& name)
{
    onMesh(kind, nineSpheres(), 5, name + "_clump", "union of 9 spheres");
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(volumeFraction, hex)
{
    sphereOn(blockMesh::kind::hex, "hex");
}


TEST(volumeFraction, tet)
{
    sphereOn(blockMesh::kind::tet, "tet");
}


TEST(volumeFraction, refined)
{
    sphereOn(blockMesh::kind::refined, "refined");
}


TEST(volumeFraction, hexClump)
{
    clumpOn(blockMesh::kind::hex, "hex");
}


TEST(volumeFraction, tetClump)
{
    clumpOn(blockMesh::kind::tet, "tet");
}


TEST(volumeFraction, refinedClump)
{
    clumpOn(blockMesh::kind::refined, "refined");
}


TEST(volumeFraction, unionOfTwo)
{
    // Two spheres of radius R at a distance of R: two balls less their lens
    const scalar R = 0.5*d;
    const scalar exact = 2*4*pi/3*pow3(R) - 5*pi/12*pow3(R);

    List<dem::shape::sphereData> spheres(2);
    spheres[0] = dem::shape::sphereData(point(0.5*R, 0, 0), R);
    spheres[1] = dem::shape::sphereData(point(-0.5*R, 0, 0), R);
    const PtrList<dem::shape> two = oneShape(dem::shape("two", spheres));

    const scalar h = d/10;
    const blockMesh mesh(blockMesh::kind::hex, 20*h, 20);
    const coupling::cellBins bins(mesh());
    Random random(5);
    errors e;
    for (label k = 0; k < 10; ++k)
    {
        e.add
        (
            errorsOf
            (
                placed(two, h, random),
                mesh(),
                bins,
                exact,
                List<FixedList<scalar, 4>>()
            )
        );
    }
    figure("volumeFraction_union", 100*e.volume, 0, 0.2, "%",
        "two balls less their lens, closed form");
}


TEST(volumeFraction, linear)
{
    // Corners below 0 of a tetrahedron cut by planes: closed forms
    const auto part = coupling::cutTets::negativeFraction;
    EXPECT_EQ(part(1, 2, 3, 4), 0);
    EXPECT_EQ(part(-1, -2, -3, 0), 1);
    EXPECT_NEAR(part(-1, 1, 1, 1), 0.125, 1e-15);
    EXPECT_NEAR(part(-1, -1, 1, 1), 0.5, 1e-15);
    EXPECT_NEAR(part(-1, -1, 1, -1), 0.875, 1e-15);
    EXPECT_NEAR(part(3, -1, -1, -1), 1 - 27./64, 1e-15);

    // Corners on the plane
    EXPECT_NEAR(part(0, 0, 0, 1), 0, 1e-15);
    EXPECT_NEAR(part(-1, 0, 0, 0), 1, 1e-15);
    EXPECT_NEAR(part(-1, 0, 0, 1), 0.5, 1e-15);
}


// ************************************************************************* //
