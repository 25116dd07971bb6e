/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.
\*---------------------------------------------------------------------------*/

#include "closedSurface.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

// Six times the signed volume of the tetrahedron a b c p: its sign tells on
// which side of the triangle a b c the point p is
inline scalar side
(
    const point& a,
    const point& b,
    const point& c,
    const point& p
)
{
    return (a - p) & ((b - p) ^ (c - p));
}


// Does the edge from p to q go through the triangle a b c? The edge must
// reach beyond the plane on both sides; it may pass through the triangle's
// rim, so that a passage between two triangles is not missed.
bool pierces
(
    const point& p,
    const point& q,
    const point& a,
    const point& b,
    const point& c
)
{
    const scalar size = mag(q - p) + mag(b - a) + mag(c - a);
    const scalar tolerance = 1e-12*size*size*size;

    const scalar sp = side(a, b, c, p);
    const scalar sq = side(a, b, c, q);

    if (mag(sp) <= tolerance || mag(sq) <= tolerance || (sp > 0) == (sq > 0))
    {
        return false;
    }

    const scalar u = side(p, a, b, q);
    const scalar v = side(p, b, c, q);
    const scalar w = side(p, c, a, q);

    return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
}


// Does an edge of f go through g? Edges that start at a corner of g cannot
bool edgePierces
(
    const labelledTri& f,
    const labelledTri& g,
    const pointField& points
)
{
    for (label e = 0; e < 3; ++e)
    {
        const label p = f[e];
        const label q = f[(e + 1) % 3];

        if
        (
            g.find(p) < 0
         && g.find(q) < 0
         && pierces
            (
                points[p],
                points[q],
                points[g[0]],
                points[g[1]],
                points[g[2]]
            )
        )
        {
            return true;
        }
    }

    return false;
}


label nShared(const labelledTri& f, const labelledTri& g)
{
    return (g.find(f[0]) >= 0) + (g.find(f[1]) >= 0) + (g.find(f[2]) >= 0);
}


// Neighbours over an edge that lie on each other: a fold
bool folded
(
    const labelledTri& f,
    const labelledTri& g,
    const pointField& points
)
{
    return
        (f.unitNormal(points) & g.unitNormal(points)) < -1 + 1e-12;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

Foam::List<Foam::labelPair> Foam::dem::triangleIntersections
(
    const triSurface& surface,
    const indexedOctree<treeDataTriSurface>& tree
)
{
    const pointField& points = surface.points();
    DynamicList<labelPair> pairs;

    forAll(surface, i)
    {
        const labelledTri& f = surface[i];
        const treeBoundBox box(points, f);

        for (const label j : tree.findBox(box))
        {
            if (j <= i)
            {
                continue;
            }

            const labelledTri& g = surface[j];

            if
            (
                nShared(f, g) == 2
              ? folded(f, g, points)
              : edgePierces(f, g, points) || edgePierces(g, f, points)
            )
            {
                pairs.append(labelPair(i, j));
            }
        }
    }

    return List<labelPair>(std::move(pairs));
}


// ************************************************************************* //
