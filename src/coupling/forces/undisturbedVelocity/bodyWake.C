/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "bodyWake.H"
#include "mathematicalConstants.H"

#include <cmath>

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

//- Parts of an age that neighbours may last together
const Foam::scalar together = 0.25;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::coupling::bodyWake::join()
{
    // From the oldest on; the last two steps stay as they are
    label kept = 0;
    for (label j = 1; j < records_.size(); ++j)
    {
        record& old = records_[kept];
        const record& r = records_[j];
        const scalar width = old.width + r.width;
        if
        (
            j < records_.size() - 2
         && width <= together*(r.t - 0.5*r.width)
        )
        {
            old.J += r.J;
            old.at = (old.width*old.at + r.width*r.at)/width;
            old.t = (old.width*old.t + r.width*r.t)/width;
            old.width = width;
        }
        else
        {
            records_[++kept] = r;
        }
    }
    records_.setSize(min(kept + 1, records_.size()));
}


Foam::vector Foam::coupling::bodyWake::flow
(
    const record& r,
    const fluidAtPoint& fluid,
    const meshDecay& decay
) const
{
    const scalar h = fluid.cellSize;
    const scalar own = fluid.ownShare;

    // The interpolation's mean over cells around a point of the surface: half
    // a cell away along the way to the point, the rest is across
    const scalar out = 0.5*(1 - own);
    const vector side =
        out > SMALL ? -0.5/out*fluid.toCentre : vector(Zero);
    const scalar across = (0.75*sqr(h) - min(magSqr(side), 0.75*sqr(h)))/3;

    // Equal parts of the duration in 1/sqrt(t), in which all is smooth
    const scalar first = tau_ + r.t - 0.5*r.width;
    const scalar last = first + r.width;
    const label n = r.width <= together*first ? 1 : 8;
    const auto q = [&](const scalar t) { return 1/sqrt(t + 0.05*sqr(h)); };
    vector sum = Zero;
    for (label i = 0; i < n; ++i)
    {
        const scalar qi =
            q(first) + (i + 0.5)/n*(q(last) - q(first));
        const scalar t = n == 1 ? tau_ + r.t : 1/sqr(qi) - 0.05*sqr(h);
        const scalar weight =
            n == 1 ? 1 : 2/pow3(qi)*(q(first) - q(last))/n/r.width;
        const vector at =
            r.at + (t - tau_ - r.t)/max(nu_, VSMALL)*u_;
        const scalar te = decay.effective(t, h);
        sum +=
            weight*own*impulsive(fluid.toCentre - at, te, r.J);
        if (own < 1)
        {
            sum +=
                weight*(1 - own)
               *impulsive
                (
                    fluid.toCentre + side - at,
                    te + 0.125*sqr(h) + 0.5*across,
                    r.J
                );
        }
    }
    return sum;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::coupling::bodyWake::impulsive
(
    const vector& r,
    const scalar t,
    const vector& J
)
{
    using constant::mathematical::pi;

    const scalar s2 = magSqr(r)/(4*t);
    const scalar s = sqrt(s2);
    const scalar peak = 1/(4*pi*t*sqrt(4*pi*t));
    const scalar p = peak*std::exp(-s2);

    // erf less the rest of A cancels near the centre: there a series
    const scalar A =
        s < 0.05
      ? -peak/3*(1 - 0.6*s2 + 3.0/14*sqr(s2))
      : (2*s/sqrt(pi)*std::exp(-s2) - std::erf(s))
       *peak*sqrt(pi)/(4*s2*s);
    const scalar along = s2 > 0 ? (r & J)/magSqr(r) : 0;
    return (p + A)*J - (p + 3*A)*along*r;
}


void Foam::coupling::bodyWake::note(const exchangedImpulse& impulse)
{
    tau_ = impulse.tau;
    onFaces_ = impulse.onFaces;
    if (impulse.step == step_ && records_.size())
    {
        records_.last().J = impulse.J;
        return;
    }
    step_ = impulse.step;

    const vector carried = impulse.dt*u_;
    const scalar aged = impulse.dt*nu_;
    for (record& r : records_)
    {
        r.at += carried - impulse.moved;
        r.t += aged;
    }
    records_.append
    (
        record
        {
            impulse.J,
            impulse.offset + 0.5*carried,
            0.5*aged,
            aged
        }
    );
    join();
}


void Foam::coupling::bodyWake::takeOff
(
    fluidAtPoint& fluid,
    const meshDecay& onCells,
    const meshDecay& onFaces
)
{
    const meshDecay& decay = onFaces_ ? onFaces : onCells;
    vector sum = Zero;
    for (const record& r : records_)
    {
        sum += flow(r, fluid, decay);
    }
    fluid.u += sum/(fluid.rho*fluid.voidFraction);
    u_ = fluid.u;
    nu_ = fluid.nu;
}


void Foam::coupling::bodyWake::save(DynamicList<vector>& values) const
{
    values.append(vector(records_.size(), step_, onFaces_));
    values.append(u_);
    values.append(vector(nu_, tau_, 0));
    for (const record& r : records_)
    {
        values.append(r.J);
        values.append(r.at);
        values.append(vector(r.t, r.width, 0));
    }
}


bool Foam::coupling::bodyWake::load(const UList<vector>& values)
{
    if
    (
        values.size() < 3
     || values.size() != 3 + 3*label(values[0].x())
    )
    {
        return false;
    }

    step_ = label(values[0].y());
    onFaces_ = values[0].z() > 0.5;
    u_ = values[1];
    nu_ = values[2].x();
    tau_ = values[2].y();
    records_.clear();
    for (label j = 3; j < values.size(); j += 3)
    {
        records_.append
        (
            record
            {
                values[j],
                values[j + 1],
                values[j + 2].x(),
                values[j + 2].y()
            }
        );
    }
    return true;
}


// ************************************************************************* //
