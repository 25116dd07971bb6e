/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "buoyancy.H"
#include "addToRunTimeSelectionTable.H"
#include "allowedKeys.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace coupling
{
    defineTypeNameAndDebug(buoyancy, 0);
    addToRunTimeSelectionTable(pointForce, buoyancy, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::buoyancy::buoyancy
(
    const vector& g,
    const dictionary& dict
)
:
    g_(g)
{
    dem::checkKeys(dict, {});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::coupling::buoyancy::add
(
    const pointBody& body,
    const fluidAtPoint& fluid,
    pointSum& sum
) const
{
    sum.undisturbed -= fluid.rho*body.volume*g_;
}


// ************************************************************************* //
