/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.


Description
    Finding cells: the cell of any point, on faces, edges and vertices too,
    and the cells that a ball may touch.

\*---------------------------------------------------------------------------*/

#include "cellBins.H"
#include "figure.H"
#include "Random.H"
#include "testMeshes.H"

#include <set>

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


//- How far a point lies outside of a cell's farthest face [m]
scalar outside(const polyMesh& mesh, const label cell, const point& p)
{
    scalar worst = -GREAT;
    for (const label f : mesh.cells()[cell])
    {
        vector n = mesh.faceAreas()[f];
        n *= (mesh.faceOwner()[f] == cell ? 1 : -1)/mag(n);
        worst = max(worst, n & (p - mesh.faceCentres()[f]));
    }
    return worst;
}


//- Is the point found, in a cell that holds it?
bool found
(
    const polyMesh& mesh,
    const coupling::cellBins& bins,
    const point& p
)
{
    const label c = bins.find(p);
    return c >= 0 && outside(mesh, c, p) < 1e-9;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(cellBins, find)
{
    label lost = 0;
    label asked = 0;
    for (const blockMesh::kind kind : kinds)
    {
        const blockMesh block(kind, 1, 7);
        const polyMesh& mesh = block();
        const coupling::cellBins bins(mesh);

        DynamicList<point> points;
        points.append(mesh.points());
        points.append(mesh.cellCentres());
        for (const edge& e : mesh.edges())
        {
            points.append(e.centre(mesh.points()));
            points.append
            (
                0.3*mesh.points()[e[0]] + 0.7*mesh.points()[e[1]]
            );
        }
        points.append(mesh.faceCentres());
        Random random(1);
        for (label k = 0; k < 2000; ++k)
        {
            points.append(random.sample01<vector>() - 0.5*vector::one);
        }

        for (const point& p : points)
        {
            ++asked;
            lost += !found(mesh, bins, p);
        }

        for (label k = 0; k < 100; ++k)
        {
            point p = 3*(random.sample01<vector>() - 0.5*vector::one);
            p[k % 3] = k % 2 ? 0.51 : -0.51;
            EXPECT_EQ(bins.find(p), -1) << p.x() << ' ' << p.y();
        }
    }
    EXPECT_GT(asked, 10000);
    figure("cellBins_lost", lost, 0, 0, "points",
        "on corners, edges, faces and inside of three meshes");
}


// Row 30 of the hard cases: outside by round-off is not lost
TEST(cellBins, outsideByRoundOff)
{
    label lost = 0;
    for (const blockMesh::kind kind : kinds)
    {
        const blockMesh block(kind, 1, 7);
        const coupling::cellBins bins(block());
        for (const point& p : block().points())
        {
            lost += bins.find(p*(1 + 1e-15)) < 0;
            lost += bins.find(p + 1e-15*vector(1, -1, 1)) < 0;
        }
    }
    figure("hard30_outside", lost, 0, 0, "points",
           "row 30: corners of three meshes, 1e-15 off");
}


// From any cell, the same is found: points inside, on faces, edges and corners,
// and outside
TEST(cellBins, walk)
{
    label differ = 0;
    label asked = 0;
    for (const blockMesh::kind kind : kinds)
    {
        const blockMesh block(kind, 1, 7);
        const polyMesh& mesh = block();
        const coupling::cellBins bins(mesh);
        Random random(3);
        for (label k = 0; k < 3000; ++k)
        {
            point p = 1.1*(random.sample01<vector>() - 0.5*vector::one);
            if (k % 5 == 0)
            {
                p = mesh.faceCentres()[k % mesh.nFaces()];
            }
            if (k % 5 == 1)
            {
                p = mesh.points()[k % mesh.nPoints()];
            }
            const label near = label(random.sample01<scalar>()*mesh.nCells());
            ++asked;
            differ += bins.find(p) != bins.find(p, near);
        }
        differ += bins.find(Zero) != bins.find(Zero, mesh.nCells() + 5);
    }
    figure("cellBins_walk", differ, 0, 0, "points",
           "9,000 walks from any cell against the tree");
    EXPECT_EQ(asked, 9000);
}


// The first points of a mesh are sought in bins, the others in a tree
TEST(cellBins, binsOrTree)
{
    label differ = 0;
    for (const blockMesh::kind kind : kinds)
    {
        const blockMesh block(kind, 1, 14);
        const polyMesh& mesh = block();
        const label n = mesh.nCells()/100 - 1;
        ASSERT_GT(n, 20);

        Random random(7);
        pointField points(n);
        forAll(points, k)
        {
            points[k] = 1.1*(random.sample01<vector>() - 0.5*vector::one);
            points[k] = k % 3 == 0 ? mesh.faceCentres()[17*k] : points[k];
            points[k] = k % 3 == 1 ? mesh.points()[11*k] : points[k];
        }

        const coupling::cellBins bins(mesh);
        labelList first(n);
        forAll(points, k)
        {
            first[k] = bins.find(points[k]);
        }
        bins.find(Zero);
        bins.find(Zero);
        forAll(points, k)
        {
            differ += bins.find(points[k]) != first[k];
        }
    }
    figure("cellBins_binsOrTree", differ, 0, 0, "points",
        "the same points sought again");
}


// A mesh graded by a factor of 1000: a search looks at few cells all the same
TEST(cellBins, graded)
{
    const blockMesh block(blockMesh::kind::hex, 1, 20);
    pointField points(block().points());
    for (point& p : points)
    {
        // From -1/2 to 1/2, cells grow by 1.44 each
        p.x() = (std::pow(1000.0, p.x() + 0.5) - 1)/999 - 0.5;
    }
    polyMesh& mesh = const_cast<polyMesh&>(block());
    mesh.movePoints(points);

    coupling::cellTree tree(mesh);
    label most = 0;
    for (const point& p : mesh.cellCentres())
    {
        most = max(most, tree.forEach(p, [](const label) {}));
    }
    figure("cellTree_looks", most, 1, 40, "cells",
           "of 8,000 on a mesh graded by 1000");
}


TEST(cellBins, ballsBruteForce)
{
    label missed = 0;
    label twice = 0;
    for (const blockMesh::kind kind : kinds)
    {
        const blockMesh block(kind, 1, 7);
        const polyMesh& mesh = block();
        const coupling::cellBins bins(mesh);
        Random random(2);

        for (label k = 0; k < 200; ++k)
        {
            // In the mesh and beside it
            const point x = 1.4*(random.sample01<vector>() - 0.5*vector::one);
            const scalar ball = k % 4 ? 0.4*random.sample01<scalar>() : 0;

            std::multiset<label> visited;
            bins.forEach(x, ball, [&](const label c) { visited.insert(c); });

            forAll(mesh.cells(), c)
            {
                bool touched =
                    outside(mesh, c, x) < 0
                 || mag(mesh.cellCentres()[c] - x) < ball;
                for (const label p : mesh.cellPoints()[c])
                {
                    touched = touched || mag(mesh.points()[p] - x) < ball;
                }
                missed += touched && !visited.count(c);
                twice += visited.count(c) > 1;
            }
        }
    }
    figure("cellBins_missed", missed + twice, 0, 0, "cells",
        "brute force, 600 balls on three meshes");
}


TEST(cellBins, nearest)
{
    const blockMesh block(blockMesh::kind::hex, 1, 7);
    const coupling::cellBins bins(block());
    const vector& centre = block().cellCentres()[100];

    EXPECT_EQ(bins.nearest(centre + vector(0.01, 0.02, -0.01), 0.1), 100);
    EXPECT_EQ(bins.nearest(point(3, 0, 0), 0.1), -1);
}


// ************************************************************************* //
