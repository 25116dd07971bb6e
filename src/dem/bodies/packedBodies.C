/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "packedBodies.H"
#include "areMany.H"
#include "quadRecords.H"
#include "rotation.H"

using Foam::dem::quadRecords::record;
using Foam::dem::quadRecords::vectorOf;

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::packedBodies::packSingle(const bodies& state, const label b)
{
    const label s = state.firstSphere[b];
    const scalar r = state.sphereR[s];

    place_.set(b, -1 - s);
    now_.x(s) = record(state.x[b], 1/state.mass[b]);
    now_.v(s) = record(state.v[b], r);
    now_.w[s] = record(r*state.omega[b], r);
}


void Foam::dem::packedBodies::packClump(const bodies& state, const label b)
{
    clump c;
    c.body = b;
    c.first = state.firstSphere[b];
    c.last = state.firstSphere[b + 1];
    c.copied = !state.owns(b);
    c.form = &state.shapeOf(b);
    c.centres = c.form->centres().cdata()->cdata();
    c.radius = c.form->boundingRadius();
    c.mass = state.mass[b];
    c.inertia = state.inertia(b);
    c.x = state.x[b];
    c.v = state.v[b];
    c.q = state.q[b];
    c.L = state.L(b);
    c.omega = state.omega[b];
    c.q0 = c.q;

    for (label s = c.first; s < c.last; ++s)
    {
        now_.v(s).w = state.sphereR[s];
    }
    place_.set(b, label(clumps_.size()));
    if (!c.copied)
    {
        ownClump_.push_back(place_[b]);
    }
    clumps_.push_back(c);
}


void Foam::dem::packedBodies::hold(const bodies& state)
{
    bool any = false;
    const bool none = state.fluidForce.none() && state.fluidTorque.none();
    for (label b = 0; b < state.size() && !none; ++b)
    {
        any =
            any
         || state.fluidForce[b] != vector(Zero)
         || state.fluidTorque[b] != vector(Zero);
    }
    held_.clear();
    clumpForce_.assign(clumps_.size(), vector(Zero));
    clumpTorque_ = clumpForce_;
    if (!any)
    {
        return;
    }

    held_.assign(nSpheres_, quadPair{{0, 0, 0, 0}, {0, 0, 0, 0}});
    forAll(state.x, b)
    {
        if (place_[b] >= 0)
        {
            clumpForce_[place_[b]] = state.fluidForce[b];
            clumpTorque_[place_[b]] = state.fluidTorque[b];
            continue;
        }
        const label s = -1 - place_[b];
        held_[s].first = record(state.fluidForce[b], 0);
        held_[s].second = record(state.fluidTorque[b]/now_.v(s).w, 0);
    }
}


