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

Foam::pointField Foam::coupling::pointForces::elementPoints
(
    labelList& cellOf
)
{
    const dem::bodies& state = dem_.state();

    DynamicList<point> points;
    points.append(state.x);
    DynamicList<label> cells;
    cells.append(cells_.find(state));

    first_.setSize(state.size() + 1);
    first_[0] = 0;
    forAll(state.x, b)
    {
        const label n = sumOfSpheres_ ? state.shapeOf(b).radii().size() : 1;
        if (n > 1)
        {
            for (label s = state.firstSphere[b]; s < state.firstSphere[b + 1];)
            {
                points.append(state.sphereX[s]);
                cells.append(bins_.find(state.sphereX[s++], cells[b]));
            }
        }
        first_[b + 1] = first_[b] + n;
    }
    cellOf.transfer(cells);
    return pointField(std::move(points));
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
    const scalar speed = mag(slip);
    if (!drag_->shaped() || !(speed > 0))
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
    const fluidAtPoint& fluid,
    const UList<fluidAtPoint>& atElements
)
{
    const dem::bodies& state = dem_.state();
    const dem::shape& s = state.shapeOf(b);

    fluidVelocity_[b] = fluid.u;
    scalar weight = 0;
    vector mean = Zero;
    forAll(atElements, k)
    {
        const fluidAtPoint& f = atElements[k];
        const bool whole = atElements.size() == 1;
        const scalar d =
            grainWidth_*(whole ? s.equivalentDiameter() : 2*s.radii()[k]);

        element& e = elements_[first_[b] + k];
        e.stokes = 3*constant::mathematical::pi*f.rho*f.nu*d*grains_;
        if (equations_ == averagedEquations::B && f.rho > 0)
        {
            e.stokes /= f.voidFraction;
        }
        e.ReOverSlip = d/max(f.nu, VSMALL);
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
    const UList<fluidAtPoint>& atElements,
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


Foam::List<Foam::coupling::pointSum>
Foam::coupling::pointForces::sumForces
(
    List<fluidAtPoint>& fluid,
    List<vector>& change,
    const scalar dt
)
{
    const label n = dem_.state().size();
    DynamicList<pointBody> bodies(n);
    change.setSize(n);
    for (label b = 0; b < n; ++b)
    {
        bodies.append(bodyOf(b, dt));
        change[b] = fluid[b].u;
    }

    // Force by force, so that the time of each is known
    for (pointForce& f : forces_)
    {
        for (label b = 0; b < n; ++b)
        {
            if (fluid[b].rho > 0)
            {
                f.note(bodies[b], fluid[b]);
            }
        }
        times_.lap("force " + f.type());
    }
    List<pointSum> sums(n);
    for (const pointForce& f : forces_)
    {
        for (label b = 0; b < n; ++b)
        {
            if (fluid[b].rho > 0)
            {
                f.add(bodies[b], fluid[b], sums[b]);
            }
        }
        times_.lap("force " + f.type());
    }
    for (label b = 0; b < n; ++b)
    {
        change[b] = fluid[b].u - change[b];
        if (grains_ != 1)
        {
            countGrains(sums[b]);
        }
    }
    return sums;
}


void Foam::coupling::pointForces::act
(
    const label b,
    const pointSum& sum,
    const vector& change,
    const fluidAtPoint& fluid,
    UList<fluidAtPoint>& atElements,
    const scalar dt
)
{
    dem::bodies& state = dem_.state();

    // The spheres of a clump see the same change; a single one is fluid itself
    if (fluid.rho > 0 && atElements.size() > 1)
    {
        for (fluidAtPoint& f : atElements)
        {
            f.u += change;
        }
    }

    inertia_[b] = state.mass[b] + sum.addedMass;
    exchanged_[b] = sum.force;
    setDrag(b, fluid, atElements);
    state.fluidForce[b] = sum.force + sum.undisturbed;
    state.fluidTorque[b] =
        meanTorque(b, sum, 0.5*fluid.curlU, atElements, dt);
}


void Foam::coupling::pointForces::checkRange()
{
    if (warned_ || !drag_.valid())
    {
        return;
    }

    const dem::bodies& state = dem_.state();
    const dragLaw::limits range(drag_->range());
    forAll(fluidVelocity_, b)
    {
        const scalar slip = mag(fluidVelocity_[b] - state.v[b]);
        for (label i = first_[b]; i < first_[b + 1]; ++i)
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
                return;
            }
        }
    }
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

    labelList cellOf;
    times_.start();
    const pointField points(elementPoints(cellOf));
    times_.lap("locating");
    List<fluidAtPoint>& fluid = sampler_->sample(points, cellOf, U, alpha);
    times_.lap("sampling of the fluid");
    List<vector> change;
    const List<pointSum> sums(sumForces(fluid, change, dt));

    elements_.setSize(first_[n]);
    fluidVelocity_.setSize(n);
    inertia_.setSize(n);
    exchanged_.setSize(n);

    // A clump's spheres follow the centres of mass
    label next = n;
    forAll(state.x, b)
    {
        const label nElements = first_[b + 1] - first_[b];
        const bool whole = nElements == 1;
        SubList<fluidAtPoint> own(fluid, nElements, whole ? b : next);
        act(b, sums[b], change[b], fluid[b], own, dt);
        next += whole ? 0 : nElements;
    }
    times_.lap("drag");

    for (pointForce& f : forces_)
    {
        if (f.remembers())
        {
            f.keepOnly(labelHashSet(state.id));
        }
    }
    state.drag = followsBody_ ? this : nullptr;
    if (followsBody_)
    {
        expand(state.v);
    }
    if (watched_)
    {
        sampled_ = fluid;
    }
    checkRange();
}


// ************************************************************************* //
