/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    The wake of a body at its own place: against the closed forms of a Gaussian
    force in a viscous fluid, steady, started and moving, and against a mesh.

\*---------------------------------------------------------------------------*/

#include "figure.H"

#include "bodyWake.H"
#include "mathematicalConstants.H"

#include <cmath>

using namespace styxTest;
using namespace Foam;
using namespace Foam::coupling;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const scalar pi = constant::mathematical::pi;

// A fluid, a force, a bandwidth and a step far below b^2/nu
const scalar rho = 1000, nu = 1e-5, F = 1e-6, b = 3e-3;
const scalar tau = b*b/4;

const meshDecay onCells(false), onFaces(true);


fluidAtPoint still(const scalar h)
{
    fluidAtPoint f;
    f.rho = rho;
    f.nu = nu;
    f.cellSize = h;
    return f;
}


//- The velocity that a body has given to the fluid at itself, along its force,
//  n steps after it began to pull with F and to move with v across it and
//  along it
scalar ownVelocity
(
    bodyWake& wake,
    const label n,
    const scalar dt,
    const vector& v,
    const scalar h,
    const scalar tauOfSpread,
    const bool faces
)
{
    fluidAtPoint f(still(h));
    wake.takeOff(f, onCells, onFaces);
    for (label i = 0; i < n; ++i)
    {
        exchangedImpulse got;
        got.J = vector(-F*dt, 0, 0);
        got.moved = dt*v;
        got.dt = dt;
        got.step = i;
        got.tau = tauOfSpread;
        got.onFaces = faces;
        wake.note(got);

        // Said again in the same step: it counts once
        wake.note(got);
    }
    f = still(h);
    wake.takeOff(f, onCells, onFaces);
    return -f.u.x();
}


