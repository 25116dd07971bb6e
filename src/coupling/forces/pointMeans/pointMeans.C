/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "pointMeans.H"
#include "emptyFvPatch.H"
#include "surfaceFields.H"
#include "syncTools.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace coupling
{
    defineTypeNameAndDebug(pointMeans, 0);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::coupling::pointMeans::hasValues(const label patchi) const
{
    return
       !isA<emptyFvPatch>(mesh_.boundary()[patchi])
    && !mesh_.magSf().boundaryField()[patchi].coupled();
}


void Foam::coupling::pointMeans::makeWeights()
{
    static label last = 0;
    version_ = ++last;
    const pointField& points = mesh_.points();

    labelList onPatch(points.size(), 0);
    forAll(mesh_.boundaryMesh(), patchi)
    {
        const polyPatch& p = mesh_.boundaryMesh()[patchi];
        if (hasValues(patchi))
        {
            UIndirectList<label>(onPatch, p.meshPoints()) = 1;
        }
    }
    syncTools::syncPointList(mesh_, onPatch, maxEqOp<label>(), label(0));

    scalarField sums(points.size(), Zero);
    const auto append = [&]
    (
        DynamicList<share>& shares,
        const label pointi,
        const label of,
        const point& centre
    )
    {
        const scalar w = 1/mag(points[pointi] - centre);
        shares.append(share{pointi, of, w});
        sums[pointi] += w;
    };

    cells_.clear();
    const labelListList& pointCells = mesh_.pointCells();
    forAll(pointCells, pointi)
    {
        for (const label c : pointCells[pointi])
        {
            if (!onPatch[pointi])
            {
                append(cells_, pointi, c, mesh_.cellCentres()[c]);
            }
        }
    }

    faces_.clear();
    end_.setSize(mesh_.boundaryMesh().size());
    forAll(mesh_.boundaryMesh(), patchi)
    {
        const polyPatch& p = mesh_.boundaryMesh()[patchi];
        for
        (
            label f = p.start();
            hasValues(patchi) && f < p.start() + p.size();
            ++f
        )
        {
            for (const label pointi : mesh_.faces()[f])
            {
                append(faces_, pointi, f - p.start(), mesh_.faceCentres()[f]);
            }
        }
        end_[patchi] = faces_.size();
    }

    // All images of a point together
    syncTools::syncPointList(mesh_, sums, plusEqOp<scalar>(), scalar(0));
    for (share& s : cells_)
    {
        s.weight /= sums[s.point];
    }
    for (share& s : faces_)
    {
        s.weight /= sums[s.point];
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::pointMeans::pointMeans(const fvMesh& mesh)
:
    MeshObject<fvMesh, UpdateableMeshObject, pointMeans>(mesh)
{
    makeWeights();
}


// ************************************************************************* //
