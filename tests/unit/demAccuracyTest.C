/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    What a target error makes of the steps in a contact, and what the run says
    of them, against closed forms and against runs with far smaller steps.

\*---------------------------------------------------------------------------*/

#include "contactAccuracy.H"
#include "impulseError.H"
#include "demCase.H"
#include "figure.H"
#include "gtest/gtest.h"

#include <cmath>
#include <complex>
#include <functional>

using namespace styxTest;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::dem::accuracyPlan;

//- A ball of 10 mm on a floor
std::string ballOnFloor
(
    const std::string& pair,
    const std::string& control,
    const std::string& contact = "",
    const std::string& body = "position (0 0 0.0055); velocity (0 0 -1);"
)
{
    return
        "demSolver hades;\n"
        "materials { s { density 2500; youngsModulus 1e7;"
        " poissonsRatio 0.25; } }\n"
        "pairs { s-s { " + pair + " } }\n"
        "contact { tangential none; " + contact + " }\n"
        "shapes { ball { type sphere; diameter 0.01; } }\n"
        "walls { floor { type plane; point (0 0 0); normal (0 0 1);"
        " material s; } }\n" + control
      + "bodies { a { shape ball; material s; " + body + " } }\n";
}


std::string steps(const scalar n)
{
    return "stepControl { type hades; contactSteps " + text(n) + "; }\n";
}


//- The velocity at which the ball comes back [m/s]
scalar rebound(const std::string& dict)
{
    demCase run(dict);
    run.run(0.05);
    return run.state().v[0].z();
}


//- The part of the plan that the steps are, with what the entries say
accuracyPlan::part partOf(const std::string& dict, const scalar error)
{
    const demCase run
    (
        dict, gravity, Foam::List<Foam::dem::corners>(),
        [=](Foam::dem::demInput& input) { input.contactError = error; }
    );
    return *const_cast<demCase&>(run).solver().stepAccuracy();
}


