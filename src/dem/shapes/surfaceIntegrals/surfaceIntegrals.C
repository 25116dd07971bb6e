/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.
\*---------------------------------------------------------------------------*/

#include "surfaceIntegrals.H"
#include "boundBox.H"

// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

Foam::dem::massProperties Foam::dem::surfaceIntegrals
(
    const triSurface& surface
)
{
    const pointField& points = surface.points();
    const point origin(boundBox(points, false).centre());

    scalar volume = 0;
    vector first(Zero);
    symmTensor second(Zero);

    for (const labelledTri& f : surface)
    {
        const vector a(points[f[0]] - origin);
        const vector b(points[f[1]] - origin);
        const vector c(points[f[2]] - origin);
        const vector s(a + b + c);

        const scalar V = (a & (b ^ c))/6;

        volume += V;
        first += 0.25*V*s;
        second += V/20*(sqr(a) + sqr(b) + sqr(c) + sqr(s));
    }

    return massProperties::fromMoments(volume, first, second, origin);
}


Foam::scalarField Foam::dem::partVolumes
(
    const triSurface& surface,
    const labelUList& part,
    const label nParts
)
{
    const pointField& points = surface.points();
    const point origin(boundBox(points, false).centre());
    scalarField volumes(nParts, Zero);

    forAll(surface, i)
    {
        const labelledTri& f = surface[i];

        volumes[part[i]] +=
            (
                (points[f[0]] - origin)
              & ((points[f[1]] - origin) ^ (points[f[2]] - origin))
            )/6;
    }

    return volumes;
}


// ************************************************************************* //
