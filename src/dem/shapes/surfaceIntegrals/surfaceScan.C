/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.
\*---------------------------------------------------------------------------*/

#include "surfaceScan.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

// Twice the area of the triangle p q (y z), the edge taken from its lower to
// its higher point number so that both its triangles get the same value
scalar edgeArea
(
    const label p,
    const label q,
    const pointField& points,
    const scalar y,
    const scalar z
)
{
    const bool turned = (p > q);
    const point& a = points[turned ? q : p];
    const point& b = points[turned ? p : q];

    const scalar area =
        (b.y() - a.y())*(z - a.z()) - (b.z() - a.z())*(y - a.y());

    return turned ? -area : area;
}


// Is the line left of the edge? On the edge: the line counts as moved by
// (eps, eps^2) in y and z
bool leftOf(const scalar area, const point& p, const point& q)
{
    if (area != 0)
    {
        return area > 0;
    }
    if (p.z() != q.z())
    {
        return q.z() < p.z();
    }
    return q.y() > p.y();
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::surfaceScan::cross
(
    const labelledTri& f,
    const scalar z,
    std::vector<crossings>& lines
) const
{
    const pointField& points = surface_.points();
    const point& a = points[f[0]];
    const point& b = points[f[1]];
    const point& c = points[f[2]];

    const scalar low = min(min(a.y(), b.y()), c.y());
    const scalar high = max(max(a.y(), b.y()), c.y());

    // One line more on each side: the lattice may be off by round-off
    const label from = max(label(0), label(std::floor((low - y0_)/h_)));
    const label to = min(ny_ - 1, label(std::ceil((high - y0_)/h_)));

    for (label j = from; j <= to; ++j)
    {
        const scalar y = y0_ + j*h_;
        const scalar ab = edgeArea(f[0], f[1], points, y, z);
        const scalar bc = edgeArea(f[1], f[2], points, y, z);
        const scalar ca = edgeArea(f[2], f[0], points, y, z);

        const bool left = leftOf(ab, a, b);
        if (leftOf(bc, b, c) != left || leftOf(ca, c, a) != left)
        {
            continue;
        }

        const scalar sum = ab + bc + ca;
        const scalar x =
            (sum != 0)
          ? (bc*a.x() + ca*b.x() + ab*c.x())/sum
          : (a.x() + b.x() + c.x())/3;

        // Seen along x, a face that turns left has its normal along x:
        // the line leaves the body there
        lines[j].push_back({x, left ? -1 : 1});
    }
}


std::vector<Foam::dem::surfaceScan::crossings>
Foam::dem::surfaceScan::crossingsOf(const label k) const
{
    std::vector<crossings> lines(ny_);
    const scalar z = z0_ + k*h_;

    for (const label i : rowTriangles_[k])
    {
        cross(surface_[i], z, lines);
    }

    for (crossings& line : lines)
    {
        std::sort
        (
            line.begin(),
            line.end(),
            [](const crossing& p, const crossing& q)
            {
                // Where they coincide: first in, then out
                return p.x < q.x || (p.x == q.x && p.turn > q.turn);
            }
        );
    }

    return lines;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::surfaceScan::surfaceScan
(
    const triSurface& surface,
    const scalar y0,
    const scalar z0,
    const scalar h,
    const label ny,
    const label nz
)
:
    surface_(surface),
    y0_(y0),
    z0_(z0),
    h_(h),
    ny_(ny),
    nz_(nz),
    rowTriangles_(nz)
{
    const pointField& points = surface.points();

    forAll(surface, i)
    {
        const labelledTri& f = surface[i];
        const scalar a = points[f[0]].z();
        const scalar b = points[f[1]].z();
        const scalar c = points[f[2]].z();

        const label from =
            max(label(0), label(std::floor((min(min(a, b), c) - z0)/h)));
        const label to =
            min(nz - 1, label(std::ceil((max(max(a, b), c) - z0)/h)));

        for (label k = from; k <= to; ++k)
        {
            rowTriangles_[k].push_back(i);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::vector<Foam::dem::surfaceScan::intervals>
Foam::dem::surfaceScan::row(const label k) const
{
    const std::vector<crossings> lines(crossingsOf(k));
    std::vector<intervals> inside(ny_);

    for (label j = 0; j < ny_; ++j)
    {
        int winding = 0;
        for (const crossing& c : lines[j])
        {
            const int before = winding;
            winding += c.turn;

            if (before <= 0 && winding > 0)
            {
                inside[j].push_back({c.x, c.x});
            }
            else if (before > 0 && winding <= 0)
            {
                inside[j].back().second = c.x;
            }
        }
    }

    return inside;
}


Foam::scalar Foam::dem::surfaceScan::strayLength(const label k) const
{
    scalar sum = 0;

    for (const crossings& line : crossingsOf(k))
    {
        int winding = 0;
        for (size_t c = 1; c < line.size(); ++c)
        {
            winding += line[c-1].turn;
            if (winding != 0 && winding != 1)
            {
                sum += line[c].x - line[c-1].x;
            }
        }
    }

    return sum;
}


// ************************************************************************* //
