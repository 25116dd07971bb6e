/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    Linear interpolation to points: a linear field is exact on any mesh, the
    weights are between 0 and 1, and what is found does not depend on where the
    points were before; in cells that are boxes it is what their tetrahedra
    have; the cells of bodies on their way, too.

\*---------------------------------------------------------------------------*/

#include "barycentric.H"
#include "bodyCells.H"
#include "demCase.H"
#include "figure.H"
#include "pointWeights.H"
#include "Random.H"
#include "testMeshes.H"
#include "tetPointRef.H"

using namespace Foam;
using namespace styxTest;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const blockMesh::kind kinds[] =
{
    blockMesh::kind::hex,
    blockMesh::kind::tet,
    blockMesh::kind::refined
};


//- Points at random, on faces, edges and vertices
pointField somePoints(const polyMesh& mesh)
{
    Random random(7);
    pointField x(3000);
    for (point& p : x)
    {
        p = 0.999*(random.sample01<vector>() - 0.5*vector::one);
    }
    x.append(mesh.cellCentres());
    x.append(mesh.faceCentres());
    x.append(mesh.points());
    return x;
}


labelList cellsOf(const coupling::cellBins& bins, const pointField& x)
{
    labelList cells(x.size());
    forAll(x, i)
    {
        cells[i] = bins.find(x[i]);
    }
    return cells;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(pointWeights, linear)
{
    scalar off = 0, outside = 0;
    label other = 0;
    for (const blockMesh::kind kind : kinds)
    {
        const blockMesh block(kind, 1, 7);
        const polyMesh& mesh = block();
        const coupling::cellBins bins(mesh);
        const labelList all(identity(somePoints(mesh).size()));
        coupling::pointWeights kept(mesh);

        // They walk; those that remember against some that do not
        Random random(11);
        pointField x(somePoints(mesh));
        for (label step = 0; step < 20; ++step)
        {
            const labelList cells(cellsOf(bins, x));
            coupling::pointWeights fresh(mesh);
            kept.find(x, all, cells);
            fresh.find(x, all, cells);

            const scalarField one(mesh.nCells(), 1);
            const scalarField none(mesh.nPoints(), 0);
            forAll(x, k)
            {
                const vector at =
                    kept.value<vector>(k, mesh.cellCentres(), mesh.points());
                other += at != fresh.value<vector>
                (
                    k,
                    mesh.cellCentres(),
                    mesh.points()
                );
                off = max(off, mag(at - x[k]));
                const scalar w = kept.value<scalar>(k, one, none);
                outside = max(outside, max(w - 1, -w));
            }
            for (point& p : x)
            {
                p += 0.01*(random.sample01<vector>() - 0.5*vector::one);
                p = max(min(p, 0.499*vector::one), -0.499*vector::one);
            }
        }
    }
    figure("pointWeights_linear", off, -noBar, 1e-12, "of the box",
        "a linear field is exact: hex, tet, refined");
    figure("pointWeights_bounded", outside, -noBar, 1e-12, "-",
        "share of the cell from 0 to 1");
    figure("pointWeights_past", other, 0, 0, "values",
        "the same from any tetrahedron, bitwise");
}


TEST(pointWeights, mirrored)
{
    // A field that is even in x, y and z and the same if these change places,
    // and what it is at the images of points
    const auto value = [](const vector& v)
    {
        return
            std::cos(5*v.x())*std::cos(5*v.y())*std::cos(5*v.z())
          + sqr(v.x()*v.y()*v.z());
    };
    const blockMesh block(blockMesh::kind::hex, 1, 7);
    const polyMesh& mesh = block();
    const coupling::cellBins bins(mesh);
    scalarField inCells(mesh.nCells()), onPoints(mesh.nPoints());
    forAll(inCells, c)
    {
        inCells[c] = value(mesh.cellCentres()[c]);
    }
    forAll(onPoints, p)
    {
        onPoints[p] = value(mesh.points()[p]);
    }

    Random random(5);
    scalar off = 0;
    for (label k = 0; k < 2000; ++k)
    {
        const vector v = 0.49*(2*random.sample01<vector>() - vector::one);
        const pointField images
        ({
            v,
            vector(-v.x(), v.y(), v.z()),
            vector(v.x(), -v.y(), v.z()),
            vector(v.x(), v.y(), -v.z()),
            vector(v.y(), v.x(), v.z()),
            vector(v.z(), v.y(), v.x()),
            vector(-v.z(), -v.y(), v.x())
        });
        coupling::pointWeights weights(mesh);
        weights.find(images, identity(images.size()), cellsOf(bins, images));
        const scalar first = weights.value<scalar>(0, inCells, onPoints);
        for (label i = 1; i < images.size(); ++i)
        {
            off = max
            (
                off,
                mag(weights.value<scalar>(i, inCells, onPoints) - first)
            );
        }
    }
    figure("pointWeights_mirrored", off, -noBar, 1e-12, "-",
        "the same at all images of a point; diagonals of faces leave 0.2");
}


TEST(pointWeights, boxes)
{
    // Cubes, oblique boxes, and cells with one vertex moved, which are none
    const tensor oblique(1, 0.3, -0.2, 0.1, 0.7, 0.25, 0, -0.15, 1.2);
    scalar off = 0, outside = 0;
    label nBoxes = 0, nOthers = 0;
    for (label kind = 0; kind < 3; ++kind)
    {
        const blockMesh block(blockMesh::kind::hex, 1, 4);
        polyMesh& mesh = const_cast<polyMesh&>(block());
        pointField moved(mesh.points());
        if (kind == 1)
        {
            moved = oblique & moved;
        }
        if (kind == 2)
        {
            for (point& p : moved)
            {
                p += mag(p) < 1e-6 ? vector(0.03, 0.01, 0.02) : vector(Zero);
            }
        }
        mesh.movePoints(moved);
        mesh.tetBasePtIs();

        // Any values, not those of a linear field
        Random random(3);
        scalarField inCells(mesh.nCells()), onPoints(mesh.nPoints());
        for (scalar& value : inCells)
        {
            value = random.sample01<scalar>();
        }
        for (scalar& value : onPoints)
        {
            value = random.sample01<scalar>();
        }

        coupling::cellBoxes boxes(mesh);
        coupling::pointWeights weights(mesh);
        for (label k = 0; k < 3000; ++k)
        {
            // A tetrahedron of a cell, and a point in it
            const label c = random.position<label>(0, mesh.nCells() - 1);
            const label f = mesh.cells()[c][random.position<label>(0, 5)];
            const face& corners = mesh.faces()[f];
            const label i = random.position<label>(0, 3);
            const label one = corners[i], other = corners[(i + 1) % 4];
            point middle = Zero;
            scalar mean = 0;
            for (const label v : corners)
            {
                middle += 0.25*mesh.points()[v];
                mean += 0.25*onPoints[v];
            }
            const tetPointRef tet
            (
                mesh.cellCentres()[c],
                mesh.points()[one],
                mesh.points()[other],
                middle
            );
            const barycentric w(barycentric01(random));
            const point x(tet.barycentricToPoint(w));
            const scalar value =
                w[0]*inCells[c] + w[1]*onPoints[one] + w[2]*onPoints[other]
              + w[3]*mean;

            weights.find(pointField({x}), labelList({0}), labelList({c}));
            off = max
            (
                off,
                mag(weights.value<scalar>(0, inCells, onPoints) - value)
            );
            const coupling::cellBoxes::box* box = boxes.of(c);
            nBoxes += box != nullptr;
            nOthers += box == nullptr;

            // A point outside takes what there is on the surface
            if (box)
            {
                FixedList<label, 4> vertices;
                FixedList<scalar, 5> ws;
                box->locate(x + 3*(x - box->centre), vertices, ws);
                for (const scalar each : ws)
                {
                    outside = max(outside, max(each - 1, -each));
                }
            }
        }
    }
    EXPECT_GT(nBoxes, 6000);
    EXPECT_GT(nOthers, 100);
    figure("pointWeights_boxes", off, -noBar, 1e-12, "-",
        "any values, in the tetrahedra of cubes, oblique boxes, others");
    figure("pointWeights_boxesBounded", outside, -noBar, 1e-12, "-",
        "weights from 0 to 1 outside of a box");
}


TEST(pointWeights, bodyCells)
{
    PtrList<dem::shape> shapes(1);
    shapes.set(0, new dem::shape(dem::shape::sphere("ball", 0.01)));
    dem::bodies state(shapes);
    Random random(13);
    for (label b = 0; b < 2000; ++b)
    {
        dem::newBody n;
        n.shapeI = 0;
        n.materialI = 0;
        n.density = 1;
        n.position = 0.98*(random.sample01<vector>() - 0.5*vector::one);
        state.append(n);
    }

    const blockMesh block(blockMesh::kind::refined, 1, 9);
    const coupling::cellBins bins(block());
    coupling::bodyCells cells(bins);
    label other = 0;
    for (label step = 0; step < 200; ++step)
    {
        const labelList& found = cells.find(state);
        forAll(state.x, b)
        {
            other += found[b] != bins.find(state.x[b]);
            state.x[b] += 0.01*(random.sample01<vector>() - 0.5*vector::one);
        }
    }

    // While they are said to be still nobody looks, unless there are others
    const labelList before(cells.find(state));
    cells.setStill(true);
    forAll(state.x, b)
    {
        state.x[b] = -state.x[b];
    }
    EXPECT_EQ(cells.find(state), before);
    state.id[0] = 5000;
    const labelList& after = cells.find(state);
    forAll(state.x, b)
    {
        other += after[b] != bins.find(state.x[b]);
    }
    figure("bodyCells_walk", other, 0, 0, "bodies",
        "those that are looked for from nowhere, 2000 bodies, 200 steps");
}


// ************************************************************************* //
