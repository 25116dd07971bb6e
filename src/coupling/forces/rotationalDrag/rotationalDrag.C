/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "rotationalDrag.H"
#include "addToRunTimeSelectionTable.H"
#include "allowedKeys.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace coupling
{
    defineTypeNameAndDebug(rotationalDrag, 0);
    addToRunTimeSelectionTable(pointForce, rotationalDrag, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::rotationalDrag::rotationalDrag
(
    const vector&,
    const dictionary& dict
)
{
    dem::checkKeys(dict, {});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::coupling::rotationalDrag::add
(
    const pointBody& body,
    const fluidAtPoint& fluid,
    pointSum& sum
) const
{
    const scalar spin = mag(0.5*fluid.curlU - body.omega);
    const scalar ReSpin = spin*sqr(body.d)/fluid.nu;

    // C_R Re_r, which is finite where there is no difference
    const scalar C =
        ReSpin > 32
      ? 12.9*sqrt(ReSpin) + 128.4
      : 64*constant::mathematical::pi;
    sum.spin += fluid.rho*fluid.nu*pow3(body.d)*C/64;
}


// ************************************************************************* //
