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
        {"normal", "tangential", "damping", "pulling", "instructions"}
    );

    normal = getChoice(dict, "normal", {"hertz", "hooke"}, normal);
    tangential =
        getChoice
        (
            dict, "tangential", {"none", "coulomb", "mindlin"}, tangential
        );
    damping =
        getChoice
        (
            dict,
            "damping",
            {"none", "hades", "critical", "restitution"},
            damping
        );
    instructions =
        getChoice
        (
            dict, "instructions", {"auto", "sse2", "avx2", "avx512"},
            instructions
        );

    if (dict.found("pulling"))
    {
        pulling = getChoice(dict, "pulling", {"yes", "no"}) == "yes";
        if (damping == "none")
        {
            badEntry
            (
                dict,
                "pulling",
                "says what a dashpot may do, and damping none has none"
            );
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::dem::contactLaws::pairKeys() const
{
    DynamicList<word> keys;

    if (normal == "hooke")
    {
        keys.append("normalStiffness");
    }
    if (damping == "restitution")
    {
        keys.append("restitution");
    }
    if (damping == "hades")
    {
        keys.append("normalDamping");
        if (tangential == "mindlin")
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


Foam::wordList Foam::dem::contactLaws::freePairKeys() const
{
    return damping == "critical" ? wordList({"dampingRatio"}) : wordList();
}


// ************************************************************************* //
