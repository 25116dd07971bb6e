/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "sink.H"
#include "allowedKeys.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(sink, 0);
    defineRunTimeSelectionTable(sink, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::sink::sink
(
    const word& name,
    const dictionary& dict,
    const wordList& otherKeys
)
:
    name_(name),
    start_(getFinite(dict, "start", -GREAT)),
    end_(getFinite(dict, "end", GREAT))
{
    wordList keys({"type", "start", "end"});
    keys.append(otherKeys);
    checkKeys(dict, keys);

    if (end_ <= start_)
    {
        badEntry(dict, "end", "must be after the start");
    }
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dem::sink> Foam::dem::sink::New
(
    const word& name,
    const dictionary& dict,
    const wordList& outlets
)
{
    const word type = getChoice
    (
        dict,
        "type",
        dictionaryConstructorTablePtr_->sortedToc()
    );
    return (*dictionaryConstructorTablePtr_)[type](name, dict, outlets);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::sink::write(dictionary& dict) const
{
    dict.add("number", number_);
    dict.add("mass", mass_);
}


void Foam::dem::sink::read(const dictionary& dict)
{
    number_ = getLabel(dict, "number", 0);
    mass_ = getNonNegative(dict, "mass");
}


// ************************************************************************* //
