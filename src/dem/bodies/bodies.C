/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "bodies.H"
#include "bitSet.H"
#include "rotation.H"

#include <algorithm>

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

//- Take those entries of a list, in that order; behind its last are others
template<class Type>
void gather
(
    Foam::DynamicList<Type>& list,
    const Foam::labelUList& from,
    const Foam::UList<Foam::dem::bodyRecord>& others,
    Type Foam::dem::bodyRecord::* const member
)
{
    const Foam::label n = list.size();
    Foam::List<Type> taken(from.size());
    forAll(from, i)
    {
        const Foam::label k = from[i];
        taken[i] = k < n ? list[k] : others[k - n].*member;
    }
    list.transfer(taken);
}


template<class Held, class Type>
void gatherHeld
(
    Held& held,
    const Foam::labelUList& from,
    const Foam::UList<Foam::dem::bodyRecord>& others,
    Type Foam::dem::bodyRecord::* const member
)
{
    const Held& before = held;
    const Foam::label n = held.size();
    Held taken;
    for (const Foam::label k : from)
    {
        taken.append(k < n ? before[k] : others[k - n].*member);
    }
    held.swap(taken);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::bodies::bodies(const PtrList<shape>& shapes)
:
    shapes_(shapes),
    nextId_(0)
{
    firstSphere.append(0);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dem::bodies::minRadius() const
{
    if (sphereR.same())
    {
        return nSpheres() ? sphereR[0] : 0;
    }
    scalar least = GREAT;
    for (label s = 0; s < nSpheres(); ++s)
    {
        least = min(least, sphereR[s]);
    }
    return least;
}


Foam::scalar Foam::dem::bodies::meanRadius() const
{
    scalar sum = 0;
    for (label s = 0; s < nSpheres(); ++s)
    {
        sum += sphereR[s];
    }
    return nSpheres() ? sum/nSpheres() : 0;
}


Foam::label Foam::dem::bodies::append(const newBody& n)
{
    const shape& s = shapes_[n.shapeI];
    const label b = size();

    id.append(nextId_++);
    shapeI.append(n.shapeI);
    materialI.append(n.materialI);
    mass.append(n.density*s.volume());
    x.append(n.position);
    v.append(n.velocity);
    q.append(unit(n.orientation*quaternion(s.toUser())));
    omega.append(n.angularVelocity);
    force.append(Zero);
    torque.append(Zero);
    fluidForce.append(Zero);
    fluidTorque.append(Zero);

    appendSpheres(b);
    if (!s.isSphere())
    {
        L_[b] = inertiaTensor(b) & n.angularVelocity;
    }
    byId_.clear();

    return b;
}


Foam::dem::bodyRecord Foam::dem::bodies::record(const label b) const
{
    return bodyRecord
    {
        id[b], shapeI[b], materialI[b], mass[b], x[b], v[b], q[b], L(b),
        omega[b], force[b], torque[b], fluidForce[b], fluidTorque[b]
    };
}


void Foam::dem::bodies::setState(const label b, const bodyRecord& r)
{
    x[b] = r.x;
    v[b] = r.v;
    q.set(b, r.q);
    setL(b, r.L);
    omega[b] = r.omega;
    force.set(b, r.force);
    torque.set(b, r.torque);
    fluidForce.set(b, r.fluidForce);
    fluidTorque.set(b, r.fluidTorque);
    updateSpheres(b);
}


const Foam::labelList& Foam::dem::bodies::byId() const
{
    if (byId_.size() != size())
    {
        byId_ = identity(size());
        std::sort
        (
            byId_.begin(),
            byId_.end(),
            [&](const label a, const label b) { return id[a] < id[b]; }
        );
    }
    return byId_;
}


Foam::label Foam::dem::bodies::find(const label bodyId) const
{
    const labelList& all = byId();
    const auto at = std::lower_bound
    (
        all.begin(),
        all.end(),
        bodyId,
        [&](const label b, const label i) { return id[b] < i; }
    );
    return at != all.end() && id[*at] == bodyId ? *at : -1;
}


void Foam::dem::bodies::clear()
{
    take(labelList());
    isCopy.clear();
}


Foam::labelList Foam::dem::bodies::unmarked(const boolList& marked)
{
    bitSet stays(marked);
    stays.flip();
    return stays.toc();
}


void Foam::dem::bodies::remove(const boolList& marked)
{
    take(unmarked(marked));
}


void Foam::dem::bodies::take
(
    const labelUList& from,
    const UList<bodyRecord>& others
)
{
    bool balls = allBalls_;
    for (const bodyRecord& r : others)
    {
        balls = balls && shapes_[r.shapeI].isSphere();
    }
    List<vector> momenta(balls ? 0 : from.size());
    forAll(momenta, i)
    {
        const label k = from[i];
        momenta[i] = k < size() ? L(k) : others[k - size()].L;
    }

    gather(id, from, others, &bodyRecord::id);
    gatherHeld(shapeI, from, others, &bodyRecord::shapeI);
    gatherHeld(materialI, from, others, &bodyRecord::materialI);
    gatherHeld(mass, from, others, &bodyRecord::mass);
    gather(x, from, others, &bodyRecord::x);
    gather(v, from, others, &bodyRecord::v);
    gatherHeld(q, from, others, &bodyRecord::q);
    gather(omega, from, others, &bodyRecord::omega);
    gatherHeld(force, from, others, &bodyRecord::force);
    gatherHeld(torque, from, others, &bodyRecord::torque);
    gatherHeld(fluidForce, from, others, &bodyRecord::fluidForce);
    gatherHeld(fluidTorque, from, others, &bodyRecord::fluidTorque);
    byId_.clear();

    firstSphere.clear();
    firstSphere.append(0);
    sphereBody.clear();
    sphereX_.clearStorage();
    L_.clearStorage();
    allBalls_ = true;
    sphereR.clear();
    forAll(x, b)
    {
        appendSpheres(b);
    }
    if (!allBalls_)
    {
        L_.transfer(momenta);
    }
}


void Foam::dem::bodies::appendSpheres(const label b)
{
    if (allBalls_ && !shapeOf(b).isSphere())
    {
        L_.setSize(b, Zero);
        allBalls_ = false;
        sphereX_ = SubList<point>(x, b);
    }
    for (const scalar radius : shapeOf(b).radii())
    {
        sphereBody.append(b);
        sphereR.append(radius);
        if (!allBalls_)
        {
            sphereX_.append(Zero);
        }
    }
    if (!allBalls_)
    {
        L_.append(Zero);
    }
    firstSphere.append(sphereR.size());
    updateSpheres(b);
}


Foam::labelList Foam::dem::bodies::sphereMap
(
    const labelUList& first,
    const labelUList& source
) const
{
    labelList map(first.last(), -1);
    forAll(source, b)
    {
        const label begin = firstSphere[b];
        for (label s = begin; source[b] >= 0 && s < firstSphere[b + 1]; ++s)
        {
            map[first[source[b]] + s - begin] = s;
        }
    }
    return map;
}


Foam::vector Foam::dem::bodies::omegaFrom
(
    const label b,
    const vector& angularMomentum
) const
{
    if (shapeOf(b).isSphere())
    {
        return angularMomentum/inertia(b).x();
    }

    return angularVelocity(q[b], angularMomentum, inertia(b));
}


void Foam::dem::bodies::setL(const label b, const vector& angularMomentum)
{
    omega[b] = omegaFrom(b, angularMomentum);
    if (!shapeOf(b).isSphere())
    {
        L_[b] = angularMomentum;
    }
}


Foam::tensor Foam::dem::bodies::inertiaTensor(const label b) const
{
    const tensor R = q[b].R();
    const vector I = inertia(b);
    return R & tensor(I.x(), 0, 0, 0, I.y(), 0, 0, 0, I.z()) & R.T();
}


void Foam::dem::bodies::updateSpheres(const label b)
{
    if (allBalls_)
    {
        return;
    }

    const shape& s = shapeOf(b);
    const label first = firstSphere[b];

    if (s.isSphere())
    {
        sphereX_[first] = x[b];
        return;
    }

    const tensor R = q[b].R();
    const pointField& centres = s.centres();
    forAll(centres, i)
    {
        sphereX_[first + i] = x[b] + (R & centres[i]);
    }
}


void Foam::dem::bodies::update()
{
    forAll(x, b)
    {
        omega[b] = omegaFrom(b, L(b));
        updateSpheres(b);
    }
}


Foam::quaternion Foam::dem::bodies::userOrientation(const label b) const
{
    return unit(q[b]*conjugate(quaternion(shapeOf(b).toUser())));
}


Foam::scalar Foam::dem::bodies::kineticEnergy() const
{
    scalar e = 0;
    forAll(x, b)
    {
        e += 0.5*mass[b]*magSqr(v[b]) + 0.5*(L(b) & omega[b]);
    }
    return e;
}


Foam::vector Foam::dem::bodies::momentum() const
{
    vector p(Zero);
    forAll(x, b)
    {
        p += mass[b]*v[b];
    }
    return p;
}


// ************************************************************************* //
