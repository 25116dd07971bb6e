/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "demCloudOption.H"
#include "allowedKeys.H"
#include "demCloudFunctionObject.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fv
{
    defineTypeNameAndDebug(demCloudOption, 0);
    addToRunTimeSelectionTable(option, demCloudOption, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fv::demCloudOption::demCloudOption
(
    const word& name,
    const word& modelType,
    const dictionary& dict,
    const fvMesh& mesh
)
:
    option(name, modelType, dict, mesh),
    cloud_(mesh, demCloud::fluidAccess::act)
{
    dem::checkKeys(dict, {"type", "active", "demCloudCoeffs"});

    fieldNames_.setSize(1, "U");
    applied_.setSize(1, false);
    functionObjects::demCloudFunctionObject::bringAlong(mesh.time());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fv::demCloudOption::addSup(fvMatrix<vector>& eqn, const label)
{
    functionObjects::demCloudFunctionObject::bringAlong(mesh_.time());
    cloud_.addForcing(eqn);
}


void Foam::fv::demCloudOption::addSup
(
    const volScalarField& rho,
    fvMatrix<vector>& eqn,
    const label
)
{
    functionObjects::demCloudFunctionObject::bringAlong(mesh_.time());
    cloud_.addForcing(eqn, rho.name());
}


bool Foam::fv::demCloudOption::read(const dictionary& dict)
{
    return option::read(dict);
}


// ************************************************************************* //
