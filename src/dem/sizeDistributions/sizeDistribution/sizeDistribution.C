/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "sizeDistribution.H"
#include "allowedKeys.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(sizeDistribution, 0);
    defineRunTimeSelectionTable(sizeDistribution, dictionary);
}
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::dem::sizeDistribution::getDiameter
(
    const dictionary& dict,
    const word& key
)
{
    return getPositive(dict, key, 2e-10, 1e12);
}


void Foam::dem::sizeDistribution::normalise(DynamicList<sizeClass>& classes)
{
    scalar sum = 0;
    for (const sizeClass& c : classes)
    {
        sum += c.share;
    }
    for (sizeClass& c : classes)
    {
        c.share /= sum;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::sizeDistribution::sizeDistribution
(
    const dictionary& dict,
    const wordList& otherKeys
)
:
    byMass_(getChoice(dict, "by", {"number", "mass"}, "number") == "mass")
{
    wordList keys({"type", "by"});
    keys.append(otherKeys);
    checkKeys(dict, keys);
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dem::sizeDistribution> Foam::dem::sizeDistribution::New
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
