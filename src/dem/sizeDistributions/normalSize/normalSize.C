/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "normalSize.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(normalSize, 0);
    addToRunTimeSelectionTable(sizeDistribution, normalSize, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::dem::normalSize::cumulative(const scalar d) const
{
    return normalShare((d - mean_)/stdDev_);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::normalSize::normalSize(const dictionary& dict)
:
    continuousSize(dict, {"mean", "stdDev"}),
    mean_(getDiameter(dict, "mean")),
    stdDev_(getPositive(dict, "stdDev"))
{
    checkShare(dict);
}



// ************************************************************************* //
