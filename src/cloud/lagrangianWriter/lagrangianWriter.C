/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "lagrangianWriter.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "polyMeshTetDecomposition.H"
#include "tetIndices.H"
#include "ranksOf.H"
#include "rankSum.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::lagrangianWriter::locate
(
    const coupling::cellBins& bins,
    const UList<point>& points
)
{
    const pointField& cc = mesh_.cellCentres();

    // The rank that holds the point, or else that of the nearest cell centre
    labelList cell(points.size());
    List<scalar> distance(points.size());
    forAll(points, i)
    {
        cell[i] = bins.find(points[i]);
        distance[i] = -1;
        if (cell[i] < 0)
        {
            cell[i] = bins.nearest(points[i], mesh_.bounds().mag());
            distance[i] =
                cell[i] < 0 ? GREAT : magSqr(cc[cell[i]] - points[i]);
        }
    }

    List<scalar> least(distance);
    Pstream::listCombineGather(least, minEqOp<scalar>());
    Pstream::listCombineScatter(least);

    labelList rank(points.size(), Pstream::nProcs());
    forAll(points, i)
    {
        if (cell[i] >= 0 && distance[i] <= least[i])
        {
            rank[i] = Pstream::myProcNo();
        }
    }
    Pstream::listCombineGather(rank, minEqOp<label>());
    Pstream::listCombineScatter(rank);

    DynamicList<label> ownCell;
    DynamicList<label>& own = toRanks_[Pstream::myProcNo()];
    forAll(points, i)
    {
        if (rank[i] == Pstream::myProcNo())
        {
            own.append(i);
            ownCell.append(cell[i]);
        }
    }
    points_ = mine(points);
    cell_ = ownCell;
}


void Foam::lagrangianWriter::locateShared
(
    const coupling::cellBins& bins,
    const UList<point>& points
)
{
    const labelList rank
    (
        coupling::nearestRanksOf
        (
            mesh_,
            bins,
            points,
            coupling::cellsOf(bins, points)
        )
    );
    forAll(rank, i)
    {
        toRanks_[rank[i]].append(i);
    }
    points_ = mine(points);
    cell_.setSize(points_.size());
    forAll(points_, k)
    {
        cell_[k] = bins.find(points_[k]);
        if (cell_[k] < 0)
        {
            cell_[k] = bins.nearest(points_[k], mesh_.bounds().mag());
        }
    }
}


void Foam::lagrangianWriter::writeCoordinates
(
    Ostream& os,
    const point& p,
    const label c
) const
{
    label faceI = -1;
    label pointI = -1;
    mesh_.findTetFacePt(c, p, faceI, pointI);

    if (faceI < 0)
    {
        // Outside: any tetrahedron that is not flat will do
        scalar largest = -1;
        for
        (
            const tetIndices& t
          : polyMeshTetDecomposition::cellTetIndices(mesh_, c)
        )
        {
            const scalar volume = mag(t.tet(mesh_).mag());
            if (volume > largest)
            {
                largest = volume;
                faceI = t.face();
                pointI = t.tetPt();
            }
        }
    }

    os  << tetIndices(c, faceI, pointI).tet(mesh_).pointToBarycentric(p)
        << token::SPACE << c << token::SPACE << faceI << token::SPACE
        << pointI << nl;
}


void Foam::lagrangianWriter::writePoints() const
{
    for (const word& file : wordList({"positions", "coordinates"}))
    {
        IOobject header(io(file));
        mkDir(header.path());

        OFstream os(header.objectPath());
        os.precision(17);
        header.writeHeader(os, "Cloud<passiveParticle>");

        os  << nl << points_.size() << nl << token::BEGIN_LIST << nl;
        forAll(points_, k)
        {
            const point& p = points_[k];
            if (file == "positions")
            {
                os  << p << token::SPACE << cell_[k] << nl;
            }
            else
            {
                writeCoordinates(os, p, cell_[k]);
            }
        }
        os  << token::END_LIST << nl;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::lagrangianWriter::lagrangianWriter
(
    const polyMesh& mesh,
    const coupling::cellBins& bins,
    const word& name,
    const UList<point>& points,
    const dem::rankGroup& group,
    const UList<label>* id
)
:
    mesh_(mesh),
    name_(name),
    group_(group),
    id_(id),
    toRanks_(Pstream::nProcs())
{
    // Made by all ranks together, or not at all
    mesh.tetBasePtIs();

    if (group.shared())
    {
        locateShared(bins, points);
    }
    else
    {
        locate(bins, points);
    }
    writePoints();
}


// ************************************************************************* //
