/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    The watchdog finds what is wrong with an advance of the bodies, and nothing
    where nothing is; what it restores is what was there.

\*---------------------------------------------------------------------------*/

#include "demCase.H"
#include "figure.H"
#include "watchdog.H"

#include <limits>

using namespace Foam;
using namespace styxTest;

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

//- Two balls that meet at 1 ms
const std::string twoBalls
(
    "demSolver hades;\n"
    "materials { s { density 2500; youngsModulus 1e7;"
    " poissonsRatio 0.25; } }\n"
    "pairs { s-s { restitution 0.9; friction 0.3; } }\n"
    "shapes { ball { type sphere; diameter 0.01; } }\n"
    "stepControl { type hades; }\n"
    "bodies {\n"
    "    a { shape ball; material s; position (0 0 0);"
    " velocity (1 0.2 0); }\n"
    "    b { shape ball; material s; position (0.012 0 0);"
    " velocity (-1 0 0); } }\n"
);

const boundBox room(point(-1, -1, -1), point(1, 1, 1));


struct watched
{
    demCase balls;
    watchdog dog;

    watched()
    :
        balls(twoBalls),
        dog(dictionary(), room, true)
    {}

    dem::demSolver& dem()
    {
        return balls.solver();
    }
};


bool says(const string& complaint, const std::string& words)
{
    return complaint.find(words) != std::string::npos;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(watchdog, quiet)
{
    // Before, in and after the impact there is nothing wrong
    watched w;
    label n = 0;
    for (label i = 0; i < 40; ++i)
    {
        w.dog.store(w.dem());
        w.dem().advance(i*1e-4, (i + 1)*1e-4);
        n += !w.dog.complaint(w.dem(), 1e-4).empty();
    }
    figure("watchdog_quiet", n, 0, 0, "complaints of 40", "an impact");
    figure
    (
        "watchdog_met", w.dem().state().v[0].x(), -1, 0, "m/s", "rebound"
    );
}


TEST(watchdog, finds)
{
    const auto spoiled = [](const std::function<void(dem::bodies&)>& spoil)
    {
        watched w;
        w.dog.store(w.dem());
        w.dem().advance(0, 1e-4);
        spoil(w.dem().state());
        return w.dog.complaint(w.dem(), 1e-4);
    };
    const scalar nan = std::numeric_limits<scalar>::quiet_NaN();

    figure
    (
        "watchdog_energy",
        says
        (
            spoiled([](dem::bodies& s) { s.v[0] *= 1.02; s.v[1] *= 1.02; }),
            "kinetic energy has grown"
        ),
        1, 1, "-", "4 % more"
    );
    figure
    (
        "watchdog_momentum",
        says
        (
            spoiled([](dem::bodies& s) { s.v[0] *= 0.999; }), "momentum is off"
        ),
        1, 1, "-", "0.1 % of one is gone"
    );
    figure
    (
        "watchdog_nan",
        says(spoiled([=](dem::bodies& s) { s.v[1].y() = nan; }), "body 1"),
        1, 1, "-", "no number"
    );
    figure
    (
        "watchdog_lost",
        says
        (
            spoiled([](dem::bodies& s) { s.x[0].z() = 1.1; }),
            "without a way out"
        ),
        1, 1, "-", "outside"
    );

    const watched w;
    const vector J(1, 2, 3);
    figure
    (
        "watchdog_exchange",
        says(w.dog.complaint(J, -0.99999*J), "do not cancel")
     && w.dog.complaint(J, -(1 + 1e-9)*J).empty(),
        1, 1, "-", "1e-5 and 1e-9 off"
    );
}


TEST(watchdog, restores)
{
    // To the middle of the impact and on from there, twice
    watched w;
    w.dem().advance(0, 1.05e-3);
    w.dog.store(w.dem());
    w.dem().advance(1.05e-3, 2e-3);
    const vector once(w.dem().state().v[0]);
    const vector turned(w.dem().state().omega[0]);
    w.dog.restore(w.dem());
    w.dem().advance(1.05e-3, 2e-3);
    figure
    (
        "watchdog_restores",
        mag(w.dem().state().v[0] - once)
      + mag(w.dem().state().omega[0] - turned),
        0, 1e-12, "m/s and 1/s", "the same again"
    );
}


TEST(watchdog, input)
{
    for (const std::string bad :
        {"energyGain -1;", "halvings -1;", "mismatch 0;", "energy 0.1;"})
    {
        const dictionary dict(dictionaryOf(bad));
        EXPECT_THROW(watchdog(dict, room, true), Foam::IOerror) << bad;
    }
}


// ************************************************************************* //
