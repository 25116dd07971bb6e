/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "wall.H"
#include "allowedKeys.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(wall, 0);
    defineRunTimeSelectionTable(wall, dictionary);
}
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::dem::wall::checkEntries
(
    const dictionary& dict,
    const wordList& keys
)
{
    wordList allowed{"type", "material", "motion", "open", "close"};
    allowed.append(keys);
    checkKeys(dict, allowed);
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::wordList Foam::dem::wall::types()
{
    return dictionaryConstructorTablePtr_->sortedToc();
}


Foam::autoPtr<Foam::dem::wall> Foam::dem::wall::New
(
    const word& name,
    const label materialI,
    const dictionary& dict,
    const fileName& directory
)
{
    const word type = getChoice(dict, "type", types());
    return
        (*dictionaryConstructorTablePtr_)[type]
        (
            name,
            materialI,
            dict,
            directory
        );
}


// ************************************************************************* //
