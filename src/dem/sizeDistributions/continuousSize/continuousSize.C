/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "continuousSize.H"
#include "checkedEntry.H"

#include <cmath>

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

Foam::wordList withOwn(const Foam::wordList& otherKeys)
{
    Foam::wordList keys({"min", "max", "classes"});
    keys.append(otherKeys);
    return keys;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::dem::continuousSize::quantile(const scalar F) const
{
    const scalar first = cumulative(min_);
    const scalar wanted = first + F*(cumulative(max_) - first);

    // Until halving makes no difference
    scalar low = min_, high = max_;
    for (scalar d = 0.5*(low + high); d > low && d < high; )
    {
        (cumulative(d) < wanted ? low : high) = d;
        d = 0.5*(low + high);
    }
    return high;
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::dem::continuousSize::normalShare(const scalar z)
{
    return 0.5*std::erfc(-z/std::sqrt(2.0));
}


void Foam::dem::continuousSize::checkShare(const dictionary& dict) const
{
    if (!(cumulative(max_) - cumulative(min_) > 1e-3))
    {
        badEntry
        (
            dict,
            "max",
            "and min hold less than a thousandth of the distribution"
        );
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::continuousSize::continuousSize
(
    const dictionary& dict,
    const wordList& otherKeys
)
:
    sizeDistribution(dict, withOwn(otherKeys)),
    nClasses_(getLabel(dict, "classes", 1, 32)),
    min_(getDiameter(dict, "min")),
    max_(getDiameter(dict, "max"))
{
    if (max_ <= min_)
    {
        badEntry(dict, "max", "must be greater than min");
    }
    if (max_ > 1e4*min_)
    {
        badEntry(dict, "max", "must be 10,000 times min at most");
    }
    if (nClasses_ > 10000)
    {
        badEntry(dict, "classes", "must be 10,000 at most");
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::DynamicList<Foam::dem::sizeDistribution::sizeClass>
Foam::dem::continuousSize::classes() const
{
    // The integrals by the midpoint rule
    const label nPoints = max(64, 2048/nClasses_);
    const scalar power = byMass_ ? -3 : 3;

    DynamicList<sizeClass> all;
    for (label i = 0; i < nClasses_; ++i)
    {
        scalar mean = 0;
        for (label k = 0; k < nPoints; ++k)
        {
            const scalar F = (i + (k + 0.5)/nPoints)/nClasses_;
            mean += std::pow(quantile(F)/min_, power)/nPoints;
        }
        all.append
        (
            sizeClass{min_*std::pow(mean, 1/power), byMass_ ? mean : 1}
        );
    }
    normalise(all);
    return all;
}


// ************************************************************************* //
