/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "overlapRelaxation.H"
#include "bodyRandom.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::dem::overlapRelaxation::givesWay
(
    const label b,
    const vector& arm,
    const vector& n
) const
{
    scalar way = 1/state_.mass[b];
    if (clumps_)
    {
        const vector lever = arm ^ n;
        way += lever & (turns_[b] & lever);
    }
    return way;
}


void Foam::dem::overlapRelaxation::push
(
    const label b,
    const vector& arm,
    const vector& impulse
)
{
    state_.x[b] += impulse/state_.mass[b];

    if (clumps_)
    {
        const vector turn = turns_[b] & (arm ^ impulse);
        const scalar angle = mag(turn);
        if (angle > 0)
        {
            state_.q.set
            (
                b, unit(quaternion(turn/angle, angle)*state_.q[b])
            );
        }
    }
    state_.updateSpheres(b);
}


void Foam::dem::overlapRelaxation::note
(
    const scalar part,
    const label a,
    const label b
)
{
    if (part > worst_)
    {
        worst_ = part;
        worstA_ = a;
        worstB_ = b;
    }
}


void Foam::dem::overlapRelaxation::separate
(
    const verletList::spherePair& p,
    const bool move
)
{
    vector n = state_.sphereX()[p.i] - state_.sphereX()[p.j];
    if (p.image != periodicity::original)
    {
        n -= period_.shift(p.image);
    }
    const scalar rI = state_.sphereR[p.i];
    const scalar rJ = state_.sphereR[p.j];
    const scalar rMin = min(rI, rJ);

    // Most have room between them
    if (magSqr(n) >= sqr(rI + rJ + 1e-3*rMin))
    {
        return;
    }
    const scalar d = mag(n);
    const scalar overlap = rI + rJ - d;
    const label a = state_.sphereBody[p.i];
    const label b = state_.sphereBody[p.j];
    note(overlap/rMin, a, b);

    const scalar way = overlap + 1e-3*rMin;
    if (!move || way <= 0)
    {
        return;
    }

    if (d > SMALL*rMin)
    {
        n /= d;
    }
    else
    {
        // One inside the other: any way out will do
        bodyRandom random(p.i, p.j, bodyRandom::purpose::placing);
        n = random.rotation().transform(vector(1, 0, 0));
    }
    const vector half = 0.5*overlap*n;
    const vector armI = state_.sphereX()[p.i] - rI*n + half - state_.x[a];
    const vector armJ = state_.sphereX()[p.j] + rJ*n - half - state_.x[b];
    const vector impulse =
        way/(givesWay(a, armI, n) + givesWay(b, armJ, n))*n;
    push(a, armI, impulse);
    push(b, armJ, -impulse);
}


void Foam::dem::overlapRelaxation::outOfWalls(const bool move)
{
    packed_.setPositions(state_);
    walls_.findTouches(packed_);
    for (const wallTouch& t : walls_.trial())
    {
        const label b = state_.sphereBody[t.sphere];
        const scalar r = state_.sphereR[t.sphere];
        note(t.overlap/r, -1 - t.wallI, b);

        // Another contact of the body may have moved it meanwhile
        const vector moved =
            state_.sphereX()[t.sphere] - packed_.centre(t.sphere);
        const scalar way = t.overlap + 1e-3*r - (moved & t.n);
        if (move && way > 0)
        {
            const vector arm = t.p - state_.x[b];
            push(b, arm, way/givesWay(b, arm, t.n)*t.n);
        }
    }
}


void Foam::dem::overlapRelaxation::renewList()
{
    packed_.setPositions(state_);
    if (!list_.outdated(packed_))
    {
        return;
    }
    forAll(state_.x, b)
    {
        const labelVector m = period_.turns(state_.x[b], 0);
        if (m != labelVector::zero)
        {
            state_.x[b] += period_.shift(m);
            state_.updateSpheres(b);
        }
    }
    packed_.setPositions(state_);
    list_.build(packed_);
    walls_.build(packed_, list_.allowed(), 0.5*list_.skin());
}


void Foam::dem::overlapRelaxation::pass(const bool move, const bool backwards)
{
    worst_ = 0;
    renewList();
    const pointField oldBodies(state_.x);
    const pointField oldSpheres
    (
        clumps_ ? pointField(state_.sphereX()) : pointField()
    );

    const auto apart =
        [&](const verletList::spherePair& p) { separate(p, move); };
    if (backwards)
    {
        list_.pairs().forEachBackwards(apart);
    }
    else
    {
        list_.pairs().forEach(apart);
    }
    if (move)
    {
        forAll(state_.x, b)
        {
            const vector way = state_.x[b] - oldBodies[b];
            const scalar limit = 0.5*small_[b];
            if (magSqr(way) > sqr(limit))
            {
                state_.x[b] = oldBodies[b] + limit/mag(way)*way;
                state_.updateSpheres(b);
            }
        }
    }
    outOfWalls(move);

    const pointField& before = clumps_ ? oldSpheres : oldBodies;
    scalar farthest = 0;
    forAll(before, s)
    {
        farthest = max(farthest, magSqr(state_.sphereX()[s] - before[s]));
    }
    list_.moved(sqrt(farthest));
    list_.accept();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::overlapRelaxation::overlapRelaxation
(
    bodies& state,
    wallSet& walls,
    const periodicity& period
)
:
    state_(state),
    walls_(walls),
    period_(period),
    packed_(state),
    list_(0.3),
    clumps_(state.nSpheres() > state.size()),
    turns_(clumps_ ? state.size() : 0, Zero),
    small_(state.size())
{
    list_.setPeriodicity(period);
    list_.setMemory(false, false, false);
    forAll(small_, b)
    {
        small_[b] = state.shapeOf(b).minRadius();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dem::overlapRelaxation::result Foam::dem::overlapRelaxation::run()
{
    result sum;
    const pointField start(state_.x);

    for (bool done = false; !done;)
    {
        // A look without moving anything says whether it is done
        pass(false, false);
        if (!sum.nPasses)
        {
            sum.before = worst_;
        }
        sum.after = worst_;
        sum.a = worstA_;
        sum.b = worstB_;
        done = worst_ <= tolerance || sum.nPasses >= maxPasses;

        for (label k = 0; k < 10 && !done; ++k)
        {
            forAll(turns_, b)
            {
                if (!state_.shapeOf(b).isSphere())
                {
                    turns_[b] = inv(state_.inertiaTensor(b));
                }
            }
            pass(true, sum.nPasses % 2);
            ++sum.nPasses;
        }
    }

    forAll(start, b)
    {
        // Not the way around through a seam
        vector way = state_.x[b] - start[b];
        for (const periodicity::seam& s : period_.seams())
        {
            way -= s.separation*std::round((way & s.normal)/s.width());
        }
        sum.farthest = max(sum.farthest, mag(way));
        sum.mean += mag(way)/start.size();

        // The spin is what was given, not the angular momentum
        state_.setL(b, state_.inertiaTensor(b) & state_.omega[b]);
    }
    return sum;
}


// ************************************************************************* //
