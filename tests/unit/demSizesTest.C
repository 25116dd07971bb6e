/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    Size distributions and mixtures against the moments of their closed forms,
    and generators that go by mass.

\*---------------------------------------------------------------------------*/

#include "demCase.H"
#include "sizeDistribution.H"

#include <cmath>

using namespace styxTest;
using namespace Foam::dem;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

typedef Foam::DynamicList<sizeDistribution::sizeClass> classList;

classList classesOf(const std::string& s)
{
    return sizeDistribution::New(dictionaryOf(s))->classes();
}


//- Mean of a power of the diameter over the number of bodies
scalar moment(const classList& classes, const scalar power)
{
    scalar sum = 0;
    for (const sizeDistribution::sizeClass& c : classes)
    {
        sum += c.share*std::pow(c.diameter, power);
    }
    return sum;
}


scalar variance(const classList& classes)
{
    return moment(classes, 2) - Foam::sqr(moment(classes, 1));
}


//- Density and share of the standard normal distribution
scalar phi(const scalar z)
{
    return std::exp(-0.5*z*z)/std::sqrt(2*M_PI);
}

scalar Phi(const scalar z)
{
    return 0.5*std::erfc(-z/std::sqrt(2.0));
}


//- Mean of d^k of a log-normal distribution between two sizes
scalar logMoment
(
    const scalar median,
    const scalar sigma,
    const scalar low,
    const scalar high,
    const scalar k
)
{
    const scalar a = std::log(low/median)/sigma;
    const scalar b = std::log(high/median)/sigma;
    return
        std::pow(median, k)*std::exp(0.5*Foam::sqr(k*sigma))
       *(Phi(b - k*sigma) - Phi(a - k*sigma))/(Phi(b) - Phi(a));
}


//- Figures of a distribution: mean and variance of the diameter, and the mean
//  volume, which the classes keep
void check
(
    const std::string& name,
    const std::string& dict,
    const scalar mean,
    const scalar var,
    const scalar cube
)
{
    const classList coarse(classesOf(dict));
    const classList fine(classesOf(dict + " classes 256;"));
    const std::string size("size_" + name);

    figureNear(size + "_mean", moment(coarse, 1), mean, 1e-3, "m",
        "closed form, 32 classes");
    figureNear(size + "_variance", variance(coarse), var, 0.01, "m2",
        "closed form, 32 classes");
    figureNear(size + "_variance256", variance(fine), var, 0.001, "m2",
        "closed form, 256 classes");
    figureNear(size + "_volume", moment(coarse, 3), cube, 2e-4, "m3",
        "closed form of the mean cube");
}


