/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.


\*---------------------------------------------------------------------------*/

#include "testMeshes.H"
#include "cellModel.H"
#include "cellShape.H"
#include "hexRef8.H"
#include "labelVector.H"
#include "mapPolyMesh.H"
#include "polyTopoChange.H"
#include "Random.H"

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- The corners of cube c of n along an edge, in OpenFOAM's order
labelList cubeCorners(const label c, const label n)
{
    const label i = c % n, j = (c/n) % n, k = c/(n*n);
    const auto at = [n](const label x, const label y, const label z)
    {
        return (z*(n + 1) + y)*(n + 1) + x;
    };
    return labelList
    ({
        at(i, j, k), at(i + 1, j, k), at(i + 1, j + 1, k), at(i, j + 1, k),
        at(i, j, k + 1), at(i + 1, j, k + 1), at(i + 1, j + 1, k + 1),
        at(i, j + 1, k + 1)
    });
}


pointField latticePoints(const scalar edge, const label n, const scalar shift)
{
    const scalar h = edge/n;
    Random random(7);
    pointField points((n + 1)*(n + 1)*(n + 1));

    forAll(points, p)
    {
        const labelVector ijk
        (
            p % (n + 1),
            (p/(n + 1)) % (n + 1),
            p/((n + 1)*(n + 1))
        );
        for (direction d = 0; d < 3; ++d)
        {
            points[p][d] = ijk[d]*h - 0.5*edge;
            const scalar by = shift*h*(2*random.sample01<scalar>() - 1);
            if (ijk[d] > 0 && ijk[d] < n)
            {
                points[p][d] += by;
            }
        }
    }
    return points;
}


cellShapeList cellsOf(const bool tets, const label n)
{
    // Six tetrahedra about the diagonal from corner 0 to corner 6
    const label ring[6] = {1, 2, 3, 7, 4, 5};
    DynamicList<cellShape> shapes;

    for (label c = 0; c < n*n*n; ++c)
    {
        const labelList v(cubeCorners(c, n));
        if (!tets)
        {
            shapes.append(cellShape(cellModel::ref(cellModel::HEX), v));
            continue;
        }
        for (label t = 0; t < 6; ++t)
        {
            const label a = v[ring[t]], b = v[ring[(t + 1) % 6]];
            shapes.append
            (
                cellShape
                (
                    cellModel::ref(cellModel::TET),
                    labelList({v[0], a, b, v[6]})
                )
            );
        }
    }
    return cellShapeList(shapes);
}


void refineSome(polyMesh& mesh)
{
    DynamicList<label> wanted;
    for (label c = 0; c < mesh.nCells(); c += 5)
    {
        wanted.append(c);
    }

    hexRef8 cutter(mesh, false);
    polyTopoChange change(mesh);
    cutter.setRefinement(cutter.consistentRefinement(wanted, true), change);
    const autoPtr<mapPolyMesh> map = change.changeMesh(mesh, false);
    mesh.updateMesh(*map);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

styxTest::blockMesh::blockMesh(const kind k, const double edge, const int n)
:
    time_(Time::New())
{
    const bool tets = k == kind::tet;

    mesh_.reset
    (
        new polyMesh
        (
            IOobject("mesh", time_->timeName(), *time_),
            latticePoints(edge, n, tets ? 0.15 : 0),
            cellsOf(tets, n),
            faceListList(),
            wordList(),
            wordList(),
            "outside",
            "patch",
            wordList()
        )
    );

    if (k == kind::refined)
    {
        refineSome(*mesh_);
    }
}


// ************************************************************************* //
