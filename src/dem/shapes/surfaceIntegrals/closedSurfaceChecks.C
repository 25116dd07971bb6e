/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.
\*---------------------------------------------------------------------------*/

#include "closedSurface.H"
#include "boundBox.H"
#include "error.H"
#include "mathematicalConstants.H"
#include "surfaceIntegrals.H"
#include "surfaceFile.H"
#include "surfaceScan.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

// Solid angle of a triangle seen from p, over 4 pi: the sum over a closed
// surface is 1 inside and 0 outside
scalar windingShare
(
    const point& p,
    const labelledTri& f,
    const pointField& points
)
{
    const vector a(points[f[0]] - p);
    const vector b(points[f[1]] - p);
    const vector c(points[f[2]] - p);
    const scalar A = mag(a), B = mag(b), C = mag(c);

    return std::atan2
    (
        a & (b ^ c),
        A*B*C + (a & b)*C + (b & c)*A + (c & a)*B
    )/constant::mathematical::twoPi;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::closedSurface::checkEdges() const
{
    const labelListList& edgeFaces = surface_.edgeFaces();
    const edgeList& edges = surface_.edges();
    const pointField& points = surface_.localPoints();

    surfaceFinding open, crowded, turned;

    forAll(edges, e)
    {
        const labelList& faces = edgeFaces[e];
        const point mid(edges[e].centre(points));

        if (faces.size() == 1)
        {
            open.add(mid);
        }
        else if (faces.size() > 2)
        {
            crowded.add(mid);
        }
        else if
        (
            surface_.localFaces()[faces[0]].edgeDirection(edges[e])
         == surface_.localFaces()[faces[1]].edgeDirection(edges[e])
        )
        {
            turned.add(mid);
        }
    }

    refuse
    (
        open.n,
        "is open: it has a hole, or corners that were not merged; open edges",
        open.where
    );
    refuse
    (
        crowded.n,
        "is non-manifold: edges with more than two triangles",
        crowded.where
    );
    refuse
    (
        turned.n,
        "is of inconsistent orientation: edges with triangles that are turned"
        " against each other (surfaceOrient may repair it)",
        turned.where
    );
}


void Foam::dem::closedSurface::checkIntersections() const
{
    const List<labelPair> pairs(triangleIntersections(surface_, tree()));

    if (pairs.size())
    {
        refuse
        (
            pairs.size(),
            "is self-intersecting: pairs of triangles that pierce each other",
            surface_[pairs[0].first()].centre(surface_.points())
        );
    }
}


void Foam::dem::closedSurface::checkParts() const
{
    const pointField& points = surface_.points();

    labelList part;
    const label nParts =
        surface_.markZones(boolList(surface_.nEdges(), false), part);
    const scalarField volumes(partVolumes(surface_, part, nParts));

    // A point on each part, and how often the other parts wind around it
    List<point> seat(nParts);
    forAll(surface_, i)
    {
        seat[part[i]] = surface_[i].centre(points);
    }

    for (label k = 0; k < nParts; ++k)
    {
        scalar winding = 0;

        for (label i = 0; nParts > 1 && i < surface_.size(); ++i)
        {
            if (part[i] != k)
            {
                winding += windingShare(seat[k], surface_[i], points);
            }
        }

        const label around = std::lround(winding);

        refuse
        (
            volumes[k] <= 0 && around != 1,
            "is inverted, or a part of it is: normals that point into the body"
            " (surfaceOrient may repair it); parts with a negative volume",
            seat[k]
        );
        refuse
        (
            volumes[k] > 0 && around != 0,
            "is self-intersecting: parts inside others, whose space would count"
            " twice",
            seat[k]
        );
    }
}


void Foam::dem::closedSurface::checkWinding() const
{
    // Surfaces that meet corner on corner pierce each other without a
    // triangle pierced by an edge: look along lines. Their number is odd so
    // that they miss what is symmetric
    constexpr label n = 63;

    const boundBox box(surface_.points(), false);
    const scalar h = max(box.span().y(), box.span().z())/n;
    const scalar y0 = box.min().y() + 0.37*h;
    const scalar z0 = box.min().z() + 0.41*h;

    const surfaceScan scan(surface_, y0, z0, h, n, n);

    label stray = 0;
    for (label k = 0; k < n; ++k)
    {
        stray += (scan.strayLength(k) > 1e-6*box.mag());
    }

    refuse
    (
        stray,
        "is self-intersecting: rows of lines that find themselves inside it"
        " twice, or inside out",
        box.centre()
    );
}


Foam::dem::massProperties Foam::dem::closedSurface::check() const
{
    checkTriangles(name_, surface_);
    checkEdges();
    checkIntersections();
    checkParts();
    checkWinding();

    return surfaceIntegrals(surface_);
}


// ************************************************************************* //
