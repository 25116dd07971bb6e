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
#include "contactLawState.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "PstreamReduceOps.H"
#include "savedFile.H"

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

wordList namesOf(const PtrList<dem::shape>& shapes)
{
    wordList names(shapes.size());
    forAll(names, i)
    {
        names[i] = shapes[i].name();
    }
    return names;
}


void writeCarried
(
    lagrangianWriter& out,
    const coupling::immersedMethod& immersed,
    const label n
)
{
    vectorField v(n), omega(n), force(n), torque(n);
    forAll(v, b)
    {
        const coupling::carriedMotion c(immersed.carriedOf(b));
        v[b] = c.imposed.v;
        omega[b] = c.imposed.omega;
        force[b] = c.force;
        torque[b] = c.torque;
    }
    out.write("imposedVelocity", v);
    out.write("imposedAngularVelocity", omega);
    out.write("fluidForce", force);
    out.write("fluidTorque", torque);
}


//- Write a list a body: owner says which body writes a contact, if it is 0 or
//  more, and give(k, list) appends the so many values of contact k. One field
//  at a time and no list longer than it must be: of a large scene they are a
//  good part of the memory
template<class Type, class Give>
void writeOf
(
    lagrangianWriter& out,
    const word& field,
    const label nBodies,
    const labelUList& owner,
    const label nEach,
    const Give& give
)
{
    labelList n(nBodies, Zero);
    for (const label b : owner)
    {
        if (b >= 0)
        {
            n[b] += nEach;
        }
    }
    List<DynamicList<Type>> lists(nBodies);
    forAll(lists, b)
    {
        lists[b].setCapacity(n[b]);
    }
    forAll(owner, k)
    {
        if (owner[k] >= 0)
        {
            give(k, lists[owner[k]]);
        }
    }
    out.writeLists(field, lists);
}


void writePairs
(
    lagrangianWriter& out,
    const dem::bodies& state,
    const dem::bodies& all,
    const UList<dem::verletList::pairHistory>& pairs,
    const bool periodic
)
{
    // The owner of the first body writes it
    labelList owner(pairs.size());
    forAll(owner, k)
    {
        const label i = all.sphereBody[pairs[k].pair.i];
        owner[k] = all.owns(i) ? state.find(all.id[i]) : -1;
    }
    const label n = state.size();
    writeOf<label>
    (
        out, "contactSpheres", n, owner, 3,
        [&](const label k, DynamicList<label>& spheres)
        {
            const dem::verletList::spherePair& p = pairs[k].pair;
            const label j = all.sphereBody[p.j];
            spheres.append(p.i - all.firstSphere[all.sphereBody[p.i]]);
            spheres.append(all.id[j]);
            spheres.append(p.j - all.firstSphere[j]);
        }
    );
    writeOf<vector>
    (
        out, "contactSlip", n, owner, 1,
        [&](const label k, DynamicList<vector>& slip)
        {
            slip.append(pairs[k].xi);
        }
    );
    if (periodic)
    {
        writeOf<label>
        (
            out, "contactImage", n, owner, 1,
            [&](const label k, DynamicList<label>& image)
            {
                image.append(pairs[k].pair.image);
            }
        );
    }
}


void writeWalls
(
    lagrangianWriter& out,
    const dem::bodies& state,
    const dem::bodies& all,
    const UList<dem::wallTouch>& touches
)
{
    labelList owner(touches.size());
    forAll(owner, k)
    {
        owner[k] = state.find(all.id[all.sphereBody[touches[k].sphere]]);
    }
    const label n = state.size();
    writeOf<label>
    (
        out, "wallSpheres", n, owner, 2,
        [&](const label k, DynamicList<label>& spheres)
        {
            const label s = touches[k].sphere;
            spheres.append(s - all.firstSphere[all.sphereBody[s]]);
            spheres.append(touches[k].wallI);
        }
    );
    writeOf<vector>
    (
        out, "wallNormal", n, owner, 1,
        [&](const label k, DynamicList<vector>& normal)
        {
            normal.append(touches[k].n);
        }
    );
    writeOf<vector>
    (
        out, "wallSlip", n, owner, 1,
        [&](const label k, DynamicList<vector>& slip)
        {
            slip.append(touches[k].xi);
        }
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::autoPtr<Foam::IOdictionary> Foam::cloudState::write
(
    const fvMesh& mesh,
    lagrangianWriter& out,
    const dem::demSolver& dem,
    const coupling::immersedMethod* immersed,
    const coupling::pointForces* points,
    const dictionary& meters,
    const dictionary& effects,
    const bool complete
)
{
    const dem::bodies& state = dem.state();

    {
        vectorField axis(state.size());
        scalarField w(state.size());
        vectorField L(state.size());
        forAll(axis, b)
        {
            axis[b] = state.q[b].v();
            w[b] = state.q[b].w();
            L[b] = state.L(b);
        }
        out.write("position", state.x);
        out.write("rotation", axis);
        out.write("rotationW", w);
        out.write("angularMomentum", L);
        out.write("material", state.materialI.list());
    }

    if (immersed)
    {
        writeCarried(out, *immersed, state.size());
    }

    wordList remembering;
    if (points)
    {
        remembering = writeForceMemory(out, state, *points);
    }

    const dem::contactHistory history(dem.history());
    const dem::bodies& all = dem.touching();
    writePairs(out, state, all, history.pairs, dem.period().active());
    writeWalls(out, state, all, history.walls);
    writeContactLaws(out, state, all, history);

    autoPtr<IOdictionary> dict
    (
        new IOdictionary(counters(mesh, IOobject::NO_READ))
    );
    dict->add("time", mesh.time().value());
    dict->add("complete", complete);
    dict->add("fluid", immersed != nullptr);
    dict->add("nBodies", dem.nBodies());
    dict->add("nextId", state.nextId());
    dict->add("shapes", namesOf(dem.shapes()));
    dict->add("materials", dem.mats().names());
    dict->add("walls", dem.walls());
    dem.writeCounters(*dict);
    dict->add("meters", meters);
    if (!effects.empty())
    {
        dict->add("effects", effects);
    }
    if (remembering.size())
    {
        dict->add("forceMemory", remembering);
    }
    dict->add("checksums", out.checksums());
    dict->add("checksum", textChecksum(*dict));
    return dict;
}


void Foam::cloudState::finish(const IOdictionary& dict)
{
    // All ranks have written the time
    returnReduce(true, andOp<bool>());

    const fileName path(dict.objectPath());
    const fileName part(path + ".part");
    mkDir(path.path());
    {
        OFstream os(part);
        os.precision(17);
        dict.writeHeader(os);
        dict.writeData(os);
        IOobject::writeEndDivider(os);
    }
    mv(part, path);
}


void Foam::cloudState::markStart(const fvMesh& mesh)
{
    IOdictionary dict(counters(mesh, IOobject::NO_READ));
    if (!returnReduce(isFile(dict.objectPath()), andOp<bool>()))
    {
        dict.add("start", true);
        finish(dict);
    }
}


void Foam::cloudState::begin(const fvMesh& mesh)
{
    const fileName path(counters(mesh, IOobject::NO_READ).objectPath());
    if (isFile(path))
    {
        rm(path);
    }
}


// ************************************************************************* //
