/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description

Description
    The step control: what it rejects is undone without a trace, an advance
    ends on its time, the order of the scheme is kept, and a step that cannot
    be made small enough stops the run with the reason.

\*---------------------------------------------------------------------------*/

#include "demCase.H"

#include "addToRunTimeSelectionTable.H"
#include "stepControl.H"

#include <cmath>

using namespace styxTest;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{

//- A fixed step; before each one it tries a longer one and rejects it, now
//  before and now after the contacts were looked at
class rejectingStep
:
    public stepControl
{
    scalar deltaT_;

    label n_ = 0;

    bool trial() const
    {
        return n_ % 2 == 0;
    }

public:

    TypeName("rejecting");

    explicit rejectingStep(const dictionary& dict)
    :
        deltaT_(dict.get<scalar>("deltaT"))
    {}

    virtual stepChoice propose
    (
        const packedBodies&,
        const contactSummary&
    )
    {
        return stepChoice{(trial() ? 7.3 : 1)*deltaT_, "rejecting"};
    }

    virtual bool acceptMove(const packedBodies&, const scalar)
    {
        return n_ % 6 == 0 ? ++n_ < 0 : true;
    }

    virtual bool acceptContacts(const contactSummary&, const scalar)
    {
        return trial() ? ++n_ < 0 : true;
    }

    virtual void accepted(const scalar)
    {
        ++n_;
    }

    virtual scalar stepInContact(const scalar duration) const
    {
        return duration;
    }

    virtual scalar minDeltaT() const
    {
        return 0;
    }

    virtual string minimum() const
    {
        return "zero is";
    }
};

defineTypeNameAndDebug(rejectingStep, 0);
addToRunTimeSelectionTable(stepControl, rejectingStep, dictionary);

} // End namespace dem
} // End namespace Foam


