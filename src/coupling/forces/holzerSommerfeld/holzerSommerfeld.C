/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "holzerSommerfeld.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace coupling
{
    defineTypeNameAndDebug(holzerSommerfeld, 0);
    addToRunTimeSelectionTable(dragLaw, holzerSommerfeld, word);
}
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::coupling::holzerSommerfeld::factor
(
    const scalar Re,
    const scalar voidFraction
) const
{
    return factor(Re, voidFraction, dragShape());
}


Foam::scalar Foam::coupling::holzerSommerfeld::factor
(
    const scalar Re,
    const scalar,
    const dragShape& shape
) const
{
    const scalar psi = min(shape.sphericity, scalar(1));
    const scalar inertia =
        0.42*pow(scalar(10), 0.4*pow(-log10(psi), 0.2))/shape.crosswise;

    return
        1/(3*sqrt(shape.lengthwise))
      + 2/(3*sqrt(psi))
      + sqrt(Re)/(8*pow(psi, 0.75))
      + inertia*Re/24;
}


// ************************************************************************* //
