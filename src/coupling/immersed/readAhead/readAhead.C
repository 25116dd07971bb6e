/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "readAhead.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- The cell that comes by so many after number k, the last if there is none
inline Foam::label later
(
    const Foam::labelUList& cells,
    const Foam::label k,
    const Foam::label by
)
{
    return cells[Foam::min(k + by, cells.size() - 1)];
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

// Each stage needs what the one before it has brought; between them are a few
// cells' work, the time of a read. The loops stand here as they are: what only
// asks, put into a function of this file, is left out by the compiler, too

void Foam::coupling::readAhead::faces
(
    const polyMesh& mesh,
    const labelUList& cells,
    const label k
)
{
    const cellList& lists = mesh.cells();
    __builtin_prefetch(&lists[later(cells, k, 10)]);
    __builtin_prefetch(lists[later(cells, k, 8)].cdata());
}


void Foam::coupling::readAhead::points
(
    const polyMesh& mesh,
    const labelUList& cells,
    const label k
)
{
    const cellList& lists = mesh.cells();
    const faceList& faces = mesh.faces();
    const pointField& points = mesh.points();

    __builtin_prefetch(&lists[later(cells, k, 10)]);
    __builtin_prefetch(lists[later(cells, k, 8)].cdata());
    for (const label f : lists[later(cells, k, 6)])
    {
        __builtin_prefetch(&faces[f]);
    }
    for (const label f : lists[later(cells, k, 4)])
    {
        __builtin_prefetch(faces[f].cdata());
    }
    for (const label f : lists[later(cells, k, 2)])
    {
        for (const label p : faces[f])
        {
            __builtin_prefetch(&points[p]);
        }
    }
}


// ************************************************************************* //
