/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "contactLaws.H"
#include "allowedKeys.H"
#include "checkedEntry.H"
#include "DynamicList.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::contactLaws::contactLaws(const dictionary& dict)
{
    checkKeys
    (
        dict,
        {"normal", "tangential", "damping", "instructions"}
    );

    if (dict.found("normal"))
    {
        normal = getChoice(dict, "normal", {"hertz"});
    }
    if (dict.found("tangential"))
    {
        tangential = getChoice(dict, "tangential", {"none", "mindlin"});
    }
    if (dict.found("damping"))
    {
        damping =
            getChoice(dict, "damping", {"none", "hades", "restitution"});
    }
    if (dict.found("instructions"))
    {
        instructions =
            getChoice(dict, "instructions", {"auto", "sse2", "avx2", "avx512"});
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::dem::contactLaws::pairKeys() const
{
    DynamicList<word> keys;

    if (damping == "restitution")
    {
        keys.append("restitution");
    }
    if (damping == "hades")
    {
        keys.append("normalDamping");
        if (tangential != "none")
        {
            keys.append("tangentialDamping");
        }
    }
    if (tangential != "none")
    {
        keys.append("friction");
    }

    return wordList(keys);
}


// ************************************************************************* //
