/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "batchGenerator.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(batchGenerator, 0);
    addToRunTimeSelectionTable(generator, batchGenerator, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::batchGenerator::batchGenerator
(
    const word& name,
    const dictionary& dict,
    shapeSizes& shapes,
    const materials& m,
    const fileName&
)
:
    regionGenerator(name, dict, shapes, m, {"times", "number"}),
    times_(1, scalar(0)),
    number_(getLabel(dict, "number", 1))
{
    if (dict.found("times"))
    {
        times_ = dict.get<scalarList>("times");
    }
    forAll(times_, i)
    {
        if (!std::isfinite(times_[i]) || mag(times_[i]) > 1e30)
        {
            badEntry(dict, "times", "has a time that is not finite");
        }
        if (i && times_[i] <= times_[i - 1])
        {
            badEntry(dict, "times", "must increase from each to the next");
        }
    }
    if (times_.empty())
    {
        badEntry(dict, "times", "has no time");
    }
    if (scalar(number_)*times_.size() > labelMax)
    {
        badEntry(dict, "number", "makes more bodies than can be counted");
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dem::generatorPlan Foam::dem::batchGenerator::plan() const
{
    return planOf(number_*times_.size());
}


Foam::label Foam::dem::batchGenerator::nDue(const scalar t)
{
    label n = 0;
    for (const scalar fire : times_)
    {
        // Round-off of t must not put a batch off by a step
        n += t >= fire - 1e-9*mag(fire) ? number_ : 0;
    }
    return n;
}


// ************************************************************************* //
