/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "translateMotion.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(translateMotion, 0);
    addToRunTimeSelectionTable(wallMotion, translateMotion, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::dem::wallMotion::state Foam::dem::translateMotion::after
(
    const scalar time
) const
{
    state s;
    s.d = time*velocity_;
    s.v = velocity_;
    return s;
}


Foam::scalar Foam::dem::translateMotion::maxSpeed
(
    const wall&
) const
{
    return mag(velocity_);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::translateMotion::translateMotion(const dictionary& dict)
:
    wallMotion(dict)
{
    checkEntries(dict, {"velocity"});
    velocity_ = getFiniteVector(dict, "velocity");
}


// ************************************************************************* //
