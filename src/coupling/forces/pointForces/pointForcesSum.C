/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "pointForces.H"
#include "SubList.H"
#include "volFields.H"

#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::coupling::pointForces::findElements()
{
    const dem::bodies& state = dem_.state();

    const labelList& centres = cells_.find(state);
    first_.setSize(state.size() + 1);
    first_[0] = 0;
    const bool shared = dem_.group().shared();
    if (!sumOfSpheres_ && !shared)
    {
        // Where the bodies are, which need not be copied
        forAll(state.x, b)
        {
            first_[b + 1] = b + 1;
        }
        at_.shallowCopy(state.x);
        cellAt_.shallowCopy(centres);
        return;
    }

    points_ = state.x;
    cellOf_ = centres;
    forAll(state.x, b)
    {
        const label n = sumOfSpheres_ ? state.shapeOf(b).radii().size() : 1;
        if (n > 1)
        {
            for (label s = state.firstSphere[b]; s < state.firstSphere[b + 1];)
            {
                points_.append(state.sphereX()[s]);
                cellOf_.append(bins_.find(state.sphereX()[s++], cellOf_[b]));
            }
        }
        first_[b + 1] = first_[b] + n;
    }
    if (shared)
    {
        hosts_.find(mesh_, bins_, false, points_, cellOf_);
    }
    at_.shallowCopy(points_);
    cellAt_.shallowCopy(cellOf_);
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


inline Foam::coupling::pointBody Foam::coupling::pointForces::bodyOf
(
    const label b,
    const scalar t,
    const scalar dt
) const
{
    const dem::bodies& state = dem_.state();
    const dem::shape& s = state.shapeOf(b);
    return pointBody
    {
        state.id[b],
        grainWidth_*s.equivalentDiameter(),
        grains_ == 1 ? s.volume() : s.volume()/grains_,
        state.v[b],
        state.omega[b],
        t,
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


void Foam::coupling::pointForces::sumForces
(
    const label first,
    const label n,
    const scalar dt
)
{
    const Time& time = mesh_.time();
    const scalar t = time.value() - time.deltaTValue();
    block_.setSize(n);
    seen_.setSize(n);
    sums_.setSize(n);
    for (label i = 0; i < n; ++i)
    {
        block_[i] = bodyOf(first + i, t, dt);
        sampler_->get(first + i, seen_[i]);
    }

    // All zeros, by wide stores
    static_assert(sizeof(pointSum) % sizeof(scalar) == 0, "a list of numbers");
    scalar* const sums = reinterpret_cast<scalar*>(sums_.data());
    std::fill(sums, sums + n*(sizeof(pointSum)/sizeof(scalar)), scalar(0));
    times_.pass();

    // Force by force, so that the time of each is known
    forAll(forces_, k)
    {
        pointForce& f = forces_[k];
        for (label i = 0; f.remembers() && i < n; ++i)
        {
            if (seen_[i].rho > 0)
            {
                f.note(block_[i], seen_[i]);
            }
        }
        if (f.remembers())
        {
            times_.lap(names_[k]);
        }
    }
    forAll(forces_, k)
    {
        const pointForce& f = forces_[k];
        for (label i = 0; i < n; ++i)
        {
            if (seen_[i].rho > 0)
            {
                f.add(block_[i], seen_[i], sums_[i]);
            }
        }
        times_.lap(names_[k]);
    }
    for (label i = 0; grains_ != 1 && i < n; ++i)
    {
        countGrains(sums_[i]);
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

    names_.setSize(forces_.size());
    forAll(forces_, k)
    {
        names_[k] = "force " + forces_[k].type();
    }
    times_.start();
    findElements();
    times_.lap("locating");
    const bool shared = dem_.group().shared();
    sampler_->sample(at_, cellAt_, U, alpha, shared ? &hosts_ : nullptr);
    leaveOutResolved();
    times_.lap("sampling of the fluid");

    elements_.setSize(first_[n]);
    shapeSeen_.setSize(drag_.valid() && drag_->shaped() ? first_[n] : 0);
    fluidVelocity_.setSize(n);
    addedMass_.clear();
    lost_.clear();
    sampled_.setSize(watched_ ? n : 0);
    startExpansion(followsBody_ ? n : 0);
    range_ = drag_.valid() ? drag_->range() : range_;
    turned_ = turns_ || kinds_.mixed();
    turns_ = false;
    largestRe_ = 0;

    // A clump's spheres follow the centres of mass. Blocks of bodies stay in
    // the cache from force to force
    label next = n;
    const bool points =
        drag_.valid() && shapeSeen_.empty() && !sumOfSpheres_
     && !kinds_.mixed();
    const label blockSize = 64;
    for (label first = 0; first < n; first += blockSize)
    {
        const label size = min(blockSize, n - first);
        sumForces(first, size, dt);
        if (points)
        {
            actOnPoints(first, size, dt);
        }
        for (label b = first; !points && b < first + size; ++b)
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
    sayRange();
}


// ************************************************************************* //