std::string properties(const std::string& generator)
{
    return
        "demSolver hades;\n"
        "materials { stuff { density 2500; youngsModulus 1e7;"
        " poissonsRatio 0.3; } wood { density 600; youngsModulus 1e7;"
        " poissonsRatio 0.3; } }\n"
        "pairs { stuff-stuff { restitution 0.5; friction 0.3; }\n"
        "stuff-wood { restitution 0.5; friction 0.3; }\n"
        "wood-wood { restitution 0.5; friction 0.3; } }\n"
        "stepControl { type hades; }\n"
        "shapes { ball { type sphere; diameter 0.01; }\n"
        "pair { type multisphere;"
        " spheres (((0 0 0) 0.004) ((0.004 0 0) 0.003)); } }\n"
        "generators { source { region { box (0 0 0) (100 100 100); } "
      + generator + " } }\n";
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(demSizes, uniform)
{
    const scalar a = 0.008, b = 0.013;
    check("uniform", "type uniform; min 0.008; max 0.013;",
        0.5*(a + b), Foam::sqr(b - a)/12,
        (Foam::pow4(b) - Foam::pow4(a))/(4*(b - a)));
}


TEST(demSizes, normal)
{
    // Cut at -2 and 3 standard deviations
    const scalar m = 0.01, s = 0.001;
    const scalar a = -2, b = 3;
    const scalar Z = Phi(b) - Phi(a);
    const scalar m1 = (phi(a) - phi(b))/Z;
    const scalar m2 = 1 + (a*phi(a) - b*phi(b))/Z;
    const scalar m3 = 2*m1 + (a*a*phi(a) - b*b*phi(b))/Z;
    check
    (
        "normal",
        "type normal; mean 0.01; stdDev 0.001; min 0.008; max 0.013;",
        m + s*m1,
        s*s*(m2 - m1*m1),
        m*m*m + 3*m*m*s*m1 + 3*m*s*s*m2 + s*s*s*m3
    );
}


TEST(demSizes, logNormal)
{
    const auto M = [](const scalar k)
    {
        return logMoment(0.01, 0.3, 0.005, 0.02, k);
    };
    const std::string dict
    (
        "type logNormal; median 0.01; sigma 0.3; min 0.005; max 0.02;"
    );
    check("logNormal", dict, M(1), M(2) - Foam::sqr(M(1)), M(3));

    // Of mass: each moment of number is the moment of mass of three less
    const auto N = [&](const scalar k) { return M(k - 3)/M(-3); };
    check("logNormalByMass", dict + " by mass;",
        N(1), N(2) - Foam::sqr(N(1)), N(3));
}


TEST(demSizes, table)
{
    const classList byNumber
    (
        classesOf("type table; table ((0.01 1) (0.02 3));")
    );
    EXPECT_EQ(byNumber[0].share, 0.25);
    EXPECT_EQ(byNumber[1].diameter, 0.02);

    // 8 small ones have the mass of a large one
    const classList byMass
    (
        classesOf("type table; by mass; table ((0.01 1) (0.02 3));")
    );
    EXPECT_NEAR(byMass[0].share, 8.0/11, 1e-14);
    EXPECT_NEAR(byMass[1].share, 3.0/11, 1e-14);

    const classList one(classesOf("type fixed; diameter 0.003;"));
    EXPECT_EQ(one.size(), 1);
    EXPECT_EQ(one[0].diameter, 0.003);
}


TEST(demSizes, drawn)
{
    // Bodies as they come in: their sizes, masses and moments of inertia
    demCase c
    (
        properties
        (
            "type batch; number 20000; shape pair; material stuff;"
            " size { type uniform; min 0.004; max 0.012; }"
        )
    );
    c.solver().enter(0);
    const bodies& state = c.state();
    const scalar n = state.size();
    EXPECT_EQ(state.size(), 20000);
    const shape& given = c.solver().shapes()[1];
    EXPECT_EQ(given.name(), "pair");

    scalar mean = 0, square = 0;
    for (label b = 0; b < state.size(); ++b)
    {
        const scalar d = state.shapeOf(b).equivalentDiameter();
        const scalar factor = d/given.equivalentDiameter();
        mean += d/n;
        square += d*d/n;

        ASSERT_EQ(state.shapeOf(b).ofName(), "pair");
        ASSERT_NEAR(state.mass[b]/(2500*M_PI/6*d*d*d), 1, 1e-12);
        ASSERT_NEAR(state.sphereR[2*b]/(0.004*factor), 1, 1e-12);
        ASSERT_NEAR(
            mag(state.sphereX()[2*b] - state.sphereX()[2*b + 1])/(0.004*factor),
            1, 1e-10);
        ASSERT_NEAR
        (
            state.inertia(b).z()
           /(2500*given.inertiaPerDensity().z()*std::pow(factor, 5)),
            1,
            1e-12
        );
    }
    // Standard deviation 0.29 of the width; three standard errors
    figure("sizeDrawn_mean", mean, 0.008 - 4.9e-5, 0.008 + 4.9e-5, "m",
        "of 20,000, uniform from 4 to 12 mm");
    figureNear("sizeDrawn_variance", square - mean*mean, 0.008*0.008/12, 0.02,
        "m2", "three standard errors are 1.9 %");

    // The same bodies in any order, on any rank
    const generator& g = c.solver().generators()[0];
    newBody body;
    g.make(777, [](const newBody&) { return true; }, body);
    EXPECT_EQ(body.position, state.x[777]);
    EXPECT_EQ(body.shapeI, state.shapeI[777]);
}


TEST(demSizes, mixture)
{
    const std::string mixture
    (
        "mixture { BY"
        " balls { fraction 0.6; shape ball; material stuff; }"
        " pairs { fraction 0.4; shape pair; material wood;"
        " size { type table; table ((0.01 1) (0.012 1)); } } }"
    );
    for (const std::string by : {"number", "mass"})
    {
        std::string dict("type batch; number 20000; " + mixture);
        dict.replace(dict.find("BY"), 2, "by " + by + ";");
        demCase c(properties(dict));
        c.solver().enter(0);
        const bodies& state = c.state();

        scalar balls = 0, all = 0;
        for (label b = 0; b < state.size(); ++b)
        {
            const scalar amount = by == "mass" ? state.mass[b] : 1;
            const bool ball = state.shapeOf(b).name() == "ball";
            EXPECT_EQ(state.materialI[b], ball ? 0 : 1);
            balls += ball ? amount : 0;
            all += amount;
        }
        figureNear("mixture_" + by, balls/all, 0.6, 0.02, "-",
            "of 20,000 bodies: three standard errors are 1.8 %");
    }
}


TEST(demSizes, byMass)
{
    // 2 kg/s of balls from 8 to 12 mm until 3 kg have come
    demCase c
    (
        properties
        (
            "type rate; massRate 2; totalMass 3; start 0.25;"
            " shape ball; material stuff;"
            " size { type uniform; min 0.008; max 0.012; }"
        )
    );
    const auto mass = [&]()
    {
        scalar m = 0;
        for (const scalar one : c.state().mass.list())
        {
            m += one;
        }
        return m;
    };
    const scalar largest = 2500*M_PI/6*std::pow(0.012, 3);
    scalar worst = 0;
    for (label i = 0; i <= 36; ++i)
    {
        const scalar t = 0.05*i;
        c.solver().enter(t);
        if (t > 0.25 && t < 1.75)
        {
            worst = Foam::max(worst, Foam::mag(mass() - 2*(t - 0.25)));
        }
    }
    figure("massRate", worst/largest, 0, 1, "bodies",
        "largest distance to the mass that is due");
    figure("totalMass", (mass() - 3)/largest, 0, 1, "bodies",
        "the last body reaches it");

    // As after a restart
    demCase again(properties
    (
        "type rate; massRate 2; totalMass 3; start 0.25;"
        " shape ball; material stuff;"
        " size { type uniform; min 0.008; max 0.012; }"
    ));
    again.solver().generators()[0].setEntered(100);
    again.solver().enter(1);
    again.solver().enter(2);
    EXPECT_EQ(again.state().size() + 100, c.state().size());
    EXPECT_EQ(again.state().x.last(), c.state().x.last());
    EXPECT_EQ(again.state().mass.list().last(), c.state().mass.list().last());
}


TEST(demSizes, wrongInput)
{
    const auto expect = [](const std::string& g, const std::string& word)
    {
        const std::string dict = properties(g);
        const std::string said = messageOf([&]() { demCase c(dict); });
        EXPECT_NE(said.find(word), std::string::npos) << g << said;
    };
    const std::string one("type batch; number 1; ");
    const std::string ball(one + "shape ball; material stuff; ");
    expect(ball + "size { type bimodal; }",
        "fixed logNormal normal table uniform");
    expect(ball + "size { type uniform; min 0.01; max 0.01; }", "greater");
    expect(ball + "size { type uniform; min 0.01; max 200; }", "10,000 times");
    expect(ball + "size { type uniform; min 0.01; max 0.02; mean 1; }", "mean");
    expect(ball + "size { type uniform; min 0.01; max 0.02; classes 0; }",
        "1 or greater");
    expect(ball + "size { type normal; mean 0.01; min 0.01; max 0.02; }",
        "stdDev");
    expect(ball + "size { type normal; mean 1; stdDev 0.01; min 0.01;"
        " max 0.02; }", "thousandth");
    expect(ball + "size { type logNormal; median 0.01; sigma -1; min 0.01;"
        " max 0.02; }", "greater than zero");
    expect(ball + "size { type table; table (); }", "no size");
    expect(ball + "size { type table; table ((0.01 0)); }", "share");
    expect(ball + "size { type table; table ((-0.01 1)); }", "diameter");
    expect(ball + "size { type fixed; diameter 0; }", "greater than zero");
    expect(ball + "size { type fixed; diameter 1; by volume; }",
        "mass number");
    expect(ball + "mixture { }", "does not go with");
    expect(one + "mixture { }", "add up to 0");
    expect(one + "mixture { a { fraction 0.5; shape ball; material stuff; } }",
        "add up to 0.5");
    expect(one + "mixture { a { shape ball; material stuff; } }", "fraction");
    expect(one + "mixture { of mass; }", "component");
    expect(one + "mixture { a { fraction 1; shape ball; } }", "material");
    expect(one + "mixture { a { fraction 1; shape bell; material stuff; } }",
        "ball pair");
    expect(one + "material stuff;", "shape");

    const std::string rate("type rate; shape ball; material stuff; ");
    expect(rate + "rate 1;", "total and totalMass");
    expect(rate + "total 1;", "massRate and rate");
    expect(rate + "rate 1; massRate 1; total 1;", "are both");
    expect(rate + "rate 1; total 1; totalMass 1;", "are both");
    expect(rate + "massRate 0; total 1;", "greater than zero");
    expect(rate + "rate 1; totalMass 1e20;", "counted");
}


// ************************************************************************* //
