/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "kochHill.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace coupling
{
    defineTypeNameAndDebug(kochHill, 0);
    addToRunTimeSelectionTable(dragLaw, kochHill, word);
}
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::coupling::kochHill::factor
(
    const scalar Re,
    const scalar voidFraction
) const
{
    const scalar phi = 1 - voidFraction;
    const scalar phiLog = phi > 0 ? phi*log(phi) : 0;
    const scalar F0 =
        phi < 0.4
      ? (1 + 3*sqrt(max(phi, scalar(0))/2) + 135.0/64*phiLog + 16.14*phi)
       /(1 + phi*(0.681 + phi*(-8.48 + 8.16*phi)))
      : 10*phi/pow3(voidFraction);
    const scalar F3 = 0.0673 + 0.212*phi + 0.0232/pow5(voidFraction);
    return sqr(voidFraction)*(F0 + 0.5*F3*voidFraction*Re);
}


// ************************************************************************* //
