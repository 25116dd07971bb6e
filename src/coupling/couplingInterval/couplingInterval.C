/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "couplingInterval.H"
#include "allowedKeys.H"
#include "checkedEntry.H"
#include "volFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::coupling::couplingInterval::readBounds()
{
    dem::checkKeys(dict_, {"every", "maxCo", "relaxation", "maxChange"});

    maxCo_ = dem::getPositive(dict_, "maxCo", 0);
    relaxation_ = dem::getPositive(dict_, "relaxation", 0);
    maxChange_ = dem::getPositive(dict_, "maxChange", 0);

    if (dict_.found("every"))
    {
        token first;
        dict_.lookup("every").read(first);
        every_ =
            first.isWord() && first.wordToken() == "auto"
          ? 0
          : dem::getLabel(dict_, "every", 1);
    }
    if (every_ < 2 && !(maxCo_ + relaxation_ + maxChange_ > 0))
    {
        FatalIOErrorInFunction(dict_)
            << "There is no bound: give maxCo, relaxation or maxChange,"
            << (every_ ? " or every 2 and more," : "")
            << " or take couplingInterval out." << exit(FatalIOError);
    }
}


Foam::scalar Foam::coupling::couplingInterval::crossing
(
    const dem::bodies& state
) const
{
    scalar least = GREAT;
    forAll(state.x, b)
    {
        const dem::shape& s = state.shapeOf(b);
        const scalar speed =
            mag(state.v[b])
          + (s.isSphere() ? 0 : mag(state.omega[b])*s.boundingRadius());

        scalar V = GREAT;
        bins_.forEach
        (
            state.x[b],
            s.boundingRadius(),
            [&](const label c)
            {
                V = min(V, mesh_.V()[c]);
            }
        );
        if (V < GREAT)
        {
            const scalar h = thickness_ > 0 ? sqrt(V/thickness_) : cbrt(V);
            least = min(least, h/max(speed, VSMALL));
        }
    }
    return returnReduce(least, minOp<scalar>());
}


void Foam::coupling::couplingInterval::limit
(
    scalar& bound,
    const scalar other,
    const word& name
)
{
    if (other < bound)
    {
        bound = other;
        limit_ = name;
    }
}


