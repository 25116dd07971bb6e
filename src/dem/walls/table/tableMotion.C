/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "tableMotion.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"
#include "StringStream.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(tableMotion, 0);
    addToRunTimeSelectionTable(wallMotion, tableMotion, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vector Foam::dem::tableMotion::slope(const label i) const
{
    return
        (rows_[i].second() - rows_[i - 1].second())
       /(rows_[i].first() - rows_[i - 1].first());
}


Foam::dem::wallMotion::state Foam::dem::tableMotion::after
(
    const scalar time
) const
{
    // The row after the time, the last if there is none
    label i = 1;
    while (i + 1 < rows_.size() && rows_[i].first() <= time)
    {
        ++i;
    }
    const scalar left = rows_[i].first() - time;

    state s;
    s.d = rows_[i].second();
    if (left > 0)
    {
        s.v = slope(i);
        s.d -= left*s.v;
    }
    return s;
}


Foam::scalar Foam::dem::tableMotion::maxSpeed
(
    const wall&
) const
{
    scalar speed = 0;
    for (label i = 1; i < rows_.size(); ++i)
    {
        speed = max(speed, mag(slope(i)));
    }
    return speed;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::tableMotion::tableMotion(const dictionary& dict)
:
    wallMotion(dict)
{
    checkEntries(dict, {"displacements"});
    rows_ = dict.get<List<Tuple2<scalar, vector>>>("displacements");

    if (rows_.size() < 2)
    {
        badEntry(dict, "displacements", "has fewer than two rows");
    }
    forAll(rows_, i)
    {
        const scalar t = rows_[i].first();
        const vector& d = rows_[i].second();
        const bool good =
            std::isfinite(t)
         && isFinite(d)
         && (i ? t > rows_[i - 1].first() : t == 0 && mag(d) == 0);
        if (!good)
        {
            OStringStream why;
            why << "has in place " << i << " the row " << rows_[i]
                << "; all must be finite, the first (0 (0 0 0)), and each time"
                << " after the one before";
            badEntry(dict, "displacements", why.str());
        }
    }
}


// ************************************************************************* //
