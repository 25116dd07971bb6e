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
    deltaT_(0)
{
    checkKeys(dict, {"type", "deltaT"});
    deltaT_ = getPositive(dict, "deltaT");
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::dem::fixedStep::acceptContacts
(
    const contactSummary& contacts,
    const scalar dt
)
{
    if (dt > 0.5*contacts.duration)
    {
        FatalErrorInFunction
            << "The fixed step of " << dt << " s is too large: a contact of"
            << " body " << contacts.stiffA << " lasts " << contacts.duration
            << " s." << nl
            << "    Take at most a twentieth of it, " << 0.05*contacts.duration
            << " s, or stepControl hades." << exit(FatalError);
    }
    return true;
}


// ************************************************************************* //
