/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description

Description
    Wrong input stops with the file, the line, the keyword and what is
    allowed.

\*---------------------------------------------------------------------------*/

#include "demCase.H"

#include <algorithm>

using namespace styxTest;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const std::string good
(
    "demSolver hades;\n"
    "contact { normal hertz; tangential mindlin; damping restitution; }\n"
    "materials\n{\n"
    "rock { density 2500; youngsModulus 1e7; poissonsRatio 0.3; }\n"
    "steel { density 7800; youngsModulus 2e11; poissonsRatio 0.3; }\n"
    "board { youngsModulus 1e7; poissonsRatio 0.3; }\n}\n"
    "pairs\n{\n"
    "rock-rock { restitution 0.5; friction 0.3; }\n"
    "rock-steel { restitution 0.5; friction 0.3; }\n"
    "steel-steel { restitution 0.5; friction 0.3; }\n"
    "rock-board { restitution 0.5; friction 0.3; }\n"
    "board-steel { restitution 0.5; friction 0.3; }\n}\n"
    "shapes { ball { type sphere; diameter 0.01; } }\n"
    "integrator stormerVerlet;\n"
    "neighbours { type verletList; skin 0.1; }\n"
    "stepControl { type hades; safety 0.8; }\n"
    "walls { floor { type plane; point (0 0 0); normal (0 0 1);"
    " material board; } }\n"
    "bodies\n{\n"
    "a { shape ball; material rock; position (0 0 0.01); }\n"
    "b { shape ball; material steel; position (0 0 0.03); }\n}\n"
    "generators { pipe { type rate; shape ball; material rock;"
    " region { box (0 0 1) (1 1 2); } rate 1; total 3; } }\n"
);


