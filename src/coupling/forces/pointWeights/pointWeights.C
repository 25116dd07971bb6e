/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "pointWeights.H"

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

// A point is inside if all of its coordinates are above
const Foam::scalar roundOff = 1e-9;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::coupling::pointWeights::locate
(
    const point& x,
    const label c,
    const corner& t,
    weighted& found
) const
{
    const face& f = mesh_.faces()[t.face];
    const label base = max(mesh_.tetBasePtIs()[t.face], label(0));
    const label first = (base + t.triangle) % f.size();
    found.cell = c;
    found.vertex[0] = f[base];
    found.vertex[1] = f[first];
    found.vertex[2] = f[f.fcIndex(first)];

    const pointField& points = mesh_.points();
    const point& centre = mesh_.cellCentres()[c];
    const vector e1 = points[found.vertex[0]] - centre;
    const vector e2 = points[found.vertex[1]] - centre;
    const vector e3 = points[found.vertex[2]] - centre;
    const vector r = x - centre;
    const vector n1 = e2 ^ e3;
    const scalar volume6 = e1 & n1;
    if (mag(volume6) < 1e-12*mesh_.cellVolumes()[c])
    {
        return -GREAT;
    }

    found.w[1] = (r & n1)/volume6;
    found.w[2] = (r & (e3 ^ e1))/volume6;
    found.w[3] = (r & (e1 ^ e2))/volume6;
    found.w[0] = 1 - found.w[1] - found.w[2] - found.w[3];
    return min(min(found.w[0], found.w[1]), min(found.w[2], found.w[3]));
}


bool Foam::coupling::pointWeights::belongs
(
    const corner& t,
    const label c
) const
{
    if (t.face < 0 || t.face >= mesh_.nFaces())
    {
        return false;
    }
    const bool here =
        mesh_.faceOwner()[t.face] == c
     || (mesh_.isInternalFace(t.face) && mesh_.faceNeighbour()[t.face] == c);
    return here && t.triangle < mesh_.faces()[t.face].size() - 1;
}


Foam::coupling::pointWeights::corner Foam::coupling::pointWeights::search
(
    const point& x,
    const label c,
    weighted& best
) const
{
    corner found;
    scalar deepest = -GREAT;
    weighted tried;
    for (const label face : mesh_.cells()[c])
    {
        const label n = mesh_.faces()[face].size() - 2;
        for (label i = 1; i <= n; ++i)
        {
            const corner t{face, i};
            const scalar depth = locate(x, c, t, tried);
            if (depth > deepest)
            {
                deepest = depth;
                found = t;
                best = tried;
            }
            if (deepest > roundOff)
            {
                return found;
            }
        }
    }

    if (found.face < 0)
    {
        // A cell without a volume: its own value
        const face& f = mesh_.faces()[mesh_.cells()[c].first()];
        best = {c, {f[0], f[1], f[2]}, {1, 0, 0, 0}};
        return found;
    }
    scalar sum = 0;
    for (scalar& w : best.w)
    {
        w = max(w, scalar(0));
        sum += w;
    }
    for (scalar& w : best.w)
    {
        w /= sum;
    }
    return found;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::pointWeights::pointWeights(const polyMesh& mesh)
:
    mesh_(mesh)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::coupling::pointWeights::find
(
    const UList<point>& points,
    const labelUList& mine,
    const labelUList& cells
)
{
    // Made by all ranks together on first use
    mesh_.tetBasePtIs();

    last_.setSize(points.size());
    points_.setSize(mine.size());
    forAll(mine, k)
    {
        corner& t = last_[mine[k]];
        const point& x = points[mine[k]];
        const label c = cells[k];
        if
        (
            !belongs(t, c)
         || !(locate(x, c, t, points_[k]) > roundOff)
        )
        {
            t = search(x, c, points_[k]);
        }
    }
}


// ************************************************************************* //
