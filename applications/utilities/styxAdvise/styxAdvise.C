/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Application
    styxAdvise

Description
    Says of each effect whether a case calls for it: the number that decides,
    the bar and its source, the expected share of the force, what it costs;
    and how the case differs. From the case's properties and mesh, and from the
    fields of a time. See Foam::effectTable.

Usage
    styxAdvise [-case DIR] [-time T | -latestTime] [-target E]

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "columnFvMesh.H"
#include "demCloud.H"
#include "earlyChoice.H"
#include "effectChoice.H"
#include "effectInput.H"
#include "pointForce.H"
#include "sceneSurvey.H"
#include "timeSelector.H"
#include "Time.H"
#include "volFields.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

//- The velocity at the present time; none if there is no such field
autoPtr<volVectorField> velocity(const fvMesh& mesh)
{
    autoPtr<volVectorField> U;
    IOobject io
    (
        "U",
        mesh.time().timeName(),
        mesh,
        IOobject::MUST_READ,
        IOobject::NO_WRITE
    );
    if (io.typeHeaderOk<volVectorField>(true))
    {
        U.reset(new volVectorField(io, mesh));
    }
    return U;
}


//- The properties of the particles as they are written
IOdictionary propertiesOf(const fvMesh& mesh)
{
    return IOdictionary
    (
        IOobject
        (
            "demCloudProperties",
            mesh.time().constant(),
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    );
}


//- Say where the case has an effect that is not called for, or lacks one
void compare(const dictionary& properties, const effectTable& table)
{
    const dictionary& forces = properties.subOrEmptyDict("forces");
    const word coupling
    (
        properties.getOrDefault<word>("coupling", "none")
    );
    const bool points =
        coupling == "fluidToParticles"
     || (coupling != "none" && properties.found("forces"));

    label n = 0;
    const auto differ = [&](const word& name, const bool has)
    {
        if (has != table.on(name))
        {
            Info<< "    Advice: " << name
                << (
                       has
                     ? " is named but not called for: its share is "
                     : " is called for but not named: its share is "
                   )
                << 100*table.share(name) << " %." << nl;
            ++n;
        }
    };
    if (points)
    {
        for (const word& name : effectChoice::forces())
        {
            const bool lift =
                name == "saffman" && coupling::pointForce::switchedOn
                (
                    "mei",
                    forces
                );
            differ
            (
                name,
                lift || coupling::pointForce::switchedOn(name, forces)
            );
        }
        differ("exchange", coupling != "fluidToParticles");
    }
    if (coupling != "none" && !points)
    {
        differ("immersed", true);
    }
    if (!n)
    {
        Info<< "    Nothing to advise." << nl;
    }
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote("Says which effects a case with particles calls for.");
    argList::noFunctionObjects();
    argList::noParallel();
    timeSelector::addOptions(true, false);
    argList::addOption("target", "error", "target error (default: 0.05)");

    #include "setRootCase.H"
    #include "createTime.H"
    timeSelector::selectIfPresent(runTime, args);
    #include "createMesh.H"

    const IOdictionary properties(propertiesOf(mesh));
    const scalar target =
        args.lookupOrDefault<scalar>
        (
            "target", effectInput(properties).target
        );
    if (!(target > 0 && target < 1))
    {
        FatalErrorInFunction
            << "The target error is " << target << "; it may be above 0 and"
            << " below 1." << exit(FatalError);
    }

    const autoPtr<volVectorField> U(velocity(mesh));
    const bool alone =
        runTime.controlDict().getOrDefault<word>("application", "none")
     == "demFoam" || !U.valid();
    const sceneFluid fluid
    (
        alone ? sceneFluid() : sceneFluid(mesh, properties, U.get())
    );

    const demCloud cloud(mesh, demCloud::fluidAccess::none);
    const coupling::cellBins bins(mesh);
    effectTable table
    (
        sceneSurvey(mesh, bins, cloud.dem(), fluid).numbers(),
        target
    );
    if (alone && table.kinds().size())
    {
        earlyChoice::judgeRest(table, properties, mesh, cloud.dem().g());
    }

    Info<< nl << "styxAdvise: " << runTime.caseName() << " at time "
        << runTime.timeName() << ", "
        << (alone ? "no fluid" : "in a fluid") << ", target error "
        << 100*target << " %" << nl;
    table.writeNumbers(Info);
    table.write(Info);
    if (!alone)
    {
        compare(properties, table);

        dictionary whole;
        for (const char* block : {"fluid", "momentumExchange"})
        {
            if (properties.found(block))
            {
                whole.add(block, properties.subDict(block));
            }
        }
        Info<< nl << "Entries that do this:" << nl;
        effectChoice::chooseCoupling
        (
            whole,
            table,
            true,
            runTime.controlDict().getOrDefault<word>("application", "")
         == "styxFoam",
            runTime.deltaTValue()
        ).write(Info, false);
    }
    Info<< nl << endl;

    return 0;
}


// ************************************************************************* //
