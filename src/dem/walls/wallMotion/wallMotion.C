/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "wallMotion.H"
#include "allowedKeys.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(wallMotion, 0);
    defineRunTimeSelectionTable(wallMotion, dictionary);
}
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::dem::wallMotion::checkEntries
(
    const dictionary& dict,
    const wordList& keys
)
{
    wordList allowed{"type", "start", "stop"};
    allowed.append(keys);
    checkKeys(dict, allowed);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::wallMotion::wallMotion(const dictionary& dict)
:
    start_(getFinite(dict, "start", 0)),
    stop_(getFinite(dict, "stop", GREAT))
{
    if (stop_ <= start_)
    {
        badEntry(dict, "stop", "is not after the start of the motion");
    }
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dem::wallMotion> Foam::dem::wallMotion::New
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


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dem::wallMotion::state Foam::dem::wallMotion::at(const scalar t) const
{
    state s(after(min(max(t, start_), stop_) - start_));
    if (t < start_ || t >= stop_)
    {
        s.v = Zero;
        s.omega = Zero;
    }
    return s;
}


Foam::scalar Foam::dem::wallMotion::speed
(
    const wall& surface,
    const scalar t0,
    const scalar t1
) const
{
    return t1 > start_ && t0 < stop_ ? maxSpeed(surface) : 0;
}


// ************************************************************************* //
