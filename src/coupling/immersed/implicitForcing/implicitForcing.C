/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "implicitForcing.H"
#include "allowedKeys.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace coupling
{
    defineTypeNameAndDebug(implicitForcing, 0);
    addToRunTimeSelectionTable(immersedMethod, implicitForcing, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::coupling::implicitForcing::setForcing(const knownFlow& flow)
{
    forAll(cells_, b)
    {
        for (bodyCell& bc : cells_[b])
        {
            setLaw(b, bc, flow);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::implicitForcing::implicitForcing
(
    const immersedScene& scene,
    const dictionary& dict
)
:
    immersedMethod(scene, dict)
{
    dem::checkKeys(dict, commonKeys({}));
}


// ************************************************************************* //
