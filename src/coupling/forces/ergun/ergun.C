/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "ergun.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace coupling
{
    defineTypeNameAndDebug(ergun, 0);
    addToRunTimeSelectionTable(dragLaw, ergun, word);
}
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::coupling::ergun::factor
(
    const scalar Re,
    const scalar voidFraction
) const
{
    return (150*(1 - voidFraction)/voidFraction + 1.75*Re)/18;
}


void Foam::coupling::ergun::factors
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
