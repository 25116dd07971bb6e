/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "contactAccuracy.H"
#include "impactTrials.H"
#include "StringStream.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::dictionary Foam::dem::contactAccuracy::controlOf(const scalar n) const
{
    dictionary control(control_);
    control.set(key_, key_ == "contactSteps" ? n : 1/n);
    return control;
}


Foam::scalar Foam::dem::contactAccuracy::steps() const
{
    return
        key_ == "contactSteps"
      ? control_.get<scalar>(key_)
      : 1/control_.get<scalar>(key_);
}


Foam::scalar Foam::dem::contactAccuracy::errorOf
(
    const label i,
    const label j,
    const scalar n
) const
{
    // Each impact at once, so that its end is not that of an advance
    const scalar atOnce = 3;

    for (scalar faster = 1; ; faster *= 10)
    {
        const impactSetting setting
        {
            case_, "", "ball", materials_.names()[i], materials_.names()[j],
            false, faster*speed_, 16, 1
        };
        const dictionary& pair =
            case_.subDict("pairs").subDict(setting.pairKey());
        const impactTrials trials(setting, pair);
        const auto coarse = trials.impacts(pair, controlOf(n), atOnce);
        const auto fine = trials.impacts(pair, controlOf(2*n), atOnce);

        bool sticks = false;
        scalar sum = 0, sumSqr = 0;
        forAll(coarse, k)
        {
            sticks = sticks || !(fine[k].out > 0);
            const scalar off =
                (coarse[k].out - fine[k].out)
               /max(fine[k].out, 0.1*fine[k].in);
            sum += off;
            sumSqr += sqr(off);
        }
        const scalar mean = sum/coarse.size();
        const scalar scatter =
            sqrt(max(sumSqr/coarse.size() - sqr(mean), scalar(0)));
        const scalar e = 12*mag(mean) + 2*sqrt(scalar(3))*scatter;
        if (!sticks || faster > 50)
        {
            return e;
        }
    }
}


Foam::scalar Foam::dem::contactAccuracy::error(const scalar n) const
{
    scalar worst = -1;
    const wordList& names = materials_.names();
    forAll(names, i)
    {
        for (label j = i; j < names.size(); ++j)
        {
            const scalar e = errorOf(i, j, n);
            if (e > worst)
            {
                worst = e;
                worst_ = names[i] + '-' + names[j];
            }
        }
    }
    return worst;
}


Foam::scalar Foam::dem::contactAccuracy::find
(
    const scalar target,
    scalar& e
) const
{
    scalar n = least;
    e = error(n);
    while (e > target && n < most)
    {
        const scalar before = e;
        n *= 2;
        e = error(n);
        if (e <= target)
        {
            // Between the two, on a straight line of logarithms
            const scalar slope = log(before/max(e, 1e-3*target))/log(2.0);
            n *= 0.5*pow(before/target, 1/slope);
            e = target;
        }
    }
    return std::ceil(n);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::contactAccuracy::contactAccuracy
(
    const dictionary& properties,
    const materials& stuff,
    const scalar d,
    const scalar g
)
:
    case_(properties),
    control_(properties.subOrEmptyDict("stepControl")),
    materials_(stuff),
    speed_(sqrt(20*(g > 0 ? g : 9.81)*d))
{
    dictionary ball;
    ball.add("type", word("sphere"));
    ball.add("diameter", d);
    dictionary shapes(properties.name() + ".shapes");
    shapes.add("ball", ball);
    case_.set("shapes", shapes);

    if (control_.empty())
    {
        control_.add("type", word("hades"));
    }
    const word type = control_.getOrDefault<word>("type", word::null);
    key_ =
        type == "hades" ? "contactSteps"
      : type == "contact" ? "contactFraction"
      : "deltaT";
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dictionary Foam::dem::contactAccuracy::choose
(
    const scalar share,
    accuracyPlan::part& chosen
) const
{
    chosen.name = accuracyPlan::steps;
    chosen.error = -1;
    dictionary control(control_);
    OStringStream entry;
    if (key_ == "deltaT" || control_.found(key_))
    {
        if (key_ != "deltaT")
        {
            chosen.error = error(steps());
        }
        entry << key_ << ' ' << control_.get<scalar>(key_) << ", by hand";
    }
    else
    {
        const scalar n = find(share, chosen.error);
        control = controlOf(n);
        entry.precision(3);
        entry << key_ << ' ' << control.get<scalar>(key_);

        OStringStream cost;
        cost.precision(2);
        cost << n/20 << " times the steps of the default";
        chosen.cost = cost.str();
    }
    chosen.chosen = entry.str();
    chosen.basis =
        "of the height after three rebounds, by twice the steps; " + worst_;
    return control;
}


// ************************************************************************* //
