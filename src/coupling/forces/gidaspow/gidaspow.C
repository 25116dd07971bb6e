/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "gidaspow.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace coupling
{
    defineTypeNameAndDebug(gidaspow, 0);
    addToRunTimeSelectionTable(dragLaw, gidaspow, word);
}
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::coupling::gidaspow::factor
(
    const scalar Re,
    const scalar voidFraction
) const
{
    return
        voidFraction > 0.8
      ? dilute_.factor(Re, voidFraction)
      : dense_.factor(Re, voidFraction);
}


void Foam::coupling::gidaspow::factors
(
    const scalar width,
    const UList<scalar>& Re,
    const UList<scalar>& voidFraction,
    UList<triple>& f
) const
{
    forAll(f, i)
    {
        f[i] =
            voidFraction[i] > 0.8
          ? dilute_.near(width, Re[i], voidFraction[i])
          : dense_.near(width, Re[i], voidFraction[i]);
    }
}


// ************************************************************************* //
