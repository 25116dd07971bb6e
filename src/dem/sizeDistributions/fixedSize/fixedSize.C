/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "fixedSize.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(fixedSize, 0);
    addToRunTimeSelectionTable(sizeDistribution, fixedSize, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::fixedSize::fixedSize(const dictionary& dict)
:
    sizeDistribution(dict, {"diameter"}),
    diameter_(getDiameter(dict, "diameter"))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::DynamicList<Foam::dem::sizeDistribution::sizeClass>
Foam::dem::fixedSize::classes() const
{
    DynamicList<sizeClass> all;
    all.append(sizeClass{diameter_, 1});
    return all;
}


// ************************************************************************* //
