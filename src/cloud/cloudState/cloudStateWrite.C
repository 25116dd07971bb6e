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


void writePairs
(
    lagrangianWriter& out,
    const dem::bodies& state,
    const dem::bodies& all,
    const UList<dem::verletList::pairHistory>& pairs,
    const bool periodic
)
{
    List<DynamicList<label>> image(state.size());
    List<DynamicList<label>> spheres(state.size());
    List<DynamicList<vector>> slip(state.size());
    for (const dem::verletList::pairHistory& h : pairs)
    {
        // The owner of the first body writes it
        const label i = all.sphereBody[h.pair.i];
        const label j = all.sphereBody[h.pair.j];
        const label a = all.owns(i) ? state.find(all.id[i]) : -1;
        if (a >= 0)
        {
            spheres[a].append(h.pair.i - all.firstSphere[i]);
            spheres[a].append(all.id[j]);
            spheres[a].append(h.pair.j - all.firstSphere[j]);
            slip[a].append(h.xi);
            image[a].append(h.pair.image);
        }
    }
    out.writeLists("contactSpheres", spheres);
    out.writeLists("contactSlip", slip);
    if (periodic)
    {
        out.writeLists("contactImage", image);
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
    List<DynamicList<label>> spheres(state.size());
    List<DynamicList<vector>> normal(state.size());
    List<DynamicList<vector>> slip(state.size());
    for (const dem::wallTouch& t : touches)
    {
        const label i = all.sphereBody[t.sphere];
        const label b = state.find(all.id[i]);
        if (b >= 0)
        {
            spheres[b].append(t.sphere - all.firstSphere[i]);
            spheres[b].append(t.wallI);
            normal[b].append(t.n);
            slip[b].append(t.xi);
        }
    }
    out.writeLists("wallSpheres", spheres);
    out.writeLists("wallNormal", normal);
    out.writeLists("wallSlip", slip);
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
