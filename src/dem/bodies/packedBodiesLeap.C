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

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using dem::quad;

// Nothing here is called from another file
#pragma GCC diagnostic ignored "-Wpsabi"

//- Four numbers at once; the compiler makes of it what the processor has
typedef double four __attribute__((vector_size(32)));

inline four in(const quad& q)
{
    four a;
    __builtin_memcpy(&a, &q, sizeof(a));
    return a;
}

inline void out(quad& q, const four a)
{
    __builtin_memcpy(&q, &a, sizeof(a));
}

inline double square(const four a)
{
    const four s = a*a;
    return s[0] + s[1] + s[2];
}

} // End anonymous namespace

using Foam::dem::quadRecords::record;
using Foam::dem::quadRecords::surface;
using Foam::dem::quadRecords::vectorOf;

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::packedBodies::spread
(
    const clump& c,
    const tensor& R0,
    const tensor& R
)
{
    const pointField& centres = c.form->centres();

    for (label s = c.first; s < c.last; ++s)
    {
        const point& p = centres[s - c.first];
        const vector arm = R & p;

        // Half way, where the velocities are
        const vector middle = 0.5*((R0 & p) + arm);

        const scalar r = now_.v[s].w;
        now_.x[s] = record(c.x + arm, now_.x[s].w);
        now_.v[s] = record(c.v + (c.omega ^ middle), r);
        now_.w[s] = record(r*c.omega, r);
    }
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
    if (!drag_)
    {
        return v + (pending + h)*a;
    }

    // One after the other, as the drag follows the velocity
    const vector now = pending > 0 ? v + drag_->kick(b, v, a, pending) : v;
    return h > 0 ? now + drag_->kick(b, now, a, h) : now;
}


void Foam::dem::packedBodies::leapSingles
(
    const records& from,
    const scalar dt
)
{
    const scalar h = pending_ + 0.5*dt;
    const four g = {g_.x(), g_.y(), g_.z(), 0};
    const four step = {dt, dt, dt, 0};
    const four zero = {};
    const bool held = !heldForce_.empty();

    double speed = 0, turning = 0, acceleration = 0;
    const label n = nSingles();
    for (label k = 0; k < n; ++k)
    {
        const label s = singleSphere(k);
        const four x = in(from.x[s]);
        const four a = g + x[3]*in(from.f[s]);
        four v = in(from.v[s]);

        if (drag_)
        {
            const vector moved = kicked
            (
                singleBody(k),
                vector(v[0], v[1], v[2]),
                vector(a[0], a[1], a[2]),
                pending_,
                0.5*dt
            );
            v = four{moved.x(), moved.y(), moved.z(), v[3]};
        }
        else
        {
            v += h*a;
        }
        const four w = in(from.w[s]) + (surface*h*x[3])*in(from.t[s]);

        out(now_.x[s], x + step*v);
        out(now_.v[s], v);
        out(now_.w[s], w);
        out(now_.f[s], held ? in(heldForce_[s]) : zero);
        out(now_.t[s], held ? in(heldTorque_[s]) : zero);

        speed = max(speed, square(v));
        turning = max(turning, square(w));
        acceleration = max(acceleration, square(a));
    }

    motion_.speed = max(motion_.speed, sqrt(speed));
    motion_.turning = max(motion_.turning, sqrt(turning));
    motion_.acceleration = max(motion_.acceleration, sqrt(acceleration));
}


void Foam::dem::packedBodies::leapClumps
(
    const records& from,
    const std::vector<clump>& clumps,
    const scalar dt
)
{
    const label n = label(clumps.size());
    for (label k = 0; k < n; ++k)
    {
        clump c = clumps[k];
        vector F, T;
        collect(from, k, c, F, T);

        const vector a = g_ + F/c.mass;
        c.v = kicked(c.body, c.v, a, pending_, 0.5*dt);
        c.L += (pending_ + 0.5*dt)*T;
        c.x += dt*c.v;

        const tensor R0 = c.q.R();
        const vector before = angularVelocity(c.q, c.L, c.inertia);
        turn(c.q, c.L, c.inertia, dt);
        c.omega = 0.5*(before + angularVelocity(c.q, c.L, c.inertia));

        for (label s = c.first; s < c.last; ++s)
        {
            now_.x[s].w = from.x[s].w;
            now_.v[s].w = from.v[s].w;
            now_.w[s].w = from.w[s].w;
            now_.f[s] = now_.t[s] = quad{0, 0, 0, 0};
        }
        spread(c, R0, c.q.R());
        clumps_[k] = c;

        motion_.speed = max(motion_.speed, mag(c.v));
        motion_.turning =
            max(motion_.turning, mag(c.omega)*c.form->boundingRadius());
        motion_.acceleration = max(motion_.acceleration, mag(a));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::packedBodies::leap(const scalar dt, const bool trial)
{
    oldPending_ = pending_;
    motion_ = motion();

    if (trial)
    {
        for (auto list : {&records::x, &records::v, &records::w,
            &records::f, &records::t})
        {
            std::swap(now_.*list, old_.*list);
            if ((now_.*list).size() != (old_.*list).size())
            {
                now_.*list = old_.*list;
            }
        }
        std::swap(clumps_, oldClumps_);
        clumps_.resize(oldClumps_.size());
        leapSingles(old_, dt);
        leapClumps(old_, oldClumps_, dt);

        // The fillers
        for (label s = nSpheres_; s < nSpheres_ + 2; ++s)
        {
            now_.x[s] = old_.x[s];
            now_.v[s] = old_.v[s];
            now_.w[s] = old_.w[s];
        }
    }
    else
    {
        leapSingles(now_, dt);
        leapClumps(now_, clumps_, dt);
    }
    pending_ = 0.5*dt;
}


void Foam::dem::packedBodies::undo()
{
    std::swap(now_, old_);
    std::swap(clumps_, oldClumps_);
    pending_ = oldPending_;
}


// ************************************************************************* //
