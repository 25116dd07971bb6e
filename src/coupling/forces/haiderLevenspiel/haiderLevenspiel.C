/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "haiderLevenspiel.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace coupling
{
    defineTypeNameAndDebug(haiderLevenspiel, 0);
    addToRunTimeSelectionTable(dragLaw, haiderLevenspiel, word);
}
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::coupling::haiderLevenspiel::factor
(
    const scalar Re,
    const scalar voidFraction
) const
{
    return factor(Re, voidFraction, dragShape());
}


Foam::scalar Foam::coupling::haiderLevenspiel::factor
(
    const scalar Re,
    const scalar,
    const dragShape& shape
) const
{
    const scalar p = shape.sphericity;
    const scalar A = exp(2.3288 + p*(-6.4581 + 2.4486*p));
    const scalar B = 0.0964 + 0.5565*p;
    const scalar C = exp(4.905 + p*(-13.8944 + p*(18.4222 - 10.2599*p)));
    const scalar D = exp(1.4681 + p*(12.2584 + p*(-20.7322 + 15.8855*p)));
    return 1 + A*pow(Re, B) + C*sqr(Re)/(24*(Re + D));
}


// ************************************************************************* //
