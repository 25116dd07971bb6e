/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "contactStep.H"
#include "allowedKeys.H"
#include "checkedEntry.H"
#include "freeFlight.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(contactStep, 0);
    addToRunTimeSelectionTable(stepControl, contactStep, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::contactStep::contactStep(const dictionary& dict)
:
    stepControl(dict)
{
    checkKeys
    (
        dict,
        {
            "type", "contactFraction", "rayleighFraction",
            "maxDeltaT", "minDeltaT", "maxSteps"
        }
    );
    contactFraction_ = getInRange(dict, "contactFraction", 1e-6, 0.2, 0.05);
    rayleighFraction_ = getInRange(dict, "rayleighFraction", 1e-6, 1, 0);
    maxDeltaT_ = getPositive(dict, "maxDeltaT", GREAT);
    minDeltaT_ = getPositive(dict, "minDeltaT", 1e-12);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::dem::contactStep::rayleighFraction
(
    const bodies& state
) const
{
    if (rayleighFraction_ > 0)
    {
        return rayleighFraction_;
    }
    scalar clumps = 0;
    if (around_->stuff.laws().damping == "none")
    {
        forAll(state.x, b)
        {
            clumps = max(clumps, state.shapeOf(b).isSphere() ? 0 : 1);
        }
        clumps = around_->group.max(clumps);
    }
    return clumps > 0 ? 0.05 : 0.2;
}


void Foam::dem::contactStep::land
(
    const packedBodies& state,
    const bool touching,
    stepChoice& choice
)
{
    const scalar begin = min(wave_, begin_);
    horizon_ = max(horizon_, begin);
    const freeFlight flight
    (
        state,
        around_->walls,
        around_->period,
        min(horizon_, min(choice.dt, length_)),
        begin,
        around_->stuff.reach()
    );
    if (flight.nLooked() > 20*flight.nSpheres() + 1000)
    {
        horizon_ *= 0.5;
    }
    else if (flight.time() >= horizon_)
    {
        horizon_ *= 2;
    }

    // Forces of contacts and the drag do not stay as they are
    clear_ = touching || state.dragged() ? 0 : flight.time();
    safe_ = flight.step();
    if (safe_ < choice.dt)
    {
        choice = stepChoice{safe_, "flight", flight.body()};
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::contactStep::begin
(
    const bodies& state,
    const surroundings& around,
    const scalar length
)
{
    around_.reset(new surroundings(around));
    length_ = length;
    speed_ = 0;
    scalar shortest = GREAT;
    forAll(state.x, b)
    {
        const shape& form = state.shapeOf(b);
        speed_ = max
        (
            speed_,
            mag(state.v[b]) + mag(state.omega[b])*form.boundingRadius()
        );
        const scalar perRadius =
            around.stuff.rayleighTimePerRadius(state.materialI[b]);
        shortest = min(shortest, perRadius*form.minRadius());
    }
    speed_ = around.group.max(speed_);
    wave_ = rayleighFraction(state)*around.group.min(shortest);

    // Other forces act from now on
    clear_ = safe_ = 0;
}


Foam::dem::stepChoice Foam::dem::contactStep::propose
(
    const packedBodies& state,
    const contactSummary& contacts
)
{
    stepChoice choice{maxDeltaT_, "maximum"};
    const auto limit = [&](const scalar dt, const word& why, const label body)
    {
        if (dt < choice.dt)
        {
            choice = stepChoice{dt, why, body};
        }
    };

    const bool touching = contacts.duration < GREAT;
    if (touching)
    {
        limit(wave_, "rayleigh", -1);
        limit(contactFraction_*contacts.duration, "contact", contacts.stiffA);
        clear_ = 0;
    }
    limit(ceiling_, "contact", ceilingBody_);

    wallSpeed_ = contacts.wallSpeed;
    safe_ = clear_;
    const scalar dt = min(choice.dt, length_);
    if (dt > clear_ && !isSlow(state, dt, acceleration_*dt))
    {
        land(state, touching, choice);
    }
    return choice;
}


bool Foam::dem::contactStep::acceptMove
(
    const packedBodies& state,
    const scalar dt
)
{
    const packedBodies::motion& m = state.bounds();
    speed_ = m.speed + m.turning;
    acceleration_ = m.acceleration;
    if (dt <= safe_*(1 + 1e-9) || isSlow(state, dt, 0))
    {
        return true;
    }

    ceiling_ = 0.5*dt;
    ceilingBody_ = -1;
    return false;
}


bool Foam::dem::contactStep::acceptContacts
(
    const contactSummary& contacts,
    const scalar dt
)
{
    if (contacts.duration >= GREAT)
    {
        return true;
    }

    // The same contact may look a little shorter after a step
    const scalar wanted = contactFraction_*contacts.duration;
    if (dt <= 1.25*min(wanted, wave_))
    {
        clear_ = 0;
        return true;
    }

    ceiling_ = min(0.5*dt, min(wanted, wave_));
    ceilingBody_ = contacts.stiffA;
    begin_ = 0.9*ceiling_;
    return false;
}


void Foam::dem::contactStep::accepted(const scalar dt)
{
    // The next contact may be a longer one
    begin_ = min(1.005*begin_, GREAT);
    ceiling_ = GREAT;
    clear_ = max(clear_ - dt, scalar(0));
}


void Foam::dem::contactStep::writeState(dictionary& dict) const
{
    dict.add("acceleration", acceleration_);
    dict.add("begin", begin_);
    dict.add("horizon", horizon_);
}


void Foam::dem::contactStep::readState(const dictionary& dict)
{
    dict.readIfPresent("acceleration", acceleration_);
    dict.readIfPresent("begin", begin_);
    dict.readIfPresent("horizon", horizon_);
}


// ************************************************************************* //
