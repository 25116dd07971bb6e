/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.
\*---------------------------------------------------------------------------*/

#include "testSurfaces.H"

#include "EdgeMap.H"
#include "error.H"
#include "mergePoints.H"

#include <cmath>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- A surface from points and corners; points at the same place become one
triSurface merged
(
    const List<point>& points,
    const List<labelledTri>& triangles
)
{
    labelList toNew;
    pointField unique;
    mergePoints(points, 1e-9, false, toNew, unique);

    List<labelledTri> faces(triangles);
    for (labelledTri& f : faces)
    {
        f = labelledTri(toNew[f[0]], toNew[f[1]], toNew[f[2]], 0);
    }
    return triSurface(faces, unique);
}

//- The triangles of an icosahedron: three corners that are all neighbours
List<labelledTri> icosahedron(const UList<point>& points)
{
    List<labelledTri> faces(20);
    label nFaces = 0;
    const scalar reach = 1.01*mag(points[0] - points[1]);
    for (label i = 0; i < 12; ++i)
    {
        for (label j = i + 1; j < 12; ++j)
        {
            for (label k = j + 1; k < 12; ++k)
            {
                const point a(points[i]), b(points[j]), c(points[k]);
                if (mag(a - b) < reach && mag(b - c) < reach
                 && mag(c - a) < reach)
                {
                    faces[nFaces++] =
                        (a & (b ^ c)) > 0
                      ? labelledTri(i, j, k, 0)
                      : labelledTri(i, k, j, 0);
                }
            }
        }
    }

    return faces;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

Foam::triSurface styxTest::box(const vector& edges, const label n)
{
    DynamicList<point> points;
    DynamicList<labelledTri> faces;

    for (direction d = 0; d < 3; ++d)
    {
        for (label high = 0; high < 2; ++high)
        {
            for (label k = 0; k < n*n; ++k)
            {
                const label first = points.size();

                for (label corner = 0; corner < 4; ++corner)
                {
                    vector p(Zero);
                    p[d] = high;
                    p[(d + 1) % 3] = scalar(k % n + (corner & 1))/n;
                    p[(d + 2) % 3] = scalar(k/n + (corner >> 1))/n;
                    points.append(cmptMultiply(p, edges));
                }

                const label a = first, b = first + 1;
                const label c = first + 3, e = first + 2;
                faces.append
                (
                    high ? labelledTri(a, b, c, 0) : labelledTri(a, c, b, 0)
                );
                faces.append
                (
                    high ? labelledTri(a, c, e, 0) : labelledTri(a, e, c, 0)
                );
            }
        }
    }

    return merged(points, faces);
}


Foam::triSurface styxTest::ellipsoid(const vector& semiAxes, const label n)
{
    const scalar g = 0.5*(1 + std::sqrt(scalar(5)));
    DynamicList<point> points(List<point>
    ({
        point(-1, g, 0), point(1, g, 0), point(-1, -g, 0), point(1, -g, 0),
        point(0, -1, g), point(0, 1, g), point(0, -1, -g), point(0, 1, -g),
        point(g, 0, -1), point(g, 0, 1), point(-g, 0, -1), point(-g, 0, 1)
    }));
    for (point& p : points)
    {
        p /= mag(p);
    }

    List<labelledTri> faces(icosahedron(points));

    for (label level = 0; level < n; ++level)
    {
        EdgeMap<label> middles;
        auto middle = [&](const label a, const label b)
        {
            const edge e(a, b);
            if (!middles.found(e))
            {
                const point p(points[a] + points[b]);
                middles.insert(e, points.size());
                points.append(p/mag(p));
            }
            return middles[e];
        };

        DynamicList<labelledTri> finer(4*faces.size());
        for (const labelledTri& f : faces)
        {
            const label a = middle(f[0], f[1]);
            const label b = middle(f[1], f[2]);
            const label c = middle(f[2], f[0]);
            finer.append(labelledTri(f[0], a, c, 0));
            finer.append(labelledTri(a, f[1], b, 0));
            finer.append(labelledTri(c, b, f[2], 0));
            finer.append(labelledTri(a, b, c, 0));
        }
        faces = finer;
    }

    for (point& p : points)
    {
        p = cmptMultiply(p, semiAxes);
    }
    return triSurface(faces, pointField(points));
}


Foam::triSurface styxTest::tetrahedron
(
    const scalar a,
    const scalar b,
    const scalar c
)
{
    const List<point> points
    ({
        point(0, 0, 0), point(a, 0, 0), point(0, b, 0), point(0, 0, c)
    });
    const List<labelledTri> faces
    ({
        labelledTri(0, 2, 1, 0),
        labelledTri(0, 1, 3, 0),
        labelledTri(0, 3, 2, 0),
        labelledTri(1, 2, 3, 0)
    });
    return triSurface(faces, pointField(points));
}


Foam::triSurface styxTest::moved
(
    const triSurface& surface,
    const std::function<point(const point&)>& move
)
{
    pointField points(surface.points());
    for (point& p : points)
    {
        p = move(p);
    }
    return triSurface(List<labelledTri>(surface), points);
}


Foam::triSurface styxTest::joined(const triSurface& a, const triSurface& b)
{
    pointField points(a.points());
    points.append(b.points());

    List<labelledTri> faces(a);
    const label shift = a.points().size();
    for (const labelledTri& f : b)
    {
        faces.append
        (
            labelledTri(f[0] + shift, f[1] + shift, f[2] + shift, 0)
        );
    }
    return triSurface(faces, points);
}


Foam::triSurface styxTest::turned(const triSurface& surface)
{
    List<labelledTri> faces(surface);
    for (labelledTri& f : faces)
    {
        f = labelledTri(f[0], f[2], f[1], 0);
    }
    return triSurface(faces, pointField(surface.points()));
}


std::string styxTest::errorOf(const std::function<void()>& call)
{
    try
    {
        call();
    }
    catch (const Foam::error& e)
    {
        return e.message();
    }
    return std::string();
}


// ************************************************************************* //
