/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "voidFraction.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace coupling
{
    defineTypeNameAndDebug(voidFraction, 0);
    defineRunTimeSelectionTable(voidFraction, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::voidFraction::voidFraction
(
    const polyMesh& mesh,
    const cellBins& bins,
    const dem::periodicity& period
)
:
    mesh_(mesh),
    bins_(bins),
    period_(period)
{}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::coupling::voidFraction>
Foam::coupling::voidFraction::New
(
    const polyMesh& mesh,
    const cellBins& bins,
    const dem::periodicity& period,
    const dictionary& dict
)
{
    const word type
    (
        dem::getChoice
        (
            dict,
            "type",
            dictionaryConstructorTablePtr_->sortedToc()
        )
    );
    return dictionaryConstructorTablePtr_->cfind(type).val()
    (
        mesh,
        bins,
        period,
        dict
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::coupling::voidFraction::commonKeys(const wordList& more)
{
    wordList keys({"type", "maxPacking"});
    keys.append(more);
    return keys;
}


// ************************************************************************* //
