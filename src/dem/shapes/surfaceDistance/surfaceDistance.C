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

#include <algorithm>
#include <cmath>
#include <vector>

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
    outline_.setSize(triangles.size());
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
            outline_[t].x[k] = p;
            outline_[t].out[k] = a ^ normal_[t];
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
    const outline& of = outline_[triangle];
    const point* const x = of.x;

    // Beyond an edge, or a corner at one of its ends
    bool above = true;
    for (label k = 0; k < 3; ++k)
    {
        const point& a = x[k];
        const point& b = x[(k + 1) % 3];
        if ((of.out[k] & (p - a)) <= 0)
        {
            continue;
        }
        above = false;
        const vector along = b - a;
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
    normal =
        cornerNormal_[surface_.surface().localFaces()[triangle][best]];
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
Foam::dem::surfaceDistance::operator()
(
    const point& p,
    const label near
) const
{
    // A little farther, so that which is found does not hang on round-off
    constexpr scalar slack = 1 + 1e-6;

    vector normal;
    const scalar within =
        near < 0
      ? sqr(GREAT)
      : sqr(slack*mag(p - nearestOf(near, p, normal)) + 1e-9*radius_);
    return make(surface_.tree().findNearest(p, within).index(), p);
}


Foam::dem::surfaceDistance::hit Foam::dem::surfaceDistance::operator()
(
    const point& p,
    const neighbours& some,
    const label first
) const
{
    // Which is found must not depend on which is looked at first: not on the
    // round-off of what is left out, and of two as near it is that of lower
    // number
    constexpr scalar slack = 1 + 1e-9;

    vector normal;
    label best = first;
    scalar least = first < 0 ? GREAT : mag(p - nearestOf(first, p, normal));
    const scalar away = slack*mag(p - some.centre);
    forAll(some.triangles, k)
    {
        // It, and what follows, is too far from here even so
        if (some.least[k] - away > least*slack)
        {
            break;
        }
        const label t = some.triangles[k];
        const vector way = p - middle_[t];
        const scalar way2 = magSqr(way);
        if (way2 > sqr(least*slack + reach_[t]))
        {
            continue;
        }

        // Or by its plane and the disc in it
        const scalar height2 = sqr(way & normal_[t]);
        const scalar rest2 = sqr(least*slack) - height2;
        if (rest2 < 0 || way2 - height2 > sqr(reach_[t] + sqrt(rest2))*slack)
        {
            continue;
        }
        const scalar d = mag(p - nearestOf(t, p, normal));
        if (d < least || (d == least && t < best))
        {
            least = d;
            best = t;
        }
    }
    return best < 0 ? (*this)(p) : make(best, p);
}


Foam::dem::surfaceDistance::neighbours Foam::dem::surfaceDistance::within
(
    const point& p,
    const scalar distance
) const
{
    const vector half = distance*vector::one;
    const labelList found
    (
        surface_.tree().findBox(treeBoundBox(p - half, p + half))
    );
    std::vector<std::pair<scalar, label>> near;
    near.reserve(found.size());
    for (const label t : found)
    {
        const scalar least = mag(p - middle_[t]) - reach_[t];
        if (least <= distance)
        {
            near.emplace_back(least, t);
        }
    }
    std::sort(near.begin(), near.end());

    neighbours n;
    n.centre = p;
    n.triangles.setSize(near.size());
    n.least.setSize(near.size());
    forAll(n.triangles, k)
    {
        n.least[k] = near[k].first;
        n.triangles[k] = near[k].second;
    }
    return n;
}


// ************************************************************************* //
