/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "immersedMethod.H"
#include "rankSum.H"

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

// Added mass of a sphere that leaves a wall over that far away
const Foam::scalar atWall = 1.606;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::coupling::immersedMethod::findDisplaced()
{
    const dem::bodies& state = dem_.state();
    displaced_.setSize(state.size());

    if (!rho_.isField())
    {
        forAll(displaced_, b)
        {
            const dem::shape& s = state.shapeOf(b);
            const scalar rho = rho_.uniform();
            displaced_[b] =
                displacedFluid
                {
                    rho*s.fluidVolume(),
                    rho*s.volume(),
                    rho*s.fluidVolume(),
                    Zero
                };
        }
        return;
    }

    List<scalar> mass(state.size(), scalar(0));
    List<scalar> densest(state.size(), scalar(0));
    List<vector> moment(state.size(), vector(Zero));
    forAll(cells_, b)
    {
        for (const bodyCell& bc : cells_[b])
        {
            const scalar m = bc.beta*bc.rho*mesh_.V()[bc.cell];
            mass[b] += m;
            moment[b] += m*bc.r;
            if (bc.beta < 1)
            {
                densest[b] = max(densest[b], bc.rho);
            }
        }
    }
    dem::sumOverRanks(mass);
    dem::maxOverRanks(densest);
    dem::sumOverRanks(moment);
    forAll(displaced_, b)
    {
        displaced_[b] =
            displacedFluid
            {
                mass[b],
                mass[b],
                densest[b]*state.shapeOf(b).fluidVolume(),
                moment[b]
            };
    }
}


const Foam::coupling::addedMass&
Foam::coupling::immersedMethod::addedOf(const label b)
{
    const dem::shape& s = dem_.state().shapeOf(b);
    if (!added_.found(s.name()))
    {
        added_.insert
        (
            s.name(),
            addedMass(s.volume(), s.inertiaPerDensity())
        );
    }
    return added_[s.name()];
}


