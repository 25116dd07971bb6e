/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "patchSink.H"
#include "allowedKeys.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(patchSink, 0);
    addToRunTimeSelectionTable(sink, patchSink, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::patchSink::patchSink
(
    const word& name,
    const dictionary& dict,
    const wordList& outlets
)
:
    sink(name, dict, {"patches"}),
    patches_(dict.get<wordRes>("patches"))
{
    if (patches_.empty())
    {
        badEntry(dict, "patches", "names no patch");
    }
    for (const wordRe& wanted : patches_)
    {
        bool found = false;
        for (const word& patch : outlets)
        {
            found = found || wanted.match(patch);
        }
        if (!found)
        {
            badEntry
            (
                dict,
                "patches",
                "names " + wanted + ", but bodies can leave through: "
              + (outlets.empty() ? "no patch" : listWords(outlets))
            );
        }
    }
}


// ************************************************************************* //
