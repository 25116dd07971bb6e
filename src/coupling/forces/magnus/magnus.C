/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "magnus.H"
#include "addToRunTimeSelectionTable.H"
#include "allowedKeys.H"
#include "checkedEntry.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace coupling
{
    defineTypeNameAndDebug(magnus, 0);
    addToRunTimeSelectionTable(pointForce, magnus, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::magnus::magnus
(
    const vector&,
    const dictionary& dict
)
:
    creeping_
    (
        dem::getChoice
        (
            dict,
            "law",
            {"oesterleBuiDinh", "rubinowKeller"},
            "oesterleBuiDinh"
        ) == "rubinowKeller"
    )
{
    dem::checkKeys(dict, {"law"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::coupling::magnus::add
(
    const pointBody& body,
    const fluidAtPoint& fluid,
    pointSum& sum
) const
{
    const vector Omega = 0.5*fluid.curlU - body.omega;
    const vector slip = fluid.u - body.v;
    const scalar spin = mag(Omega);
    const scalar speed = mag(slip);
    if (!(spin > 0) || !(speed > 0))
    {
        return;
    }

    const scalar Re = speed*body.d/fluid.nu;
    const scalar ReSpin = spin*sqr(body.d)/fluid.nu;
    const scalar small = ReSpin/Re;
    const scalar C =
        creeping_
      ? small
      : 0.45
      + (small - 0.45)*exp(-0.05684*pow(ReSpin, 0.4)*pow(Re, 0.3));
    sum.force +=
        constant::mathematical::pi/8*fluid.rho*sqr(body.d)*speed*C/spin
       *(Omega ^ slip);
}


// ************************************************************************* //
