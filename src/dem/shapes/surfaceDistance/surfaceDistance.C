/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "surfaceDistance.H"
#include "treeBoundBox.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// Normals of neighbours that differ by less are of one face: cosine of 20
// degrees. Those within 5e-5 are of one plane: files have six digits
const Foam::scalar sameFace = 0.94;
const Foam::scalar samePlane = 1 - 1e-9;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::surfaceDistance::setNormals()
{
    const triSurface& s = surface_.surface();
    const pointField& points = s.localPoints();
    const List<labelledTri>& triangles = s.localFaces();

    normal_.setSize(triangles.size());
    middle_.setSize(triangles.size());
    reach_.setSize(triangles.size(), Zero);
    cornerNormal_.setSize(points.size(), Zero);
    edgeNormal_.setSize(triangles.size());
    forAll(triangles, t)
    {
        const labelledTri& tri = triangles[t];
        const vector n =
            (points[tri[1]] - points[tri[0]])
          ^ (points[tri[2]] - points[tri[0]]);
        normal_[t] = n/mag(n);
        middle_[t] = tri.centre(points);
        for (const label corner : tri)
        {
            reach_[t] = max(reach_[t], mag(points[corner] - middle_[t]));
        }
        for (label k = 0; k < 3; ++k)
        {
            const point& p = points[tri[k]];
            const vector a = points[tri[(k + 1) % 3]] - p;
            const vector b = points[tri[(k + 2) % 3]] - p;
            const scalar angle = std::atan2(mag(a ^ b), a & b);
            cornerNormal_[tri[k]] += angle*normal_[t];
        }
    }

    forAll(triangles, t)
    {
        for (label k = 0; k < 3; ++k)
        {
            // The edge from corner k to the next
            const edge e(triangles[t][k], triangles[t][(k + 1) % 3]);
            vector n(Zero);
            for (const label id : s.faceEdges()[t])
            {
                if (s.edges()[id] == e)
                {
                    for (const label other : s.edgeFaces()[id])
                    {
                        n += normal_[other];
                    }
                }
            }
            edgeNormal_[t][k] = n;
        }
    }
}


void Foam::dem::surfaceDistance::setFaces()
{
    const triSurface& s = surface_.surface();
    face_.setSize(s.size(), -1);
    plane_ = true;

    label nFaces = 0;
    forAll(face_, first)
    {
        if (face_[first] >= 0)
        {
            continue;
        }
        DynamicList<label> open(1, first);
        face_[first] = nFaces;
        while (open.size())
        {
            const label t = open.remove();
            for (const label id : s.faceEdges()[t])
            {
                for (const label other : s.edgeFaces()[id])
                {
                    const scalar cosine = normal_[t] & normal_[other];
                    if (other == t || cosine < sameFace)
                    {
                        continue;
                    }
                    plane_ = plane_ && cosine > samePlane;
                    if (face_[other] < 0)
                    {
                        face_[other] = nFaces;
                        open.append(other);
                    }
                }
            }
        }
        ++nFaces;
    }
}


Foam::point Foam::dem::surfaceDistance::nearestOf
(
    const label triangle,
    const point& p,
    vector& normal
) const
{
    const labelledTri& tri = surface_.surface().localFaces()[triangle];
    const pointField& points = surface_.surface().localPoints();
    const FixedList<point, 3> x{points[tri[0]], points[tri[1]], points[tri[2]]};

    // Beyond an edge, or a corner at one of its ends
    bool above = true;
    for (label k = 0; k < 3; ++k)
    {
        const point& a = x[k];
        const point& b = x[(k + 1) % 3];
        const vector along = b - a;
        if (((along ^ normal_[triangle]) & (p - a)) <= 0)
        {
            continue;
        }
        above = false;
        const scalar part = ((p - a) & along)/magSqr(along);
        if (part > 0 && part < 1)
        {
            normal = edgeNormal_[triangle][k];
            return a + part*along;
        }
    }
    if (above)
    {
        normal = normal_[triangle];
        return p - ((p - x[0]) & normal)*normal;
    }

    label best = 0;
    for (label k = 1; k < 3; ++k)
    {
        if (magSqr(p - x[k]) < magSqr(p - x[best]))
        {
            best = k;
        }
    }
    normal = cornerNormal_[tri[best]];
    return x[best];
}


Foam::dem::surfaceDistance::hit Foam::dem::surfaceDistance::make
(
    const label triangle,
    const point& p
) const
{
    vector normal;
    const vector way = p - nearestOf(triangle, p, normal);
    const scalar distance = mag(way);
    const scalar side = (way & normal) < 0 ? -1 : 1;
    return hit
    {
        side*distance,
        distance > 1e-12*radius_ ? side*way/distance : normal_[triangle],
        triangle
    };
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::surfaceDistance::surfaceDistance
(
    const string& name,
    const triSurface& surface
)
:
    surface_(name, surface),
    plane_(true),
    radius_(std::sqrt(max(magSqr(surface.localPoints()))))
{
    setNormals();
    setFaces();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dem::surfaceDistance::hit
Foam::dem::surfaceDistance::operator()(const point& p) const
{
    return make(surface_.tree().findNearest(p, sqr(GREAT)).index(), p);
}


Foam::dem::surfaceDistance::hit Foam::dem::surfaceDistance::operator()
(
    const point& p,
    const labelUList& some
) const
{
    label best = -1;
    scalar least = GREAT;
    vector normal;
    for (const label t : some)
    {
        // Most are farther away by the balls around them
        if (magSqr(p - middle_[t]) >= sqr(least + reach_[t]))
        {
            continue;
        }
        const scalar d = mag(p - nearestOf(t, p, normal));
        if (d < least)
        {
            least = d;
            best = t;
        }
    }
    return best < 0 ? (*this)(p) : make(best, p);
}


Foam::labelList Foam::dem::surfaceDistance::within
(
    const point& p,
    const scalar distance
) const
{
    const vector half = distance*vector::one;
    return surface_.tree().findBox(treeBoundBox(p - half, p + half));
}


// ************************************************************************* //
