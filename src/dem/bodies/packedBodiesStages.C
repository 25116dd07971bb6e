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
using Foam::dem::quadRecords::surface;
using Foam::dem::quadRecords::vectorOf;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Set the angular velocity of a clump, whose spheres follow
void place(Foam::dem::packedBodies::clump& c)
{
    c.omega = Foam::dem::angularVelocity(c.q, c.L, c.inertia);
    c.q0 = c.q;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::packedBodies::note(const label b, const vector& a)
{
    motion_.speed = max(motion_.speed, mag(velocity(b)));
    motion_.turning = max(motion_.turning, turning(b));
    motion_.acceleration = max(motion_.acceleration, mag(a));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::packedBodies::keep()
{
    old_ = now_;
    oldClumps_ = clumps_;
    oldGiven_ = given_;
    oldPending_ = pending_;
    motion_ = motion();
}


void Foam::dem::packedBodies::drift(const scalar h, const bool fourth)
{
    const label n = nSingles();
    for (label k = 0; k < n; ++k)
    {
        const label s = singleSphere(k);
        const vector x = vectorOf(now_.x(s)) + h*vectorOf(now_.v(s));
        now_.x(s) = record(x, now_.x(s).w);
        note(singleBody(k), Zero);
    }

    // A turn is symmetric, so that three of these lengths are of fourth order
    const scalar outer = 1/(2 - cbrt(scalar(2)));
    for (clump& c : clumps_)
    {
        c.x += h*c.v;
        if (fourth)
        {
            for (const scalar part : {outer, 1 - 2*outer, outer})
            {
                turn(c.q, c.L, c.inertia, part*h);
            }
        }
        else
        {
            turn(c.q, c.L, c.inertia, h);
        }
        place(c);
        note(c.body, Zero);
    }
    spreadAll();
    clearForces();
}


void Foam::dem::packedBodies::kick(const scalar h)
{
    const label n = nSingles();
    for (label k = 0; k < n; ++k)
    {
        const label s = singleSphere(k);
        const label b = singleBody(k);
        const scalar mInverse = now_.x(s).w;
        const vector a = g_ + mInverse*vectorOf(now_.f(s));
        const vector turn = surface*h*mInverse*vectorOf(now_.t(s));
        const vector v = driven(b, vectorOf(now_.v(s)), a, h, given_);
        now_.v(s) = record(v, now_.v(s).w);
        now_.w[s] = record(vectorOf(now_.w[s]) + turn, now_.w[s].w);
        note(b, a);
    }

    for (label k = 0; k < label(clumps_.size()); ++k)
    {
        clump& c = clumps_[k];
        vector F, T;
        collect(now_, k, c, F, T);
        const vector a = g_ + F/c.mass;
        c.v = driven(c.body, c.v, a, h, given_);
        c.L += h*T;
        place(c);
        note(c.body, a);
    }
    spreadAll();
}


Foam::dem::packedBodies::slope Foam::dem::packedBodies::slopes() const
{
    slope all;
    all.singles.resize(nSingles());
    all.clumps.resize(clumps_.size());

    for (label k = 0; k < nSingles(); ++k)
    {
        const label s = singleSphere(k);
        const scalar turn = surface*now_.x(s).w;
        all.singles[k] =
        {
            vectorOf(now_.v(s)),
            acceleration(singleBody(k)),
            turn*vectorOf(now_.t(s))
        };
    }
    for (label k = 0; k < label(clumps_.size()); ++k)
    {
        const clump& c = clumps_[k];
        vector F, T;
        collect(now_, k, c, F, T);
        const vector omega = angularVelocity(c.q, c.L, c.inertia);
        all.clumps[k].of = {c.v, acceleration(c.body), T};
        all.clumps[k].q = 0.5*(quaternion(omega)*c.q);
    }
    for (std::size_t b = 0; b < given_.given.size(); ++b)
    {
        all.drag.push_back(acceleration(b) - undragged(b));
    }
    return all;
}


void Foam::dem::packedBodies::moveBy(const parts& terms)
{
    for (label k = 0; k < nSingles(); ++k)
    {
        const label s = singleSphere(k);
        vector x = vectorOf(old_.x(s));
        vector v = vectorOf(old_.v(s));
        vector w = vectorOf(old_.w[s]);
        for (const auto& term : terms)
        {
            const slope::rates& r = term.second->singles[k];
            x += term.first*r.x;
            v += term.first*r.v;
            w += term.first*r.L;
        }
        now_.x(s) = record(x, old_.x(s).w);
        now_.v(s) = record(v, old_.v(s).w);
        now_.w[s] = record(w, old_.w[s].w);
        note(singleBody(k), terms.back().second->singles[k].v);
    }

    for (label k = 0; k < label(clumps_.size()); ++k)
    {
        clump c = oldClumps_[k];
        for (const auto& term : terms)
        {
            const auto& r = term.second->clumps[k];
            c.x += term.first*r.of.x;
            c.v += term.first*r.of.v;
            c.L += term.first*r.of.L;
            c.q = c.q + term.first*r.q;
        }
        c.q = unit(c.q);
        clumps_[k] = c;
        place(clumps_[k]);
        note(c.body, terms.back().second->clumps[k].of.v);
    }
    spreadAll();
    for (std::size_t b = 0; b < given_.given.size(); ++b)
    {
        given_.given[b] = oldGiven_.given[b];
        for (const auto& term : terms)
        {
            given_.given[b] += term.first*term.second->drag[b];
        }
    }
    clearForces();
}


Foam::dem::packedBodies::records Foam::dem::packedBodies::meanVelocities()
{
    records end;
    end.xv = now_.xv;
    end.w = now_.w;
    for (label s = 0; s < nSpheres_; ++s)
    {
        const vector v = 0.5*(vectorOf(old_.v(s)) + vectorOf(now_.v(s)));
        const vector w = 0.5*(vectorOf(old_.w[s]) + vectorOf(now_.w[s]));
        now_.v(s) = record(v, now_.v(s).w);
        now_.w[s] = record(w, now_.w[s].w);
    }
    clearForces();
    return end;
}


void Foam::dem::packedBodies::setVelocities(const records& r)
{
    for (label s = 0; s < nSpheres_; ++s)
    {
        now_.v(s) = r.v(s);
    }
    now_.w = r.w;
    clearForces();
}

// ************************************************************************* //
