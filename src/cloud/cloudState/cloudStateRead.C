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
#include "savedFile.H"
#include "dictionaryText.H"
#include "IOdictionary.H"

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using cloudState::savedBodies;

//- Index of the sphere that a body counts as number s
label sphereOf
(
    const dem::bodies& state,
    const label b,
    const label s,
    const savedBodies& saved,
    const word& field
)
{
    if (b < 0 || s < 0 || s >= state.shapeOf(b).radii().size())
    {
        saved.bad(field)
            << "A contact names a body or a sphere that is not there."
            << exit(FatalIOError);
    }
    return state.firstSphere[b] + s;
}


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

        state.q[b] = q;
        state.L[b] = L[b];
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
    coupling::implicitForcing& immersed
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


//- The image of the partner in each contact; the original without a seam
List<labelField> readImages
(
    const savedBodies& saved,
    const UList<vectorField>& slip,
    const bool periodic
)
{
    List<labelField> images(slip.size());
    if (!periodic)
    {
        forAll(images, b)
        {
            images[b] =
                labelField(slip[b].size(), label(dem::periodicity::original));
        }
        return images;
    }

    const word name("contactImage");
    images = saved.lists<label>(name);
    forAll(images, b)
    {
        bool good = images[b].size() == slip[b].size();
        for (const label image : images[b])
        {
            good = good && image >= 0 && image < 27;
        }
        if (!good)
        {
            saved.bad(name)
                << "Body " << saved.id[b] << " has the images " << images[b]
                << " for " << slip[b].size() << " contacts: one each, from 0 to"
                << " 26." << exit(FatalIOError);
        }
    }
    return images;
}


List<dem::verletList::pairHistory> readPairs
(
    const savedBodies& saved,
    const dem::bodies& state,
    const bool periodic
)
{
    const word name("contactSpheres");
    const List<labelField> spheres(saved.lists<label>(name));
    const List<vectorField> slip(saved.lists<vector>("contactSlip"));
    const List<labelField> images(readImages(saved, slip, periodic));

    Map<label> indexOf(2*state.size());
    forAll(saved.id, b)
    {
        indexOf.insert(saved.id[b], b);
    }

    DynamicList<dem::verletList::pairHistory> pairs;
    forAll(spheres, b)
    {
        if (spheres[b].size() != 3*slip[b].size())
        {
            saved.bad(name)
                << "Body " << saved.id[b] << " has " << spheres[b].size()
                << " numbers for " << slip[b].size() << " contacts."
                << exit(FatalIOError);
        }
        forAll(slip[b], k)
        {
            const label* number = &spheres[b][3*k];
            const label other = indexOf.lookup(number[1], -1);
            const label i = sphereOf(state, b, number[0], saved, name);
            const label j = sphereOf(state, other, number[2], saved, name);
            if (other <= b)
            {
                saved.bad(name)
                    << "The contact of body " << saved.id[b] << " with body "
                    << number[1] << " is on the wrong one."
                    << exit(FatalIOError);
            }
            pairs.append
            (
                dem::verletList::pairHistory{{i, j, images[b][k]}, slip[b][k]}
            );
        }
    }
    return List<dem::verletList::pairHistory>(std::move(pairs));
}


List<dem::wallTouch> readWalls
(
    const savedBodies& saved,
    const dem::bodies& state,
    const wordList& savedWalls,
    const wordList& walls
)
{
    const word name("wallSpheres");
    const List<labelField> spheres(saved.lists<label>(name));
    const List<vectorField> normal(saved.lists<vector>("wallNormal"));
    const List<vectorField> slip(saved.lists<vector>("wallSlip"));

    DynamicList<dem::wallTouch> touches;
    forAll(spheres, b)
    {
        if
        (
            spheres[b].size() != 2*slip[b].size()
         || normal[b].size() != slip[b].size()
        )
        {
            saved.bad(name)
                << "Body " << saved.id[b] << " has " << spheres[b].size()
                << " numbers and " << normal[b].size() << " normals for "
                << slip[b].size() << " contacts." << exit(FatalIOError);
        }
        forAll(slip[b], k)
        {
            const label w = spheres[b][2*k + 1];
            if (w < 0 || w >= savedWalls.size())
            {
                saved.bad(name)
                    << "Body " << saved.id[b] << " touches wall number " << w
                    << " of " << savedWalls << "." << exit(FatalIOError);
            }

            // A wall that is not in the case any more is not touched
            const label wallI = walls.find(savedWalls[w]);
            if (wallI < 0)
            {
                continue;
            }
            dem::wallTouch t;
            t.sphere = sphereOf(state, b, spheres[b][2*k], saved, name);
            t.wallI = wallI;
            t.p = state.sphereX[t.sphere];
            t.n = normal[b][k];
            t.overlap = 0;
            t.xi = slip[b][k];
            t.likeness = 0;
            touches.append(t);
        }
    }
    return List<dem::wallTouch>(std::move(touches));
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
    coupling::implicitForcing* immersed,
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

    const savedBodies saved(mesh, dict);
    checkCounters(dict);
    readBodies(saved, dict, dem);
    dem.setHistory
    (
        dem::contactHistory
        {
            readPairs(saved, dem.state(), dem.period().active()),
            readWalls
            (
                saved,
                dem.state(),
                dict.get<wordList>("walls"),
                dem.walls()
            )
        }
    );
    dem.readCounters(dict);

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

    // The name of a time directory has fewer digits than the time
    const_cast<Time&>(mesh.time()).setTime(time, mesh.time().timeIndex());
    return fluid;
}


// ************************************************************************* //
