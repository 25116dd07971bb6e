/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "logNormalSize.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(logNormalSize, 0);
    addToRunTimeSelectionTable(sizeDistribution, logNormalSize, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::dem::logNormalSize::cumulative(const scalar d) const
{
    return normalShare(std::log(d/median_)/sigma_);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::logNormalSize::logNormalSize(const dictionary& dict)
:
    continuousSize(dict, {"median", "sigma"}),
    median_(getDiameter(dict, "median")),
    sigma_(getPositive(dict, "sigma"))
{
    checkShare(dict);
}



// ************************************************************************* //
