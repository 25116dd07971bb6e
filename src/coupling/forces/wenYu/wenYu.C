/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "wenYu.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace coupling
{
    defineTypeNameAndDebug(wenYu, 0);
    addToRunTimeSelectionTable(dragLaw, wenYu, word);
}
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::coupling::wenYu::factor
(
    const scalar Re,
    const scalar voidFraction
) const
{
    return single_.factor(voidFraction*Re, 1)*pow(voidFraction, -2.65);
}


Foam::coupling::dragLaw::triple Foam::coupling::wenYu::near
(
    const scalar width,
    const scalar Re,
    const scalar voidFraction
) const
{
    // What depends on the void fraction alone once
    const scalar crowd = pow(voidFraction, -2.65);
    const scalar alone = voidFraction*Re;
    return
    {
        crowd*single_.factor(alone, 1),
        crowd*single_.factor((1 - width)*alone, 1),
        crowd*single_.factor((1 + width)*alone, 1)
    };
}


void Foam::coupling::wenYu::factors
(
    const scalar width,
    const UList<scalar>& Re,
    const UList<scalar>& voidFraction,
    UList<triple>& f
) const
{
    forAll(f, i)
    {
        f[i] = near(width, Re[i], voidFraction[i]);
    }
}


// ************************************************************************* //