Foam::scalar Foam::coupling::couplingInterval::bound
(
    const dem::bodies& state,
    const pointForces* points
)
{
    scalar least = GREAT;
    limit_ = "none";
    if (maxCo_ > 0)
    {
        limit(least, maxCo_*crossing(state), "maxCo");
    }

    // What is known of the last exchange, unless that is lost in a restart
    if (points && !written_ && ids_ == state.id && nExchanges_)
    {
        if (relaxation_ > 0)
        {
            const scalar tau = points->shortestRelaxation();
            limit
            (
                least,
                relaxation_*returnReduce(tau, minOp<scalar>()),
                "relaxation"
            );
        }
        if (maxChange_ > 0)
        {
            limit(least, changeBound_, "maxChange");
        }
    }
    return least;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::couplingInterval::couplingInterval
(
    const fvMesh& mesh,
    const cellBins& bins,
    const dictionary* dict,
    const bool points,
    autoPtr<frictionReach>&& friction
)
:
    mesh_(mesh),
    bins_(bins),
    named_(dict),
    dict_(dict ? *dict : dictionary()),
    friction_(std::move(friction)),
    every_(1),
    maxCo_(0),
    relaxation_(0),
    maxChange_(0),
    thickness_(0),
    asked_(false),
    limit_("none"),
    steps_(1),
    made_(0),
    written_(true),
    changeBound_(GREAT),
    nSteps_(0),
    nExchanges_(0),
    nAbove_(0)
{
    if (named_)
    {
        readBounds();
    }
    for (const word& key : {"every", "relaxation", "maxChange"})
    {
        if (dict_.found(key) && !points)
        {
            dem::badEntry
            (
                *dict,
                key,
                "is for bodies that are points to the fluid; those around"
                " which the flow is resolved exchange in every step"
            );
        }
    }

    for (direction d = 0; d < 3; ++d)
    {
        if (mesh.solutionD()[d] < 0)
        {
            thickness_ = mesh.bounds().span()[d];
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::coupling::couplingInterval::maxDeltaT
(
    const dem::bodies& state,
    const pointForces* points
)
{
    asked_ = true;
    written_ = mesh_.time().writeTime();
    scalar least = bound(state, points)/max(every_, label(1));
    if (friction_.valid())
    {
        frictionBound_ = friction_->maxDeltaT(state);
        cuts_ = mesh_.time().deltaTValue() > frictionBound_;
        limit(least, frictionBound_, "friction");
    }
    return least;
}


void Foam::coupling::couplingInterval::beginStep(const dem::bodies& state)
{
    if (friction_.valid() && !asked_ && !nSteps_)
    {
        friction_->checkFixed(state);
    }

    const bool bounded = every_ && maxCo_ + relaxation_ + maxChange_ > 0;
    if (bounded && !asked_)
    {
        FatalIOErrorInFunction(dict_)
            << "The entries bound the fluid's deltaT, but this solver has not"
            << " asked for a bound: its step is fixed." << nl
            << "    Set  adjustTimeStep yes;  in controlDict, if the solver"
            << " has it (pimpleFoam, not pisoFoam or icoFoam);" << nl
            << "    otherwise take couplingInterval out and choose deltaT"
            << " yourself, or, for bodies that are points, add  every auto;"
            << exit(FatalIOError);
    }
    ++nSteps_;
    if (!bounded && limit_ == "friction")
    {
        // Nobody has asked for it: it counts where the step is at it
        const scalar dt = mesh_.time().deltaTValue();
        if (!cuts_ && dt < frictionBound_*(1 - 1e-9))
        {
            limit_ = "none";
        }
    }
    if (bounded || limit_ == "friction")
    {
        ++held_(limit_);
    }
}


bool Foam::coupling::couplingInterval::due
(
    const dem::bodies& state,
    const pointForces& points
)
{
    const Time& time = mesh_.time();
    ++made_;
    const bool anew = written_ || ids_ != state.id;
    const bool isDue = anew || made_ >= steps_;
    if (isDue)
    {
        steps_ = every_;
        if (!every_)
        {
            const scalar longest = bound(state, &points);
            const scalar n = longest/time.deltaTValue()*(1 + 1e-9);
            ++held_(limit_);
            nAbove_ += n < 1;

            // The change is known from the third exchange on
            const bool known = !(maxChange_ > 0) || changeBound_ < GREAT;
            steps_ =
                anew || !known
              ? 1
              : label(min(max(n, scalar(1)), scalar(1e6)));
        }
        if (anew)
        {
            forces_.clear();
            changeBound_ = GREAT;
        }
        made_ = 0;
        ++nExchanges_;
    }
    written_ = time.writeTime();
    return isDue;
}


void Foam::coupling::couplingInterval::exchanged
(
    const dem::bodies& state,
    const pointForces& points
)
{
    ids_ = state.id;
    if (!(maxChange_ > 0))
    {
        return;
    }

    const bool known = forces_.size();
    scalar change = 0, size = 0;
    forAll(state.x, b)
    {
        const vector F =
            state.fluidForce[b]
          + points.dragCoefficient(b)
           *(points.fluidVelocity(b) - state.v[b]);
        change += magSqr(F - forces_.lookup(state.id[b], F));
        size += magSqr(F);
        forces_.set(state.id[b], F);
    }
    reduce(change, sumOp<scalar>());
    reduce(size, sumOp<scalar>());
    if (!known || !(size > 0))
    {
        return;
    }

    // At most twice the last one: a force that stands still says little
    const scalar last = steps_*mesh_.time().deltaTValue();
    const scalar part = sqrt(change/size);
    changes_ += steps_ > 1 ? part*last : 0;
    heldTime_ += last;
    changeBound_ = last*min(maxChange_/max(part, VSMALL), scalar(2));
}


void Foam::coupling::couplingInterval::writeSummary(Ostream& os) const
{
    if (!nSteps_)
    {
        return;
    }
    os  << "    Coupling: " << nSteps_ << " steps of the fluid";
    if (nExchanges_)
    {
        os  << ", " << nExchanges_ << " exchanges";
    }
    for (const word& name : held_.sortedToc())
    {
        os  << "; least bound " << name << ' ' << held_[name];
    }
    os  << nl;
    if (nAbove_)
    {
        os  << "    The step of the fluid was above the bound in " << nAbove_
            << " exchanges" << nl;
    }
}


// ************************************************************************* //
