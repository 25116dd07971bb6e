/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    How neighbours are found does not change what comes out, and the skin that
    auto chooses is the best by its clock.

\*---------------------------------------------------------------------------*/

#include "demCase.H"
#include "skinTuner.H"

#include <cmath>
#include <random>

using namespace styxTest;
using namespace Foam::dem;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Balls of three sizes and cubes that fall onto each other in a box
std::string heap(const std::string& neighbours)
{
    std::mt19937 random(4);
    const auto uniform = [&]() { return random()/2147483648.0 - 1; };
    std::string shapes = cubeOfNine;
    shapes.insert
    (
        shapes.find('{') + 1,
        " b0 { type sphere; diameter 0.012; }"
        " b1 { type sphere; diameter 0.006; }"
        " b2 { type sphere; diameter 0.0012; } "
    );
    std::string dict =
        "demSolver hades;\nmaterials { stuff { density 2500;"
        " youngsModulus 1e6; poissonsRatio 0.3; } }\n"
        "pairs { stuff-stuff { restitution 0.5; friction 0.5; } }\n" + shapes
      + "stepControl { type fixed; deltaT 2e-5; }\n" + neighbours
      + "walls { box { type box; min (-0.05 -0.05 0); max (0.05 0.05 1);"
        " side inside; material stuff; } }\nbodies\n{\n";
    for (label k = 0; k < 240; ++k)
    {
        const vector cell(k % 6 - 2.5, k/6 % 6 - 2.5, k/36 + 0.6);
        const vector shake(uniform(), uniform(), uniform());
        const vector v(uniform(), uniform(), uniform());
        dict += "p" + std::to_string(k) + " { shape "
          + (k % 4 == 3 ? "cube" : "b" + std::to_string(k % 3))
          + "; material stuff; position " + text(0.0155*cell + 5e-4*shake)
          + "; velocity " + text(0.3*v) + "; }\n";
    }
    return dict + "}\n";
}


//- Time of a step with a skin, made up: more pairs for a wider one, and a list
//  that costs twenty sweeps, when bodies have moved by half of it at this speed
scalar madeUp(const scalar skin, const scalar speed)
{
    return 1 + 3*skin + 20*(skin > 2*speed ? 2*speed/skin : 1);
}


//- The skin that is chosen after so many windows
scalar chosen(skinTuner& tuner, const scalar speed, const label nWindows)
{
    for (label n = 0; n < nWindows; ++n)
    {
        for (label k = 0; k < 3; ++k)
        {
            tuner.built();
        }
        tuner.windowDone(madeUp(tuner.skin(), speed));
    }
    return tuner.skin();
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(demSkin, sameResult)
{
    demCase usual(heap(""), gravity);
    usual.run(0.15);
    EXPECT_GT(usual.solver().report().nContacts, 200);

    scalar worst = 0;
    for
    (
        const char* const other :
        {
            "type verletList; skin 0.5;",
            "type linkCell;",
            "type auto;"
        }
    )
    {
        demCase c(heap(std::string("neighbours { ") + other + " }\n"), gravity);
        c.run(0.15);
        EXPECT_EQ(c.solver().report().nContacts,
            usual.solver().report().nContacts) << other;
        for (label b = 0; b < 240; ++b)
        {
            worst = std::max
            (
                worst,
                mag(c.state().x[b] - usual.state().x[b])/0.01
              + mag(c.state().v[b] - usual.state().v[b])
            );
        }
    }
    figure("neighboursSame", worst, 0, 1e-9, "-",
        "places and velocities with skin 0.5, linkCell and auto, 7,500 steps");
}


TEST(demSkin, best)
{
    // The best rung of the ladder for lists that cost more or less, and after
    // that has changed
    skinTuner tuner(false);
    const scalar rungs[] = {0, 0.02, 0.035, 0.06, 0.1, 0.17, 0.3, 0.5, 0.8};
    scalar worst = 0;
    for (const scalar speed : {1e-3, 1e-5, 0.5, 0.02, 1e-3})
    {
        // It may have to walk over the whole ladder, from rest to rest
        scalar best = Foam::GREAT;
        for (const scalar skin : rungs)
        {
            best = std::min(best, madeUp(skin, speed));
        }
        const scalar skin = chosen(tuner, speed, 170);
        worst = std::max(worst, madeUp(skin, speed)/best - 1);
    }
    figure("neighboursAuto", worst, 0, 0.04, "-",
        "time of the skin that is chosen over the best, after 170 windows");
}


TEST(demSkin, noListNoWindow)
{
    // Without a new list a window says nothing, until it is long
    skinTuner tuner(false);
    for (label n = 0; n < 19999; ++n)
    {
        EXPECT_FALSE(tuner.stepped());
    }
    EXPECT_TRUE(tuner.stepped());
}


TEST(demSkin, wrongEntries)
{
    const auto says = [](const std::string& entries)
    {
        return messageOf([&]()
        {
            demCase c(heap("neighbours { " + entries + " }\n"));
        });
    };
    const std::string type = says("type cells;");
    for (const char* const part : {"cells", "verletList", "linkCell", "auto"})
    {
        EXPECT_NE(type.find(part), std::string::npos) << part << type;
    }
    EXPECT_NE(says("type linkCell; skin 0.1;").find("skin"), std::string::npos);
    EXPECT_NE(says("type auto; skin 0.1;").find("skin"), std::string::npos);
}


// ************************************************************************* //
