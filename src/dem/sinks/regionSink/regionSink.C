/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "regionSink.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(regionSink, 0);
    addToRunTimeSelectionTable(sink, regionSink, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::regionSink::regionSink
(
    const word& name,
    const dictionary& dict,
    const wordList&
)
:
    sink(name, dict, {"region"}),
    region_(region::New(dict.subDict("region")))
{}


// ************************************************************************* //
