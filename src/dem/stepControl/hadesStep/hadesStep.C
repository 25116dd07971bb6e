/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "hadesStep.H"
#include "allowedKeys.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(hadesStep, 0);
    addToRunTimeSelectionTable(stepControl, hadesStep, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::hadesStep::hadesStep(const dictionary& dict)
:
    stepControl(dict)
{
    checkKeys
    (
        dict,
        {
            "type", "safety", "maxDisplacement", "contactSteps",
            "maxDeltaT", "minDeltaT", "maxSteps"
        }
    );
    safety_ = getInRange(dict, "safety", 0.01, 0.99, 0.8);
    maxDisplacement_ = getInRange(dict, "maxDisplacement", 1e-6, 0.5, 0.1);
    contactSteps_ = getInRange(dict, "contactSteps", 10, 1e6, 20);
    maxDeltaT_ = getPositive(dict, "maxDeltaT", GREAT);
    minDeltaT_ = getPositive(dict, "minDeltaT", 1e-12);
    ceiling_ = GREAT;
    ceilingBody_ = -1;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::dem::stepChoice Foam::dem::hadesStep::byDisplacement
(
    const packedBodies& state,
    const scalar wallSpeed,
    const scalar bound
) const
{
    // speed dt + acceleration dt^2/2 = allowed
    const auto stepOf =
        [](const scalar speed, const scalar acceleration, const scalar allowed)
    {
        return
            2*allowed
           /max
            (
                speed + sqrt(sqr(speed) + 2*acceleration*allowed),
                VSMALL
            );
    };

    // One for all, with the acceleration of the last step
    const packedBodies::motion& m = state.bounds();
    stepChoice choice{maxDeltaT_, "maximum"};
    if (m.acceleration > 0)
    {
        const scalar dt = safety_*stepOf
        (
            m.speed + m.turning + wallSpeed,
            m.acceleration,
            maxDisplacement_*state.minRadius()
        );
        if (dt > min(bound, maxDeltaT_))
        {
            return choice;
        }
    }

    for (label b = 0; b < state.size(); ++b)
    {
        if (!state.owns(b) || state.asleep().has(b))
        {
            continue;
        }
        const scalar dt = safety_*stepOf
        (
            mag(state.velocity(b)) + state.turning(b) + wallSpeed,
            mag(state.acceleration(b)),
            maxDisplacement_*state.minRadius(b)
        );
        if (dt < choice.dt)
        {
            choice = stepChoice{dt, "displacement", b};
        }
    }

    const scalar least = state.group().min(choice.dt);
    return
        least < choice.dt
      ? stepChoice{least, "displacement", stepChoice::elsewhere}
      : choice;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dem::stepChoice Foam::dem::hadesStep::propose
(
    const packedBodies& state,
    const contactSummary& contacts
)
{
    const scalar inContact = safety_*contacts.duration/contactSteps_;
    stepChoice choice =
        byDisplacement(state, contacts.wallSpeed, min(inContact, ceiling_));

    if (inContact < choice.dt)
    {
        choice = stepChoice{inContact, "contact", contacts.stiffA};
    }
    if (ceiling_ < choice.dt)
    {
        choice = stepChoice{ceiling_, "growth", ceilingBody_};
    }
    return choice;
}


bool Foam::dem::hadesStep::acceptMove
(
    const packedBodies& state,
    const scalar dt
)
{
    const packedBodies::motion& m = state.bounds();
    if ((m.speed + m.turning)*dt <= maxDisplacement_*state.minRadius())
    {
        return true;
    }

    scalar worst = 0;
    label body = -1;
    for (label b = 0; b < state.size(); ++b)
    {
        if (!state.owns(b))
        {
            continue;
        }
        const scalar moved =
            mag(state.position(b) - state.oldPosition(b))
          + state.turning(b)*dt;
        const scalar part = moved/(maxDisplacement_*state.minRadius(b));

        // NaN is the worst of all
        if (!(part <= worst))
        {
            worst = part < GREAT ? part : GREAT;
            body = b;
        }
    }

    const scalar worstOfAll = state.group().max(worst);
    if (worst < worstOfAll)
    {
        worst = worstOfAll;
        body = stepChoice::elsewhere;
    }
    if (worst <= 1)
    {
        return true;
    }

    ceiling_ = safety_*dt/worst;
    ceilingBody_ = body;
    return false;
}


bool Foam::dem::hadesStep::acceptContacts
(
    const contactSummary& contacts,
    const scalar dt
)
{
    if (contactSteps_*dt <= contacts.duration)
    {
        return true;
    }

    ceiling_ = min(0.5*dt, safety_*contacts.duration/contactSteps_);
    ceilingBody_ = contacts.stiffA;
    return false;
}


void Foam::dem::hadesStep::accepted(const scalar dt)
{
    // After a step that had to be repeated the next ones grow slowly, or
    // each of them would have to be repeated as well
    ceiling_ = ceiling_ < GREAT ? max(ceiling_, dt)*1.25 : GREAT;
    if (ceiling_ > 1e6*dt)
    {
        ceiling_ = GREAT;
    }
}


// ************************************************************************* //
