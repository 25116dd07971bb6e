/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "syamlalOBrien.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace coupling
{
    defineTypeNameAndDebug(syamlalOBrien, 0);
    addToRunTimeSelectionTable(dragLaw, syamlalOBrien, word);
}
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::coupling::syamlalOBrien::factor
(
    const scalar Re,
    const scalar voidFraction
) const
{
    const scalar A = pow(voidFraction, 4.14);
    const scalar B =
        voidFraction > 0.85
      ? pow(voidFraction, 2.65)
      : 0.8*pow(voidFraction, 1.28);
    const scalar r = 0.06*Re;
    const scalar Vr = 0.5*(A - r + sqrt(sqr(r) + 2*r*(2*B - A) + sqr(A)));
    return voidFraction/24*sqr(0.63*sqrt(Re/sqr(Vr)) + 4.8/sqrt(Vr));
}


// ************************************************************************* //
