/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "tableSize.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"
#include "Tuple2.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(tableSize, 0);
    addToRunTimeSelectionTable(sizeDistribution, tableSize, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::tableSize::tableSize(const dictionary& dict)
:
    sizeDistribution(dict, {"table"})
{
    const List<Tuple2<scalar, scalar>> table
    (
        dict.get<List<Tuple2<scalar, scalar>>>("table")
    );
    for (const Tuple2<scalar, scalar>& row : table)
    {
        const scalar d = row.first();
        const scalar share = row.second();
        if (!std::isfinite(d) || d < 2e-10 || d > 1e12)
        {
            badEntry(dict, "table", "has a diameter not of 2e-10 to 1e12 m");
        }
        if (!std::isfinite(share) || share <= 0 || share > 1e30)
        {
            badEntry(dict, "table", "has a share that is not from 0 to 1e30");
        }
        classes_.append
        (
            sizeClass{d, byMass_ ? share/pow3(d/table[0].first()) : share}
        );
    }
    if (classes_.empty())
    {
        badEntry(dict, "table", "has no size");
    }
    normalise(classes_);
}



// ************************************************************************* //
