/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "cellBoxes.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::coupling::cellBoxes::make(const label c, box& b) const
{
    const cell& faces = mesh_.cells()[c];
    if (faces.size() != 6)
    {
        return false;
    }
    for (const label f : faces)
    {
        if (mesh_.faces()[f].size() != 4)
        {
            return false;
        }
    }
    const pointField& points = mesh_.points();
    const labelList vertices(faces.labels(mesh_.faces()));
    if (vertices.size() != 8)
    {
        return false;
    }

    // The three edges from a vertex: two along a face, the third along one of
    // the others that it is on
    const face& base = mesh_.faces()[faces[0]];
    const label v = base[0];
    label top = -1;
    for (label i = 1; i < 6; ++i)
    {
        const face& f = mesh_.faces()[faces[i]];
        const label at = f.find(v);
        for (const label to : {f.fcIndex(max(at, 0)), f.rcIndex(max(at, 0))})
        {
            top = at >= 0 && !base.found(f[to]) ? f[to] : top;
        }
    }
    if (top < 0)
    {
        return false;
    }
    const vector e1 = points[base[1]] - points[v];
    const vector e2 = points[base[3]] - points[v];
    const vector e3 = points[top] - points[v];
    const scalar volume = e1 & (e2 ^ e3);
    if (mag(volume) < SMALL*mag(e1)*mag(e2)*mag(e3))
    {
        return false;
    }

    b.centre = mesh_.cellCentres()[c];
    b.perHalfEdge[0] = 2/volume*(e2 ^ e3);
    b.perHalfEdge[1] = 2/volume*(e3 ^ e1);
    b.perHalfEdge[2] = 2/volume*(e1 ^ e2);
    b.vertex = -1;
    for (const label p : vertices)
    {
        unsigned place = 0;
        for (unsigned i = 0; i < 3; ++i)
        {
            const scalar s = (points[p] - b.centre) & b.perHalfEdge[i];
            if (mag(mag(s) - 1) > roundOff)
            {
                return false;
            }
            place |= s > 0 ? 1u << i : 0;
        }
        b.vertex[place] = p;
    }
    return !b.vertex.found(-1);
}


void Foam::coupling::cellBoxes::look(const label c)
{
    box b;
    boxOf_[c] = make(c, b) ? boxes_.size() : none;
    if (boxOf_[c] != none)
    {
        boxes_.append(b);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::cellBoxes::cellBoxes(const polyMesh& mesh)
:
    mesh_(mesh)
{
    forget();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::coupling::cellBoxes::forget()
{
    boxes_.clear();
    boxOf_.clear();
    boxOf_.setSize(mesh_.nCells(), unknown);
}


// ************************************************************************* //
