/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "volumeFraction.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::coupling::volumeFraction::volume(const tet& t)
{
    return
        mag
        (
            ((t[1].x - t[0].x) ^ (t[2].x - t[0].x)) & (t[3].x - t[0].x)
        )/6;
}


Foam::scalar Foam::coupling::volumeFraction::negativeFraction
(
    const FixedList<scalar, 4>& phi
)
{
    FixedList<scalar, 4> f(phi);
    std::sort(f.begin(), f.end());

    if (f[0] >= 0)
    {
        return 0;
    }
    if (f[3] <= 0)
    {
        return 1;
    }

    // Where the plane cuts the edge from corner i to corner j
    const auto cut = [&f](const label i, const label j)
    {
        return f[i]/(f[i] - f[j]);
    };

    if (f[1] >= 0)
    {
        return cut(0, 1)*cut(0, 2)*cut(0, 3);
    }
    if (f[2] < 0)
    {
        return 1 - cut(3, 0)*cut(3, 1)*cut(3, 2);
    }

    // A wedge between corners 0 and 1, cut into three tetrahedra
    const scalar c02 = cut(0, 2), c03 = cut(0, 3);
    const scalar c12 = cut(1, 2), c13 = cut(1, 3);
    return c02*c03 + c02*(1 - c03)*c13 + (1 - c02)*c12*c13;
}


Foam::scalar Foam::coupling::volumeFraction::insideLinear
(
    const bodyGeometry& body,
    const tet& t
)
{
    const point mean = 0.25*(t[0].x + t[1].x + t[2].x + t[3].x);
    const vector r = body.fromNearestCentre(mean);
    const scalar rho = max(mag(r), VSMALL);
    const vector n = r/rho;

    scalar bulge = 0;
    for (const corner& c : t)
    {
        const vector d = body.inPlane(c.x - mean);
        bulge += magSqr(d) - sqr(d & n);
    }
    bulge *= 0.1/rho;

    FixedList<scalar, 4> phi;
    forAll(phi, k)
    {
        phi[k] = t[k].phi - bulge;
    }
    return negativeFraction(phi)*volume(t);
}


bool Foam::coupling::volumeFraction::creased
(
    const bodyGeometry& body,
    const tet& t
)
{
    // Only where the surface passes between the corners or close by
    const scalar close = 0.4*mag(t[1].x - t[0].x);
    scalar low = t[0].phi;
    scalar high = t[0].phi;
    for (const corner& c : t)
    {
        low = min(low, c.phi);
        high = max(high, c.phi);
    }
    if (low > close || high < -close)
    {
        return false;
    }

    const label first = body.nearest(t[0].x);
    for (label k = 1; k < 4; ++k)
    {
        if (body.nearest(t[k].x) != first)
        {
            return true;
        }
    }
    return false;
}


Foam::scalar Foam::coupling::volumeFraction::inside
(
    const bodyGeometry& body,
    const tet& t,
    const label refinements,
    const label creases
)
{
    // No point is farther from a corner than the corner's longest edge
    for (label i = 0; i < 4; ++i)
    {
        scalar edge2 = 0;
        for (label j = 0; j < 4; ++j)
        {
            edge2 = max(edge2, magSqr(t[i].x - t[j].x));
        }
        if (sqr(t[i].phi) > edge2)
        {
            return t[i].phi > 0 ? 0 : volume(t);
        }
    }
    if (!refinements && !(creases && creased(body, t)))
    {
        return insideLinear(body, t);
    }

    const auto middle = [&](const label i, const label j)
    {
        const point x = 0.5*(t[i].x + t[j].x);
        return corner{x, body.distance(x)};
    };
    const corner m01 = middle(0, 1), m02 = middle(0, 2), m03 = middle(0, 3);
    const corner m12 = middle(1, 2), m13 = middle(1, 3), m23 = middle(2, 3);

    // Four at the corners, four in the octahedron that is left
    const FixedList<tet, 8> parts
    ({
        tet({t[0], m01, m02, m03}),
        tet({t[1], m01, m12, m13}),
        tet({t[2], m02, m12, m23}),
        tet({t[3], m03, m13, m23}),
        tet({m01, m23, m02, m03}),
        tet({m01, m23, m03, m13}),
        tet({m01, m23, m13, m12}),
        tet({m01, m23, m12, m02})
    });

    scalar sum = 0;
    for (const tet& part : parts)
    {
        sum +=
            refinements
          ? inside(body, part, refinements - 1, creases)
          : inside(body, part, 0, creases - 1);
    }
    return sum;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::coupling::volumeFraction::operator()
(
    const bodyGeometry& whole,
    const label cell,
    const scalar radius
) const
{
    const point& centre = mesh_.cellCentres()[cell];
    const scalar phi = whole.distance(centre);

    if (phi >= radius)
    {
        return 0;
    }
    if (phi <= -radius)
    {
        return 1;
    }

    const bodyGeometry body(whole.near(centre, radius));

    // Spheres that are small beside the cell ask for smaller tetrahedra
    const label refinements = max
    (
        refinements_,
        min(label(std::ceil(std::log2(4*radius/body.minRadius()))), label(5))
    );

    const pointField& points = mesh_.points();
    scalar sum = 0;
    scalar all = 0;

    for (const label f : mesh_.cells()[cell])
    {
        const face& corners = mesh_.faces()[f];

        // The fan starts at the corner nearest to the body: with which one
        // the face happens to begin is another on another rank
        DynamicList<corner, 12> fan;
        label first = 0;
        for (const label p : corners)
        {
            fan.append(corner{points[p], body.distance(points[p])});
            if (fan.last().phi < fan[first].phi)
            {
                first = fan.size() - 1;
            }
        }
        std::rotate(fan.begin(), fan.begin() + first, fan.end());

        for (label k = 2; k < fan.size(); ++k)
        {
            const tet t({corner{centre, phi}, fan[0], fan[k - 1], fan[k]});
            all += volume(t);
            sum += inside(body, t, refinements, 3);
        }
    }

    // Round-off, which depends on the order of the faces and so on the ranks,
    // must not make a cut cell of a full one
    const scalar beta = sum/max(all, VSMALL);
    return beta > 1 - 1e-9 ? 1 : beta < 1e-9 ? 0 : beta;
}


// ************************************************************************* //
