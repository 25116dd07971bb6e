/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "region.H"
#include "allowedKeys.H"
#include "checkedEntry.H"
#include "ITstream.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(region, 0);
    defineRunTimeSelectionTable(region, dictionary);
}
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::dem::region::read
(
    const dictionary& dict,
    const word& key,
    UList<point>& points,
    scalar* radius
)
{
    ITstream& is = dict.lookup(key);
    for (point& p : points)
    {
        is >> p;
        if (!isFinite(p))
        {
            badEntry(dict, key, "has a point that is not finite to 1e12");
        }
    }
    if (radius)
    {
        is >> *radius;
        if (!std::isfinite(*radius) || *radius <= 0 || *radius > 1e12)
        {
            badEntry(dict, key, "must end with a radius from 0 to 1e12 m");
        }
    }
    if (is.nRemainingTokens())
    {
        badEntry(dict, key, "has more numbers than belong to it");
    }
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dem::region> Foam::dem::region::New
(
    const dictionary& dict
)
{
    const wordList allowed(dictionaryConstructorTablePtr_->sortedToc());
    checkKeys(dict, allowed);

    const wordList given(dict.toc());
    if (given.size() != 1)
    {
        FatalIOErrorInFunction(dict)
            << "A region is one of: " << listWords(allowed).c_str()
            << "; here are " << given.size() << exit(FatalIOError);
    }
    return (*dictionaryConstructorTablePtr_)[given[0]](dict);
}


// ************************************************************************* //
