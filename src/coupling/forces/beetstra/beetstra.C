/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "beetstra.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace coupling
{
    defineTypeNameAndDebug(beetstra, 0);
    addToRunTimeSelectionTable(dragLaw, beetstra, word);
}
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::coupling::beetstra::factor
(
    const scalar Re,
    const scalar voidFraction
) const
{
    const scalar phi = max(1 - voidFraction, scalar(0));
    const scalar Res = voidFraction*Re;
    const scalar alphaSqr = sqr(voidFraction);

    // Powers of Re_s above 0 only: it may be 0
    const scalar power = pow(Res, 0.5 + 2*phi);
    const scalar inertia =
        0.413/(24*alphaSqr)
       *(
            Res*(1/voidFraction + 3*voidFraction*phi)
          + 8.4*pow(Res, 0.657)
        )
       *power/(power + pow(scalar(10), 3*phi));

    return
        voidFraction
       *(10*phi/alphaSqr + alphaSqr*(1 + 1.5*sqrt(phi)) + inertia);
}


// ************************************************************************* //
