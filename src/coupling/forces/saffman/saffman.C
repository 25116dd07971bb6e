/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "saffman.H"
#include "addToRunTimeSelectionTable.H"
#include "allowedKeys.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace coupling
{
    defineTypeNameAndDebug(saffman, 0);
    addToRunTimeSelectionTable(pointForce, saffman, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::saffman::saffman
(
    const vector&,
    const dictionary& dict
)
{
    dem::checkKeys(dict, {});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::coupling::saffman::add
(
    const pointBody& body,
    const fluidAtPoint& fluid,
    pointSum& sum
) const
{
    const scalar w = mag(fluid.curlU);
    if (w > 0)
    {
        sum.force +=
            1.615*fluid.rho*sqr(body.d)*sqrt(fluid.nu/w)
           *((fluid.u - body.v) ^ fluid.curlU);
    }
}


// ************************************************************************* //