void Foam::dem::packedBodies::collect
(
    const records& r,
    const label k,
    const clump& c,
    vector& F,
    vector& T
) const
{
    F = clumpForce_[k];
    T = clumpTorque_[k];
    for (label s = c.first; s < c.last; ++s)
    {
        const vector f = vectorOf(r.f(s));
        F += f;
        T += ((vectorOf(r.x(s)) - c.x) ^ f) + r.v(s).w*vectorOf(r.t(s));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::packedBodies::pack(const bodies& state, const vector& g)
{
    state_ = &state;
    nBodies_ = state.size();
    nSpheres_ = state.nSpheres();
    g_ = g;
    drag_ = state.drag;
    given_ = packedDrag();
    given_.given.assign(drag_ && state.recordDrag ? nBodies_ : 0, Zero);
    pending_ = 0;
    motion_ = motion();

    // The two that fill up have a radius, as a sweep divides by it, but are
    // too far from each other to touch
    const label n = nSpheres_ + 2;
    now_.xv.assign(n, quadPair{{0, 0, 0, 1}, {0, 0, 0, 0.1}});
    now_.x(n - 1).x = 1e30;
    now_.w.assign(n, quad{0, 0, 0, 0.1});
    now_.ft.resize(n);

    // A leap fills what it finds here, but for copies
    if (state.isCopy.size())
    {
        old_ = records();
    }

    // Others than these are not where a leap may leave what stays
    clumps_.clear();
    oldClumps_.clear();
    ownClump_.clear();
    single_.clear();
    singleBody_.clear();
    place_.start(nBodies_, state.allBalls());

    allSingle_ = nSpheres_ == nBodies_ && state.isCopy.empty();
    bool oneMaterial = true;
    for (label b = 0; b < nBodies_; ++b)
    {
        oneMaterial = oneMaterial && state.materialI[b] == 0;
        if (!state.shapeOf(b).isSphere())
        {
            packClump(state, b);
            continue;
        }
        packSingle(state, b);
        if (!allSingle_ && state.owns(b))
        {
            single_.push_back(state.firstSphere[b]);
            singleBody_.push_back(b);
        }
    }

    spreadAll();

    material_.clear();
    if (!oneMaterial)
    {
        material_.assign(n, 0);
        forAll(state.sphereBody, s)
        {
            material_[s] = state.materialI[state.sphereBody[s]];
        }
    }

    minRadius_ = state.minRadius();
    meanRadius_ = state.meanRadius();
    hold(state);
    clearForces();
    if (asleep_.any())
    {
        setAsleep(UList<bool>());
    }
}


void Foam::dem::packedBodies::unpackPositions(bodies& state) const
{
    for (label b = 0; b < nBodies_; ++b)
    {
        state.x[b] = position(b);
    }
    if (!state.allBalls())
    {
        for (label s = 0; s < nSpheres_; ++s)
        {
            state.setSphereX(s, centre(s));
        }
    }
    for (const clump& c : clumps_)
    {
        state.q.set(c.body, c.q);
    }
}


void Foam::dem::packedBodies::unpack(bodies& state)
{
    unpackPositions(state);
    const std::vector<vector>& given = given_.given;
    state.dragGiven.setSize(label(given.size()));

    const auto end = [&](const label b, const vector& v, const vector& a)
    {
        state.v[b] = kicked(b, v, a, pending_, 0);
        if (!given.empty())
        {
            state.dragGiven[b] = given[b] + state.v[b] - v - pending_*a;
        }
    };

    const label n = nSingles();
    for (label k = 0; k < n; ++k)
    {
        const label s = singleSphere(k);
        const label b = singleBody(k);
        const vector f = vectorOf(now_.f(s));
        const vector t = vectorOf(now_.t(s));
        const scalar mInverse = now_.x(s).w;
        const scalar r = now_.v(s).w;

        end(b, vectorOf(now_.v(s)), g_ + mInverse*f);
        const scalar turn = quadRecords::surface*pending_*mInverse;
        state.omega[b] = (vectorOf(now_.w[s]) + turn*t)/r;
    }

    // What is packed anew before it is read again makes room for the forces
    if (areMany(nSpheres_) && state.isCopy.empty())
    {
        std::vector<quad>().swap(now_.w);
    }
    for (label k = 0; k < n; ++k)
    {
        const label s = singleSphere(k);
        const label b = singleBody(k);
        state.force[b] = vectorOf(now_.f(s)) + state.mass[b]*g_;
        state.torque[b] = now_.v(s).w*vectorOf(now_.t(s));
    }

    for (const int k : ownClump_)
    {
        const clump& c = clumps_[k];
        vector F, T;
        collect(now_, k, c, F, T);

        state.force[c.body] = F + c.mass*g_;
        state.torque[c.body] = T;
        end(c.body, c.v, g_ + F/c.mass);
        state.setL(c.body, c.L + pending_*T);
    }
    if (asleep_.any())
    {
        unpackAsleep(state);
    }
}


void Foam::dem::packedBodies::setInstructions(const sweepSet& sweeps)
{
    sweeps_ = &sweeps;
}


void Foam::dem::packedBodies::free(const bool onlyForces)
{
    if (onlyForces)
    {
        std::vector<quadPair>().swap(now_.ft);
        return;
    }
    now_ = records();
    old_ = records();
}


void Foam::dem::packedBodies::clearForces()
{
    now_.ft.assign(nSpheres_ + 2, quadPair{{0, 0, 0, 0}, {0, 0, 0, 0}});
    std::copy(held_.begin(), held_.end(), now_.ft.begin());
}


void Foam::dem::packedBodies::setForces(const bodies& state)
{
    for (label b = 0; b < nBodies_; ++b)
    {
        const vector F = state.force[b] - state.mass[b]*g_;
        if (place_[b] < 0)
        {
            const label s = -1 - place_[b];
            now_.f(s) = record(F, 0);
            now_.t(s) = record(state.torque[b]/now_.v(s).w, 0);
            continue;
        }

        // Its spheres have none
        clumpForce_[place_[b]] = F;
        clumpTorque_[place_[b]] = state.torque[b];
    }
}


Foam::point Foam::dem::packedBodies::oldPosition(const label b) const
{
    const label p = place_[b];
    return p >= 0 ? oldClumps_[p].x : vectorOf(old_.x(-1 - p));
}


Foam::vector Foam::dem::packedBodies::velocity(const label b) const
{
    const label p = place_[b];
    return p >= 0 ? clumps_[p].v : vectorOf(now_.v(-1 - p));
}


Foam::scalar Foam::dem::packedBodies::turning(const label b) const
{
    const label p = place_[b];
    return
        p >= 0
      ? mag(clumps_[p].omega)*clumps_[p].form->boundingRadius()
      : mag(vectorOf(now_.w[-1 - p]));
}


Foam::vector Foam::dem::packedBodies::undragged(const label b) const
{
    const label p = place_[b];
    vector a;
    if (p >= 0)
    {
        vector F, T;
        collect(now_, p, clumps_[p], F, T);
        a = g_ + F/clumps_[p].mass;
    }
    else
    {
        a = g_ + now_.x(-1 - p).w*vectorOf(now_.f(-1 - p));
    }
    return a;
}


Foam::vector Foam::dem::packedBodies::acceleration(const label b) const
{
    const vector a = undragged(b);
    return drag_ ? drag_->acceleration(b, velocity(b), a) : a;
}


Foam::vector Foam::dem::packedBodies::held(const label b) const
{
    const label p = place_[b];
    return
        p >= 0
      ? clumpForce_[p]/clumps_[p].mass
      : held_.empty()
      ? vector(Zero)
      : now_.x(-1 - p).w*vectorOf(held_[-1 - p].first);
}


Foam::vector Foam::dem::packedBodies::pushed(const label b) const
{
    return undragged(b) - g_ - held(b);
}


Foam::scalar Foam::dem::packedBodies::paths(std::vector<path>& all) const
{
    all.assign(nSpheres_, path{Zero, Zero, 0});
    scalar longest = GREAT;

    const auto centre = [&](const label b, const vector& old, const vector& a)
    {
        path p{kicked(b, old, a, pending_, 0), a, 0};
        if (drag_)
        {
            const vector slip = drag_->fluidVelocity(b) - p.v;
            const scalar k = drag_->rate(b, mag(slip));
            p.a = drag_->massShare(b)*a + k*slip;
            p.bend = k*mag(slip);

            // The position is off by about k a h^3/4 after a step h
            const scalar jerk = k*mag(p.a);
            longest = min(longest, cbrt(0.04*minRadius(b)/max(jerk, VSMALL)));
        }
        return p;
    };

    const label n = nSingles();
    for (label k = 0; k < n; ++k)
    {
        const label s = singleSphere(k);
        all[s] = centre
        (
            singleBody(k),
            vectorOf(now_.v(s)),
            g_ + now_.x(s).w*vectorOf(now_.f(s))
        );
    }

    for (const int k : ownClump_)
    {
        const clump& c = clumps_[k];
        vector F, T;
        collect(now_, k, c, F, T);
        const path p = centre(c.body, c.v, g_ + F/c.mass);

        const vector L = c.L + pending_*T;
        const vector omega = angularVelocity(c.q, L, c.inertia);
        const scalar least = cmptMin(c.inertia);
        const scalar spin = largestSpin(L, omega, c.inertia);
        const scalar gain = mag(T)/least;

        // A free body's |d omega/dt| is below 0.58 omega^2, as no moment is
        // above the sum of the others; what a torque adds to omega is in the
        // margins of the bound below, as long as it turns by 0.01 at most
        longest = min(longest, 0.04/max(spin, VSMALL));
        longest = min(longest, sqrt(0.02/max(gain, VSMALL)));
        for (label s = c.first; s < c.last; ++s)
        {
            const vector arm = vectorOf(now_.x(s)) - c.x;
            all[s] = p;
            all[s].v += omega ^ arm;
            all[s].bend += mag(arm)*(2*sqr(spin) + 1.2*gain);
        }
    }
    return longest;
}


Foam::scalar Foam::dem::packedBodies::wayLeft(const placesBefore& b) const
{
    return sweeps_->wayLeft(now_.xv.data(), b, nSpheres_);
}


Foam::scalar Foam::dem::packedBodies::minRadius() const
{
    return minRadius_;
}


Foam::scalar Foam::dem::packedBodies::meanRadius() const
{
    return meanRadius_;
}


Foam::label Foam::dem::packedBodies::idOf(const label b) const
{
    return state_->id[b];
}


const Foam::dem::rankGroup& Foam::dem::packedBodies::group() const
{
    return group_;
}


bool Foam::dem::packedBodies::dragged() const
{
    return drag_;
}


Foam::scalar Foam::dem::packedBodies::minRadius(const label b) const
{
    const label p = place_[b];
    return p >= 0 ? clumps_[p].form->minRadius() : now_.v(-1 - p).w;
}


// ************************************************************************* //
