/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "pointWeights.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::coupling::pointWeights::set
(
    tetrahedron& t,
    const label c,
    const label face,
    const label triangle
) const
{
    const Foam::face& f = mesh_.faces()[face];
    const pointField& points = mesh_.points();
    t.cell = c;
    const point& centre = mesh_.cellCentres()[c];
    point third;
    if (f.size() == 4)
    {
        third = Zero;
        forAll(t.vertex, i)
        {
            t.vertex[i] = f[(triangle + i) % 4];
            third += 0.25*points[f[i]];
        }
    }
    else
    {
        const label base = max(mesh_.tetBasePtIs()[face], label(0));
        const label first = (base + triangle + 1) % f.size();
        t.vertex[0] = f[base];
        t.vertex[1] = f[first];
        t.vertex[2] = t.vertex[3] = f[f.fcIndex(first)];
        third = points[t.vertex[2]];
    }

    const vector e1 = points[t.vertex[0]] - centre;
    const vector e2 = points[t.vertex[1]] - centre;
    const vector e3 = third - centre;
    const vector n1 = e2 ^ e3;
    const scalar volume6 = e1 & n1;
    if (mag(volume6) < 1e-12*mesh_.cellVolumes()[c])
    {
        return false;
    }

    t.gradient[0] = n1/volume6;
    t.gradient[1] = (e3 ^ e1)/volume6;
    t.gradient[2] = (e1 ^ e2)/volume6;
    return true;
}


Foam::coupling::pointWeights::tetrahedron
Foam::coupling::pointWeights::search
(
    const point& x,
    const label c,
    weighted& best
) const
{
    tetrahedron found, t;
    scalar deepest = -GREAT;
    weighted tried = weighted();
    for (const label face : mesh_.cells()[c])
    {
        const label n = nTriangles(face);
        for (label i = 0; i < n; ++i)
        {
            const scalar depth =
                set(t, c, face, i) ? locate(x, t, tried) : -GREAT;
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

    if (found.cell < 0)
    {
        // A cell without a volume: its own value
        const face& f = mesh_.faces()[mesh_.cells()[c].first()];
        best = {c, {f[0], f[1], f[2], f[0]}, {1, 0, 0, 0, 0}};
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


void Foam::coupling::pointWeights::look
(
    const point& x,
    const label i,
    const label n,
    const label c,
    weighted& found
)
{
    last_.setSize(n);
    tetrahedron& t = last_[i];
    if (!holds(x, t, c, found))
    {
        t = search(x, c, found);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::pointWeights::pointWeights(const polyMesh& mesh)
:
    mesh_(mesh),
    boxes_(mesh)
{}


// ************************************************************************* //
