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


// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

//- Is the first of two entries there? One of them must be
bool isFirst
(
    const Foam::dictionary& dict,
    const Foam::word& first,
    const Foam::word& second
)
{
    if (dict.found(first) == dict.found(second))
    {
        FatalIOErrorInFunction(dict)
            << "One of the entries " << first << " and " << second
            << " is needed; here "
            << (dict.found(first) ? "are both" : "is neither")
            << Foam::exit(Foam::FatalIOError);
    }
    return dict.found(first);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::rateGenerator::rateGenerator
(
    const word& name,
    const dictionary& dict,
    shapeSizes& shapes,
    const materials& m,
    const fileName&
)
:
    regionGenerator
    (
        name,
        dict,
        shapes,
        m,
        {"rate", "massRate", "start", "total", "totalMass"}
    ),
    byMass_(isFirst(dict, "massRate", "rate")),
    rate_(getPositive(dict, byMass_ ? "massRate" : "rate")),
    start_(getFinite(dict, "start", 0)),
    total_
    (
        isFirst(dict, "total", "totalMass")
      ? getLabel(dict, "total", 0)
      : labelMax
    ),
    totalMass_(getPositive(dict, "totalMass", GREAT))
{
    if (totalMass_/mixture_.meanMass() > labelMax && total_ == labelMax)
    {
        badEntry(dict, "totalMass", "is more bodies than can be counted");
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dem::generatorPlan Foam::dem::rateGenerator::plan() const
{
    return planOf
    (
        total_ < labelMax
      ? total_
      : label(std::ceil(totalMass_/mixture_.meanMass()))
    );
}


Foam::label Foam::dem::rateGenerator::nDue(const scalar t)
{
    // Round-off of t must not decide whether a body comes now or a step later
    const scalar unit = byMass_ ? mixture_.meanMass() : 1;
    const scalar due = (t - start_)*rate_ + 1e-6*unit;

    while
    (
        t >= start_ && amount_ <= due
     && n_ < total_ && mass_ < totalMass_
    )
    {
        const mixture::kind& k = mixture_.kindOf(seed_, n_);
        const scalar own = k.density*k.volume;
        mass_ += own;
        amount_ += byMass_ ? own : 1;
        ++n_;
    }
    return n_;
}


// ************************************************************************* //
