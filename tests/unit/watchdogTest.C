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
#include "fluidDrag.H"
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


bool says(const string& complaint, const std::string& words)
{
    return complaint.find(words) != std::string::npos;
}


//- What is said of an advance by 0.1 ms after which the state was spoiled
string complaintAfter(const std::function<void(dem::bodies&)>& spoil)
{
    demCase balls(twoBalls);
    dem::bodies& state = balls.solver().state();
    const dem::bodies start(state);
    balls.solver().advance(0, 1e-4);
    spoil(state);
    const dem::packedBodies now(state);
    dem::watchdog dog{dictionary()};
    return dog.complaint
    (
        dem::watchdog::advance
        {
            start, now, labelUList(), Zero, 1e-4, dem::periodicity(),
            room, true, true, 0, dem::packedDrag()
        }
    );
}


//- Advances by so long to 4 ms; where the bodies are, and how they move. With
//  a seam at x [m], if that is above 0
List<vector> ended
(
    const std::string& text,
    const scalar length,
    label& nTwice,
    scalar& gain,
    const scalar seam = 0
)
{
    demCase c
    (
        text,
        vector(Zero),
        List<dem::corners>(),
        [=](dem::demInput& input)
        {
            if (seam > 0)
            {
                input.period.append
                (
                    dem::periodicity::seam
                    {
                        vector(1, 0, 0), seam, vector(0.022, 0, 0)
                    }
                );
            }
        }
    );
    nTwice = 0;
    gain = 0;
    for (label i = 0; i < label(4e-3/length + 0.5); ++i)
    {
        c.solver().advance(i*length, (i + 1)*length);
        nTwice += c.solver().report().nTwice;
        gain = max(gain, c.solver().report().energyGain);
    }
    const dem::bodies& state = c.solver().state();
    List<vector> all(state.x);
    all.append(state.v);
    all.append(state.omega);
    return all;
}


//- A drag in proportion to the slip velocity
class evenDrag
:
    public dem::fluidDrag
{
    scalar k_;

    vector u_;

    scalar share_;

public:

    evenDrag(const scalar k, const vector& u, const scalar share)
    :
        k_(k),
        u_(u),
        share_(share)
    {}

    virtual const vector& fluidVelocity(const label) const
    {
        return u_;
    }

    virtual scalar rate(const label, const scalar) const
    {
        return k_;
    }

    virtual scalar massShare(const label) const
    {
        return share_;
    }
};


//- What the watchdog sees of bodies in a drag to 4 ms
struct draggedRun
{
    label nBack = 0;
    scalar gain = 0;

    //- Largest change of momentum in an advance without the drag's and the
    //  held force's, over m |v| [-]
    scalar mismatch = 0;

    vector v;
};

draggedRun inDrag
(
    const std::string& text,
    const evenDrag& drag,
    const vector& g,
    const scalar length,
    const vector& held = Zero
)
{
    demCase c(text, g);
    dem::bodies& state = c.solver().state();
    state.drag = &drag;
    state.recordDrag = true;
    draggedRun run;
    for (label i = 0; i < label(4e-3/length + 0.5); ++i)
    {
        forAll(state.v, b)
        {
            state.fluidForce.set(b, held);
        }
        const dem::bodies start(state);
        c.solver().advance(i*length, (i + 1)*length);
        run.nBack += c.solver().report().nBack;
        run.gain = max(run.gain, c.solver().report().energyGain);
        EXPECT_EQ(c.solver().report().energyUnknown, nullptr);
        vector off(Zero);
        scalar size = 0;
        forAll(state.v, b)
        {
            const scalar m = state.mass[b];
            off +=
                m*(state.v[b] - start.v[b] - state.dragGiven[b] - length*g)
              - length*held;
            size += m*(mag(start.v[b]) + mag(state.v[b]));
        }
        run.mismatch = max(run.mismatch, mag(off)/size);
    }
    run.v = state.v[0];
    return run;
}


