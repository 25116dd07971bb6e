/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.
\*---------------------------------------------------------------------------*/

#include "multisphereErrors.H"
#include "indexedOctree.H"
#include "treeDataPoint.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

// Points wanted on each sphere and on the whole surface
constexpr label spherePoints = 2000;
constexpr label surfacePoints = 20000;


// Depth of p in the union: largest of r - |p - c| [m]; negative outside,
// where it is minus the distance
scalar depth
(
    const point& p,
    const pointField& centres,
    const scalarField& radii
)
{
    scalar deepest = -GREAT;
    forAll(centres, i)
    {
        deepest = max(deepest, radii[i] - mag(p - centres[i]));
    }
    return deepest;
}


// Points on the spheres that no other sphere covers. A golden spiral spreads
// them evenly over each sphere
pointField exposedPoints
(
    const pointField& centres,
    const scalarField& radii
)
{
    const scalar goldenAngle =
        constant::mathematical::pi*(3 - std::sqrt(scalar(5)));
    const scalar size = max(radii);
    DynamicList<point> exposed;

    forAll(centres, i)
    {
        for (label k = 0; k < spherePoints; ++k)
        {
            const scalar z = 1 - (2*k + 1)/scalar(spherePoints);
            const scalar rho = std::sqrt(1 - z*z);
            const scalar angle = k*goldenAngle;
            const point p
            (
                centres[i]
              + radii[i]
               *vector(rho*std::cos(angle), rho*std::sin(angle), z)
            );

            if (depth(p, centres, radii) <= 1e-9*size)
            {
                exposed.append(p);
            }
        }
    }

    return pointField(std::move(exposed));
}


// The corners, and points on a lattice over each large triangle
pointField pointsOn(const triSurface& surface)
{
    const pointField& points = surface.localPoints();
    DynamicList<point> samples(points);

    scalar area = 0;
    for (const labelledTri& f : surface)
    {
        area += f.mag(surface.points());
    }

    for (const labelledTri& f : surface)
    {
        const triPointRef t(f.tri(surface.points()));
        const label n = std::ceil(std::sqrt(2*surfacePoints*t.mag()/area));

        for (label i = 0; i < n; ++i)
        {
            for (label j = 0; j < n - i; ++j)
            {
                const scalar u = (i + scalar(1)/3)/n;
                const scalar v = (j + scalar(1)/3)/n;
                samples.append((1 - u - v)*t.a() + u*t.b() + v*t.c());
            }
        }
    }

    return pointField(std::move(samples));
}

} // End anonymous namespace


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

void Foam::dem::multisphereErrors::distances
(
    const closedSurface& body,
    const pointField& centres,
    const scalarField& radii,
    scalar& surfaceToSpheres,
    scalar& spheresToSurface
)
{
    const pointField exposed(exposedPoints(centres, radii));

    spheresToSurface = 0;
    for (const point& p : exposed)
    {
        spheresToSurface = max(spheresToSurface, body.distance(p));
    }

    // Outside the union the distance from it is closed; inside, the nearest
    // exposed point is looked up
    treeBoundBox box(exposed);
    box.inflate(0.01);
    const indexedOctree<treeDataPoint> tree
    (
        treeDataPoint(exposed),
        box,
        10,
        10,
        3
    );

    surfaceToSpheres = 0;
    for (const point& p : pointsOn(body.surface()))
    {
        const scalar inside = depth(p, centres, radii);
        surfaceToSpheres = max
        (
            surfaceToSpheres,
            inside <= 0
          ? -inside
          : mag(p - exposed[tree.findNearest(p, sqr(GREAT)).index()])
        );
    }
}


// ************************************************************************* //
