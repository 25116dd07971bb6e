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

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

inline Foam::label Foam::coupling::volumeFraction::cellCorners::place
(
    const bodyGeometry& body,
    const pointField& x,
    const label p
)
{
    const label n = points.size();
    for (label k = 0; k < n; ++k)
    {
        if (points[k] == p)
        {
            return k;
        }
    }
    points.append(p);
    corners.append(corner(body, x[p]));
    return n;
}


inline Foam::scalar Foam::coupling::volumeFraction::volume(const tet& t)
{
    return
        mag
        (
            ((t[1].x - t[0].x) ^ (t[2].x - t[0].x)) & (t[3].x - t[0].x)
        )/6;
}


inline bool Foam::coupling::volumeFraction::creased(const tet& t)
{
    if (onePart(t))
    {
        return false;
    }

    // Only where the surface passes between the corners or close by
    const scalar close = 0.4*mag(t[1].x - t[0].x);
    scalar low = t[0].phi;
    scalar high = t[0].phi;
    for (label k = 1; k < 4; ++k)
    {
        low = min(low, t[k].phi);
        high = max(high, t[k].phi);
    }
    return low <= close && high >= -close;
}


inline Foam::scalar Foam::coupling::volumeFraction::longest2(const tet& t)
{
    scalar edge2 = 0;
    for (label i = 0; i < 3; ++i)
    {
        for (label j = i + 1; j < 4; ++j)
        {
            edge2 = max(edge2, magSqr(t[i].x - t[j].x));
        }
    }
    return edge2;
}


inline Foam::label Foam::coupling::volumeFraction::side
(
    const bodyGeometry& body,
    const tet& t,
    const scalar edge2
)
{
    const scalar low =
        min(min(t[0].phi, t[1].phi), min(t[2].phi, t[3].phi));
    const scalar high =
        max(max(t[0].phi, t[1].phi), max(t[2].phi, t[3].phi));

    if (body.outside(low, edge2))
    {
        return 1;
    }
    if (body.inside(low, high, edge2, onePart(t)))
    {
        return -1;
    }
    return 0;
}


inline void Foam::coupling::volumeFraction::addLinear
(
    const bodyGeometry& body,
    const tet& t,
    const scalar V,
    cutTets& cut
)
{
    label part = t[0].part;
    if (!onePart(t))
    {
        scalar phi;
        part = body.nearest(0.25*(t[0].x + t[1].x + t[2].x + t[3].x), phi);
    }

    const label k = cut.append(body.centre(part), V);
    for (label c = 0; c < 4; ++c)
    {
        cut.setCorner(k, c, t[c].x, t[c].phi);
    }
}


void Foam::coupling::volumeFraction::addInside
(
    const bodyGeometry& body,
    const tet& t,
    const scalar edge2,
    const label refinements,
    const label creases,
    const scalar V,
    cutTets& cut
)
{
    const label where = side(body, t, edge2);
    if (where)
    {
        cut.addWhole(where > 0 ? 0 : V);
        return;
    }
    if (!refinements && !(creases && creased(t)))
    {
        addLinear(body, t, V, cut);
        return;
    }

    const auto middle = [&](const label i, const label j)
    {
        return corner(body, 0.5*(t[i].x + t[j].x));
    };
    const corner m01 = middle(0, 1), m02 = middle(0, 2), m03 = middle(0, 3);
    const corner m12 = middle(1, 2), m13 = middle(1, 3), m23 = middle(2, 3);

    // Four at the corners, four in the octahedron that is left
    const tet parts[8] =
    {
        {t[0], m01, m02, m03},
        {t[1], m01, m12, m13},
        {t[2], m02, m12, m23},
        {t[3], m03, m13, m23},
        {m01, m23, m02, m03},
        {m01, m23, m03, m13},
        {m01, m23, m13, m12},
        {m01, m23, m12, m02}
    };
    const scalar partEdge2 = max(0.25*edge2, magSqr(m01.x - m23.x));

    // All of the same volume
    for (const tet& part : parts)
    {
        if (refinements)
        {
            addInside
            (
                body, part, partEdge2, refinements - 1, creases, V/8, cut
            );
        }
        else
        {
            addInside(body, part, partEdge2, 0, creases - 1, V/8, cut);
        }
    }
}


Foam::scalar Foam::coupling::volumeFraction::cutFraction
(
    const bodyGeometry& body,
    const label cell,
    const scalar radius
) const
{
    // What is small beside the cell, or curved, asks for smaller tetrahedra
    const label refinements = max(refinements_, body.refinements(radius));

    // Where parts meet, down to a sixteenth of the cell whatever they are
    const label creases = max(4 - refinements, 1);

    const pointField& points = mesh_.points();
    const corner atCentre(body, mesh_.cellCentres()[cell]);
    const DynamicList<corner, 16>& corners = at_.corners;
    DynamicList<label, 8>& fan = at_.fan;
    at_.points.clear();
    at_.corners.clear();
    cutTets cut(body.solved());
    scalar all = 0;

    for (const label f : mesh_.cells()[cell])
    {
        // The fan starts at the corner nearest to the body: with which one
        // the face happens to begin is another on another rank
        fan.clear();
        label first = 0;
        for (const label p : mesh_.faces()[f])
        {
            fan.append(at_.place(body, points, p));
            if (corners[fan.last()].phi < corners[fan[first]].phi)
            {
                first = fan.size() - 1;
            }
        }
        std::rotate(fan.begin(), fan.begin() + first, fan.end());

        for (label k = 2; k < fan.size(); ++k)
        {
            const tet t
            (
                atCentre, corners[fan[0]], corners[fan[k - 1]], corners[fan[k]]
            );
            const scalar V = volume(t);
            all += V;
            addInside
            (
                body, t, longest2(t), refinements, creases, V, cut
            );
        }
    }

    // Round-off, which depends on the order of the faces and so on the ranks,
    // must not make a cut cell of a full one
    const scalar beta = cut.sum()/max(all, VSMALL);
    return beta > 1 - 1e-9 ? 1 : beta < 1e-9 ? 0 : beta;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::coupling::volumeFraction::operator()
(
    const bodyGeometry& body,
    const label cell,
    const scalar radius
) const
{
    const point& centre = mesh_.cellCentres()[cell];
    const scalar phi = body.distance(centre, radius);

    if (phi >= radius)
    {
        return 0;
    }
    if (phi <= -radius)
    {
        return 1;
    }

    // Of several parts those that are near
    return
        body.isBall()
      ? cutFraction(body, cell, radius)
      : cutFraction(body.near(centre, radius), cell, radius);
}


// ************************************************************************* //
