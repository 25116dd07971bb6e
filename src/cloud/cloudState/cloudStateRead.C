/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "cloudState.H"
#include "forceMemory.H"
#include "savedBodies.H"
#include "savedContacts.H"
#include "savedFile.H"
#include "dictionaryText.H"
#include "IOdictionary.H"

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using cloudState::savedBodies;

void readBodies
(
    const savedBodies& saved,
    const dictionary& counters,
    dem::demSolver& dem
)
{
    dem::bodies& state = dem.state();

    wordList shapes;
    for (const dem::shape& s : dem.shapes())
    {
        shapes.append(s.name());
    }
    const labelList shapeI
    (
        saved.indices("template", counters.get<wordList>("shapes"), shapes)
    );
    const labelList materialI
    (
        saved.indices
        (
            "material",
            counters.get<wordList>("materials"),
            dem.mats().names()
        )
    );
    const List<vector> x(saved.vectors("position"));
    const List<vector> v(saved.vectors("velocity"));
    const List<vector> omega(saved.vectors("angularVelocity"));
    const List<vector> L(saved.vectors("angularMomentum"));
    const List<vector> axis(saved.vectors("rotation"));
    const List<scalar> w(saved.field<scalar>("rotationW"));

    forAll(x, b)
    {
        const quaternion q(w[b], axis[b]);
        if (!(mag(mag(q) - 1) < 1e-3))
        {
            saved.bad("rotationW")
                << "The rotation of body " << saved.id[b] << ", " << q
                << ", is none." << exit(FatalIOError);
        }

        dem::newBody n;
        n.shapeI = shapeI[b];
        n.materialI = materialI[b];
        n.density = dem.mats().density(materialI[b]);
        n.position = x[b];
        n.velocity = v[b];
        state.setNextId(saved.id[b]);
        state.append(n);

        state.q.set(b, q);
        state.setL(b, L[b]);
        state.omega[b] = omega[b];
        state.updateSpheres(b);
    }

    const label nextId = counters.get<label>("nextId");
    if (saved.id.size() && nextId <= saved.id.last())
    {
        saved.bad("id")
            << "The id " << saved.id.last() << " is not below the nextId "
            << nextId << " of " << counters.name() << "."
            << exit(FatalIOError);
    }
    state.setNextId(nextId);
}


void readCarried
(
    const savedBodies& saved,
    coupling::immersedMethod& immersed
)
{
    const List<vector> v(saved.vectors("imposedVelocity"));
    const List<vector> omega(saved.vectors("imposedAngularVelocity"));
    const List<vector> force(saved.vectors("fluidForce"));
    const List<vector> torque(saved.vectors("fluidTorque"));
    forAll(v, b)
    {
        immersed.setCarried(b, {{v[b], omega[b]}, force[b], torque[b]});
    }
}


//- The last time before the present one that was written to its end; the
//  same on all ranks
word lastWhole(const Time& time)
{
    word found;
    if (Pstream::master())
    {
        for (const instant& t : time.times())
        {
            if
            (
                t.name() != time.constant()
             && t.value() < time.value()
             && isFile(time.path()/t.name()/"uniform"/"demCloudProperties")
            )
            {
                found = t.name();
            }
        }
    }
    Pstream::scatter(found);
    return found;
}


//- Stop if the dictionary is not the one that was written
void checkCounters(const dictionary& dict)
{
    if (!dict.found("checksum"))
    {
        return;
    }
    if (cloudState::textChecksum(dict) != dict.get<label>("checksum"))
    {
        FatalIOErrorInFunction(dict)
            << "The entries are not those that were written: their checksum"
            << " differs." << nl
            << "    Start from another time. If they were changed on purpose,"
            << " take out the entry checksum."
            << exit(FatalIOError);
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::IOobject Foam::cloudState::counters
(
    const fvMesh& mesh,
    const IOobject::readOption r
)
{
    return IOobject
    (
        "demCloudProperties",
        mesh.time().timeName(),
        "uniform",
        mesh.time(),
        r,
        IOobject::NO_WRITE,
        false
    );
}


bool Foam::cloudState::found(const fvMesh& mesh)
{
    const bool any = returnReduce
    (
        isDir(mesh.time().timePath()/cloud::prefix/"demCloud"),
        orOp<bool>()
    );
    IOobject io(counters(mesh, IOobject::MUST_READ));
    const fileName text(io.globalFilePath(IOdictionary::typeName));
    if (isFile(text, false))
    {
        dem::checkText(text);
    }
    const bool counted = io.typeHeaderOk<IOdictionary>(true);

    if (counted)
    {
        return !IOdictionary(io).lookupOrDefault<bool>("start", false);
    }

    const word earlier(lastWhole(mesh.time()));
    if (any || earlier.size())
    {
        FatalIOError(FUNCTION_NAME, __FILE__, __LINE__, io.objectPath())
            << "This file is missing or broken, though "
            << (any ? "there are bodies in lagrangian/demCloud" :
                "the time " + earlier + " has it")
            << "." << nl
            << "    It is written last: the run was stopped while it wrote the"
            << " time " << mesh.time().timeName() << "," << nl
            << "    or the file was lost. Go on from an earlier time;"
            << " demRestart puts times aside that are not whole." << nl
            << "    To start anew from here with the bodies of"
            << " constant/demCloudProperties, remove lagrangian/demCloud" << nl
            << "    and write the file with the one entry 'start yes;'."
            << exit(FatalIOError);
    }
    return false;
}


bool Foam::cloudState::read
(
    const fvMesh& mesh,
    dem::demSolver& dem,
    coupling::bodyKinds& kinds,
    coupling::immersedMethod* immersed,
    coupling::pointForces* points
)
{
    const IOdictionary dict(counters(mesh, IOobject::MUST_READ));
    if (!dict.get<bool>("complete"))
    {
        FatalIOErrorInFunction(dict)
            << "The time " << mesh.time().timeName()
            << " was saved when the run stopped inside a step." << nl
            << "    Start from an earlier one." << exit(FatalIOError);
    }
    const scalar time = dict.get<scalar>("time");
    if (mag(time - mesh.time().value()) > 0.1*mesh.time().deltaTValue())
    {
        FatalIOErrorInFunction(dict)
            << "The state is of time " << time << ", not of "
            << mesh.time().timeName() << "." << exit(FatalIOError);
    }

    const savedBodies saved(mesh, dict, dem.group());
    checkCounters(dict);
    readBodies(saved, dict, dem);
    readContacts(saved, dict.get<wordList>("walls"), dem);
    dem.readCounters(dict);

    if (kinds.mixed())
    {
        kinds.restore(dem.state(), saved.field<label>("resolved"));
    }
    const bool fluid = dict.get<bool>("fluid");
    if (fluid && immersed)
    {
        readCarried(saved, *immersed);
    }
    if (points)
    {
        readForceMemory
        (
            saved,
            dict.lookupOrDefault<wordList>("forceMemory", wordList()),
            *points
        );
    }

    // What contacts remember comes together while no body has left yet
    dem.shareOut();
    if (points)
    {
        points->moveMemory();
    }
    if (immersed)
    {
        immersed->moveMemory();
    }

    // The name of a time directory has fewer digits than the time
    const_cast<Time&>(mesh.time()).setTime(time, mesh.time().timeIndex());
    return fluid;
}


// ************************************************************************* //
