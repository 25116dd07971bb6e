/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "tang.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace coupling
{
    defineTypeNameAndDebug(tang, 0);
    addToRunTimeSelectionTable(dragLaw, tang, word);
}
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::coupling::tang::factor
(
    const scalar Re,
    const scalar voidFraction
) const
{
    const scalar phi = max(1 - voidFraction, scalar(0));
    const scalar Res = voidFraction*Re;
    const scalar alpha4 = pow4(voidFraction);

    return
        voidFraction
       *(
            10*phi/sqr(voidFraction)
          + sqr(voidFraction)*(1 + 1.5*sqrt(phi))
          + (0.11*phi*(1 + phi) - 0.00456/alpha4)*Res
          + (0.169*voidFraction + 0.0644/alpha4)*pow(Res, 0.657)
        );
}


// ************************************************************************* //
