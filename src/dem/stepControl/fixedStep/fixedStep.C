/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "fixedStep.H"
#include "allowedKeys.H"
#include "checkedEntry.H"
#include "packedBodies.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(fixedStep, 0);
    addToRunTimeSelectionTable(stepControl, fixedStep, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::fixedStep::fixedStep(const dictionary& dict)
:
    stepControl(dict),
    deltaT_(0),
    needed_(GREAT),
    body_(-1)
{
    checkKeys(dict, {"type", "deltaT", "maxSteps"});
    deltaT_ = getPositive(dict, "deltaT");
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::dem::fixedStep::acceptContacts
(
    const contactSummary& contacts,
    const scalar dt
)
{
    if (dt <= 0.5*contacts.duration)
    {
        return true;
    }

    needed_ = 0.05*contacts.duration;
    body_ = contacts.stiffA;
    return false;
}


Foam::dem::stepChoice Foam::dem::fixedStep::propose
(
    const packedBodies& state,
    const contactSummary&
)
{
    return
        (state.group().shared() ? agreed_ : overstepped())
      ? stepChoice{needed_, "contact", body_}
      : stepChoice{deltaT_, "fixed"};
}


void Foam::dem::fixedStep::agree(const rankGroup& group)
{
    const scalar least = group.min(needed_);
    if (least < needed_)
    {
        body_ = stepChoice::elsewhere;
    }
    needed_ = least;
    agreed_ = true;
}


// ************************************************************************* //
