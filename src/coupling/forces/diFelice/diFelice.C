/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "diFelice.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace coupling
{
    defineTypeNameAndDebug(diFelice, 0);
    addToRunTimeSelectionTable(dragLaw, diFelice, word);
}
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::coupling::diFelice::factor
(
    const scalar Re,
    const scalar voidFraction
) const
{
    const scalar Res = voidFraction*Re;
    const scalar chi =
        3.7 - 0.65*exp(-sqr(1.5 - log10(max(Res, VSMALL)))/2);
    return sqr(0.63*sqrt(Res) + 4.8)*pow(voidFraction, 1 - chi)/24;
}


// ************************************************************************* //
