/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "rotateMotion.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"
#include "quaternion.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(rotateMotion, 0);
    addToRunTimeSelectionTable(wallMotion, rotateMotion, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::dem::wallMotion::state Foam::dem::rotateMotion::after
(
    const scalar time
) const
{
    state s;
    s.R = quaternion(axis_, omega_*time).R();
    s.d = origin_ - (s.R & origin_);
    s.omega = omega_*axis_;
    s.origin = origin_;
    return s;
}


Foam::scalar Foam::dem::rotateMotion::maxSpeed
(
    const wall& surface
) const
{
    return mag(omega_)*surface.farthest(origin_, axis_);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::rotateMotion::rotateMotion(const dictionary& dict)
:
    wallMotion(dict)
{
    checkEntries(dict, {"origin", "axis", "omega"});
    origin_ = getFiniteVector(dict, "origin");
    axis_ = getDirection(dict, "axis");
    omega_ = getFinite(dict, "omega");
}


// ************************************************************************* //
