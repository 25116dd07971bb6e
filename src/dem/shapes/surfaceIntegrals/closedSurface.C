/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.
\*---------------------------------------------------------------------------*/

#include "closedSurface.H"
#include "surfaceFile.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::closedSurface::refuse
(
    const label n,
    const string& what,
    const point& where
) const
{
    refuseSurface(name_, n, what, where);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::closedSurface::closedSurface
(
    const fileName& file,
    const scalar scale
)
:
    name_(file),
    surface_(readSurface(file, scale)),
    search_(surface_),
    properties_(check())
{}


Foam::dem::closedSurface::closedSurface
(
    const string& name,
    const triSurface& surface
)
:
    name_(name),
    surface_(surface),
    search_(surface_),
    properties_(check())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::point Foam::dem::closedSurface::nearest(const point& p) const
{
    const pointIndexHit hit(tree().findNearest(p, sqr(GREAT)));
    return hit.rawPoint();
}


// ************************************************************************* //
