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
        {
            "normal", "tangential", "damping", "pulling", "rolling",
            "torsion", "cohesion", "instructions"
        }
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

    rolling = getChoice(dict, "rolling", {"none", "constant"}, rolling);
    torsion = getChoice(dict, "torsion", {"none", "constant"}, torsion);
    cohesion =
        getChoice(dict, "cohesion", {"none", "simplifiedJKR"}, cohesion);

    for (const char* key : {"rolling", "torsion"})
    {
        const word& law = key == word("rolling") ? rolling : torsion;
        if (law != "none" && tangential == "none")
        {
            badEntry
            (
                dict,
                key,
                "needs friction: with tangential none nothing makes a body"
                " turn, and rolling is not resisted"
            );
        }
    }
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
    if (rolling != "none")
    {
        keys.append("rollingFriction");
    }
    if (torsion != "none")
    {
        keys.append("torsionalFriction");
    }
    if (cohesion != "none")
    {
        keys.append("cohesionEnergyDensity");
    }

    return wordList(keys);
}


Foam::wordList Foam::dem::contactLaws::freePairKeys() const
{
    return damping == "critical" ? wordList({"dampingRatio"}) : wordList();
}


// ************************************************************************* //
