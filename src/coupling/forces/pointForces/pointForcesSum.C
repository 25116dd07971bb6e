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
#include "volFields.H"

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

//- (1 - exp(-z))/z
Foam::scalar phi(const Foam::scalar z)
{
    return z > 0 ? -std::expm1(-z)/z : 1;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::coupling::pointForces::findElements()
{
    const dem::bodies& state = dem_.state();

    points_ = state.x;
    cellOf_ = cells_.find(state);
    first_.setSize(state.size() + 1);
    first_[0] = 0;
    forAll(state.x, b)
    {
        const label n = sumOfSpheres_ ? state.shapeOf(b).radii().size() : 1;
        if (n > 1)
        {
            for (label s = state.firstSphere[b]; s < state.firstSphere[b + 1];)
            {
                points_.append(state.sphereX[s]);
                cellOf_.append(bins_.find(state.sphereX[s++], cellOf_[b]));
            }
        }
        first_[b + 1] = first_[b] + n;
    }
}


void Foam::coupling::pointForces::leaveOutResolved()
{
    // As points they are in no fluid
    label next = dem_.state().size();
    for (label b = 0; kinds_.mixed() && b < dem_.state().size(); ++b)
    {
        const label n = first_[b + 1] - first_[b];
        const label nOwn = n == 1 ? 0 : n;
        if (kinds_.resolved(b))
        {
            UList<sampledFluid>& fluid = sampler_->fluid();
            fluid[b] = sampledFluid();
            SubList<sampledFluid>(fluid, nOwn, next) = sampledFluid();
        }
        next += nOwn;
    }
}


Foam::coupling::pointBody Foam::coupling::pointForces::bodyOf
(
    const label b,
    const scalar dt
) const
{
    const dem::bodies& state = dem_.state();
    const dem::shape& s = state.shapeOf(b);
    return pointBody
    {
        state.id[b],
        grainWidth_*s.equivalentDiameter(),
        s.volume()/grains_,
        state.v[b],
        state.omega[b],
        mesh_.time().value() - mesh_.time().deltaTValue(),
        dt
    };
}


void Foam::coupling::pointForces::countGrains(pointSum& sum) const
{
    // A body's moment of inertia is that of so many grains, each at a distance
    // that is larger as their widths are: it turns as one of them does if the
    // torque is as much larger
    const scalar turning = grains_/sqr(grainWidth_);
    sum.force *= grains_;
    sum.undisturbed *= grains_;
    sum.addedMass *= grains_;
    sum.torque *= turning;
    sum.spin *= turning;
}


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

        element& e = elements_[first_[b] + k];
        e.stokes = 3*constant::mathematical::pi*f.rho*f.nu*d*grains_;
        if (equations_ == averagedEquations::B && f.rho > 0)
        {
            e.stokes /= f.voidFraction;
        }
        e.ReOverSlip = f.nu > 0 ? d/f.nu : 0;
        e.voidFraction = f.rho > 0 ? f.voidFraction : 1;
        if (!drag_.valid())
        {
            continue;
        }
        e.shape = whole ? shapeSeen(b, f.u - state.v[b]) : dragShape();
        if (!whole)
        {
            const vector arm =
                state.sphereX[state.firstSphere[b] + k] - state.x[b];
            const vector u = f.u - (state.omega[b] ^ arm);
            const scalar K = e.stokes*factorOf(e, mag(u - state.v[b]));
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

    if (!(sum.spin > 0) && sum.torque == vector(Zero) && !sumOfSpheres_)
    {
        return Zero;
    }

    // Torque at the velocity that the body has, and what it falls by as that
    // grows
    vector T = sum.torque + sum.spin*(omegaFluid - omega);
    if (state.shapeOf(b).isSphere())
    {
        // Exact: I omega' = T - C omega
        const scalar I = state.inertia[b].x();
        return phi(sum.spin*dt/I)*T;
    }

    tensor D = sum.spin*tensor::I;
    if (drag_.valid() && atElements.size() > 1)
    {
        forAll(atElements, k)
        {
            const element& e = elements_[first_[b] + k];
            const vector r =
                state.sphereX[state.firstSphere[b] + k] - state.x[b];
            const vector slip =
                atElements[k].u - state.v[b] - (omega ^ r);
            const scalar K = e.stokes*factorOf(e, mag(slip));
            T += r ^ (K*slip);
            D += K*(magSqr(r)*tensor::I - r*r);
        }
    }

    // Backward Euler: (J + dt D) (omega1 - omega) = dt T
    const tensor J = state.inertiaTensor(b);
    return (J & (inv(J + dt*D) & T));
}


void Foam::coupling::pointForces::sumForces
(
    const label first,
    const label n,
    const scalar dt
)
{
    block_.setSize(n);
    seen_.setSize(n);
    sums_.setSize(n);
    for (label i = 0; i < n; ++i)
    {
        block_[i] = bodyOf(first + i, dt);
        sampler_->get(first + i, seen_[i]);
        sums_[i] = pointSum();
    }
    times_.pass();

    // Force by force, so that the time of each is known
    for (pointForce& f : forces_)
    {
        for (label i = 0; f.remembers() && i < n; ++i)
        {
            if (seen_[i].rho > 0)
            {
                f.note(block_[i], seen_[i]);
            }
        }
        if (f.remembers())
        {
            times_.lap("force " + f.type());
        }
    }
    for (const pointForce& f : forces_)
    {
        for (label i = 0; i < n; ++i)
        {
            if (seen_[i].rho > 0)
            {
                f.add(block_[i], seen_[i], sums_[i]);
            }
        }
        times_.lap("force " + f.type());
    }
    for (label i = 0; grains_ != 1 && i < n; ++i)
    {
        countGrains(sums_[i]);
    }
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
    for (sampledFluid& f : atElements)
    {
        f.u += change;
    }

    inertia_[b] = state.mass[b] + sum.addedMass;
    exchanged_[b] = sum.force;
    fluidVelocity_[b] = fluid.u;
    setDrag(b, atElements);
    followBody(b);
    if (kinds_.resolved(b))
    {
        return;
    }
    state.fluidForce[b] = sum.force + sum.undisturbed;
    state.fluidTorque[b] =
        meanTorque(b, sum, 0.5*fluid.curlU, atElements, dt);
}


void Foam::coupling::pointForces::checkRange(const label b, const scalar slip)
{
    const dem::bodies& state = dem_.state();
    const dragLaw::limits range(drag_->range());
    for (label i = first_[b]; !warned_ && i < first_[b + 1]; ++i)
    {
        const element& e = elements_[i];
        const scalar Re = e.ReOverSlip*slip;
        if (e.stokes > 0 && !range.hold(Re, e.voidFraction))
        {
            warned_ = true;
            Info<< "    The law of drag " << drag_->type()
                << " is used outside of its range, by body "
                << state.id[b] << " first: Re " << Re
                << ", void fraction " << e.voidFraction << ";" << nl
                << "    it was made for Re up to " << range.Re
                << " and void fractions from " << range.least << " to "
                << range.largest << ". It is used as it is." << endl;
        }
    }
}


void Foam::coupling::pointForces::followBody(const label b)
{
    const dem::bodies& state = dem_.state();
    const vector& u = fluidVelocity_[b];
    const scalar slip = mag(u - state.v[b]);
    for (label i = first_[b]; i < first_[b + 1]; ++i)
    {
        largestRe_ = max(largestRe_, elements_[i].ReOverSlip*slip);
    }
    if (!warned_ && drag_.valid())
    {
        checkRange(b, slip);
    }
    if (!followsBody_)
    {
        return;
    }

    const scalar share = state.mass[b]/inertia_[b];
    if (first_[b + 1] - first_[b] > 1 || !drag_.valid())
    {
        const auto rateOf = [&](const scalar s) { return rate(b, s); };
        expand(b, u, share, slip, rateOf);
        return;
    }
    const element& e = elements_[first_[b]];
    const scalar perSlip = max(e.stokes, scalar(0))/inertia_[b];
    const auto rateOf = [&](const scalar s) { return perSlip*factorOf(e, s); };
    expand(b, u, share, slip, rateOf);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::coupling::pointForces::sample
(
    const volVectorField& U,
    const volScalarField* alpha,
    const averagedEquations equations
)
{
    equations_ = equations;
    const scalar dt = steps_*mesh_.time().deltaTValue();
    dem::bodies& state = dem_.state();
    const label n = state.size();

    times_.start();
    findElements();
    times_.lap("locating");
    sampler_->sample(points_, cellOf_, U, alpha);
    leaveOutResolved();
    times_.lap("sampling of the fluid");

    elements_.setSize(first_[n]);
    fluidVelocity_.setSize(n);
    inertia_.setSize(n);
    exchanged_.setSize(n);
    sampled_.setSize(watched_ ? n : 0);
    startExpansion(followsBody_ ? n : 0);
    largestRe_ = 0;

    // A clump's spheres follow the centres of mass. Blocks of bodies stay in
    // the cache from force to force
    label next = n;
    const label blockSize = 512;
    for (label first = 0; first < n; first += blockSize)
    {
        const label size = min(blockSize, n - first);
        sumForces(first, size, dt);
        for (label b = first; b < first + size; ++b)
        {
            const label nElements = first_[b + 1] - first_[b];
            const bool whole = nElements == 1;
            SubList<sampledFluid> own
            (
                sampler_->fluid(),
                nElements,
                whole ? b : next
            );
            act(b, sums_[b - first], seen_[b - first], own, dt);
            next += whole ? 0 : nElements;
        }
        if (watched_)
        {
            SubList<fluidAtPoint>(sampled_, size, first) = seen_;
        }
        times_.lap("drag");
    }

    for (pointForce& f : forces_)
    {
        if (f.remembers())
        {
            f.keepOnly(labelHashSet(state.id));
        }
    }
    state.drag = followsBody_ ? this : nullptr;
}


// ************************************************************************* //