void Foam::coupling::immersedMethod::move(const label b)
{
    dem::bodies& state = dem_.state();
    const imposedMotion& old = imposed0_[state.id[b]];
    const imposedMotion& now = imposed_[b];
    const scalar dt = mesh_.time().deltaTValue();
    const vector& g = dem_.g();
    const displacedFluid& fluid = displaced_[b];
    const tensor R = state.q[b].R();
    const auto inSpace = [&R](const vector& d)
    {
        return R & tensor(d.x(), 0, 0, 0, d.y(), 0, 0, 0, d.z()) & R.T();
    };

    // What contacts did: all of the change that the held forces did not make
    // when the bodies advanced
    const scalar m = state.mass[b];
    const vector& F0 = state.fluidForce[b];
    const tensor I = state.inertiaTensor(b);
    const imposedMotion& first = repeat_.valid() ? repeat_->first(b) : now;
    const scalar share = along_.massShare(b);
    const vector J = (m*(first.v - v0_[b]) - dt*(m*g + F0))/share;
    const vector JL = (I & first.omega) - L0_[b] - dt*state.fluidTorque[b];
    contactForce_[b] = J/dt;
    contactTorque_[b] = JL/dt;
    if (starts_[b])
    {
        // The flow around it comes into being in this step; that is not the
        // body's to pay for, and the force to start with holds on
        newForce_[b] = F0;
        newTorque_[b] = state.fluidTorque[b];
        return;
    }

    // Translation
    const scalar mf = fluid.mass;
    const addedMass& added = addedOf(b);
    const scalar nuDt = viscosity_[b]*dt;
    const scalar counted = virtualMass_*fluid.around;
    const tensor Ap = inSpace(counted*added.mass());
    const tensor Af = inSpace(counted*added.frictionMass(nuDt));
    const tensor passing = inSpace(counted*added.passingMass(nuDt));
    const tensor A = Ap + Af;
    const tensor inverse = inv(m*tensor::I + A);
    const vector dv = now.v - old.v;
    const vector dOmega = now.omega - old.omega;

    const vector v =
        v0_[b]
      + (
            inverse
          & (
                dt*force_[b]
              + (dOmega ^ fluid.moment)
              + mf*dv + (Ap & dv)
              + (Af & (now.v - v0_[b])) + (passing & (v0_[b] - old.v))
              + dt*(m - fluid.buoyant)*g
              + J
            )
        );

    // Rotation: the inertia of the fluid inside is that of the body, scaled.
    // The viscous layer is part of what turns with it
    const vector T = torque_[b] + (fluid.moment ^ (dv/dt - g));
    const tensor Bp = inSpace
    (
        fluid.around/m*(0.5*vector::one + virtualMass_*added.inertia())
    );
    const tensor Bf = inSpace(counted/m*added.frictionInertia(nuDt));
    const tensor passingB = inSpace(counted/m*added.passingInertia(nuDt));
    const tensor B = Bp + Bf;
    const tensor inverseB = inv(tensor::I + B);
    const vector dL = I & dOmega;

    const vector L =
        inverseB
      & (
            L0_[b]
          + (Bp & ((I & omega0_[b]) + dL)) + (Bf & (I & now.omega))
          + (passingB & (I & (omega0_[b] - old.omega)))
          + dt*T
          + fluid.buoyant/m*dL
          + JL
        );

    // The force to hold in the next step, without the fluid's answer to the
    // contacts of this one, which will not come again
    const vector answer = share < 1 ? (1 - share)*J : A & (inverse & J);
    newForce_[b] = (m*(v - v0_[b]) - J + answer)/dt - m*g;
    newTorque_[b] =
        (L - L0_[b] - JL)/dt + (B & (inverseB & JL))/dt;

    state.v[b] = v;
    state.setL(b, L);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::coupling::immersedMethod::startForce
(
    const label b,
    const bool twoWay
)
{
    const dem::bodies& state = dem_.state();
    const scalar m = state.mass[b];

    scalar mf = 0;
    scalar around = 0;
    if (rho_.isField())
    {
        cells_.setSize(max(cells_.size(), b + 1));
        findCells(b);
        for (const bodyCell& bc : cells_[b])
        {
            mf += bc.beta*bc.rho*mesh_.V()[bc.cell];
            around = max(around, bc.rho);
        }
        reduce(mf, sumOp<scalar>());
        reduce(around, maxOp<scalar>());
        around *= state.shapeOf(b).fluidVolume();
    }
    else
    {
        mf = around = rho_.uniform()*state.shapeOf(b).volume();
    }

    // The acceleration along each principal axis, and what it takes
    const vector added = (twoWay ? around : 0)*addedOf(b).mass();
    const tensor R = state.q[b].R();
    const vector a =
        cmptDivide((m - mf)*(R.T() & dem_.g()), m*vector::one + added);
    return m*((R & a) - dem_.g());
}


void Foam::coupling::immersedMethod::store()
{
    const dem::bodies& state = dem_.state();
    v0_ = state.v;
    L0_.setSize(state.size());
    forAll(L0_, b)
    {
        L0_[b] = state.L(b);
    }
    omega0_ = state.omega;
}


void Foam::coupling::immersedMethod::takeAlong()
{
    dem::bodies& state = dem_.state();
    if (state.drag || rho_.isField())
    {
        // Bodies that are points to the fluid have their own way, and where
        // the density changes it is not known what is taken along
        return;
    }
    along_.start(state.size());
    held_ = state.fluidForce.list();
    forAll(held_, b)
    {
        if (kinds_.resolved(b))
        {
            // Along the way that it goes
            const vector& C = addedOf(b).mass();
            const vector e = state.q[b].R().T() & state.v[b];
            const scalar part =
                magSqr(e) > 0
              ? (C & vector(cmptMultiply(e, e)))/magSqr(e)
              : (C.x() + C.y() + C.z())/3;
            along_.set
            (
                b,
                state.mass[b],
                atWall*part*rho_.uniform()*state.shapeOf(b).fluidVolume()
            );
            const vector weight = state.mass[b]*dem_.g();
            state.fluidForce[b] =
                (held_[b] + weight)/along_.massShare(b) - weight;
        }
    }
    state.drag = &along_;
}


void Foam::coupling::immersedMethod::letGo()
{
    dem::bodies& state = dem_.state();
    if (state.drag == &along_)
    {
        state.drag = nullptr;
        forAll(held_, b)
        {
            state.fluidForce[b] = held_[b];
        }
    }
}


void Foam::coupling::immersedMethod::correctMotion()
{
    const dem::bodies& state = dem_.state();
    findDisplaced();
    newForce_.setSize(state.size());
    newTorque_.setSize(state.size());
    contactForce_.setSize(state.size());
    contactTorque_.setSize(state.size());

    slip_ = 0;
    forAll(state.x, b)
    {
        if (kinds_.resolved(b))
        {
            move(b);
            slip_ = max(slip_, mag(state.v[b] - imposed_[b].v));
        }
    }
    slip_ = dem_.group().max(slip_);
}


bool Foam::coupling::immersedMethod::acts(const label b) const
{
    return kinds_.resolved(b);
}


const Foam::vector&
Foam::coupling::immersedMethod::force(const label b) const
{
    return force_[b];
}


const Foam::vector&
Foam::coupling::immersedMethod::torque(const label b) const
{
    return torque_[b];
}


Foam::vector Foam::coupling::immersedMethod::contactForce(const label b) const
{
    return contactForce_.empty() ? vector(Zero) : contactForce_[b];
}


Foam::vector Foam::coupling::immersedMethod::contactTorque(const label b) const
{
    return contactTorque_.empty() ? vector(Zero) : contactTorque_[b];
}


Foam::vector Foam::coupling::immersedMethod::fluidForce(const label b) const
{
    if (contactForce_.empty())
    {
        return force_[b];
    }
    const dem::bodies& state = dem_.state();
    return
        state.mass[b]
       *((state.v[b] - v0_[b])/mesh_.time().deltaTValue() - dem_.g())
      - contactForce_[b];
}


Foam::vector Foam::coupling::immersedMethod::fluidTorque(const label b) const
{
    if (contactTorque_.empty())
    {
        return torque_[b];
    }
    return
        (dem_.state().L(b) - L0_[b])/mesh_.time().deltaTValue()
      - contactTorque_[b];
}


// ************************************************************************* //
