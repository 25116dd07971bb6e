/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "rateGenerator.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(rateGenerator, 0);
    addToRunTimeSelectionTable(generator, rateGenerator, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::rateGenerator::rateGenerator
(
    const word& name,
    const dictionary& dict,
    const PtrList<shape>& shapes,
    const materials& m
)
:
    regionGenerator(name, dict, shapes, m, {"rate", "start", "total"}),
    rate_(getPositive(dict, "rate")),
    start_(getFinite(dict, "start", 0)),
    total_(getLabel(dict, "total", 0))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dem::generatorPlan Foam::dem::rateGenerator::plan() const
{
    return planOf(total_);
}


Foam::label Foam::dem::rateGenerator::nDue(const scalar t)
{
    if (t < start_)
    {
        return 0;
    }
    // Round-off of t must not decide whether a body comes now or a step later
    const scalar n = 1 + std::floor((t - start_)*rate_ + 1e-6);
    return n < total_ ? label(n) : total_;
}


// ************************************************************************* //