//- The good case with one thing changed must stop; the message holds each of
//  the parts, the file, and its line unless it is another dictionary's
void spoil
(
    const std::string& from,
    const std::string& to,
    const std::vector<std::string>& parts,
    const bool atItsLine = true
)
{
    std::string bad = good;
    const size_t at = bad.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    bad.replace(at, from.size(), to);

    const std::string said = messageOf([&]() { demCase c(bad); });
    EXPECT_NE(said, "") << to << ": no error";
    EXPECT_NE(said.find("file: demCloudProperties"), std::string::npos)
        << said;
    if (atItsLine)
    {
        const std::string line =
            "at line "
          + std::to_string(1 + std::count(bad.begin(), bad.begin() + at, '\n'))
          + ".";
        EXPECT_NE(said.find(line), std::string::npos) << line << said;
    }
    for (const std::string& part : parts)
    {
        EXPECT_NE(said.find(part), std::string::npos)
            << '"' << part << "\" is not in: " << said;
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(demInput, good)
{
    EXPECT_NO_THROW(demCase c(good));
}


TEST(demInput, unknownKeyword)
{
    spoil("safety 0.8", "saefty 0.8", {"saefty", "safety", "minDeltaT"});
    spoil("damping rest", "damper rest", {"damper", "damping", "normal"});
    spoil("skin 0.1", "skim 0.1", {"skim", "skin"});
    spoil("density 2500", "densty 2500", {"densty", "density"});
    spoil("friction 0.3", "frction 0.3", {"frction", "friction"});
    spoil("normal (0 0 1)", "normal (0 0 1); colour red",
        {"colour", "point", "material"});
    spoil("position (0 0 0.01)", "position (0 0 0.01); speed 1",
        {"speed", "velocity", "rotation"});
    spoil("total 3", "total 3; sed 1", {"sed", "seed"});
    spoil("rock-rock", "rock-wood", {"rock-wood", "rock-rock"});
}


TEST(demInput, wrongChoice)
{
    spoil("demSolver hades", "demSolver zeus", {"zeus", "fixed", "hades"});
    spoil("normal hertz", "normal herz", {"herz", "hertz", "hooke"});
    spoil("normal hertz", "instructions avx3; normal hertz",
        {"avx3", "auto", "sse2", "avx2", "avx512"});
    spoil("mindlin", "mindless", {"mindless", "none", "coulomb", "mindlin"});
    spoil("damping restitution", "damping some",
        {"some", "none", "hades", "critical", "restitution"});
    spoil("damping restitution;", "damping restitution; pulling maybe;",
        {"pulling", "maybe", "yes", "no"});
    spoil("integrator stormerVerlet;",
        "integrator stormerVerlet; start relaxed;",
        {"start", "relaxed", "asGiven", "relax"});
    spoil("stormerVerlet", "euler", {"euler", "stormerVerlet"});
    spoil("type verletList", "type none", {"none", "verletList"});
    spoil("type hades", "type variable", {"variable", "fixed", "hades"});
    spoil("type plane", "type wavy", {"wavy", "patch", "plane"});
    spoil("material board", "material bord", {"bord", "board", "rock"});
    spoil("shape ball", "shape bal", {"bal", "ball"});
    spoil("type rate", "type flood", {"flood", "batch", "fill", "rate"});
}


TEST(demInput, pairs)
{
    spoil
    (
        "rock-steel { restitution 0.5; friction 0.3; }",
        "",
        {"rock", "steel", "missing", "rock-steel", "restitution", "friction"},
        false
    );
    spoil
    (
        "rock-board { restitution 0.5; friction 0.3; }",
        "",
        {"board", "rock", "missing"},
        false
    );
    spoil
    (
        "board-steel {",
        "steel-rock { restitution 0.5; friction 0.3; }\nboard-steel {",
        {"steel-rock", "rock-steel", "once more"}
    );
    spoil
    (
        "rock-rock { restitution 0.5; friction 0.3; }",
        "rock-rock { restitution 0.5; }",
        {"friction"}
    );
}


TEST(demInput, entriesOfLaws)
{
    spoil("normal hertz", "normal hooke", {"normalStiffness"}, false);
    spoil("tangential mindlin;", "tangential none; rolling constant;",
        {"rolling", "friction", "tangential none"});
    spoil("tangential mindlin;", "tangential none; torsion constant;",
        {"torsion", "friction", "tangential none"});
    spoil("normal hertz;", "normal hertz; rolling constant;",
        {"rollingFriction"}, false);
    spoil("normal hertz;", "normal hertz; torsion constant;",
        {"torsionalFriction"}, false);
    spoil("normal hertz;", "normal hertz; cohesion simplifiedJKR;",
        {"cohesionEnergyDensity"}, false);
    spoil("normal hertz;", "normal hertz; cohesion glue;",
        {"glue", "none", "simplifiedJKR"});
    spoil("normal hertz;", "normal hertz; rolling some;",
        {"some", "none", "constant"});
    spoil("normal hertz;", "normal hertz; rolling elasticPlastic;",
        {"rollingFriction"}, false);
    spoil("rock-rock { rest", "rock-rock { rollingDampingRatio 0.5; rest",
        {"rollingDampingRatio", "friction", "restitution"});
    spoil("normal hertz;", "normal hertz; multiContact split;",
        {"split", "none", "share"});
    spoil("normal hertz;", "normal hertz; cohesion capillary;",
        {"contactAngle"}, false);
    spoil("normal hertz;", "normal hertz; cohesion vanDerWaals;",
        {"hamakerConstant"}, false);
    spoil("normal hertz;", "normal hertz; cohesion electrostatic;",
        {"chargeCutOff"}, false);
    spoil("normal hertz;",
        "normal hertz; cohesion electrostatic; chargeCutOff 1e-3;",
        {"surfaceCharge"}, false);
    spoil("normal hertz;", "normal hertz; chargeCutOff 1e-3;",
        {"chargeCutOff", "electrostatic only"});
    spoil("normal hertz;",
        "normal hertz; cohesion (simplifiedJKR vanDerWaals);",
        {"simplifiedJKR", "vanDerWaals", "one of them"});
    spoil("normal hertz;", "normal hertz; cohesion (capillary capillary);",
        {"capillary", "twice"});
    spoil("normal hertz;", "normal hertz; cohesion (capillary none);",
        {"none", "capillary electrostatic simplifiedJKR vanDerWaals"});
    spoil("damping restitution;", "damping none; pulling no;",
        {"pulling", "dashpot"});
    spoil("damping restitution;", "damping hades;",
        {"restitution", "normalDamping", "tangentialDamping"}, false);
    spoil("tangential mindlin; damping restitution;",
        "tangential coulomb; damping hades;",
        {"Allowed keywords: friction normalDamping"}, false);
    spoil("rock-rock { rest", "rock-rock { normalStiffness 1e5; rest",
        {"normalStiffness", "friction", "restitution"});
    spoil("rock-rock { rest", "rock-rock { dampingRatio 0.5; rest",
        {"dampingRatio", "friction", "restitution"});
}


TEST(demInput, values)
{
    spoil("density 2500", "density -2500", {"density", "-2500", "greater"});
    spoil("density 2500", "density 0", {"density", "greater than zero"});
    spoil("Modulus 1e7", "Modulus nan", {"youngsModulus", "nan"});
    spoil("Ratio 0.3", "Ratio 0.6", {"poissonsRatio", "0.6", "0 to 0.5"});
    spoil("restitution 0.5;", "restitution 1.1;",
        {"restitution", "1.1", "from 0 to 1"});
    spoil("restitution 0.5;", "restitution 0;", {"restitution", "0.001"});
    spoil("friction 0.3", "friction -0.3", {"friction", "-0.3", "zero or"});
    spoil("(0 0 0.01)", "(0 nan 0.01)", {"position", "nan"});
    spoil("(0 0 0.01)", "(0 inf 0.01)", {"position", "inf"});
    spoil("(0 0 0.01)", "(0 0 0.01); rotation ((0 0 0) 9)",
        {"rotation", "axis"});
    spoil("(0 0 0.01)", "(0 0 0.01); rotation ((0 0 1) nan)",
        {"rotation", "nan"});
    spoil("normal (0 0 1)", "normal (0 0 0)", {"normal", "length"});
    spoil("safety 0.8", "safety 1", {"safety", "0.99"});
    spoil("skin 0.1", "skin 0", {"skin", "greater than zero"});
    spoil("rate 1;", "rate 0;", {"rate", "greater than zero"});
    spoil("total 3", "total -3", {"total", "-3", "0 or greater"});
    spoil("(1 1 2)", "(1 1 0.5)", {"box", "smallest"});
    spoil("(1 1 2)", "(1 1 nan)", {"box"});
    spoil("material rock; position", "material board; position",
        {"material", "density"});
}


TEST(demInput, missing)
{
    spoil("poissonsRatio 0.3", "", {"poissonsRatio"});
    spoil("stepControl {", "stepKontrol {", {"stepControl"}, false);
    spoil("position (0 0 0.01);", "", {"position"});
    spoil("shapes { ball { type sphere; diameter 0.01; } }", "shapes {}",
        {"no shape"}, false);
}


TEST(demInput, overlapAtTheStart)
{
    spoil("(0 0 0.03)", "(0 0 0.019)",
        {"body 0 (ball)", "body 1 (ball)", "overlap", "20 %"}, false);
    spoil("(0 0 0.03)", "(0 0 0.01)", {"body 0", "body 1", "overlap"}, false);
    spoil("(0 0 0.01)", "(0 0 0.004)", {"body 0", "wall floor", "20 %"}, false);
    spoil("(0 0 0.01)", "(0 0 -1)", {"body 0", "wall floor"}, false);
}


// ************************************************************************* //
