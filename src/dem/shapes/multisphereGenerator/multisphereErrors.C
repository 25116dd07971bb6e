/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.
\*---------------------------------------------------------------------------*/

#include "multisphereErrors.H"
#include "mathematicalConstants.H"
#include "sphereUnion.H"
#include "surfaceScan.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::dem;

typedef surfaceScan::intervals intervals;

// Sort, and join those that overlap
void join(intervals& list)
{
    std::sort(list.begin(), list.end());

    size_t n = 0;
    for (const auto& i : list)
    {
        if (n && i.first <= list[n-1].second)
        {
            list[n-1].second = max(list[n-1].second, i.second);
        }
        else
        {
            list[n++] = i;
        }
    }
    list.resize(n);
}


scalar length(const intervals& list)
{
    scalar sum = 0;
    for (const auto& i : list)
    {
        sum += i.second - i.first;
    }
    return sum;
}


// Length that two sorted lists share
scalar common(const intervals& p, const intervals& q)
{
    scalar sum = 0;
    size_t i = 0, j = 0;

    while (i < p.size() && j < q.size())
    {
        const scalar from = max(p[i].first, q[j].first);
        const scalar to = min(p[i].second, q[j].second);
        sum += max(scalar(0), to - from);

        if (p[i].second < q[j].second)
        {
            ++i;
        }
        else
        {
            ++j;
        }
    }
    return sum;
}


// Add what one sphere cuts from the lines y0 + j h of a row
void addSphere
(
    const point& c,
    const scalar r,
    const scalar z,
    const scalar y0,
    const scalar h,
    std::vector<intervals>& lines
)
{
    const scalar discSqr = sqr(r) - sqr(z - c.z());
    if (discSqr <= 0)
    {
        return;
    }

    const scalar disc = std::sqrt(discSqr);
    const label last = lines.size() - 1;
    const label from =
        max(label(0), label(std::ceil((c.y() - disc - y0)/h)));
    const label to = min(last, label(std::floor((c.y() + disc - y0)/h)));

    for (label j = from; j <= to; ++j)
    {
        const scalar half =
            std::sqrt(max(scalar(0), discSqr - sqr(y0 + j*h - c.y())));
        lines[j].push_back({c.x() - half, c.x() + half});
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

Foam::scalar Foam::dem::multisphereErrors::offsetVolume
(
    const triSurface& surface,
    const pointField& centres,
    const scalarField& radii,
    const label n
)
{
    boundBox box(surface.points(), false);
    forAll(centres, i)
    {
        box.add(centres[i] - radii[i]*vector::one);
        box.add(centres[i] + radii[i]*vector::one);
    }

    const scalar h = max(box.span().y(), box.span().z())/n;
    const label ny = std::ceil(box.span().y()/h);
    const label nz = std::ceil(box.span().z()/h);
    const scalar y0 = box.centre().y() - 0.5*(ny - 1)*h;
    const scalar z0 = box.centre().z() - 0.5*(nz - 1)*h;

    const surfaceScan scan(surface, y0, z0, h, ny, nz);
    scalar sum = 0;

    for (label k = 0; k < nz; ++k)
    {
        const std::vector<intervals> body(scan.row(k));
        std::vector<intervals> spheres(ny);

        forAll(centres, i)
        {
            addSphere(centres[i], radii[i], z0 + k*h, y0, h, spheres);
        }

        for (label j = 0; j < ny; ++j)
        {
            join(spheres[j]);
            sum +=
                length(body[j]) + length(spheres[j])
              - 2*common(body[j], spheres[j]);
        }
    }

    return sum*h*h;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::multisphereErrors::multisphereErrors
(
    const closedSurface& body,
    const pointField& centres,
    const scalarField& radii,
    const label n
)
:
    nLines(n*n)
{
    const massProperties& a = body.properties();
    const massProperties b(sphereUnion(centres, radii).properties());
    const scalar d = std::cbrt(6*a.volume/constant::mathematical::pi);

    volume = mag(a.volume - b.volume)/a.volume;
    inertia = mag(a.inertia - b.inertia)/mag(a.inertia);
    centroid = mag(a.centroid - b.centroid)/d;
    offset = offsetVolume(body.surface(), centres, radii, n)/a.volume;

    distances(body, centres, radii, surfaceToSpheres, spheresToSurface);
}


// ************************************************************************* //
