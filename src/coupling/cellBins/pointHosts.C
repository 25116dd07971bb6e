/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "pointHosts.H"
#include "ranksOf.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::coupling::pointHosts::find
(
    const polyMesh& mesh,
    const cellBins& bins,
    const bool nearest,
    DynamicList<point>& points,
    DynamicList<label>& cells
)
{
    const label me = Pstream::myProcNo();
    const scalar most = mesh.bounds().mag();
    const auto cellOf = [&](const point& p)
    {
        const label c = bins.find(p);
        return c < 0 && nearest ? bins.nearest(p, most) : c;
    };

    const labelList rank
    (
        nearest
      ? nearestRanksOf(mesh, bins, points, cells)
      : ranksOf(mesh, bins, points, cells)
    );
    List<DynamicList<label>> toRanks(Pstream::nProcs());
    forAll(rank, i)
    {
        if (rank[i] >= 0 && rank[i] != me)
        {
            toRanks[rank[i]].append(i);
            cells[i] = -1;
        }
        else if (rank[i] == me && cells[i] < 0)
        {
            cells[i] = cellOf(points[i]);
        }
    }
    set(toRanks);
    for (const point& p : send(points))
    {
        points.append(p);
        cells.append(cellOf(p));
    }
}


// ************************************************************************* //
