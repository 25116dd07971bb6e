/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "stepControl.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(stepControl, 0);
    defineRunTimeSelectionTable(stepControl, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::stepControl::stepControl(const dictionary& dict)
:
    maxSteps_(getLabel(dict, "maxSteps", 1, 10000000))
{}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dem::stepControl> Foam::dem::stepControl::New
(
    const dictionary& dict
)
{
    const word type = getChoice
    (
        dict,
        "type",
        dictionaryConstructorTablePtr_->sortedToc()
    );
    return (*dictionaryConstructorTablePtr_)[type](dict);
}


// ************************************************************************* //
