/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "hadesSolver.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(hadesSolver, 0);
    addToRunTimeSelectionTable(demSolver, hadesSolver, input);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::hadesSolver::save()
{
    old_.x = state_.x;
    old_.v = state_.v;
    old_.q = state_.q;
    old_.L = state_.L;
    old_.omega = state_.omega;
    old_.force = state_.force;
    old_.torque = state_.torque;
}


void Foam::dem::hadesSolver::undo()
{
    state_.x = old_.x;
    state_.v = old_.v;
    state_.q = old_.q;
    state_.L = old_.L;
    state_.omega = old_.omega;
    state_.force = old_.force;
    state_.torque = old_.torque;
    forAll(state_.x, b)
    {
        state_.updateSpheres(b);
    }
}


void Foam::dem::hadesSolver::computeForces(const scalar dt)
{
    if (list_.outdated(state_))
    {
        list_.build(state_);
        walls_.build(state_, list_.skin());
    }

    forAll(state_.x, b)
    {
        state_.force[b] = state_.mass[b]*g() + state_.fluidForce[b];
        state_.torque[b] = state_.fluidTorque[b];
    }

    summary_ = contacts_->addForces(state_, list_, walls_, dt);
}


bool Foam::dem::hadesSolver::tryStep(const scalar t, const scalar dt)
{
    save();
    const contactSummary oldSummary = summary_;
    bool ok = true;

    integrator_->step
    (
        state_,
        t,
        dt,
        [&](const scalar, const scalar dtForce)
        {
            ok = ok && control_->acceptMove(state_, old_.x, dt);
            if (ok)
            {
                computeForces(dtForce);
                ok = control_->acceptContacts(summary_, dt);
            }
        }
    );

    if (!ok)
    {
        undo();
        summary_ = oldSummary;
        return false;
    }

    list_.accept();
    walls_.accept();
    control_->accepted(dt);
    return true;
}


Foam::dem::stepChoice Foam::dem::hadesSolver::nextStep
(
    const scalar t,
    const scalar t1
) const
{
    stepChoice step = control_->propose(state_, summary_);

    // Not a whole step and a tiny rest, but two of the same length
    const scalar left = t1 - t;
    if (step.dt >= left)
    {
        step = stepChoice{left, "end", step.body};
    }
    else if (2*step.dt > left)
    {
        step.dt = 0.5*left;
    }
    return step;
}


void Foam::dem::hadesSolver::giveUp(const scalar t, const stepChoice& step)
{
    if (input_.save)
    {
        input_.save();
    }

    OStringStream body;
    if (step.body >= 0)
    {
        body<< "    It is limited (" << step.limit << ") by "
            << nameOf(step.body) << " at " << state_.x[step.body]
            << " with velocity " << state_.v[step.body] << " m/s." << nl;
    }
    if (summary_.overlapA >= 0)
    {
        body<< "    Largest overlap: " << 100*summary_.overlap
            << " % of the smaller radius, between "
            << nameOf(summary_.overlapA) << " and "
            << nameOf(summary_.overlapB) << '.' << nl;
    }

    FatalErrorInFunction
        << "At time " << t << " s the step of the bodies would have to be "
        << step.dt << " s, below minDeltaT " << control_->minDeltaT()
        << " s." << nl << body.str().c_str()
        << "    The state has been written." << exit(FatalError);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

namespace
{

Foam::dem::contactLaws readLaws(const Foam::dictionary& dict)
{
    return
        dict.found("contact")
      ? Foam::dem::contactLaws(dict.subDict("contact"))
      : Foam::dem::contactLaws();
}

} // End anonymous namespace


Foam::dem::hadesSolver::hadesSolver(const demInput& input)
:
    demSolver(input, &static_cast<const contactLaws&>(readLaws(input.dict))),
    contacts_(contactModel::New(readLaws(input.dict), materials_)),
    list_
    (
        input.dict.found("neighbours")
      ? verletList(input.dict.subDict("neighbours"))
      : verletList(0.1)
    ),
    integrator_(integrator::New(input.dict)),
    control_(stepControl::New(input.dict.subDict("stepControl")))
{
    readWalls();
    readGenerators();
    if (!input.restart)
    {
        checkOverlaps();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::hadesSolver::enter(const scalar t)
{
    report_.nEntered = 0;

    for (generator& g : generators_)
    {
        while (g.nEntered() < g.nDue(t))
        {
            newBody body;
            const bool made = g.make
            (
                g.nEntered(),
                [this](const newBody& n) { return hasRoom(n); },
                body
            );
            if (!made)
            {
                Info<< "    generator " << g.name() << ": body "
                    << g.nEntered() << " waits for room" << endl;
                break;
            }
            state_.append(body);
            g.setEntered(g.nEntered() + 1);
            ++report_.nEntered;
        }
    }
}


void Foam::dem::hadesSolver::advance(const scalar t0, const scalar t1)
{
    const label nEntered = report_.nEntered;
    report_ = advanceReport();
    report_.nEntered = nEntered;

    if (!state_.size())
    {
        return;
    }

    // The forces that are held have changed, perhaps the velocities too
    state_.vHalf = state_.v;
    state_.omegaHalf = state_.omega;
    computeForces(0);
    list_.accept();
    walls_.accept();

    scalar t = t0;
    while (t < t1)
    {
        const stepChoice step = nextStep(t, t1);

        if (step.dt < control_->minDeltaT() && step.dt < t1 - t)
        {
            giveUp(t, step);
        }
        if (!tryStep(t, step.dt))
        {
            ++report_.nRejected;
            continue;
        }

        t = step.dt == t1 - t ? t1 : t + step.dt;

        ++report_.nSteps;
        ++report_.limits(step.limit);
        report_.dtMin = min(report_.dtMin, step.dt);
        report_.dtMax = max(report_.dtMax, step.dt);
        report_.overlap = max(report_.overlap, summary_.overlap);
    }

    report_.nContacts = summary_.nPairs + summary_.nWalls;
}


void Foam::dem::hadesSolver::remove(const boolList& marked)
{
    labelList newIndex(state_.nSpheres(), -1);
    label n = 0;
    forAll(newIndex, s)
    {
        if (!marked[state_.sphereBody[s]])
        {
            newIndex[s] = n++;
        }
    }

    state_.remove(marked);
    list_.renumber(newIndex);
    walls_.renumber(newIndex);
}


// ************************************************************************* //
