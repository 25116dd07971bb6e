/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "ranksOf.H"
#include "polyMesh.H"
#include "rankMail.H"
#include "rankSum.H"

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Ask ranks for points, given by their numbers, and hear a number for each:
//  hear(point, rank, answer), in the order of the ranks
template<class Answer, class Hear>
void ask
(
    const UList<point>& points,
    const UList<DynamicList<label>>& toRanks,
    const Answer& answer,
    const Hear& hear
)
{
    List<DynamicList<point>> questions(toRanks.size());
    forAll(toRanks, rank)
    {
        for (const label i : toRanks[rank])
        {
            questions[rank].append(points[i]);
        }
    }

    List<DynamicList<scalar>> answers(toRanks.size());
    const List<List<point>> asked(dem::swapRecords(questions));
    forAll(asked, rank)
    {
        for (const point& p : asked[rank])
        {
            answers[rank].append(answer(p));
        }
    }

    const List<List<scalar>> heard(dem::swapRecords(answers));
    forAll(toRanks, rank)
    {
        forAll(toRanks[rank], k)
        {
            hear(toRanks[rank][k], rank, heard[rank][k]);
        }
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::List<Foam::boundBox> Foam::coupling::rankBoxes(const polyMesh& mesh)
{
    List<boundBox> boxes(Pstream::nProcs());
    boxes[Pstream::myProcNo()] = boundBox(mesh.points(), false);
    Pstream::gatherList(boxes);
    Pstream::scatterList(boxes);
    return boxes;
}


Foam::labelList Foam::coupling::cellsOf
(
    const cellBins& bins,
    const UList<point>& points
)
{
    labelList cells(points.size());
    forAll(cells, i)
    {
        cells[i] = bins.find(points[i]);
    }
    return cells;
}


Foam::labelList Foam::coupling::ranksOf
(
    const polyMesh& mesh,
    const cellBins& bins,
    const UList<point>& points,
    const labelUList& cells
)
{
    const label me = Pstream::myProcNo();
    List<boundBox> boxes(rankBoxes(mesh));

    // A point on the side of a box is in it
    for (boundBox& box : boxes)
    {
        box.inflate(1e-6);
    }

    // Who is well inside of a cell is in no other
    labelList rank(points.size(), -1);
    scalarList claim(points.size(), -GREAT);
    List<DynamicList<label>> toRanks(boxes.size());
    forAll(points, i)
    {
        bool sure = false, asked = false;
        if (cells[i] >= 0)
        {
            rank[i] = me;
            claim[i] = bins.claim(cells[i]);
        }
        forAll(boxes, r)
        {
            if (r == me || sure || !boxes[r].contains(points[i]))
            {
                continue;
            }
            sure = !asked && bins.depth(points[i], cells[i]) > 0;
            asked = true;
            if (!sure)
            {
                toRanks[r].append(i);
            }
        }
    }
    ask
    (
        points,
        toRanks,
        [&](const point& p)
        {
            const label c = bins.find(p);
            return c < 0 ? -GREAT : bins.claim(c);
        },
        [&](const label i, const label r, const scalar theirs)
        {
            if (theirs > claim[i])
            {
                claim[i] = theirs;
                rank[i] = r;
            }
        }
    );
    return rank;
}


Foam::labelList Foam::coupling::nearestRanksOf
(
    const polyMesh& mesh,
    const cellBins& bins,
    const UList<point>& points,
    const labelUList& cells
)
{
    labelList rank(ranksOf(mesh, bins, points, cells));

    const scalar most = mesh.bounds().mag();
    scalarList least(points.size(), GREAT);
    List<DynamicList<label>> toRanks(Pstream::nProcs());
    forAll(points, i)
    {
        for (DynamicList<label>& to : toRanks)
        {
            if (rank[i] < 0)
            {
                to.append(i);
            }
        }
    }
    ask
    (
        points,
        toRanks,
        [&](const point& p)
        {
            const label c = bins.nearest(p, most);
            return c < 0 ? GREAT : magSqr(mesh.cellCentres()[c] - p);
        },
        [&](const label i, const label r, const scalar distance)
        {
            if (distance < least[i])
            {
                least[i] = distance;
                rank[i] = r;
            }
        }
    );
    return rank;
}


Foam::boolList Foam::coupling::areInMesh
(
    const polyMesh& mesh,
    const cellBins& bins,
    const dem::demSolver& dem,
    const labelUList& cells
)
{
    boolList inside(cells.size());
    if (dem.group().shared())
    {
        const labelList rank(ranksOf(mesh, bins, dem.state().x, cells));
        forAll(inside, b)
        {
            inside[b] = rank[b] >= 0;
        }
        return inside;
    }
    forAll(inside, b)
    {
        inside[b] = cells[b] >= 0;
    }
    dem::anyOverRanks(inside);
    return inside;
}


// ************************************************************************* //