namespace
{

//- Materials and pairs of a soft stuff
const std::string stuff
(
    "demSolver hades;\n"
    "materials { stuff { density 2500; youngsModulus 1e6;"
    " poissonsRatio 0.3; } }\n"
    "pairs { stuff-stuff { restitution 0.7; friction 0.4; } }\n"
);

//- A ball of 1 cm on the floor z = 0
std::string ball(const std::string& stepControl, const scalar z)
{
    return
        "demSolver hades;\n"
        "contact { tangential none; damping none; }\n"
        "materials { stuff { density 2500; youngsModulus 1e6;"
        " poissonsRatio 0.3; } }\n"
        "pairs { stuff-stuff {} }\n"
        "shapes { ball { type sphere; diameter 0.01; } }\n"
        "walls { floor { type plane; point (0 0 0); normal (0 0 1);"
        " material stuff; } }\n"
        "stepControl { " + stepControl + " }\n"
        "bodies { it { shape ball; material stuff; position (0 0 "
      + text(z) + "); } }\n";
}


//- Nine cubes that fall on one heap in a corner of three planes; laws, and
//  what a pair has for them
std::string heap
(
    const std::string& stepControl,
    const std::string& laws = "",
    const std::string& pair = ""
)
{
    std::string s = stuff;
    s.replace(s.find("friction"), 0, pair);
    s +=
        "contact { " + laws + " }\n" + cubeOfNine + "stepControl { "
      + stepControl + " }\n"
        "walls\n{\n"
        "x { type plane; point (0 0 0); normal (1 0 0); material stuff; }\n"
        "y { type plane; point (0 0 0); normal (0 1 0); material stuff; }\n"
        "z { type plane; point (0 0 0); normal (0 0 1); material stuff; }\n"
        "}\nbodies\n{\n";

    for (int n = 0; n < 9; ++n)
    {
        s +=
            "b" + std::to_string(n) + " { shape cube; material stuff;"
            " position " + text(vector(0.012, 0.013, 0.012 + 0.019*n))
          + "; velocity (-0.1 -0.13 -0.7); rotation ((1 2 "
          + std::to_string(n) + ") " + std::to_string(37*n) + "); }\n";
    }
    return s + "}\n";
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(demStep, endsOnTime)
{
    // A free fall is exact for any sequence of steps that ends on time
    demCase c(ball("type hades;", 10), gravity);

    for (int n = 0; n < 100; ++n)
    {
        c.run(0.001 + 0.0001234567*(n % 7));
    }
    EXPECT_GT(c.nSteps, 200);

    const scalar z = 10 - 0.5*9.81*c.time()*c.time();
    figure
    (
        "stepEndsOnTime",
        std::abs(c.state().x[0].z() - z),
        0,
        1e-12,
        "m",
        "closed form of the free fall"
    );
}


TEST(demStep, undoneWithoutTrace)
{
    // With slip, and with all else that contacts remember
    struct {const char *name, *laws, *pair;} cases[] =
    {
        {"stepUndone", "", ""},
        {
            "stepUndone_laws",
            "rolling elasticPlastic; torsion elasticPlastic;"
            " cohesion (capillary vanDerWaals); multiContact share;",
            "rollingFriction 0.1; torsionalFriction 0.05;"
            " surfaceTension 0.07; contactAngle 20; bridgeVolume 0.01;"
            " hamakerConstant 1e-15; minSeparation 1e-5; "
        }
    };
    for (const auto& with : cases)
    {
        demCase a
        (
            heap("type fixed; deltaT 2e-5;", with.laws, with.pair), gravity
        );
        demCase b
        (
            heap("type rejecting; deltaT 2e-5;", with.laws, with.pair), gravity
        );

        label nContacts = 0;
        for (int n = 0; n < 20; ++n)
        {
            a.run(0.01);
            b.run(0.01);
            nContacts += a.solver().report().nContacts;
        }
        EXPECT_GT(nContacts, 100);
        EXPECT_GT(b.nRejected, 9000);
        EXPECT_EQ(a.nSteps, b.nSteps);

        label nDifferent = 0;
        for (label i = 0; i < a.state().size(); ++i)
        {
            nDifferent +=
                a.state().x[i] != b.state().x[i]
             || a.state().v[i] != b.state().v[i]
             || a.state().L(i) != b.state().L(i)
             || a.state().force[i] != b.state().force[i]
             || a.state().torque[i] != b.state().torque[i]
             || a.state().q[i] != b.state().q[i];
        }
        figure
        (
            with.name,
            nDifferent,
            0,
            0,
            "bodies that differ in a bit after 10000 rejected steps",
            "a run without them"
        );
    }
}


TEST(demStep, orderKept)
{
    // A ball that swings on its contact; the steps follow its velocity
    const auto end = [](const scalar contactSteps)
    {
        demCase c
        (
            ball
            (
                "type hades; maxDisplacement 0.5; contactSteps "
              + text(contactSteps) + ";",
                0.005 - 2e-6
            ),
            gravity
        );
        c.run(0.02);
        return vector(c.state().x[0].z(), 1e-3*c.state().v[0].z(), 0);
    };

    const vector exact = end(10240);
    const scalar order =
        std::log2(mag(end(80) - exact)/mag(end(320) - exact))/2;
    figure("stepOrderKept", order, 1.9, 2.1, "-", "own run of 10240 steps");
}


TEST(demStep, cannotBeSmallEnough)
{
    demCase c
    (
        ball("type hades; minDeltaT 5e-4;", 0.02),
        gravity
    );
    const std::string said = messageOf([&]() { c.run(1); });

    for
    (
        const char* const part :
        {
            "time 0.", "minDeltaT is 0.0005", "body 0 (ball)", "wall floor",
            "Largest overlap", "% of the smaller radius", "velocity",
            "neighbours: wall floor", "The state has been written"
        }
    )
    {
        EXPECT_NE(said.find(part), std::string::npos) << part << said;
    }
    EXPECT_EQ(c.nSaves(), 1);
    EXPECT_GT(c.state().x[0].z(), 0.0049);
}


TEST(demStep, fixedTooLarge)
{
    demCase c(ball("type fixed; deltaT 0.01;", 0.02), gravity);
    const std::string said = messageOf([&]() { c.run(1); });

    for
    (
        const char* const part :
        {"fixed deltaT is 0.01 s", "need a step of", "body 0", "time 0."}
    )
    {
        EXPECT_NE(said.find(part), std::string::npos) << part << said;
    }
    EXPECT_EQ(c.nSaves(), 1);
}


TEST(demStep, notANumber)
{
    for (const std::string type : {"hades", "fixed; deltaT 1e-4"})
    {
        demCase c(ball("type " + type + ";", 0.02), gravity);
        c.state().fluidForce[0].y() = std::nan("");
        const std::string said = messageOf([&]() { c.run(0.01); });
        EXPECT_NE(said.find("body 0"), std::string::npos) << said;
        EXPECT_NE(said.find("force of the fluid"), std::string::npos);
        EXPECT_EQ(c.nSaves(), 1);
    }
}


TEST(demStep, minimumIsNoTrap)
{
    // Fluid steps that are little above or below the smallest step
    for (const scalar part : {0.3, 0.99, 1.5, 1.99, 2.01})
    {
        demCase c
        (
            ball("type hades; maxDeltaT 1e-4; minDeltaT 9e-5;", 1),
            gravity
        );
        EXPECT_NO_THROW(c.run(part*1e-4));
        EXPECT_NO_THROW(c.run(part*1e-4));
    }
}


// ************************************************************************* //
