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


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dem::stepChoice Foam::dem::hadesStep::propose
(
    const bodies& state,
    const contactSummary& contacts
) const
{
    stepChoice choice{maxDeltaT_, "maximum"};

    forAll(state.x, b)
    {
        // speed dt + acceleration dt^2/2 = allowed
        const shape& s = state.shapeOf(b);
        const scalar allowed = maxDisplacement_*s.minRadius();
        const scalar speed =
            mag(state.v[b]) + mag(state.omega[b])*s.boundingRadius()
          + contacts.wallSpeed;
        const scalar acceleration = mag(state.forceWithDrag(b))/state.mass[b];
        const scalar dt =
            2*allowed
           /max
            (
                speed + sqrt(sqr(speed) + 2*acceleration*allowed),
                VSMALL
            );
        if (safety_*dt < choice.dt)
        {
            choice = stepChoice{safety_*dt, "displacement", b};
        }
    }

    if (safety_*contacts.duration < contactSteps_*choice.dt)
    {
        choice = stepChoice
        {
            safety_*contacts.duration/contactSteps_,
            "contact",
            contacts.stiffA
        };
    }

    if (ceiling_ < choice.dt)
    {
        choice = stepChoice{ceiling_, "growth", ceilingBody_};
    }

    return choice;
}


bool Foam::dem::hadesStep::acceptMove
(
    const bodies& state,
    const UList<point>& oldX,
    const scalar dt
)
{
    scalar worst = 0;
    label body = -1;
    forAll(state.x, b)
    {
        const shape& s = state.shapeOf(b);
        const scalar moved =
            mag(state.x[b] - oldX[b])
          + mag(state.omegaHalf[b])*dt*s.boundingRadius();
        const scalar part = moved/(maxDisplacement_*s.minRadius());

        // NaN is the worst of all
        if (!(part <= worst))
        {
            worst = part < GREAT ? part : GREAT;
            body = b;
        }
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
