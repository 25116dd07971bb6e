/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "demCloud.H"
#include "cloudState.H"
#include "vtpFile.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Writer>
void Foam::demCloud::putBodies(Writer& out) const
{
    const dem::bodies& state = dem_->state();

    out.write("id", state.id);
    out.write("velocity", state.v);
    out.write("angularVelocity", state.omega);
    out.write("mass", state.mass.list());
    out.write("template", state.shapeI.list());

    const label n = state.size();
    vectorField axis(n), force(n), torque(n);
    scalarField w(n), diameter(n);
    forAll(axis, b)
    {
        const quaternion q = state.userOrientation(b);
        axis[b] = q.v();
        w[b] = q.w();
        diameter[b] = state.shapeOf(b).equivalentDiameter();
        force[b] = state.forceWithDrag(b);
        torque[b] = state.torque[b];
        if (immersed_.valid() && kinds_.resolved(b) && !dem_->moves())
        {
            force[b] = immersed_->force(b);
            torque[b] = immersed_->torque(b);
        }
    }
    out.write("orientation", axis);
    out.write("orientationW", w);
    out.write("diameter", diameter);
    if (kinds_.mixed())
    {
        out.write("resolved", kinds_.saved());
    }
    out.write("force", force);
    out.write("torque", torque);
}


template<class Writer>
void Foam::demCloud::putSpheres(Writer& out) const
{
    const dem::bodies& state = dem_->state();

    const label n = state.nSpheres();
    labelField body(n);
    vectorField velocity(n);
    scalarField diameter(n);
    forAll(body, s)
    {
        const label b = state.sphereBody[s];
        body[s] = state.id[b];
        velocity[s] = state.velocityAt(b, state.sphereX()[s]);
        diameter[s] = 2*state.sphereR[s];
    }
    out.write("body", body);
    out.write("velocity", velocity);
    out.write("diameter", diameter);
}


void Foam::demCloud::writeBodies() const
{
    const dem::bodies& state = dem_->state();
    dictionary effects(chosen_);
    if (effectWatch_.valid())
    {
        effects.set("watch", effectWatch_->state());
    }
    lagrangianWriter out
    (
        mesh_,
        bins_,
        "demCloud",
        state.x,
        dem_->group(),
        &state.id
    );
    putBodies(out);
    written_ = cloudState::write
    (
        mesh_,
        out,
        *dem_,
        immersed_.valid() ? immersed_.get() : nullptr,
        points_.valid() ? points_.get() : nullptr,
        meters_->counters(),
        effects,
        !advancing_
    );
}


void Foam::demCloud::writeSpheres() const
{
    lagrangianWriter out
    (
        mesh_,
        bins_,
        "demCloudSpheres",
        dem_->state().sphereX(),
        dem_->group(),
        nullptr
    );
    putSpheres(out);
}


void Foam::demCloud::writeVtp() const
{
    // All ranks have all bodies, or each writes its own
    const bool shared = dem_->group().shared();
    if (!vtp_ || (!shared && !Pstream::master()))
    {
        return;
    }
    const Time& time = mesh_.time();
    const fileName directory
    (
        time.rootPath()/time.globalCaseName()/"postProcessing/demCloud"
    );
    const fileName folder(directory/time.timeName());

    // Parts of an earlier run on more ranks
    if (Pstream::master())
    {
        vtpFile::removeParts(folder);
    }
    dem_->group().any(true);

    vtpFile bodies(dem_->state().x);
    putBodies(bodies);
    bodies.save(folder/vtpFile::partName("demCloud"));

    vtpFile spheres(dem_->state().sphereX());
    putSpheres(spheres);
    spheres.save(folder/vtpFile::partName("demCloudSpheres"));

    dem_->group().any(true);
    for (const word& name : {"demCloud", "demCloudSpheres"})
    {
        if (Pstream::master())
        {
            vtpFile::saveSeries(directory, name, time.value());
        }
    }
}


void Foam::demCloud::writeNetwork() const
{
    if (!network_ || !Pstream::master())
    {
        return;
    }
    const List<dem::contactForce> contacts(dem_->contacts());
    const dem::bodies& state = dem_->state();

    // A line from centre to centre, or to the wall. Both of its ends have its
    // values: a tube can have its width from them
    const label n = 2*contacts.size();
    pointField ends(n);
    scalarField normal(n), tangential(n);
    vectorField force(n);
    labelField body(n), other(n);
    for (label k = 0; k < n; ++k)
    {
        const dem::contactForce& c = contacts[k/2];
        ends[k] = state.x[c.a] - (k % 2 ? c.branch : vector(Zero));
        normal[k] = c.normal();
        tangential[k] = c.tangential();
        force[k] = c.force;
        body[k] = state.id[c.a];
        other[k] = c.b < 0 ? c.b : state.id[c.b];
    }
    vtpFile out(ends, true);
    out.write("normalForce", normal);
    out.write("tangentialForce", tangential);
    out.write("force", force);
    out.write("body", body);
    out.write("other", other);

    const Time& time = mesh_.time();
    const fileName directory
    (
        time.rootPath()/time.globalCaseName()/"postProcessing/demCloud"
    );
    out.save(directory/time.timeName()/"contactNetwork.vtp");
    vtpFile::saveSeries(directory, "contactNetwork", time.value());
}


void Foam::demCloud::finishWriting()
{
    if (written_.valid())
    {
        cloudState::finish(*written_);
        written_.clear();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::demCloud::writeObject(STYX_WRITE_OBJECT_PARAMETERS) const
{
    const ledger::entry e(ledger_, "output");
    cloudState::begin(mesh_);
    writeBodies();
    writeSpheres();
    writeVtp();
    writeNetwork();
    return true;
}


// ************************************************************************* //
