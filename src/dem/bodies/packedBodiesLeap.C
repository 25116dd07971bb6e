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

using Foam::dem::quadRecords::record;
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

        const scalar r = now_.v(s).w;
        now_.x(s) = record(c.x + arm, now_.x(s).w);
        now_.v(s) = record(c.v + (c.omega ^ middle), r);
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


Foam::vector Foam::dem::packedBodies::driven
(
    const label b,
    const vector& v,
    const vector& a,
    const scalar h
)
{
    const vector now = kicked(b, v, a, pending_, h);
    if (!given_.empty())
    {
        given_[b] += now - v - (pending_ + h)*a;
    }
    return now;
}


void Foam::dem::packedBodies::leapSingles
(
    const records& from,
    const scalar dt
)
{
    const label n = nSingles();
    const vector& g = g_;
    if (drag_)
    {
        for (label k = 0; k < n; ++k)
        {
            const label s = singleSphere(k);
            const quad& v = from.v(s);
            const scalar mInverse = from.x(s).w;
            now_.v(s) = record
            (
                driven
                (
                    singleBody(k),
                    vectorOf(v),
                    g + mInverse*vectorOf(from.f(s)),
                    0.5*dt
                ),
                v.w
            );
        }
    }

    leapData data;
    data.xv = from.xv.data();
    data.w = from.w.data();
    data.ft = from.ft.data();
    data.xvTo = now_.xv.data();
    data.wTo = now_.w.data();
    data.ftTo = now_.ft.data();
    data.n = n;
    data.list = allSingle_ ? nullptr : single_.data();
    data.moved = drag_;
    data.h = pending_ + 0.5*dt;
    data.dt = dt;
    std::copy(g.cdata(), g.cdata() + 3, data.g);
    data.held = held_.empty() ? nullptr : held_.data();

    sweeps_->leap(data, singleBounds_);
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
    const label n = label(clumps.size());
    for (label k = 0; k < n; ++k)
    {
        clump c = clumps[k];
        if (c.copied)
        {
            // A message says where it is
            clumps_[k] = c;
            continue;
        }
        vector F, T;
        collect(from, k, c, F, T);

        const vector a = g_ + F/c.mass;
        c.v = driven(c.body, c.v, a, 0.5*dt);
        c.L += (pending_ + 0.5*dt)*T;
        c.x += dt*c.v;

        c.q0 = c.q;
        const tensor R0 = c.q.R();
        const vector before = angularVelocity(c.q, c.L, c.inertia);
        turn(c.q, c.L, c.inertia, dt);
        c.omega = 0.5*(before + angularVelocity(c.q, c.L, c.inertia));

        for (label s = c.first; s < c.last; ++s)
        {
            now_.x(s).w = from.x(s).w;
            now_.v(s).w = from.v(s).w;
            now_.w[s].w = from.w[s].w;
            now_.f(s) = now_.t(s) = quad{0, 0, 0, 0};
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
        now_.swap(old_);
        if (now_.w.size() != old_.w.size())
        {
            now_ = old_;
        }
        std::swap(clumps_, oldClumps_);
        clumps_.resize(oldClumps_.size());
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
}


// ************************************************************************* //
