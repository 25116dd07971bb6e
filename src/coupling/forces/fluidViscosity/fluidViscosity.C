/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.


\*---------------------------------------------------------------------------*/

#include "fluidViscosity.H"
#include "checkedEntry.H"
#include "IOdictionary.H"
#include "dimensionedScalar.H"

// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

Foam::scalar Foam::coupling::fluidViscosity::entry(const fvMesh& mesh)
{
    IOobject io
    (
        "transportProperties",
        mesh.time().constant(),
        mesh,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );
    if (!io.typeHeaderOk<IOdictionary>(true))
    {
        return 0;
    }

    const IOdictionary dict(io);
    return
        dict.found("nu")
      ? dimensionedScalar("nu", dimViscosity, dict).value()
      : 0;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::fluidViscosity::fluidViscosity
(
    const fvMesh& mesh,
    const dictionary& fluid
)
:
    mesh_(mesh),
    value_(0)
{
    if (fluid.found("nu"))
    {
        value_ = dem::getPositive(fluid, "nu");
        return;
    }
    if (mesh.foundObject<volScalarField>("nu"))
    {
        Info<< "    viscosity of the fluid: the solver's field nu" << endl;
        return;
    }

    value_ = entry(mesh);
    if (!(value_ > 0))
    {
        FatalIOErrorInFunction(fluid)
            << "The viscosity nu of the fluid [m2/s] is not known: the solver"
            << " has no field nu," << nl
            << "    and constant/transportProperties has no entry nu above 0."
            << nl << "    Give nu in the dictionary " << fluid.dictName()
            << "." << exit(FatalIOError);
    }
    Info<< "    viscosity of the fluid: " << value_
        << " m2/s of constant/transportProperties" << endl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::volScalarField* Foam::coupling::fluidViscosity::field() const
{
    return
        value_ > 0 ? nullptr : &mesh_.lookupObject<volScalarField>("nu");
}


// ************************************************************************* //
