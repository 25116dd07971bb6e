/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "pointForces.H"
#include "mathematicalConstants.H"
#include "SubList.H"

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

//- (1 - exp(-z))/z
Foam::scalar phi(const Foam::scalar z)
{
    return z > 0 ? -std::expm1(-z)/z : 1;
}


//- Set what body b has in a list that is empty while no body has any, as it
//  mostly is
template<class Type>
inline void keep
(
    const Foam::label b,
    const Foam::label n,
    const Type& value,
    Foam::DynamicList<Type>& list
)
{
    const Type none = Foam::pTraits<Type>::zero;
    if (list.empty())
    {
        if (value == none)
        {
            return;
        }
        list.setSize(n, none);
    }
    list[b] = value;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::coupling::dragShape Foam::coupling::pointForces::shapeSeen
(
    const label b,
    const vector& slip
)
{
    const dem::bodies& state = dem_.state();
    const scalar speed = drag_->shaped() ? mag(slip) : 0;
    if (!(speed > 0))
    {
        return dragShape();
    }

    const label i = state.shapeI[b];
    if (profiles_.size() < state.shapes().size())
    {
        profiles_.setSize(state.shapes().size());
    }
    if (!profiles_.set(i))
    {
        profiles_.set(i, new bodyProfile(state.shapeOf(b), sphericity_));
    }
    return profiles_[i].seenAlong(state.q[b].R().T() & (slip/speed));
}


inline Foam::coupling::pointForces::element
Foam::coupling::pointForces::elementOf
(
    const sampledFluid& f,
    const scalar d
) const
{
    element e;
    e.stokes = 3*constant::mathematical::pi*f.rho*f.nu*d*grains_;
    if (equations_ == averagedEquations::B && f.rho > 0)
    {
        e.stokes /= f.voidFraction;
    }
    e.ReOverSlip = f.nu > 0 ? d/f.nu : 0;
    e.voidFraction = f.rho > 0 ? f.voidFraction : 1;
    return e;
}


void Foam::coupling::pointForces::noteRange
(
    const label b,
    const element& e,
    const scalar Re
)
{
    OStringStream os;
    os  << "    The law of drag " << drag_->type()
        << " is used outside of its range, by body "
        << dem_.state().id[b] << " first: Re " << Re
        << ", void fraction " << e.voidFraction << ";" << nl
        << "    it was made for Re up to " << range_.Re
        << " and void fractions from " << range_.least << " to "
        << range_.largest << ". It is used as it is." << nl;
    outside_ = os.str();
}


void Foam::coupling::pointForces::sayRange()
{
    // Once, whichever rank has the body
    const dem::rankGroup& group = dem_.group();
    if (!saidRange_ && drag_.valid() && group.any(outside_.size()))
    {
        saidRange_ = true;
        Info<< group.first(outside_).c_str() << flush;
    }
}


inline void Foam::coupling::pointForces::noteRe
(
    const label b,
    const element& e,
    const scalar slip
)
{
    const scalar Re = e.ReOverSlip*slip;
    largestRe_ = max(largestRe_, Re);
    if
    (
        !saidRange_
     && outside_.empty()
     && drag_.valid()
     && e.stokes > 0
     && !range_.hold(Re, e.voidFraction)
    )
    {
        noteRange(b, e, Re);
    }
}


void Foam::coupling::pointForces::setDrag
(
    const label b,
    const UList<sampledFluid>& atElements
)
{
    const dem::bodies& state = dem_.state();
    const dem::shape& s = state.shapeOf(b);

    scalar weight = 0;
    vector mean = Zero;
    forAll(atElements, k)
    {
        const sampledFluid& f = atElements[k];
        const bool whole = atElements.size() == 1;
        const scalar d =
            grainWidth_*(whole ? s.equivalentDiameter() : 2*s.radii()[k]);

        elements_[first_[b] + k] = elementOf(f, d);
        const scalar stokes = elements_[first_[b] + k].stokes;
        if (!drag_.valid())
        {
            continue;
        }
        if (shapeSeen_.size())
        {
            shapeSeen_[first_[b] + k] =
                whole ? shapeSeen(b, f.u - state.v[b]) : dragShape();
        }
        if (!whole)
        {
            const vector arm =
                state.sphereX()[state.firstSphere[b] + k] - state.x[b];
            const vector u = f.u - (state.omega[b] ^ arm);
            const scalar K =
                stokes*factorOf(first_[b] + k, mag(u - state.v[b]));
            weight += K;
            mean += K*u;
        }
    }

    // The spheres of a clump together pull it towards the mean of theirs
    if (weight > 0)
    {
        fluidVelocity_[b] = mean/weight;
    }
}


Foam::vector Foam::coupling::pointForces::meanTorque
(
    const label b,
    const pointSum& sum,
    const vector& omegaFluid,
    const UList<sampledFluid>& atElements,
    const scalar dt
) const
{
    const dem::bodies& state = dem_.state();
    const vector& omega = state.omega[b];

    // Torque at the velocity that the body has, and what it falls by as that
    // grows
    vector T = sum.torque + sum.spin*(omegaFluid - omega);
    if (state.shapeOf(b).isSphere())
    {
        // Exact: I omega' = T - C omega
        const scalar I = state.inertia(b).x();
        return phi(sum.spin*dt/I)*T;
    }

    tensor D = sum.spin*tensor::I;
    if (drag_.valid() && atElements.size() > 1)
    {
        forAll(atElements, k)
        {
            const label i = first_[b] + k;
            const vector r =
                state.sphereX()[state.firstSphere[b] + k] - state.x[b];
            const vector slip =
                atElements[k].u - state.v[b] - (omega ^ r);
            const scalar K = elements_[i].stokes*factorOf(i, mag(slip));
            T += r ^ (K*slip);
            D += K*(magSqr(r)*tensor::I - r*r);
        }
    }

    // Backward Euler: (J + dt D) (omega1 - omega) = dt T
    const tensor J = state.inertiaTensor(b);
    return (J & (inv(J + dt*D) & T));
}


inline void Foam::coupling::pointForces::turn
(
    const label b,
    const pointSum& sum,
    const fluidAtPoint& fluid,
    const UList<sampledFluid>& atElements,
    const scalar dt
)
{
    // Nothing is written where there was nothing and is nothing
    const bool turns =
        sum.spin > 0 || sum.torque != vector(Zero) || sumOfSpheres_;
    turns_ = turns_ || turns;
    if (turns)
    {
        dem_.state().fluidTorque[b] =
            meanTorque(b, sum, 0.5*fluid.curlU, atElements, dt);
    }
    else if (turned_)
    {
        dem_.state().fluidTorque[b] = Zero;
    }
}


void Foam::coupling::pointForces::followBody(const label b)
{
    const dem::bodies& state = dem_.state();
    const scalar slip = mag(fluidVelocity_[b] - state.v[b]);
    for (label i = first_[b]; i < first_[b + 1]; ++i)
    {
        noteRe(b, elements_[i], slip);
    }
    if (!followsBody_)
    {
        return;
    }
    expand
    (
        b,
        fluidVelocity_[b],
        massShare(b),
        slip,
        rate(b, slip),
        rate(b, (1 - width)*slip),
        rate(b, (1 + width)*slip)
    );
}


void Foam::coupling::pointForces::act
(
    const label b,
    const pointSum& sum,
    const fluidAtPoint& fluid,
    UList<sampledFluid>& atElements,
    const scalar dt
)
{
    dem::bodies& state = dem_.state();

    // What forces have changed of the velocity, the spheres of a clump see, too
    const vector change = fluid.u - sampler_->fluid()[b].u;
    if (change != vector(Zero))
    {
        for (sampledFluid& f : atElements)
        {
            f.u += change;
        }
    }

    keep(b, state.size(), sum.addedMass, addedMass_);
    keep(b, state.size(), sum.force, lost_);
    fluidVelocity_[b] = fluid.u;
    setDrag(b, atElements);
    followBody(b);
    if (kinds_.resolved(b))
    {
        return;
    }
    state.fluidForce[b] = sum.force + sum.undisturbed;
    turn(b, sum, fluid, atElements, dt);
}


void Foam::coupling::pointForces::actOnPoints
(
    const label first,
    const label n,
    const scalar dt
)
{
    dem::bodies& state = dem_.state();
    slip_.setSize(n);
    Re_.setSize(n);
    alpha_.setSize(n);
    law_.setSize(n);
    for (label i = 0; i < n; ++i)
    {
        const label b = first + i;
        const element e(elementOf(seen_[i], block_[i].d));

        // Number by number: g++ would copy it by halves that were stored as
        // numbers just before, and wait for these
        element& kept = elements_[b];
        kept.stokes = e.stokes;
        kept.ReOverSlip = e.ReOverSlip;
        kept.voidFraction = e.voidFraction;
        fluidVelocity_[b] = seen_[i].u;
        slip_[i] = mag(seen_[i].u - block_[i].v);
        Re_[i] = e.ReOverSlip*slip_[i];
        alpha_[i] = e.voidFraction;
    }
    drag_->factors(width, Re_, alpha_, law_);

    SubList<sampledFluid> own(sampler_->fluid(), n, first);
    for (label i = 0; i < n; ++i)
    {
        const label b = first + i;
        const pointSum& sum = sums_[i];
        keep(b, state.size(), sum.addedMass, addedMass_);
        keep(b, state.size(), sum.force, lost_);
        noteRe(b, elements_[b], slip_[i]);
        const scalar perSlip = max(elements_[b].stokes, scalar(0))/inertiaOf(b);
        const dragLaw::triple& f = law_[i];
        expand
        (
            b,
            seen_[i].u,
            addedMass_.empty() ? 1 : massShare(b),
            slip_[i],
            perSlip*f[0],
            perSlip*f[1],
            perSlip*f[2]
        );
        state.fluidForce[b] = sum.force + sum.undisturbed;
        turn(b, sum, seen_[i], SubList<sampledFluid>(own, 1, i), dt);
    }
}


// ************************************************************************* //
