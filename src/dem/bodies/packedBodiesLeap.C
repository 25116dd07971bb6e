/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "packedBodies.H"
#include "quadRecords.H"
#include "rotation.H"

#include <numeric>

using Foam::dem::quadRecords::record;
using Foam::dem::quadRecords::vectorOf;

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::dem::clumpData Foam::dem::packedBodies::clumpsFrom
(
    const records& from,
    const std::vector<clump>& clumps
)
{
    // What the lanes of a leap take a clump for
    static_assert
    (
        sizeof(clump) == sizeof(clumpRecord)
     && offsetof(clump, first) == offsetof(clumpRecord, first)
     && offsetof(clump, radius) == offsetof(clumpRecord, radius)
     && offsetof(clump, x) == offsetof(clumpRecord, x)
     && offsetof(clump, q0) == offsetof(clumpRecord, q0)
     && sizeof(quaternion) == sizeof(clumpRecord::q),
        "a clumpRecord is a plain image of a packedClump"
    );

    clumpData data;
    data.xv = from.xv.data();
    data.ft = from.ft.data();
    data.xvTo = now_.xv.data();
    data.wTo = now_.w.data();
    data.ftTo = nullptr;
    data.from = reinterpret_cast<const clumpRecord*>(clumps.data());
    data.to = reinterpret_cast<clumpRecord*>(clumps_.data());
    data.first = 0;
    data.last = int(clumps.size());
    data.list = nullptr;
    return data;
}


void Foam::dem::packedBodies::spreadAll()
{
    if (clumps_.size())
    {
        sweeps_->spreadClumps(clumpsFrom(now_, clumps_));
    }
}


void Foam::dem::packedBodies::spreadOne(const label k)
{
    clumpData data(clumpsFrom(now_, clumps_));
    data.last = 1;
    data.list = &k;
    data.ftTo = now_.ft.data();
    sweeps_->spreadClumps(data);
}


Foam::vector Foam::dem::packedBodies::kicked
(
    const label b,
    const vector& v,
    const vector& a,
    const scalar pending,
    const scalar h
) const
{
    // All else is the same before and after: one kick, which the drag follows
    const scalar all = pending + h;
    return v + (drag_ && all > 0 ? drag_->kick(b, v, a, all) : all*a);
}


Foam::vector Foam::dem::packedBodies::driven
(
    const label b,
    const vector& v,
    const vector& a,
    const scalar h,
    packedDrag& to
) const
{
    const vector now = kicked(b, v, a, pending_, h);
    if (drag_ && (metered_ || !to.given.empty()))
    {
        const scalar all = pending_ + h;
        const vector given = now - v - all*a;
        if (!to.given.empty())
        {
            to.given[b] += given;
        }
        if (metered_)
        {
            // Exact for a kick: half of m (now^2 - v^2) by a force is its
            // impulse times the mean of the velocities
            const scalar m = state_->mass[b];
            to.impulse += m*given;
            to.work += 0.5*m*((given + all*(g_ + held(b))) & (v + now));
        }
    }
    return now;
}


void Foam::dem::packedBodies::kickSingles
(
    const leapData& data,
    const records& from
)
{
    int left[atOnce];
    kickData kick;
    kick.bodies = allSingle_ ? nullptr : singleBody_.data();
    kick.drag = drag_->expanded(nBodies_);
    kick.width = fluidDrag::width;
    kick.given =
        given_.given.empty() ? nullptr : given_.given.data()->data();
    kick.metered = metered_;
    kick.left = left;
    if (kick.drag)
    {
        sweeps_->kick(data, kick);
        const double* p = kick.impulse;
        given_.impulse += vector(p[0], p[1], p[2]);
        given_.work += kick.work;
    }
    else
    {
        kick.nLeft = data.last - data.first;
        std::iota(left, left + kick.nLeft, data.first);
    }

    for (int i = 0; i < kick.nLeft; ++i)
    {
        const label k = left[i];
        const label s = singleSphere(k);
        const quad v = from.v(s);
        const vector a = g_ + from.x(s).w*vectorOf(from.f(s));
        now_.v(s) = record
        (
            driven(singleBody(k), vectorOf(v), a, 0.5*data.dt, given_),
            v.w
        );
    }
}


void Foam::dem::packedBodies::leapSingles
(
    const records& from,
    const scalar dt
)
{
    leapData data;
    data.xv = from.xv.data();
    data.w = from.w.data();
    data.ft = from.ft.data();
    data.xvTo = now_.xv.data();
    data.wTo = now_.w.data();
    data.ftTo = now_.ft.data();
    data.list = allSingle_ ? nullptr : single_.data();
    data.moved = drag_;
    data.h = pending_ + 0.5*dt;
    data.dt = dt;
    std::copy(g_.cdata(), g_.cdata() + 3, data.g);
    data.held = held_.empty() ? nullptr : held_.data();

    // Those that are kicked are still in the cache when they leap
    const label n = nSingles();
    const label most = drag_ ? atOnce : n;
    singleBounds_ = {};
    for (data.first = 0; data.first < n; data.first = data.last)
    {
        data.last = min(data.first + most, n);
        if (drag_)
        {
            kickSingles(data, from);
        }
        sweeps_->leap(data, singleBounds_);
    }
}


void Foam::dem::packedBodies::boundSingles()
{
    const leapBounds& bounds = singleBounds_;
    const auto length = [](const double* squares)
    {
        return sqrt(squares[0] + squares[1] + squares[2]);
    };
    motion_.speed = max(motion_.speed, length(bounds.speed));
    motion_.turning = max(motion_.turning, length(bounds.turning));
    motion_.acceleration =
        max(motion_.acceleration, length(bounds.acceleration));
}