//- The velocity of a steady Gaussian force in its middle, that moves with v
//  along or across itself, Oseen: an integral over the ages by many points
scalar oseen(const scalar v, const bool along)
{
    scalar sum = 0;
    const label n = 20000;
    for (label i = 0; i < n; ++i)
    {
        // 1/sqrt(t) from that of tau down to 0
        const scalar q = (i + 0.5)/n/std::sqrt(tau);
        const scalar t = 1/(q*q);
        const vector r((along ? 1 : 0), (along ? 0 : 1), 0);
        sum +=
            2/(q*q*q)/n/std::sqrt(tau)
           *bodyWake::impulsive(r*v*(t - tau)/nu, t, vector(1, 0, 0)).x();
    }
    return F/(rho*nu)*sum;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(bodyWake, impulse)
{
    // Beside its middle: no divergence, and a Stokeslet in sum over all ages
    const scalar t = 1e-6, e = 1e-6;
    const vector J(1, 0.3, -0.2), at(1e-3, -0.7e-3, 1.3e-3);
    scalar divergence = 0;
    for (direction d = 0; d < 3; ++d)
    {
        vector step = Zero;
        step[d] = e;
        divergence +=
            (
                bodyWake::impulsive(at + step, t, J)
              - bodyWake::impulsive(at - step, t, J)
            )[d]/(2*e);
    }
    figure
    (
        "bodyWake_divergence",
        std::abs(divergence)*mag(at)/mag(bodyWake::impulsive(at, t, J)),
        -noBar, 1e-6, "-", "none"
    );

    vector sum = Zero;
    const label n = 200000;
    const scalar last = 600/mag(at);
    for (label i = 0; i < n; ++i)
    {
        const scalar q = (i + 0.5)/n*last;
        sum +=
            2/(q*q*q)*last/n*bodyWake::impulsive(at, 1/(q*q), J);
    }
    const vector stokeslet =
        (J + (at & J)*at/magSqr(at))/(8*pi*mag(at));
    figure
    (
        "bodyWake_stokeslet",
        mag(sum - stokeslet)/mag(stokeslet),
        -noBar, 1e-4, "-", "closed form"
    );
}


TEST(bodyWake, ofAGaussian)
{
    // Cells far below the bandwidth
    const scalar h = 1e-5, dt = 0.02*tau/nu;
    const scalar steady = F/(3*std::pow(pi, 1.5)*rho*nu*b);
    bodyWake wake;
    const label n = 500;
    const scalar u =
        ownVelocity(wake, n, dt, vector(Zero), h, tau, true);
    const scalar started = 1 - 1/std::sqrt(1 + n*nu*dt/tau);
    figureNear
    (
        "bodyWake_started", u/steady, started, 0.005, "-",
        "closed form, 10 times b^2/4 nu after the start"
    );
    figure
    (
        "bodyWake_records", wake.nRecords(), -noBar, 60, "records",
        "of 500 steps; about ten for each factor of ten in age"
    );

    bodyWake long1;
    figureNear
    (
        "bodyWake_steady",
        ownVelocity(long1, 4000, 25*dt, vector(Zero), h, tau, true)/steady,
        1 - 1/std::sqrt(1 + 4000*25*nu*dt/tau), 0.005, "-",
        "F/(3 pi^(3/2) mu b) in long steps, 2000 times b^2/4 nu after"
    );
}


TEST(bodyWake, moving)
{
    // v b/nu from 1 to 30, along the force and across it
    scalar worst = 0;
    for (const scalar Re : {1.0, 5.0, 30.0})
    {
        for (const bool along : {true, false})
        {
            const scalar v = Re*nu/b;
            const scalar dt = 0.01*min(tau/nu, b/v);
            bodyWake wake;
            const scalar u =
                ownVelocity
                (
                    wake,
                    40000,
                    dt,
                    along ? vector(v, 0, 0) : vector(0, v, 0),
                    1e-5,
                    tau,
                    true
                );
            worst = std::max(worst, std::abs(u/oseen(v, along) - 1));
        }
    }
    figure
    (
        "bodyWake_oseen", worst, -noBar, 0.02, "-",
        "Oseen's equation, a Gaussian force that moves"
    );
}


TEST(bodyWake, onAMesh)
{
    // All in one cell: the sums over the waves of a lattice
    const scalar h = 1e-3;
    for (const bool faces : {false, true})
    {
        scalar lattice[2];
        for (const label fine : {0, 1})
        {
            const label m = fine ? 64 : 32;
            scalar sum = 0;
            for (label i = 0; i < m; ++i)
            for (label j = 0; j < m; ++j)
            for (label k = 0; k < m; ++k)
            {
                const scalar x[3] =
                    {pi*(i + 0.5)/m, pi*(j + 0.5)/m, pi*(k + 0.5)/m};
                scalar all = 0, trace = 0;
                for (const scalar y : x)
                {
                    all += 2 - 2*std::cos(y);
                }
                for (const scalar y : x)
                {
                    trace +=
                        faces
                      ? sqr(std::cos(y/2))*(1 - (2 - 2*std::cos(y))/all)
                      : 1 - sqr(std::sin(y))/all;
                }
                sum += trace/3/all;
            }
            lattice[fine] = sum/(scalar(m)*m*m);
        }

        // The wave 0 is missing: an error as the distance of the waves
        const scalar all = 2*lattice[1] - lattice[0];
        const scalar dt = 0.05*h*h/nu;
        bodyWake wake;
        const label n = 20000;
        const scalar u =
            ownVelocity(wake, n, dt, vector(Zero), h, 0, faces);
        const scalar missing = std::pow(4*pi, -1.5)*4/3/std::sqrt(n*dt*nu);
        figureNear
        (
            faces ? "bodyWake_onFaces" : "bodyWake_onCells",
            rho*nu*h/F*(u + missing*F/(rho*nu)), all, 0.01, "-",
            "sum over the waves, a force in one cell"
        );
    }
}


TEST(bodyWake, saved)
{
    bodyWake wake, other;
    ownVelocity(wake, 300, 0.01, vector(0.01, 0, 0), 1e-3, tau, true);
    DynamicList<vector> values;
    wake.save(values);
    figure
    (
        "bodyWake_saved",
        other.load(values)
     && std::abs
        (
            ownVelocity(wake, 0, 1, vector(Zero), 1e-3, tau, true)
          - ownVelocity(other, 0, 1, vector(Zero), 1e-3, tau, true)
        ) == 0,
        1, 1, "-", "what is read is what was written"
    );
    values.remove();
    EXPECT_FALSE(other.load(values));
}


// ************************************************************************* //
