/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "implicitForcing.H"
#include "rankSum.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::coupling::implicitForcing::startImposed(const volVectorField& U)
{
    const dem::bodies& state = dem_.state();

    List<vector> momentum(state.size(), vector(Zero));
    List<scalar> volume(state.size(), scalar(0));
    bool anyNew = false;

    forAll(cells_, b)
    {
        if (imposed0_.found(state.id[b]))
        {
            continue;
        }
        anyNew = true;
        for (const bodyCell& bc : cells_[b])
        {
            const scalar V = bc.beta*mesh_.V()[bc.cell];
            volume[b] += V;
            momentum[b] += V*U[bc.cell];
        }
    }

    if (!anyNew)
    {
        return;
    }

    // The fluid that a body finds where it enters has its own momentum, and
    // that is not the body's to pay for
    dem::sumOverRanks(momentum);
    dem::sumOverRanks(volume);
    forAll(cells_, b)
    {
        if (!imposed0_.found(state.id[b]))
        {
            imposed0_.insert
            (
                state.id[b],
                imposedMotion
                {
                    momentum[b]/max(volume[b], VSMALL),
                    Zero
                }
            );
        }
    }
}


void Foam::coupling::implicitForcing::move(const label b)
{
    dem::bodies& state = dem_.state();
    const dem::shape& s = state.shapeOf(b);
    const imposedMotion& old = imposed0_[state.id[b]];
    const imposedMotion& now = imposed_[b];
    const scalar dt = mesh_.time().deltaTValue();
    const scalar C = virtualMass_;
    const vector& g = dem_.g();

    // Translation
    const scalar m = state.mass[b];
    const scalar mf = rho_*s.unionVolume();
    const vector& F0 = state.fluidForce[b];

    // What contacts did: all of the change that the held forces did not make
    const vector J = m*(now.v - v0_[b]) - dt*(m*g + F0);

    const vector v =
        v0_[b]
      + (
            dt*force_[b]
          + (1 + C)*mf*(now.v - old.v)
          + dt*(m - rho_*s.volume())*g
          + J
        )/(m + C*mf);

    // Rotation: the inertia of the fluid inside is that of the body, scaled
    const scalar ratio = rho_*s.volume()/m;
    const tensor I = state.inertiaTensor(b);
    const vector Lnow = I & now.omega;
    const vector JL = Lnow - L0_[b] - dt*state.fluidTorque[b];

    const vector L =
        (
            L0_[b]
          + C*ratio*(I & omega0_[b])
          + dt*torque_[b]
          + (1 + C)*ratio*(I & (now.omega - old.omega))
          + JL
        )/(1 + C*ratio);

    // The force to hold in the next step, without the fluid's answer to the
    // contacts of this one, which will not come again
    newForce_[b] =
        (m*(v - v0_[b]) - J)/dt - m*g + (C*mf/(m + C*mf))*J/dt;
    newTorque_[b] =
        (L - L0_[b] - JL)/dt + (C*ratio/(1 + C*ratio))*JL/dt;

    state.v[b] = v;
    state.L[b] = L;
    state.omega[b] = state.omegaFrom(b, L);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::coupling::implicitForcing::store()
{
    const dem::bodies& state = dem_.state();
    v0_ = state.v;
    L0_ = state.L;
    omega0_ = state.omega;
}


void Foam::coupling::implicitForcing::correctMotion()
{
    const dem::bodies& state = dem_.state();
    newForce_.setSize(state.size());
    newTorque_.setSize(state.size());

    slip_ = 0;
    forAll(cells_, b)
    {
        move(b);
        slip_ = max(slip_, mag(state.v[b] - imposed_[b].v));
    }
}


Foam::coupling::implicitForcing::carried
Foam::coupling::implicitForcing::carriedOf(const label b) const
{
    const dem::bodies& state = dem_.state();
    carried c{{state.v[b], state.omega[b]}, Zero, Zero};
    c.force = state.fluidForce[b];
    c.torque = state.fluidTorque[b];

    if (open_)
    {
        c.imposed = imposed_[b];
        if (newForce_.size())
        {
            c.force = newForce_[b];
            c.torque = newTorque_[b];
        }
    }
    else if (imposed0_.found(state.id[b]))
    {
        c.imposed = imposed0_[state.id[b]];
    }
    return c;
}


void Foam::coupling::implicitForcing::setCarried
(
    const label b,
    const carried& c
)
{
    dem::bodies& state = dem_.state();
    imposed0_.set(state.id[b], c.imposed);
    state.fluidForce[b] = c.force;
    state.fluidTorque[b] = c.torque;
}


void Foam::coupling::implicitForcing::finish()
{
    if (!open_)
    {
        return;
    }

    // Only of the bodies that are still there
    imposed0_.clear();
    forAll(cells_, b)
    {
        setCarried(b, carriedOf(b));
    }
    open_ = false;
}


// ************************************************************************* //