//- The number at the end of an entry
scalar numberIn(const std::string& s)
{
    return std::stod(s.substr(s.find(' ')));
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(contactAccuracy, stepsForAnError)
{
    scalar before = 0;
    for (const scalar e : {0.9, 0.5, 0.1})
    {
        const std::string pair("restitution " + text(e) + ";");
        const scalar exact = rebound(ballOnFloor(pair, steps(2e4)));
        for (const scalar share : {0.01, 0.001})
        {
            const accuracyPlan::part p = partOf(ballOnFloor(pair, ""), share);
            const scalar n = numberIn(p.chosen);
            const std::string name
            (
                "contactAccuracy_error_" + Foam::name(e) + "_"
              + Foam::name(share)
            );
            figure
            (
                name,
                std::abs(rebound(ballOnFloor(pair, steps(n)))/exact - 1)
               /share,
                -noBar, 1, "of the error asked for",
                Foam::name(n) + " steps; the rebound with 20000 steps"
            );
            EXPECT_LE(p.error, 1.0001*share);
            EXPECT_GT(n, share < 0.005 ? before : 9);
            before = n;
        }
    }
}


TEST(contactAccuracy, byHand)
{
    const accuracyPlan::part p =
        partOf(ballOnFloor("restitution 0.5;", steps(40)), 0.001);
    EXPECT_NE(p.chosen.find("contactSteps 40, by hand"), std::string::npos);
    EXPECT_GT(p.error, 0.001);
    EXPECT_TRUE(p.cost.empty());

    const accuracyPlan::part f = partOf
    (
        ballOnFloor
        (
            "restitution 0.5;",
            "stepControl { type fixed; deltaT 1e-5; }\n"
        ),
        0.001
    );
    EXPECT_NE(f.chosen.find("by hand"), std::string::npos);
    EXPECT_LT(f.error, 0);
}


TEST(contactAccuracy, otherLawsAndControls)
{
    // A linear spring, a contact that sticks at first, another control
    const accuracyPlan::part linear = partOf
    (
        ballOnFloor
        (
            "restitution 0.7; normalStiffness 1e4;", "", "normal hooke;"
        ),
        0.002
    );
    EXPECT_GT(linear.error, 0);
    EXPECT_LE(linear.error, 0.00201);

    const accuracyPlan::part sticky = partOf
    (
        ballOnFloor
        (
            "restitution 0.7; cohesionEnergyDensity 2e5;", "",
            "cohesion simplifiedJKR;"
        ),
        0.002
    );
    EXPECT_GT(sticky.error, 0);
    EXPECT_LE(sticky.error, 0.00201);

    const accuracyPlan::part flight = partOf
    (
        ballOnFloor("restitution 0.7;", "stepControl { type contact; }\n"),
        0.002
    );
    EXPECT_NE(flight.chosen.find("contactFraction"), std::string::npos);
    EXPECT_LE(flight.error, 0.00201);
}


TEST(contactAccuracy, notAsked)
{
    demCase run(ballOnFloor("restitution 0.8;", steps(20)), gravity);
    run.run(3);
    EXPECT_EQ(run.solver().stepAccuracy(), nullptr);

    // What the run sees is told all the same
    EXPECT_GT(run.solver().stepError(), 1e-5);
    EXPECT_LT(run.solver().stepError(), 0.02);
}


namespace
{

//- Balls between two floors that both hold them swing without end; so many,
//  with n steps a half swing: the error that is seen over that of the scheme
void swing
(
    const std::string& name,
    const label nBalls,
    const scalar n,
    const std::string& integrator = "stormerVerlet",
    const std::function<scalar(scalar)>& expected = [](const scalar wh)
    {
        return (1 - std::cos(wh))/6;
    }
)
{
    const scalar k = 1e4, m = 2500*M_PI/6*1e-6;
    const scalar omega = std::sqrt(2*k/m);
    const scalar h = M_PI/omega/n;
    std::string balls;
    for (label b = 0; b < nBalls; ++b)
    {
        balls += "b" + text(b) + " { shape ball; material s; position "
          + text(vector(0.02*(b % 64), 0.02*(b/64), 0.0049975))
          + "; velocity " + text(vector(0, 0, 1e-6*omega)) + "; }\n";
    }
    demCase run
    (
        "demSolver hades;\n"
        "materials { s { density 2500; youngsModulus 1e7;"
        " poissonsRatio 0.25; } }\n"
        "pairs { s-s { normalStiffness 1e4; } }\n"
        "contact { normal hooke; tangential none; damping none; }\n"
        "shapes { ball { type sphere; diameter 0.01; } }\n"
        "walls\n{\n"
        "    low { type plane; point (0 0 0); normal (0 0 1);"
        " material s; }\n"
        "    high { type plane; point (0 0 0.009995);"
        " normal (0 0 -1); material s; }\n}\n"
        "stepControl { type fixed; deltaT " + text(h) + "; }\n"
        "integrator " + integrator + ";\n"
        "bodies { " + balls + "}\n",
        Foam::Zero
    );
    run.run((nBalls > 1 ? 640 : 6400)*h);
    figureNear
    (
        name, run.solver().stepError(), expected(omega*h), 0.01, "-",
        "closed form of the term"
    );
}

} // End anonymous namespace


// Figures "impulseError_swinging_10", "impulseError_swinging_40"
TEST(impulseError, swinging)
{
    for (const scalar n : {10, 40})
    {
        swing("impulseError_swinging_" + Foam::name(label(n)), 1, n);
    }
}


// Figures "impulseError_implicitTrapezoidal", "impulseError_rk4"
TEST(impulseError, inStages)
{
    // A swing v + i omega x is multiplied by A in each step, and a is i omega
    // times it
    typedef std::complex<double> complex;
    const auto against = [](const std::function<complex(complex)>& factor)
    {
        return [=](const scalar wh)
        {
            const complex z(0, wh), A(factor(z));
            return
                std::abs(A*A - 1.0 - z/3.0*(1.0 + 4.0*A + A*A))
               /(2*wh*std::abs(A));
        };
    };
    struct scheme
    {
        const char* name;
        std::function<complex(complex)> factor;
    };
    const scheme schemes[] =
    {
        {"implicitTrapezoidal", [](complex z) { return (2. + z)/(2. - z); }},
        {
            "rk4",
            [](complex z)
            {
                return 1. + z*(1. + z/2.*(1. + z/3.*(1. + z/4.)));
            }
        }
    };
    for (const scheme& s : schemes)
    {
        swing
        (
            std::string("impulseError_") + s.name, 1, 20, s.name,
            against(s.factor)
        );
    }
}


//- Of many bodies some are looked at
TEST(impulseError, many)
{
    swing("impulseError_many", 2*Foam::dem::impulseError::most + 5, 10);
}


TEST(impulseError, freeFlight)
{
    demCase run
    (
        ballOnFloor
        (
            "restitution 0.5;", "", "",
            "position (0 0 10); velocity (1 0 1);"
        ),
        gravity, Foam::List<Foam::dem::corners>(),
        [](Foam::dem::demInput& input) { input.contactError = 0.01; }
    );
    run.run(0.5);
    EXPECT_LT(run.solver().stepError(), 1e-9);
}


//- To look changes nothing
TEST(impulseError, onlyLooks)
{
    const auto place = [](const scalar error)
    {
        demCase run
        (
            ballOnFloor("restitution 0.8;", steps(20)), gravity,
            Foam::List<Foam::dem::corners>(),
            [=](Foam::dem::demInput& input) { input.contactError = error; }
        );
        run.run(0.3);
        return run.state().x[0].z();
    };
    EXPECT_EQ(place(0), place(0.01));
}


//- A layer on a floor that touches nothing else, and a row of balls without
//  a floor: what the sweeps take for pairs and for walls
TEST(sweepTimes, pairsAndWalls)
{
    using Foam::dem::sweepTimes;
    const auto shareOfWalls = [](const scalar spacing, const bool floor)
    {
        std::string balls;
        for (label b = 0; b < 900; ++b)
        {
            balls += "b" + text(b) + " { shape ball; material s; position "
              + text(vector(spacing*(b % 30), spacing*(b/30), 0.005))
              + "; }\n";
        }
        demCase run
        (
            "demSolver hades;\n"
            "materials { s { density 2500; youngsModulus 1e7;"
            " poissonsRatio 0.25; } }\n"
            "pairs { s-s { restitution 0.5; friction 0.3; } }\n"
            "shapes { ball { type sphere; diameter 0.01; } }\n"
          + std::string
            (
                floor
              ? "walls { floor { type plane; point (0 0 0); normal (0 0 1);"
                " material s; } }\n"
              : ""
            )
          + "stepControl { type fixed; deltaT 1e-6; }\n"
            "bodies { " + balls + "}\n",
            floor ? gravity : vector(Foam::Zero)
        );
        run.run(1e-3);
        const scalar walls = run.solver().contactTime(sweepTimes::walls);
        const scalar pairs = run.solver().contactTime(sweepTimes::pairs);
        EXPECT_GT(walls, 0);
        EXPECT_GT(pairs, 0);
        return walls/(walls + pairs);
    };
    figure
    (
        "sweepTimes_layer", shareOfWalls(0.02, true), 0.5, 1, "-",
        "share of the walls where only walls touch"
    );
    figure
    (
        "sweepTimes_pairs", shareOfWalls(0.01, false), 0, 0.2, "-",
        "share of the walls where there are none"
    );
}


TEST(accuracyPlan, sharesAndText)
{
    accuracyPlan plan(dictionaryOf("accuracy 0.02;"), 2);
    EXPECT_DOUBLE_EQ(plan.share(), 0.01);
    accuracyPlan::part p;
    p.name = "steps";
    p.chosen = "contactSteps 12";
    p.error = 0.015;
    p.basis = "tried";
    plan.append(p);
    plan.setSeen("steps", 0.001, "looked at");
    Foam::OStringStream os;
    plan.write(os);
    plan.writeSummary(os);
    for
    (
        const char* s
      : {"accuracy 2 %", "2 parts may have 1 %", "error 1.5 % (tried)",
         "more than its share", "1.5 %; 0.1 % (looked at)"}
    )
    {
        EXPECT_NE(os.str().find(s), std::string::npos) << s << os.str();
    }

    for (const char* bad : {"0", "-0.01", "0.5", "1e-5", "nan", "fine"})
    {
        EXPECT_NE
        (
            messageOf
            (
                [&]
                {
                    accuracyPlan
                    (
                        dictionaryOf("accuracy " + std::string(bad) + ";"), 1
                    );
                }
            ).find("accuracy"),
            std::string::npos
        ) << bad;
    }
}


// ************************************************************************* //
