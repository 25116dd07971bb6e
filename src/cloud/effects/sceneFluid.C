/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "sceneFluid.H"
#include "dimensionedScalar.H"
#include "fvMesh.H"
#include "IOdictionary.H"
#include "localIOdictionary.H"
#include "volFields.H"

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- A number of a dictionary of the particles or the fluid, 0 if it is none
scalar numberIn
(
    const dictionary& dict,
    const word& key,
    const dimensionSet& dimensions
)
{
    if (!dict.found(key))
    {
        return 0;
    }
    ITstream& text = dict.lookup(key);
    for (const token& t : text)
    {
        if (t.isNumber() && text.size() == 1)
        {
            return t.number();
        }
    }
    return
        text.size() > 1
      ? dimensionedScalar(key, dimensions, dict).value()
      : 0;
}


//- A dictionary of a time or of constant, empty if there is none
template<class Type, class... Words>
Type fileOf
(
    const fvMesh& mesh,
    const word& name,
    const fileName& instance,
    const Words&... words
)
{
    return Type
    (
        IOobject
        (
            name,
            instance,
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE,
            false
        ),
        words...
    );
}


//- The values in the cells of a field, of the solver or of its file; none if
//  there is no such field
scalarField cellValues(const fvMesh& mesh, const word& name)
{
    if (mesh.foundObject<volScalarField>(name))
    {
        return mesh.lookupObject<volScalarField>(name).primitiveField();
    }
    // The internal field alone: the patches may need a solver
    const localIOdictionary file
    (
        fileOf<localIOdictionary>
        (
            mesh, name, mesh.time().timeName(), volScalarField::typeName
        )
    );
    return
        file.found("internalField")
      ? scalarField("internalField", file, mesh.nCells())
      : scalarField();
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::sceneFluid::readTurbulence(const fvMesh& mesh)
{
    const bool modelled =
        turbulent(mesh)
     || fileOf<IOdictionary>
        (
            mesh, "turbulenceProperties", mesh.time().constant()
        ).getOrDefault<word>("simulationType", "laminar") != "laminar";
    if (!modelled)
    {
        return;
    }
    k = cellValues(mesh, "k");
    epsilon = cellValues(mesh, "epsilon");
    const scalarField omega(cellValues(mesh, "omega"));
    if (epsilon.empty() && omega.size() == k.size())
    {
        epsilon = 0.09*k*omega;
    }
    if (epsilon.size() != k.size())
    {
        // As in large eddies, whose smaller ones have no such time
        k.clear();
        epsilon.clear();
    }
}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

bool Foam::sceneFluid::turbulent(const fvMesh& mesh)
{
    return
        mesh.foundObject<volScalarField>("k")
     && (
            mesh.foundObject<volScalarField>("epsilon")
         || mesh.foundObject<volScalarField>("omega")
        );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::sceneFluid::sceneFluid
(
    const fvMesh& mesh,
    const dictionary& properties,
    const volVectorField* velocity
)
:
    U(velocity)
{
    const IOdictionary transport
    (
        IOobject
        (
            "transportProperties",
            mesh.time().constant(),
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE,
            false
        )
    );

    // The densest phase, or the only one
    scalar phaseRho = numberIn(transport, "rho", dimDensity);
    scalar phaseNu = numberIn(transport, "nu", dimViscosity);
    for (const entry& e : transport)
    {
        if (e.isDict() && numberIn(e.dict(), "rho", dimDensity) > phaseRho)
        {
            phaseRho = numberIn(e.dict(), "rho", dimDensity);
            phaseNu = numberIn(e.dict(), "nu", dimViscosity);
        }
    }

    const dictionary& fluid = properties.subOrEmptyDict("fluid");
    rho = numberIn(fluid, "rho", dimDensity);
    nu = numberIn(fluid, "nu", dimViscosity);
    rho = rho > 0 ? rho : phaseRho;
    nu = nu > 0 ? nu : phaseNu;
    for (const bool density : {true, false})
    {
        if (!((density ? rho : nu) > 0))
        {
            FatalIOErrorInFunction(properties)
                << "The " << (density ? "density rho" : "viscosity nu")
                << " of the fluid is not known: neither here nor in"
                << " constant/transportProperties is an entry above 0." << nl
                << "    Give  fluid { rho 1000; nu 1e-6; }  here."
                << exit(FatalIOError);
        }
    }
    readTurbulence(mesh);
}


// ************************************************************************* //
