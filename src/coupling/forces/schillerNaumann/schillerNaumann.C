/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.


\*---------------------------------------------------------------------------*/

#include "schillerNaumann.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace coupling
{
    defineTypeNameAndDebug(schillerNaumann, 0);
    addToRunTimeSelectionTable(dragLaw, schillerNaumann, word);
}
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::coupling::schillerNaumann::factor
(
    const scalar Re,
    const scalar
) const
{
    return Re > 1000 ? 0.44*Re/24 : 1 + 0.15*pow(Re, 0.687);
}


// ************************************************************************* //
