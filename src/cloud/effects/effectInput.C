/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "effectInput.H"
#include "allowedKeys.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::effectInput::effectInput(const dictionary& properties)
{
    for (const char* block : {"forces", "immersed"})
    {
        namesFilm =
            namesFilm || properties.subOrEmptyDict(block).found("lubrication");
    }

    // An effect that is left out may be as large as the error that is wanted
    target = properties.getOrDefault<scalar>("accuracy", target);

    const wordList types({"asNamed", "auto"});
    if (!properties.isDict("effects"))
    {
        automatic =
            dem::getChoice(properties, "effects", types, "asNamed") == "auto";
        return;
    }

    const dictionary& dict = properties.subDict("effects");
    dem::checkKeys(dict, {"type", "targetError", "interval", "roughness"});
    dem::getPositive(dict, "roughness", 1e-6);
    automatic = dem::getChoice(dict, "type", types, "asNamed") == "auto";
    if (dict.found("roughness") && !automatic)
    {
        dem::badEntry
        (
            dict,
            "roughness",
            "is for type auto, which chooses a film by it; name lubrication in"
            " forces or immersed"
        );
    }
    target = dem::getPositive(dict, "targetError", target);
    if (target < 1e-6 || target > 0.5)
    {
        dem::badEntry(dict, "targetError", "may be 1e-6 to 0.5");
    }
    interval = dem::getLabel(dict, "interval", 1, interval);
}


// ************************************************************************* //
