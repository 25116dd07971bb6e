/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "undisturbedVelocity.H"
#include "addToRunTimeSelectionTable.H"
#include "allowedKeys.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace coupling
{
    defineTypeNameAndDebug(undisturbedVelocity, 0);
    addToRunTimeSelectionTable(pointForce, undisturbedVelocity, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::undisturbedVelocity::undisturbedVelocity
(
    const vector&,
    const dictionary& dict
)
:
    onCells_(false),
    onFaces_(true)
{
    dem::checkKeys(dict, wordList());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::coupling::undisturbedVelocity::save
(
    const label id,
    DynamicList<vector>& values
) const
{
    if (wakes_.found(id))
    {
        wakes_[id].save(values);
    }
}


// ************************************************************************* //
