/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    The step control contact: free flights of few steps, no contact jumped
    over, the fractions of contact and Rayleigh time, and what is undone.

\*---------------------------------------------------------------------------*/

#include "demCase.H"

#include <cmath>
#include <random>

using namespace styxTest;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Elastic balls of 1 cm and 2500 kg/m3
std::string balls
(
    const std::string& stepControl,
    const std::string& walls,
    const std::string& bodies,
    const std::string& modulus = "1e7"
)
{
    return
        "demSolver hades;\n"
        "contact { tangential none; damping none; }\n"
        "materials { stuff { density 2500; youngsModulus " + modulus
      + "; poissonsRatio 0.3; } }\n"
        "pairs { stuff-stuff {} }\n"
        "shapes { ball { type sphere; diameter 0.01; } }\n"
        "walls { " + walls + " }\n"
        "stepControl { " + stepControl + " }\n"
        "bodies { " + bodies + " }\n";
}

const std::string floorAtZero
(
    "floor { type plane; point (0 0 0); normal (0 0 1); material stuff; }"
);

std::string ball
(
    const std::string& name,
    const vector& x,
    const vector& v = vector(Foam::Zero)
)
{
    return
        name + " { shape ball; material stuff; position " + text(x)
      + "; velocity " + text(v) + "; }\n";
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(demContactStep, freeFall)
{
    // From 10 m to shortly before the floor: steps double from the first,
    // which is a fifth of the Rayleigh time, so log2(fall/first) of them
    demCase c(balls("type contact;", floorAtZero, ball("b", {0, 0, 10})),
        gravity);
    c.run(1.4);
    figure
    (
        "contactStep_fallError",
        std::abs(c.state().x[0].z() - (10 - 0.5*9.81*1.96)),
        0,
        1e-12,
        "m",
        "closed form of the free fall"
    );

    const scalar G = 1e7/2.6;
    const scalar first =
        0.2*M_PI*0.005*std::sqrt(2500/G)/(0.1631*0.3 + 0.8766);
    figure
    (
        "contactStep_fallSteps",
        c.nSteps,
        1,
        std::ceil(std::log2(1.4/first)) + 1,
        "steps",
        "doubled from a fifth of the Rayleigh time"
    );
    EXPECT_EQ(c.nRejected, 0);
}


TEST(demContactStep, bouncesForever)
{
    // Elastic: it comes back to where it was, impact after impact
    const scalar h = 0.1;
    demCase c
    (
        balls("type contact;", floorAtZero, ball("b", {0, 0, h + 0.005})),
        gravity
    );
    // From the top to the floor and back
    const scalar half = std::sqrt(2*h/9.81);
    const scalar u = 9.81*half;
    const scalar m = 2500*M_PI/6*1e-6;
    const scalar EStar = 1e7/(2*(1 - 0.09));
    const scalar contact =
        2.9432*std::pow(15*m*u*u/(16*EStar*std::sqrt(0.005)), 0.4)/u;
    scalar worst = 0;
    scalar last = 9.81*h;
    for (int n = 0; n < 20; ++n)
    {
        c.run(2*half + contact);
        const scalar e =
            0.5*Foam::magSqr(c.state().v[0])
          + 9.81*(c.state().x[0].z() - 0.005);
        worst = std::max(worst, std::abs(e/last - 1));
        last = e;
    }
    figure
    (
        "contactStep_bounceEnergy",
        worst,
        0,
        2e-3,
        "-",
        "change in an elastic impact, worst of 20, exact 0"
    );
    figure
    (
        "contactStep_bounceSteps",
        c.nSteps/20.0,
        20,
        60,
        "steps an impact and flight",
        "20 of the contact at least"
    );
}


TEST(demContactStep, nothingJumpedOver)
{
    // Ten balls at 1,000 m/s, each at one that rests, head on: each pair
    // exchanges velocities. With steps of the contact's duration they would
    // pass through each other.
    std::string bodies;
    for (int n = 0; n < 10; ++n)
    {
        const scalar y = 0.1*n;
        bodies += ball("a" + std::to_string(n), {0, y, 0}, {1000, 0, 0});
        bodies += ball("b" + std::to_string(n), {0.5 + 0.037*n, y, 0});
    }
    demCase c(balls("type contact;", "", bodies, "1e11"));
    c.run(2e-3);

    scalar worst = 0;
    for (int n = 0; n < 10; ++n)
    {
        worst = std::max
        (
            worst,
            std::max
            (
                mag(c.state().v[2*n]),
                mag(c.state().v[2*n + 1] - vector(1000, 0, 0))
            )
        );
    }
    std::cout << c.nSteps << " steps, " << c.nRejected << " rejected\n";
    figure
    (
        "contactStep_headOn",
        worst/1000,
        0,
        0.005,
        "of 1000 m/s",
        "velocities are exchanged"
    );
}


TEST(demContactStep, wallAtThousand)
{
    // Through a thin sheet of triangles, or off it?
    const std::string sheet
    (
        "sheet { type rectangle; corner (-1 -1 0); edge1 (2 0 0);"
        " edge2 (0 2 0); material stuff; }"
    );
    demCase c
    (
        balls
        (
            "type contact;",
            sheet,
            ball("b", {0.1, 0.2, 3}, {0, 0, -1000}),
            "1e11"
        )
    );
    c.run(5e-3);
    figure
    (
        "contactStep_wall",
        std::abs(c.state().v[0].z()/1000 - 1),
        0,
        0.005,
        "of 1000 m/s",
        "comes back elastically"
    );
    EXPECT_GT(c.state().x[0].z(), 0);
}


TEST(demContactStep, fastOneAmongResting)
{
    // One ball rests, so that something touches all the time; another comes
    // at 1,000 m/s and hits a third
    demCase c
    (
        balls
        (
            "type contact;",
            floorAtZero,
            ball("rests", {0, 0, 0.005 - 1e-6})
          + ball("flies", {1, 0, 0.5}, {1000, 0, 0})
          + ball("waits", {2.0123, 0, 0.5}),
            "1e10"
        ),
        gravity
    );
    c.run(2e-3);
    std::cout << c.nSteps << " steps, " << c.nRejected << " rejected\n";
    figure
    (
        "contactStep_fastOne",
        c.state().v[2].x()/1000,
        0.99,
        1.01,
        "of 1000 m/s",
        "velocities are exchanged"
    );
}


TEST(demContactStep, fractions)
{
    // Steps in a contact that rests: of the Rayleigh time, and of the contact
    const scalar G = 1e7/2.6;
    const scalar rayleigh =
        M_PI*0.005*std::sqrt(2500/G)/(0.1631*0.3 + 0.8766);
    for (const scalar part : {0.01, 0.05})
    {
        demCase c
        (
            balls
            (
                "type contact; contactFraction 0.1; rayleighFraction "
              + text(part) + ";",
                floorAtZero,
                ball("b", {0, 0, 0.005 - 1e-7})
            ),
            gravity
        );
        c.run(0.01);
        figureNear
        (
            part < 0.02 ? "contactStep_rayleigh1" : "contactStep_rayleigh5",
            c.solver().report().dtMax,
            part*rayleigh,
            1e-9,
            "s",
            "thesis (3.11)"
        );
    }
}


TEST(demContactStep, order)
{
    // A ball that swings on its contact, and one that falls onto it: the error
    // at a given time falls with the square of the fraction
    const auto end = [](const scalar fraction)
    {
        demCase c
        (
            balls
            (
                "type contact; rayleighFraction 1; contactFraction "
              + text(fraction) + ";",
                floorAtZero,
                ball("b", {0, 0, 0.005 - 2e-6}),
                "1e6"
            ),
            gravity
        );
        c.run(0.02);
        return vector(c.state().x[0].z(), 1e-3*c.state().v[0].z(), 0);
    };

    const vector exact = end(1e-4);
    const scalar order =
        std::log2(mag(end(0.0125) - exact)/mag(end(0.003125) - exact))/2;
    figure("contactStep_order", order, 1.9, 2.1, "-", "own run of 1e-4");
}


TEST(demContactStep, restartIsUninterrupted)
{
    // The state of the control goes on; without it the first step differs
    const std::string dict = balls
    (
        "type contact;",
        floorAtZero,
        ball("a", {0, 0, 0.3}) + ball("b", {0.001, 0, 0.32})
    );
    demCase through(dict, gravity);
    demCase first(dict, gravity);
    for (int n = 0; n < 3; ++n)
    {
        through.run(0.1);
        first.run(0.1);
    }
    Foam::dictionary counters;
    first.solver().writeCounters(counters);
    demCase second(dict, gravity);
    second.state().x = first.state().x;
    second.state().v = first.state().v;
    second.state().q = first.state().q;
    forAll(second.state().x, k)
    {
        second.state().setL(k, first.state().L(k));
    }
    second.state().update();
    second.solver().setHistory(first.solver().history());
    second.solver().readCounters(counters);

    label nDifferent = 0;
    for (int n = 0; n < 5; ++n)
    {
        // Times as those of the run that was not stopped
        through.run(0.1);
        second.solver().advance(0.3 + 0.1*n, 0.3 + 0.1*(n + 1));
        nDifferent +=
            through.solver().report().nSteps
         != second.solver().report().nSteps;
    }
    for (label b = 0; b < 2; ++b)
    {
        nDifferent += mag(through.state().x[b] - second.state().x[b]) > 1e-12;
    }
    figure
    (
        "contactStep_restart",
        nDifferent,
        0,
        0,
        "advances or bodies that differ",
        "a run through"
    );
}


TEST(demContactStep, wrongInput)
{
    const auto said = [](const std::string& control)
    {
        return messageOf
        (
            [&]()
            {
                demCase(balls(control, floorAtZero, ball("b", {0, 0, 1})));
            }
        );
    };
    EXPECT_NE(said("type contact; contactFraction 0.3;").find
        ("contactFraction"), std::string::npos);
    EXPECT_NE(said("type contact; rayleighFraction 0;").find
        ("rayleighFraction"), std::string::npos);
    EXPECT_NE(said("type contact; safety 0.5;").find("safety"),
        std::string::npos);
    EXPECT_NE(said("type kontact;").find("contact"), std::string::npos);
    EXPECT_EQ(said("type contact; maxDeltaT 1; minDeltaT 1e-9;"), "");
}


// ************************************************************************* //
