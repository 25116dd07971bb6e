/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "stormerVerlet.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(stormerVerlet, 0);
    addToRunTimeSelectionTable(integrator, stormerVerlet, word);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::stormerVerlet::turn
(
    quaternion& q,
    const vector& L,
    const vector& inertia,
    const scalar dt
)
{
    // Angular momentum in the principal frame, which the turns change
    vector Lb = q.invTransform(L);

    const auto about = [&](const direction k, const scalar time)
    {
        const scalar angle = time*Lb[k]/inertia[k];
        const scalar c = cos(angle);
        const scalar s = sin(angle);
        const direction m = (k + 1) % 3;
        const direction n = (k + 2) % 3;

        const scalar Lm = Lb[m];
        Lb[m] = c*Lm + s*Lb[n];
        Lb[n] = c*Lb[n] - s*Lm;

        vector axis(Zero);
        axis[k] = sin(0.5*angle);
        q *= quaternion(cos(0.5*angle), axis);
    };

    about(2, 0.5*dt);
    about(1, 0.5*dt);
    about(0, dt);
    about(1, 0.5*dt);
    about(2, 0.5*dt);

    q = unit(q);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::stormerVerlet::step
(
    bodies& state,
    const scalar t,
    const scalar dt,
    const forces& force
) const
{
    const scalar h = 0.5*dt;

    forAll(state.x, b)
    {
        // First half kick
        const vector turnKick = h*state.torque[b];
        state.vHalf[b] = state.v[b] + state.kick(b, state.v[b], h);
        state.L[b] += turnKick;

        // Drift
        state.x[b] += dt*state.vHalf[b];
        if (!state.shapeOf(b).isSphere())
        {
            turn(state.q[b], state.L[b], state.inertia[b], dt);
        }
        state.updateSpheres(b);

        // Velocities that the forces at the new time see
        state.omegaHalf[b] = state.omegaFrom(b, state.L[b]);
        state.v[b] = state.vHalf[b] + state.kick(b, state.vHalf[b], h);
        state.omega[b] = state.omegaFrom(b, state.L[b] + turnKick);
    }

    force(t + dt, dt);

    // Second half kick
    forAll(state.x, b)
    {
        state.v[b] = state.vHalf[b] + state.kick(b, state.vHalf[b], h);
        state.L[b] += h*state.torque[b];
        state.omega[b] = state.omegaFrom(b, state.L[b]);
    }
}


// ************************************************************************* //
