/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "vibrateMotion.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"
#include "unitConversion.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(vibrateMotion, 0);
    addToRunTimeSelectionTable(wallMotion, vibrateMotion, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::dem::wallMotion::state Foam::dem::vibrateMotion::after
(
    const scalar time
) const
{
    const scalar angle = omega_*time + phase_;
    state s;
    s.d = (sin(angle) - sin(phase_))*amplitude_;
    s.v = omega_*cos(angle)*amplitude_;
    return s;
}


Foam::scalar Foam::dem::vibrateMotion::maxSpeed
(
    const wall&
) const
{
    return mag(amplitude_)*omega_;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::vibrateMotion::vibrateMotion(const dictionary& dict)
:
    wallMotion(dict)
{
    checkEntries(dict, {"amplitude", "frequency", "phase"});
    amplitude_ = getFiniteVector(dict, "amplitude");
    omega_ =
        constant::mathematical::twoPi
       *getPositive(dict, "frequency", 1e-12, 1e12);
    phase_ = degToRad(getFinite(dict, "phase", 0));
}


// ************************************************************************* //
