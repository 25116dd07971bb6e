/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.
\*---------------------------------------------------------------------------*/

#include "checkedEntry.H"
#include "allowedKeys.H"
#include "error.H"
#include "StringStream.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// "is <value> but must be <demand>"
template<class Type>
Foam::string mustBe(const Type& value, const Foam::string& demand)
{
    Foam::OStringStream os;
    os << "is " << value << " but must be " << demand.c_str();
    return os.str();
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

void Foam::dem::badEntry
(
    const dictionary& dict,
    const word& key,
    const string& complaint
)
{
    const entry* e = dict.findEntry(key, keyType::REGEX);

    FatalIOError
    (
        FUNCTION_NAME,
        __FILE__,
        __LINE__,
        dict.name(),
        e ? e->startLineNumber() : dict.startLineNumber(),
        e ? e->endLineNumber() : dict.endLineNumber()
    )   << "Entry '" << key << "' in dictionary " << dict.name() << ' '
        << complaint.c_str() << exit(FatalIOError);
}


Foam::scalar Foam::dem::getFinite(const dictionary& dict, const word& key)
{
    const scalar value = dict.get<scalar>(key);

    if (!std::isfinite(value))
    {
        badEntry(dict, key, mustBe(value, "a finite number"));
    }
    if (mag(value) > 1e30)
    {
        badEntry(dict, key, mustBe(value, "a number up to 1e30"));
    }
    return value;
}


Foam::scalar Foam::dem::getFinite
(
    const dictionary& dict,
    const word& key,
    scalar deflt
)
{
    return dict.found(key) ? getFinite(dict, key) : deflt;
}


bool Foam::dem::isFinite(const vector& v)
{
    // NaN must not be compared: that is a floating-point trap
    for (direction d = 0; d < 3; ++d)
    {
        if (!std::isfinite(v[d]) || mag(v[d]) > 1e12)
        {
            return false;
        }
    }
    return true;
}


Foam::vector Foam::dem::getFiniteVector
(
    const dictionary& dict,
    const word& key
)
{
    const vector value = dict.get<vector>(key);

    if (!isFinite(value))
    {
        badEntry(dict, key, mustBe(value, "finite, components to 1e12"));
    }
    return value;
}


Foam::vector Foam::dem::getDirection
(
    const dictionary& dict,
    const word& key
)
{
    const vector value = getFiniteVector(dict, key);

    if (mag(value) < SMALL)
    {
        badEntry(dict, key, "it has no length");
    }
    return value/mag(value);
}


Foam::scalar Foam::dem::getPositive(const dictionary& dict, const word& key)
{
    const scalar value = getFinite(dict, key);

    if (value <= 0)
    {
        badEntry(dict, key, mustBe(value, "greater than zero"));
    }
    if (value < 1e-60)
    {
        badEntry(dict, key, mustBe(value, "1e-60 or greater"));
    }
    return value;
}


Foam::scalar Foam::dem::getPositive
(
    const dictionary& dict,
    const word& key,
    scalar deflt
)
{
    return dict.found(key) ? getPositive(dict, key) : deflt;
}


Foam::scalar Foam::dem::getPositive
(
    const dictionary& dict,
    const word& key,
    const scalar low,
    const scalar high
)
{
    getPositive(dict, key);
    return getInRange(dict, key, low, high);
}


Foam::scalar Foam::dem::getNonNegative(const dictionary& dict, const word& key)
{
    const scalar value = getFinite(dict, key);

    if (value < 0)
    {
        badEntry(dict, key, mustBe(value, "zero or greater"));
    }
    return value;
}


Foam::scalar Foam::dem::getNonNegative
(
    const dictionary& dict,
    const word& key,
    scalar deflt
)
{
    return dict.found(key) ? getNonNegative(dict, key) : deflt;
}


Foam::scalar Foam::dem::getInRange
(
    const dictionary& dict,
    const word& key,
    const scalar low,
    const scalar high
)
{
    const scalar value = getFinite(dict, key);

    if (value < low || value > high)
    {
        OStringStream range;
        range << "from " << low << " to " << high;
        badEntry(dict, key, mustBe(value, range.str()));
    }
    return value;
}


Foam::scalar Foam::dem::getInRange
(
    const dictionary& dict,
    const word& key,
    const scalar low,
    const scalar high,
    const scalar deflt
)
{
    return dict.found(key) ? getInRange(dict, key, low, high) : deflt;
}


Foam::label Foam::dem::getLabel
(
    const dictionary& dict,
    const word& key,
    const label low
)
{
    const label value = dict.get<label>(key);

    if (value < low)
    {
        OStringStream demand;
        demand << low << " or greater";
        badEntry(dict, key, mustBe(value, demand.str()));
    }
    return value;
}


Foam::label Foam::dem::getLabel
(
    const dictionary& dict,
    const word& key,
    const label low,
    const label deflt
)
{
    return dict.found(key) ? getLabel(dict, key, low) : deflt;
}


Foam::word Foam::dem::getChoice
(
    const dictionary& dict,
    const word& key,
    const wordList& allowed
)
{
    const string oneOf("one of: " + listWords(allowed));
    if (!dict.found(key))
    {
        badEntry(dict, key, "is missing; it must be " + oneOf);
    }
    const word value(dict.get<word>(key));

    if (!allowed.found(value))
    {
        badEntry(dict, key, mustBe(value, oneOf));
    }
    return value;
}


Foam::word Foam::dem::getChoice
(
    const dictionary& dict,
    const word& key,
    const wordList& allowed,
    const word& deflt
)
{
    return dict.found(key) ? getChoice(dict, key, allowed) : deflt;
}


// ************************************************************************* //
