/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "planeWall.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(planeWall, 0);
    addToRunTimeSelectionTable(wall, planeWall, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::planeWall::planeWall
(
    const word& name,
    const label materialI,
    const dictionary& dict,
    const fileName&
)
:
    wall(name, materialI)
{
    checkEntries(dict, {"point", "normal"});
    point_ = getFiniteVector(dict, "point");
    normal_ = getDirection(dict, "normal");
}


// ************************************************************************* //
