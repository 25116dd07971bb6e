/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "mei.H"
#include "addToRunTimeSelectionTable.H"
#include "allowedKeys.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace coupling
{
    defineTypeNameAndDebug(mei, 0);
    addToRunTimeSelectionTable(pointForce, mei, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::mei::mei
(
    const vector&,
    const dictionary& dict
)
{
    dem::checkKeys(dict, {});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::coupling::mei::add
(
    const pointBody& body,
    const fluidAtPoint& fluid,
    pointSum& sum
) const
{
    const scalar w = mag(fluid.curlU);
    const vector slip = fluid.u - body.v;
    const scalar speed = mag(slip);
    if (!(w > 0) || !(speed > 0))
    {
        return;
    }

    const scalar Re = speed*body.d/fluid.nu;
    const scalar b = 0.5*w*body.d/speed;
    const scalar overSaffman =
        Re <= 40
      ? (1 - 0.3314*sqrt(b))*exp(-Re/10) + 0.3314*sqrt(b)
      : 0.0524*sqrt(b*Re);
    sum.force +=
        overSaffman*1.615*fluid.rho*sqr(body.d)*sqrt(fluid.nu/w)
       *(slip ^ fluid.curlU);
}


// ************************************************************************* //