void Foam::dem::packedBodies::leapClumps
(
    const records& from,
    const std::vector<clump>& clumps,
    const scalar dt
)
{
    const bool all = ownClump_.size() == clumps.size();
    if (clumps.empty())
    {
        return;
    }
    if (!all)
    {
        // A message says where the copies are
        for (std::size_t k = 0; k < clumps.size(); ++k)
        {
            if (clumps[k].copied)
            {
                clumps_[k] = clumps[k];
            }
        }
    }
    if (drag_)
    {
        for (const int k : ownClump_)
        {
            const clump& c = clumps[k];
            vector F, T;
            collect(from, k, c, F, T);
            const vector a = g_ + F/c.mass;
            clumps_[k].v = driven(c.body, c.v, a, 0.5*dt, given_);
        }
    }

    clumpData data(clumpsFrom(from, clumps));
    data.ftTo = now_.ft.data();
    data.list = all ? nullptr : ownClump_.data();
    data.moved = drag_;
    data.h = pending_ + 0.5*dt;
    data.dt = dt;
    std::copy(g_.cdata(), g_.cdata() + 3, data.g);
    data.force = clumpForce_.data()->cdata();
    data.torque = clumpTorque_.data()->cdata();

    // Their spheres are still in the cache when these follow
    const int n = int(ownClump_.size());
    const int most = 32;
    for (data.first = 0; data.first < n; data.first = data.last)
    {
        data.last = min(data.first + most, n);
        clumpBounds bounds;
        sweeps_->leapClumps(data, bounds);
        sweeps_->spreadClumps(data);
        motion_.speed = max(motion_.speed, bounds.speed);
        motion_.turning = max(motion_.turning, bounds.turning);
        motion_.acceleration = max(motion_.acceleration, bounds.acceleration);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::packedBodies::leap(const scalar dt, const bool trial)
{
    oldPending_ = pending_;
    motion_ = motion();

    if (trial)
    {
        const bool stale = asleep_.takeStale();
        now_.swap(old_);
        if (stale || now_.w.size() != old_.w.size())
        {
            now_ = old_;
        }
        std::swap(clumps_, oldClumps_);
        if (stale || clumps_.size() != oldClumps_.size())
        {
            clumps_ = oldClumps_;
        }
        oldGiven_ = given_;
        leapSingles(old_, dt);
        leapClumps(old_, oldClumps_, dt);

        // The fillers
        for (label s = nSpheres_; s < nSpheres_ + 2; ++s)
        {
            now_.xv[s] = old_.xv[s];
            now_.w[s] = old_.w[s];
        }
    }
    else
    {
        leapSingles(now_, dt);
        leapClumps(now_, clumps_, dt);
    }
    for (label b = 0; b < label(given_.given.size()) && asleep_.any(); ++b)
    {
        if (asleep_.has(b))
        {
            // The fluid loses what the contacts take up
            given_.given[b] +=
                dt/drag_->massShare(b)*drag_->acceleration(b, Zero);
        }
    }
    clumpMotion_ = motion_;
    boundSingles();
    pending_ = 0.5*dt;
}


void Foam::dem::packedBodies::undo()
{
    now_.swap(old_);
    std::swap(clumps_, oldClumps_);
    std::swap(given_, oldGiven_);
    pending_ = oldPending_;
    if (asleep_.any())
    {
        asleep_.reset(now_);
        asleep_.setStale();
    }
}


Foam::dem::packedEnd Foam::dem::packedBodies::end
(
    const label b,
    packedDrag& drag
) const
{
    const label k = place_[b];
    if (asleep_.has(b))
    {
        return packedEnd{Zero, Zero, Zero};
    }
    if (k < 0)
    {
        const label s = -1 - k;
        const scalar mInverse = now_.x(s).w;
        const vector a(g_ + mInverse*vectorOf(now_.f(s)));
        const scalar turn = quadRecords::surface*pending_*mInverse;
        const vector w(vectorOf(now_.w[s]) + turn*vectorOf(now_.t(s)));
        const vector omega(w/now_.v(s).w);
        return packedEnd
        {
            driven(b, vectorOf(now_.v(s)), a, 0, drag),
            state_->inertia(b).x()*omega,
            omega
        };
    }
    const clump& c = clumps_[k];
    vector F, T;
    collect(now_, k, c, F, T);
    const vector L(c.L + pending_*T);
    return packedEnd
    {
        driven(b, c.v, g_ + F/c.mass, 0, drag),
        L,
        angularVelocity(c.q, L, c.inertia)
    };
}


void Foam::dem::packedBodies::setPositions(const bodies& state)
{
    for (label s = 0; s < nSpheres_; ++s)
    {
        now_.x(s) = record(state.sphereX()[s], now_.x(s).w);
    }
    for (clump& c : clumps_)
    {
        c.x = state.x[c.body];
    }
    asleep_.setStale();
}


void Foam::dem::packedBodies::shift(const label b, const vector& by)
{
    const label p = place_[b];
    const label first = p >= 0 ? clumps_[p].first : -1 - p;
    const label last = p >= 0 ? clumps_[p].last : first + 1;
    for (label s = first; s < last; ++s)
    {
        now_.x(s) = record(centre(s) + by, now_.x(s).w);
    }
    if (p >= 0)
    {
        clumps_[p].x += by;
    }
    asleep_.setStale();
}


// ************************************************************************* //
