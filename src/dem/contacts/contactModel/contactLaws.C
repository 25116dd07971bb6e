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

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::contactLaws::readCohesion(const dictionary& dict)
{
    const wordList kinds
    (
        {"simplifiedJKR", "capillary", "vanDerWaals", "electrostatic"}
    );
    if (dict.found("cohesion"))
    {
        const tokenList& tokens = dict.lookup("cohesion");
        if (tokens.size() && !tokens[0].isWord())
        {
            cohesion = dict.get<wordList>("cohesion");
        }
        else if (dict.get<word>("cohesion") != "none")
        {
            cohesion = wordList({dict.get<word>("cohesion")});
        }
    }
    forAll(cohesion, n)
    {
        if (!kinds.found(cohesion[n]))
        {
            badEntry
            (
                dict,
                "cohesion",
                "names " + cohesion[n] + "; it may be none, one of "
              + listWords(kinds) + ", or a list of these"
            );
        }
        if (cohesion.find(cohesion[n]) != n)
        {
            badEntry(dict, "cohesion", "names " + cohesion[n] + " twice");
        }
    }
    if (coheres("simplifiedJKR") && coheres("vanDerWaals"))
    {
        badEntry
        (
            dict,
            "cohesion",
            "has the attraction between the surfaces themselves twice, as"
            " simplifiedJKR and as vanDerWaals: take one of them"
        );
    }

    for (const char* key : {"relativePermittivity", "chargeCutOff"})
    {
        if (dict.found(key) && !coheres("electrostatic"))
        {
            badEntry(dict, key, "is for cohesion electrostatic only");
        }
    }
    if (coheres("electrostatic"))
    {
        permittivity = getPositive(dict, "relativePermittivity", scalar(1));
        chargeCutOff = getPositive(dict, "chargeCutOff", 1e-12, 1e9);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::contactLaws::contactLaws(const dictionary& dict)
{
    checkKeys
    (
        dict,
        {
            "normal", "tangential", "damping", "pulling", "rolling",
            "torsion", "cohesion", "relativePermittivity", "chargeCutOff",
            "multiContact", "instructions"
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

    const wordList resistances({"none", "constant", "elasticPlastic"});
    rolling = getChoice(dict, "rolling", resistances, rolling);
    torsion = getChoice(dict, "torsion", resistances, torsion);
    readCohesion(dict);
    multiContact =
        getChoice(dict, "multiContact", {"none", "share"}, multiContact);

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

bool Foam::dem::contactLaws::coheres(const word& kind) const
{
    return cohesion.found(kind);
}


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
    if (coheres("simplifiedJKR"))
    {
        keys.append("cohesionEnergyDensity");
    }
    if (coheres("capillary"))
    {
        keys.append("surfaceTension");
        keys.append("contactAngle");
        keys.append("bridgeVolume");
    }
    if (coheres("vanDerWaals"))
    {
        keys.append(wordList({"hamakerConstant", "minSeparation"}));
    }

    return wordList(keys);
}


Foam::wordList Foam::dem::contactLaws::freePairKeys() const
{
    DynamicList<word> keys;

    if (damping == "critical")
    {
        keys.append("dampingRatio");
    }
    if (rolling == "elasticPlastic")
    {
        keys.append("rollingDampingRatio");
    }
    if (torsion == "elasticPlastic")
    {
        keys.append("torsionalDampingRatio");
    }

    if (coheres("vanDerWaals"))
    {
        keys.append("maxSeparation");
    }

    return wordList(keys);
}


// ************************************************************************* //
