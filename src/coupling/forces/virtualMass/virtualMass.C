/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "virtualMass.H"
#include "addToRunTimeSelectionTable.H"
#include "allowedKeys.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace coupling
{
    defineTypeNameAndDebug(virtualMass, 0);
    addToRunTimeSelectionTable(pointForce, virtualMass, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::virtualMass::virtualMass
(
    const vector&,
    const dictionary& dict
)
:
    C_(dem::getPositive(dict, "coefficient", 0.5))
{
    dem::checkKeys(dict, {"coefficient"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::coupling::virtualMass::add
(
    const pointBody& body,
    const fluidAtPoint& fluid,
    pointSum& sum
) const
{
    const scalar m = C_*fluid.rho*body.volume;
    sum.addedMass += m;
    sum.force += m*fluid.DuDt;
}


// ************************************************************************* //
