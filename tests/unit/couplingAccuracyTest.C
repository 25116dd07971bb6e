/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    What a target error makes of the coupling: parts of the chain, entries,
    and the expansion of the heat equation that is as exact as it says.

\*---------------------------------------------------------------------------*/

#include "couplingAccuracy.H"
#include "decay.H"
#include "figure.H"
#include "gtest/gtest.h"
#include "StringStream.H"

#include <cmath>

using namespace Foam;
using namespace styxTest;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

dictionary dictionaryFrom(const std::string& s)
{
    IStringStream is(s);
    return dictionary("demCloudProperties", dictionary::null, is);
}


//- What an expansion leaves of each wave, as a diagonal operator shows it:
//  the largest error
scalar largestError
(
    const coupling::decay& d,
    const scalar range,
    const label n
)
{
    scalarField x(n, 1.0);
    d.apply
    (
        [&](const scalarField& from, scalarField& to)
        {
            forAll(to, i)
            {
                to[i] = range*i/(n - 1)*from[i];
            }
        },
        x
    );
    scalar worst = 0;
    forAll(x, i)
    {
        worst = max(worst, mag(x[i] - d(range*i/(n - 1))));
    }
    return worst;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(couplingAccuracy, sleeping)
{
    // The share of gravity; what is there by hand stands
    dictionary dict
    (
        dictionaryFrom
        (
            "coupling none; accuracy 0.02; sleeping { speed 1e-3; time 1; }"
        )
    );
    const label n = couplingAccuracy::nParts(dict, false);
    EXPECT_EQ(n, 2);
    dem::accuracyPlan plan(dict, n);
    couplingAccuracy::chooseSleeping(dict, plan, 9.81);
    figureNear
    (
        "couplingAccuracy_sleeping",
        dict.subDict("sleeping").get<scalar>("acceleration"), 0.01*9.81,
        1e-12, "m/s2", "one of two parts of 2 %"
    );
    EXPECT_NEAR(plan.parts()[0].error, 0.01, 1e-12);

    dict.subDict("sleeping").set("acceleration", 0.5);
    dem::accuracyPlan byHand(dict, n);
    couplingAccuracy::chooseSleeping(dict, byHand, 9.81);
    EXPECT_EQ(dict.subDict("sleeping").get<scalar>("acceleration"), 0.5);
    EXPECT_NEAR(byHand.parts()[0].error, 0.5/9.81, 1e-12);

    // Nothing of it without the entry
    dictionary none(dictionaryFrom("coupling none; accuracy 0.02;"));
    dem::accuracyPlan alone(none, 1);
    couplingAccuracy::chooseSleeping(none, alone, 9.81);
    EXPECT_EQ(alone.parts().size(), 0);
    EXPECT_FALSE(none.found("sleeping"));
}


TEST(couplingAccuracy, parts)
{
    const auto n = [](const std::string& s, const bool inFluid)
    {
        return couplingAccuracy::nParts(dictionaryFrom(s), inFluid);
    };
    EXPECT_EQ(n("coupling none;", true), 1);
    EXPECT_EQ(n("coupling none; demSolver fixed;", true), 0);
    EXPECT_EQ(n("coupling twoWay; immersed {}", false), 1);
    EXPECT_EQ(n("coupling twoWay; immersed {}", true), 2);
    EXPECT_EQ(n("coupling fluidToParticles; forces {}", true), 2);
    EXPECT_EQ
    (
        n("coupling twoWay; forces {} voidFraction { type centroid; }", true),
        2
    );
    const std::string dense
    (
        "coupling twoWay; forces {} voidFraction { type diffusion; }"
    );
    EXPECT_EQ(n(dense, true), 3);
    EXPECT_EQ(n(dense + " immersed {}", true), 4);
    EXPECT_EQ
    (
        n
        (
            "coupling twoWay; forces { pressureGradient yes; }"
            " voidFraction { type diffusion; }", true
        ),
        2
    );
    EXPECT_EQ(n("effects auto;", true), 2);
    EXPECT_EQ(n("effects auto;", false), 1);
}


TEST(couplingAccuracy, entries)
{
    const dictionary accuracy(dictionaryFrom("accuracy 0.03;"));
    dictionary all
    (
        dictionaryFrom
        (
            "voidFraction { type diffusion; bandwidth 1; } forces {}"
        )
    );
    dem::accuracyPlan plan(accuracy, 3);
    couplingAccuracy::choose(all, plan, true, true);
    EXPECT_NEAR
    (
        all.subDict("couplingInterval").get<scalar>("maxChange"), 0.02, 1e-12
    );
    EXPECT_NEAR
    (
        all.subDict("voidFraction").get<scalar>("tolerance"), 1e-3, 1e-12
    );
    EXPECT_EQ(plan.parts().size(), 2);

    // What is there stays
    dictionary byHand
    (
        dictionaryFrom
        (
            "voidFraction { type diffusion; tolerance 1e-6; }"
            " couplingInterval { every 2; maxChange 0.1; }"
        )
    );
    dem::accuracyPlan other(accuracy, 3);
    couplingAccuracy::choose(byHand, other, true, true);
    EXPECT_EQ(byHand.subDict("voidFraction").get<scalar>("tolerance"), 1e-6);
    EXPECT_FALSE(byHand.subDict("couplingInterval").found("maxCo"));
    EXPECT_NEAR(other.parts()[0].error, 0.05, 1e-12);

    // What the expansion leaves out is told in any run
    EXPECT_EQ(couplingAccuracy::expansionError(byHand), 1e-6);
    EXPECT_LT(couplingAccuracy::expansionError(dictionary()), 0);

    // Without points nothing
    dictionary solids(dictionaryFrom("immersed {}"));
    dem::accuracyPlan third(accuracy, 2);
    couplingAccuracy::choose(solids, third, false, true);
    EXPECT_FALSE(solids.found("couplingInterval"));
    couplingAccuracy::noteCells(third, 8);
    EXPECT_NEAR(third.parts()[0].error, 0.0181, 1e-6);
    EXPECT_NE(third.parts()[0].cost.find("about 1 times"), std::string::npos);
    EXPECT_NEAR(couplingAccuracy::costOf(16), 15.2, 0.5);
    EXPECT_NEAR
    (
        couplingAccuracy::errorOf(couplingAccuracy::cellsFor(0.004)), 0.004,
        1e-9
    );
}


TEST(couplingAccuracy, tolerance)
{
    const scalar range = 200;
    label before = 0;
    for (const scalar tolerance : {1e-3, 1e-6, 1e-9})
    {
        coupling::decay d("exact", 1, tolerance);
        d.expand(range);
        figure
        (
            "couplingAccuracy_tolerance_" + Foam::name(tolerance),
            largestError(d, range, 2001)/tolerance, -noBar, 2.5, "tolerances",
            Foam::name(d.nProducts()) + " products; exp(-z)"
        );
        EXPECT_GT(d.nProducts(), before);
        before = d.nProducts();

        // A constant stays, to the last digit
        scalarField one(1, 1.0);
        d.apply
        (
            [](const scalarField& from, scalarField& to) { to = 0; },
            one
        );
        EXPECT_NEAR(one[0], 1, 1e-13);
    }
}


// ************************************************************************* //
