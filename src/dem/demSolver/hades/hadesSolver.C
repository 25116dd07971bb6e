/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "hadesSolver.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"

#include <chrono>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(hadesSolver, 0);
    addToRunTimeSelectionTable(demSolver, hadesSolver, input);
}
}


// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

Foam::scalar secondsSince(const std::chrono::steady_clock::time_point& start)
{
    return std::chrono::duration<Foam::scalar>
    (
        std::chrono::steady_clock::now() - start
    ).count();
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::hadesSolver::crossSeams(const scalar slack)
{
    if
    (
        !input_.period.active()
     || (slackBefore_ == slack && movedBefore_ < untilOut_)
    )
    {
        return;
    }

    scalar least = GREAT;
    for (label b = 0; b < packed_.size(); ++b)
    {
        if (packed_.owns(b))
        {
            least = min(least, input_.period.depth(packed_.position(b)));
        }
    }
    least = group_.min(least);
    slackBefore_ = slack;
    movedBefore_ = 0;
    untilOut_ = slack + least;
    if (untilOut_ > 0)
    {
        return;
    }

    // The bodies stay where the advance began: it may be gone back over
    const periodicity& period = input_.period;
    List<labelVector> turns(packed_.size());
    bool any = false;
    forAll(turns, b)
    {
        const point x(packed_.position(b));
        any = any || period.turns(x, slack) != labelVector::zero;
        turns[b] = period.turns(x, 0);
    }
    if (!group_.any(any))
    {
        return;
    }
    forAll(turns, b)
    {
        if (turns[b] != labelVector::zero)
        {
            packed_.shift(b, period.shift(turns[b]));
        }
    }
    list_.turn(moving(), turns);
    untilOut_ = slack;
}


bool Foam::dem::hadesSolver::outdated()
{
    return list_.outdated(packed_) || walls_.outdated(0.5*list_.skin());
}


void Foam::dem::hadesSolver::begin(const scalar t, const scalar t1)
{
    if (state_.drag && integrator_->goesBack())
    {
        badEntry
        (
            input_.dict,
            "integrator",
            "goes back in time within a step, where the drag of a fluid would"
            " speed bodies up: take stormerVerlet"
        );
    }
    pack();
    control_->begin
    (
        state_,
        {materials_, walls_, input_.period, group_},
        t1 - t
    );
    lastDt_ = 0;
    untilOut_ = 0;
    if (sleepers_.valid())
    {
        beginSleep();
    }
    computeForces(t, 0, false);
    list_.accept();
    walls_.accept();
    if (films_.valid())
    {
        films_->begin(packed_, contacts_.films());
    }
    if (notesStored_)
    {
        stored_ = storedInContacts();
        notesStored_ = false;
    }
    if (sleepers_.valid())
    {
        sleep(t, 0);
    }
}


void Foam::dem::hadesSolver::computeForces
(
    const scalar t,
    const scalar dt,
    const bool onTrial
)
{
    walls_.moveTo(t);
    if (exchange_.valid() ? due_ : outdated())
    {
        if (exchange_.valid())
        {
            if (!exchange_->takeFresh())
            {
                exchange_->reachOut(packed_, list_, walls_);
            }
            if (impulse_.valid())
            {
                impulse_->restart();
            }
        }
        const auto start = std::chrono::steady_clock::now();

        // Nothing but the held forces is there yet: they make room
        const bool makesRoom =
            areMany(packed_.nSpheres()) && !exchange_.valid()
         && !sleepers_.valid();
        if (makesRoom)
        {
            packed_.free(true);
        }
        list_.build(packed_);
        walls_.build(packed_, list_.allowed(), 0.5*list_.skin());
        if (makesRoom)
        {
            packed_.clearForces();
        }
        neighbourTime_ += secondsSince(start);
        ++nListsTimed_;
        packed_.asleep().setDue();
    }

    // To read the clock each time would cost as much as a few contacts
    const bool timed = nSweeps_++ % 64 == 0;
    nSweepsTimed_ += timed;
    summary_ = contacts_.addForces
    (
        packed_,
        list_,
        walls_,
        dt,
        integrator_->leaps() ? 0.5*(lastDt_ + dt) : 0,
        onTrial,
        timed ? &sweepTimes_ : nullptr
    );
    shareSummary();
}


bool Foam::dem::hadesSolver::tryStep(const scalar t, const scalar dt)
{
    const bool onTrial = control_->undoes();
    const bool inStages = !integrator_->leaps();
    const contactSummary oldSummary = summary_;
    bool ok = true;

    integrator_->step
    (
        packed_,
        t,
        dt,
        onTrial,
        [&](const scalar time, const scalar dtForce)
        {
            if (exchange_.valid())
            {
                due_ = meetOthers(time, dt);
            }
            movedBefore_ += packed_.bounds().speed*dt;
            ok = ok && control_->acceptMove(packed_, dt);
            if (ok)
            {
                if (!exchange_.valid())
                {
                    const packedBodies::motion& m = packed_.bounds();
                    list_.moved((m.speed + m.turning)*dt);
                }
                computeForces(time, dtForce, onTrial || inStages);
                checkClosing(time);
                ok = control_->acceptContacts(summary_, dt);
            }
        }
    );

    rejected_ = contactSummary();
    if (!ok && onTrial)
    {
        packed_.undo();
        walls_.moveTo(t);
        rejected_ = summary_;
        summary_ = oldSummary;
        return false;
    }

    const contactLaws& laws = materials_.laws();
    if (inStages && (laws.slips() || laws.rollsBack()))
    {
        endOfStages(t + dt, dt);
    }
    else
    {
        list_.accept();
        walls_.accept();
    }
    control_->accepted(dt);
    lastDt_ = dt;
    return true;
}


void Foam::dem::hadesSolver::endOfStages(const scalar t, const scalar dt)
{
    const packedBodies::records end = packed_.meanVelocities();
    computeForces(t, dt, true);
    list_.accept();
    walls_.accept();

    packed_.setVelocities(end);
    computeForces(t, 0, true);
}


Foam::scalar Foam::dem::hadesSolver::nextStep
(
    const scalar t,
    const scalar t1,
    stepChoice& step
)
{
    step = control_->propose(packed_, summary_);

    // Round-off of t must not cost another step
    const scalar left = t1 - t;
    if (step.dt*(1 + 1e-9) >= left)
    {
        step.limit = "end";
        return left;
    }
    if (step.dt < control_->minDeltaT() || t + step.dt <= t)
    {
        giveUp(t, step);
    }

    // Not a whole step and a tiny rest, but two of the same length
    return 2*step.dt > left ? 0.5*left : step.dt;
}


void Foam::dem::hadesSolver::move(const scalar t0, const scalar t1)
{
    // The forces that are held have changed, perhaps the velocities too
    walls_.beginAdvance(t0, t1);
    list_.start();
    begin(t0, t1);

    scalar t = t0;
    while (t < t1)
    {
        // A list reaches half of the skin: no sooner is it made again
        crossSeams(0.5*list_.skin());

        stepChoice step;
        scalar dt = nextStep(t, t1, step);
        if (sleepers_.valid() && wakeForWalls(dt))
        {
            dt = nextStep(t, t1, step);
        }
        if (report_.nSteps + report_.nRejected >= control_->maxSteps())
        {
            giveUp(t, t1 - t0, dt, step);
        }

        if (!tryStep(t, dt))
        {
            ++report_.nRejected;
            continue;
        }

        t = dt == t1 - t ? t1 : t + dt;
        if (impulse_.valid())
        {
            impulse_->step(packed_, moving().id, state_.nextId(), dt);
        }
        if (films_.valid())
        {
            films_->step(packed_, contacts_.films(), dt);
        }
        if (sleepers_.valid())
        {
            sleep(t, dt);
        }

        ++report_.nSteps;
        ++report_.limits(step.limit);
        report_.dtMin = min(report_.dtMin, dt);
        report_.dtMax = max(report_.dtMax, dt);
        report_.overlap = max(report_.overlap, summary_.overlap);
    }

    list_.stop();
    crossSeams(0);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

namespace
{

Foam::dem::contactLaws readLaws(const Foam::dem::demInput& input)
{
    Foam::dem::contactLaws laws;
    if (input.dict.found("contact"))
    {
        laws = Foam::dem::contactLaws(input.dict.subDict("contact"));
    }
    laws.film = input.film;
    return laws;
}

} // End anonymous namespace


Foam::dem::hadesSolver::hadesSolver(const demInput& input)
:
    demSolver
    (
        input,
        &static_cast<const contactLaws&>(readLaws(input)),
        canShare(input)
    ),
    contacts_(readLaws(input), materials_),
    list_
    (
        input.dict.found("neighbours")
      ? verletList(input.dict.subDict("neighbours"))
      : verletList(0.1)
    ),
    relaxes_
    (
        getChoice(input.dict, "start", {"asGiven", "relax"}, "asGiven")
     == "relax"
    ),
    integrator_(integrator::New(input.dict)),
    control_(chooseControl())
{
    const contactLaws& laws = materials_.laws();
    if (group_.shared())
    {
        exchange_.reset
        (
            new bodyExchange(shapes_, input.owner(), input.period)
        );
        list_.setEven();
    }
    packed_.setInstructions(contacts_.instructions());
    list_.setLanes(contacts_.nLanes());
    list_.setMemory(laws.slips(), true, laws.rollsBack());
    walls_.setMemory(laws.rollsBack());
    hadesSolver::setFilm(laws.film);
    list_.setPeriodicity(input_.period);
    walls_.setPeriodicity(input_.period);
    readWalls();
    readMirrors();
    readGenerators();
    readSinks();
    readWatchdog();
    checkIntegrator(laws);
    checkShapes(laws);
    readSleeping();
    if (!input.restart)
    {
        relax();
        checkOverlaps();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::hadesSolver::advance(const scalar t0, const scalar t1)
{
    const label nEntered = report_.nEntered;
    report_ = advanceReport();
    report_.nEntered = nEntered;

    if (!nBodies())
    {
        return;
    }

    checkFinite(t0);

    // Those of the last advance make room
    state_.force.forget();
    state_.torque.forget();
    if (watchdog_.valid())
    {
        keepStart();
    }
    move(t0, t1);
    if (watchdog_.valid())
    {
        watch(t0, t1);
        if (areMany(state_.nSpheres()))
        {
            // The forces take its room
            start_.forget();
        }
    }
    unpack();
    for (std::size_t b = 0; b < start_.drag.given.size(); ++b)
    {
        state_.dragGiven[b] += start_.drag.given[b];
    }
    checkFinite(t1);
    report_.overlap = group_.max(report_.overlap);
    report_.nContacts = nContacts();
    report_.nAsleep = sleepers_.valid() ? sleepers_->nAsleep() : -1;
}


Foam::List<Foam::dem::contactForce> Foam::dem::hadesSolver::contacts() const
{
    return contactForces
    (
        contacts_,
        materials_,
        state_,
        list_.histories(),
        input_.period,
        walls_.together().accepted,
        walls_.walls()
    );
}


// ************************************************************************* //