std::string replaced
(
    std::string text,
    const std::string& what,
    const std::string& by
)
{
    const auto at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return text.replace(at, what.size(), by);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(watchdog, quiet)
{
    // Before, in and after the impact there is nothing wrong
    demCase balls(twoBalls);
    label n = 0;
    scalar gain = 0;
    for (label i = 0; i < 40; ++i)
    {
        balls.solver().advance(i*1e-4, (i + 1)*1e-4);
        n += balls.solver().report().nBack;
        gain = max(gain, balls.solver().report().energyGain);
    }
    figure("watchdog_quiet", n, 0, 0, "steps gone back over", "an impact");
    figure("watchdog_gain", gain, 0, 0.01, "of the energy", "");
    figure
    (
        "watchdog_met",
        balls.solver().state().v[0].x(),
        -1, 0, "m/s", "rebound"
    );
}


TEST(watchdog, finds)
{
    const scalar nan = std::numeric_limits<scalar>::quiet_NaN();
    const auto finds = [](const char* name, const string& wrong, const char* s)
    {
        figure(std::string("watchdog_") + name, says(wrong, s), 1, 1, "-", s);
    };
    finds
    (
        "energy",
        complaintAfter([](dem::bodies& s) { s.v[0] *= 1.02; s.v[1] *= 1.02; }),
        "kinetic energy has grown"
    );
    finds
    (
        "momentum",
        complaintAfter([](dem::bodies& s) { s.v[0] *= 0.999; }),
        "momentum is off"
    );
    finds
    (
        "nan",
        complaintAfter([=](dem::bodies& s) { s.v[1].y() = nan; }),
        "body 1"
    );
    finds
    (
        "lost",
        complaintAfter
        (
            [](dem::bodies& s)
            {
                s.x[0].z() = 1.1;
                s.updateSpheres(0);
            }
        ),
        "without a way out"
    );
    figure
    (
        "watchdog_nothing",
        complaintAfter([](dem::bodies&) {}).empty(),
        1, 1, "-", "not spoiled"
    );

    const dem::watchdog dog{dictionary()};
    const vector J(1, 2, 3);
    figure
    (
        "watchdog_exchange",
        says(dog.complaint(J, -0.99999*J, mag(J)), "do not cancel")
     && dog.complaint(J, -(1 + 1e-9)*J, mag(J)).empty()
     && dog.complaint(1e-12*J, -2e-12*J, mag(J)).empty(),
        1, 1, "-", "1e-5 and 1e-9 off"
    );
}


TEST(watchdog, looksTwice)
{
    // An advance that begins in the middle of the impact gains what the
    // contact has stored: it is made twice, and nothing is wrong
    const std::string rolling
    (
        replaced
        (
            twoBalls, "friction 0.3;",
            "friction 0.3; rollingFriction 0.1; torsionalFriction 0.1;"
        )
      + "contact { rolling elasticPlastic; torsion elasticPlastic; }\n"
    );
    const std::string clumps
    (
        replaced
        (
            twoBalls, "type sphere; diameter 0.01;",
            "type multisphere; spheres ( ((0 0 0) 0.005) ((0 0.003 0) 0.004)"
            " );"
        )
    );
    const std::string slow
    (
        replaced(twoBalls, "stepControl { type hades; }",
            "stepControl { type contact; }")
    );
    struct scene
    {
        const char* name;
        std::string text;
        scalar seam;
    };
    const scene cases[] =
    {
        {"balls", twoBalls, 0},
        {"rolling", rolling, 0},
        {"clumps", clumps, 0},
        {"contactStep", slow, 0},
        {"acrossSeam", twoBalls, 0.006},
        {"throughSeam", twoBalls, 0.0011},
        {"rollingThroughSeam", rolling, 0.0011}
    };
    for (const auto& c : cases)
    {
        label nTwice, none;
        scalar gain;
        const scalar length = 5e-5;
        const List<vector> with(ended(c.text, length, nTwice, gain, c.seam));
        const List<vector> without
        (
            ended
            (
                c.text + "watchdog off;\n", length, none, gain, c.seam
            )
        );
        scalar off = 0;
        forAll(with, k)
        {
            off = max(off, mag(with[k] - without[k]));
        }
        figure
        (
            std::string("watchdog_twice_") + c.name,
            nTwice, 1, 40, "advances made twice", "of 80"
        );
        figure
        (
            std::string("watchdog_same_") + c.name,
            off, 0, 1e-15, "m, m/s, 1/s", "without a watchdog"
        );
    }
}


TEST(watchdog, inDrag)
{
    // A stream that follows the bodies does work on them, which is no gain
    struct scene
    {
        const char* name;
        scalar k, share, length;
        vector g, held;
    };
    const scene cases[] =
    {
        {"slow", 50, 1, 1e-4, vector(Zero), vector(Zero)},
        {"whole", 50, 1, 4e-3, vector(Zero), vector(Zero)},
        {"stiff", 1e6, 1, 1e-4, vector(0, 0, -9.81), vector(Zero)},
        {"light", 500, 0.1, 1e-4, vector(0, 0, -9.81), vector(0, 0.01, 0)}
    };
    for (const auto& c : cases)
    {
        const evenDrag drag(c.k, vector(3, 1, -0.5), c.share);
        const draggedRun run(inDrag(twoBalls, drag, c.g, c.length, c.held));
        const std::string name(std::string("watchdog_drag_") + c.name);
        figure(name, run.nBack, 0, 0, "steps gone back over", "2 balls meet");
        figure(name + "_gain", run.gain, 0, 0.01, "of the energy", "");
        figure(name + "_exchange", run.mismatch, 0, 1e-12, "of m |v|", "");
    }

    // One at its terminal velocity: as much work by the drag as by gravity
    const std::string dust
    (
        "demSolver hades;\n"
        "materials { s { density 2500; youngsModulus 1e7;"
        " poissonsRatio 0.25; } }\n"
        "shapes { ball { type sphere; diameter 1e-4; } }\n"
        "pairs { s-s { restitution 0.9; friction 0; } }\n"
        "stepControl { type fixed; deltaT 5e-5; }\n"
        "bodies { a { shape ball; material s; position (0 0 0); } }\n"
    );
    const vector g(0, 0, -9.81);
    const evenDrag still(1e5, Zero, 1);
    const draggedRun falls(inDrag(dust, still, g, 1e-3));
    figure
    (
        "watchdog_drag_dust", -falls.v.z()*1e5/9.81 - 1, -1e-9, 1e-9,
        "of g/k", "terminal velocity"
    );
    figure
    (
        "watchdog_drag_dust_gain", falls.gain, 0, 1e-9, "of the energy",
        "steps of 100 relaxation times"
    );

    // Steps that are too long for the contact give energy: in a stream that
    // hardly acts, and in one that does
    const std::string elastic
    (
        replaced
        (
            replaced(twoBalls, "restitution 0.9; friction 0.3;", ""),
            "stepControl { type hades; }",
            "contact { damping none; tangential none; }\n"
            "stepControl { type fixed; deltaT 5e-5; }\n"
            "watchdog { energyGain 1e-4; halvings 8; }"
        )
    );
    for (const scalar k : {0.1, 20.})
    {
        const evenDrag drag(k, vector(3, 1, -0.5), 1);
        draggedRun run;
        for (label i = 0; i < 8; ++i)
        {
            // They meet at other times within a step
            const std::string text
            (
                replaced
                (
                    elastic, "position (0.012", "position (0.0120"
                  + std::to_string(i + 1)
                )
            );
            const draggedRun one(inDrag(text, drag, Zero, 1e-3));
            run.nBack += one.nBack;
            run.gain = max(run.gain, one.gain);
            run.mismatch = max(run.mismatch, one.mismatch);
        }
        const std::string name("watchdog_drag_k" + std::to_string(int(k)));
        figure(name + "_back", run.nBack, 1, 40, "steps gone back over", "");
        figure(name + "_after", run.gain, 0, 1e-4, "of the energy", "");
        figure(name + "_pieces", run.mismatch, 0, 1e-12, "of m |v|", "");
    }
}


TEST(watchdog, input)
{
    for (const std::string bad :
        {"energyGain -1;", "halvings -1;", "mismatch 0;", "energy 0.1;"})
    {
        const dictionary dict(dictionaryOf("watchdog { " + bad + " }"));
        EXPECT_THROW(dem::watchdog{dict}, Foam::IOerror) << bad;
    }
    EXPECT_THROW
    (
        dem::watchdog::on(dictionaryOf("watchdog never;")), Foam::IOerror
    );
    EXPECT_FALSE(dem::watchdog::on(dictionaryOf("watchdog off;")));
}


// ************************************************************************* //
