/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Application
    demCheck

Description
    Reads a case without running it, as its solver would, and says what it
    found: sizes, times, memory, and what it would advise. Exit status 1 with
    the error if the case is wrong. See Foam::caseCheck.

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "columnFvMesh.H"
#include "Time.H"
#include "volFields.H"
#include "demCloud.H"
#include "effectInput.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

//- Does the case itself say that its bodies are in a fluid?
bool inFluid(const fvMesh& mesh)
{
    const IOdictionary properties
    (
        IOobject
        (
            "demCloudProperties",
            mesh.time().constant(),
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE,
            false
        )
    );
    const word application
    (
        mesh.time().controlDict().getOrDefault<word>("application", "none")
    );
    const bool chosen =
        !properties.found("coupling") && effectInput(properties).automatic
     && IOobject("U", mesh.time().timeName(), mesh, IOobject::MUST_READ)
       .typeHeaderOk<volVectorField>(true);
    return
        application != "demFoam"
     && (
            chosen
         || properties.getOrDefault<word>("coupling", "none") != "none"
        );
}


//- Is an entry of the dictionary the cloud?
bool loadsCloud(const dictionary& dict)
{
    for (const entry& e : dict)
    {
        if
        (
            e.isDict()
         && e.dict().getOrDefault<word>("type", "none") == "demCloud"
        )
        {
            return true;
        }
    }
    return false;
}


//- Do the fvOptions make the solver of the case load the bodies?
bool inOptions(const fvMesh& mesh)
{
    for (const word& folder : {mesh.time().constant(), mesh.time().system()})
    {
        const IOdictionary options
        (
            IOobject
            (
                "fvOptions",
                folder,
                mesh,
                IOobject::READ_IF_PRESENT,
                IOobject::NO_WRITE,
                false
            )
        );
        if (loadsCloud(options))
        {
            return true;
        }
    }
    return false;
}


//- Do the function objects?
bool inFunctions(const fvMesh& mesh)
{
    return loadsCloud(mesh.time().controlDict().subOrEmptyDict("functions"));
}


//- The densest fluid of the case everywhere [kg/m3], where the coupling looks
//  up the density of a solver that is not there; none if it is a number
autoPtr<volScalarField> densityField(const fvMesh& mesh)
{
    autoPtr<volScalarField> field;
    const auto read = [&mesh](const word& name)
    {
        return IOdictionary
        (
            IOobject
            (
                name,
                mesh.time().constant(),
                mesh,
                IOobject::READ_IF_PRESENT,
                IOobject::NO_WRITE,
                false
            )
        );
    };

    const IOdictionary properties(read("demCloudProperties"));
    const dictionary& fluid = properties.subOrEmptyDict("fluid");
    token first;
    if (fluid.found("rho"))
    {
        fluid.lookup("rho").read(first);
    }
    if (!first.isWord())
    {
        return field;
    }

    scalar rho = 0;
    const IOdictionary transport(read("transportProperties"));
    for (const entry& phase : transport)
    {
        if (phase.isDict() && phase.dict().found("rho"))
        {
            rho = max
            (
                rho,
                dimensionedScalar("rho", dimDensity, phase.dict()).value()
            );
        }
    }
    if (rho > 0)
    {
        field.reset
        (
            new volScalarField
            (
                IOobject(first.wordToken(), mesh.time().timeName(), mesh),
                mesh,
                dimensionedScalar("rho", dimDensity, rho)
            )
        );
    }
    return field;
}


//- Fields that forces look up of a solver that is not there: the pressure, and
//  those of turbulence that the case has a file of. Their values do not matter
PtrList<volScalarField> solverFields(const fvMesh& mesh)
{
    PtrList<volScalarField> fields;
    for (const word& name : {"p", "k", "epsilon", "omega"})
    {
        const IOobject io(name, mesh.time().timeName(), mesh);
        if (name == "p" || isFile(io.objectPath()))
        {
            fields.append
            (
                new volScalarField
                (
                    io,
                    mesh,
                    dimensionedScalar(name, dimless, 0)
                )
            );
        }
    }
    return fields;
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Checks a case with particles without running it, and advises."
    );
    argList::noFunctionObjects();

    #include "setRootCase.H"
    #include "createTime.H"
    #include "createMesh.H"

    const bool fluid = inFluid(mesh);
    autoPtr<volVectorField> U;
    autoPtr<volScalarField> rho;
    PtrList<volScalarField> others;
    if (fluid)
    {
        rho = densityField(mesh);
        others = solverFields(mesh);

        // What the coupling looks up
        U.reset
        (
            new volVectorField
            (
                IOobject
                (
                    "U",
                    runTime.timeName(),
                    mesh,
                    IOobject::MUST_READ,
                    IOobject::NO_WRITE
                ),
                mesh
            )
        );
    }

    {
        const bool options = inOptions(mesh);
        const bool functions = inFunctions(mesh);
        const demCloud cloud
        (
            mesh,
            !fluid ? demCloud::fluidAccess::none
          : options || !functions ? demCloud::fluidAccess::act
          : demCloud::fluidAccess::look
        );
        const caseCheck check(cloud.check(true));

        Info<< nl << "demCheck: " << runTime.caseName() << " at time "
            << runTime.timeName() << ", "
            << (fluid ? "in a fluid" : "no fluid") << nl;
        check.writeFigures(Info);
        if (fluid && !options && !functions)
        {
            Info<< "    Advice: No entry of type demCloud in"
                << " constant/fvOptions, or in functions in controlDict, loads"
                << " the bodies." << nl;
        }
        check.writeAdvice(Info);
        Info<< "demCheck: the case can run"
            << (check.advice().empty() ? ", nothing to advise" : "")
            << nl << endl;
    }

    return 0;
}


// ************************************************************************* //
