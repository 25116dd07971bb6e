/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.


Description
    What is found in a case before it runs, against closed forms, and what is
    advised.

\*---------------------------------------------------------------------------*/

#include "caseCheck.H"
#include "demCase.H"
#include "testMeshes.H"

using namespace Foam;
using namespace styxTest;

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

//- One glass ball of 10 mm in a box of 0.1 m with 20 cells along an edge
const std::string ball
(
    "demSolver hades;\n"
    "materials { glass { density 2500; youngsModulus 1e8;"
    " poissonsRatio 0.25; } }\n"
    "pairs { glass-glass { restitution 0.9; friction 0.3; } }\n"
    "shapes { ball { type sphere; diameter 0.01; } }\n"
);

const std::string oneBody
(
    "bodies { a { shape ball; material glass; position (0 0 0);"
    " velocity (1 0 0); } }\n"
);


class checkedCase
{
    blockMesh mesh_;
    coupling::cellBins bins_;
    demCase case_;
    caseCheck check_;

public:

    checkedCase(const std::string& dict, const caseCheck::surroundings& s)
    :
        mesh_(blockMesh::kind::hex, 0.1, 20),
        bins_(mesh_()),
        case_(dict),
        check_(mesh_(), bins_, case_.solver(), s, true)
    {}

    scalar operator[](const std::string& name) const
    {
        for (const caseCheck::figure& f : check_.figures())
        {
            if (f.name == name)
            {
                return f.value;
            }
        }
        ADD_FAILURE() << "no figure " << name;
        return 0;
    }

    //- Is there a line of advice with these words?
    bool advises(const std::string& words) const
    {
        for (const string& a : check_.advice())
        {
            if (a.find(words) != std::string::npos)
            {
                return true;
            }
        }
        return false;
    }

    label nAdvice() const
    {
        return check_.advice().size();
    }
};


caseCheck::surroundings water(const scalar deltaT)
{
    caseCheck::surroundings s;
    s.deltaT = deltaT;
    s.rho = 1000;
    s.nu = 1e-6;
    return s;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(caseCheck, closedForms)
{
    caseCheck::surroundings s;
    s.deltaT = 1e-3;
    const checkedCase c
    (
        ball + oneBody + "stepControl { type fixed; deltaT 1e-6; }", s
    );

    // Rayleigh: G = 4e7 Pa, 0.1631*0.25 + 0.8766 = 0.917375
    figureNear
    (
        "check_rayleighTime", c["rayleighTime"],
        M_PI*0.005*std::sqrt(2500/4e7)/0.917375, 1e-9, "s",
        "pi r sqrt(rho/G)/(0.1631 nu + 0.8766)"
    );

    // On a wall of glass at 1 m/s: the wall has the longer contact, the
    // other ball the shorter
    const double m = 2500*M_PI/6*1e-6;
    const double EStar = 0.5*1e8/(1 - 0.0625);
    const double D = std::pow
    (
        15*m/(16*EStar*std::sqrt(0.005)), 0.4
    );
    figureNear
    (
        "check_overlap", c["overlap"], 100*D/0.005, 1e-9, "%", "Hertz"
    );
    const double Dball = std::pow
    (
        15*0.5*m/(16*EStar*std::sqrt(0.0025)), 0.4
    );
    figureNear
    (
        "check_contactTime", c["contactTime"], 2.9432*min(D, Dball), 1e-4,
        "s", "2.9432 D/u"
    );
    figureNear
    (
        "check_domain", c["domainOverBody"], 10, 1e-9, "-", "0.1/0.01"
    );
    EXPECT_EQ(c.nAdvice(), 0);
}


TEST(caseCheck, fluid)
{
    const checkedCase c
    (
        ball + oneBody + "stepControl { type hades; }", water(1e-3)
    );
    figureNear
    (
        "check_cells", c["cellsOverDiameter"], 2, 1e-6, "-", "10 mm/5 mm"
    );
    figureNear
    (
        "check_relaxation", c["relaxationTime"], 3000*1e-4/(18*1e-3), 1e-9,
        "s", "(rho + rhof/2) d2/(18 mu)"
    );
    figureNear
    (
        "check_cellsPerStep", c["cellsPerStep"], 0.2, 1e-6, "-",
        "1 m/s, 1 ms, 5 mm"
    );
    EXPECT_TRUE(c.advises("2 cells over the diameter of ball of glass"));
    EXPECT_FALSE(c.advises("passes"));

    caseCheck::surroundings refined(water(1e-3));
    refined.levels = 3;
    const checkedCase r
    (
        ball + oneBody + "stepControl { type hades; }", refined
    );
    EXPECT_NEAR(r["cellsOverDiameter"], 16, 1e-6);
    EXPECT_FALSE(r.advises("cells over the diameter"));
    EXPECT_TRUE(r.advises("passes 1.6 cells"));

    const checkedCase slow
    (
        ball + oneBody + "stepControl { type hades; }", water(10)
    );
    EXPECT_TRUE(slow.advises("takes a body along"));
}


TEST(caseCheck, thinBodiesAndGaps)
{
    // A plate of 4 by 4 by 1 spheres of 3 mm on 5 mm cells, and two balls
    // half a cell apart (hard case 31)
    std::string plate(ball);
    std::string spheres;
    for (int i = 0; i < 16; ++i)
    {
        spheres +=
            "((" + std::to_string(0.003*(i % 4)) + ' '
          + std::to_string(0.003*(i/4)) + " 0) 0.0015) ";
    }
    plate.replace
    (
        plate.find("shapes {"), 8,
        "shapes { plate { type multisphere; spheres (" + spheres + "); }"
    );
    const std::string bodies
    (
        "bodies { a { shape ball; material glass; position (-0.01 0 0); }"
        " b { shape ball; material glass; position (0.0025 0 0); }"
        " c { shape plate; material glass; position (0 0.03 0); } }\n"
        "stepControl { type hades; }"
    );
    const checkedCase c(plate + bodies, water(1e-3));
    EXPECT_TRUE(c.advises("plate of glass is 0.003"));
    EXPECT_TRUE(c.advises("between two bodies is 0.0025 m, 0.5 cells"));
    figure
    (
        "hard31_thickness", c["cellsOverThickness"], 0.6, 0.8, "cells",
        "spheres of 0.6 cells side by side"
    );

    caseCheck::surroundings film(water(1e-3));
    film.film = true;
    EXPECT_FALSE(checkedCase(plate + bodies, film).advises("narrowest gap"));

    caseCheck::surroundings fine(water(1e-3));
    fine.levels = 3;
    const checkedCase f(plate + bodies, fine);
    EXPECT_FALSE(f.advises("thick"));
    EXPECT_FALSE(f.advises("narrowest gap"));
}


TEST(caseCheck, correctors)
{
    caseCheck::surroundings s(water(1e-3));
    s.nu = 1;
    s.nCorrectors = 2;
    const std::string dict(ball + oneBody + "stepControl { type hades; }");
    const checkedCase few(dict, s);
    figureNear
    (
        "check_diffusion", few["diffusionNumber"], 40, 1e-6, "-",
        "1 m2/s 1 ms/(5 mm)^2"
    );
    EXPECT_TRUE(few.advises("take 9,"));
    s.nCorrectors = 9;
    EXPECT_FALSE(checkedCase(dict, s).advises("nCorrectors"));
    s.nu = 1e-6;
    s.nCorrectors = 1;
    EXPECT_FALSE(checkedCase(dict, s).advises("nCorrectors"));
}


TEST(caseCheck, hops)
{
    // Cells of 5 mm, balls of oneBody
    caseCheck::surroundings s(water(1e-5));
    s.points = s.felt = s.hops = true;
    const std::string dict(ball + oneBody + "stepControl { type hades; }");
    const checkedCase fast(dict, s);
    EXPECT_TRUE(fast.advises("Take divided"));
    const scalar before = fast["hopOverSpeed"];
    s.deltaT = 1e-3;
    const checkedCase slow(dict, s);
    figureNear
    (
        "check_hops", before/slow["hopOverSpeed"], 100, 1e-9, "-",
        "by steps of a hundredth"
    );
    s.hops = false;
    s.deltaT = 1e-5;
    EXPECT_FALSE(checkedCase(dict, s).advises("Take divided"));
}


TEST(caseCheck, steps)
{
    caseCheck::surroundings s;
    s.deltaT = 1e-3;

    // Rayleigh time 1.354e-4 s, impact about 3e-4 s
    const checkedCase third
    (
        ball + oneBody + "stepControl { type fixed; deltaT 5e-5; }", s
    );
    EXPECT_TRUE(third.advises("% of the Rayleigh time"));
    EXPECT_FALSE(third.advises("the run will stop"));

    const checkedCase tooLarge
    (
        ball + oneBody + "stepControl { type fixed; deltaT 1e-3; }", s
    );
    EXPECT_TRUE(tooLarge.advises("the run will stop"));
}


TEST(caseCheck, softAndUnused)
{
    std::string soft(ball);
    soft.replace(soft.find("1e8"), 3, "1e4");
    soft.replace(soft.find("shapes {"), 8,
        "shapes { rock { type sphere; diameter 0.02; }");
    caseCheck::surroundings s;
    s.deltaT = 1e-3;
    const checkedCase c(soft + oneBody + "stepControl { type hades; }", s);
    EXPECT_TRUE(c.advises("Hertz' law holds up to 5 %"));
    EXPECT_TRUE(c.advises("No body and no generator has the shape rock"));
}


TEST(caseCheck, generators)
{
    const auto with = [](const std::string& box, const std::string& total)
    {
        return
            ball + "stepControl { type hades; }\n"
            "walls { floor { type plane; material glass; point (0 0 0);"
            " normal (0 0 1); } }\n"
            "generators { rain { type rate; shape ball; material glass;"
            " region { box " + box + "; } rate 10; total " + total
          + "; } }\n";
    };
    caseCheck::surroundings s;
    s.deltaT = 1e-3;

    const checkedCase good(with("(-0.02 -0.02 0.01) (0.02 0.02 0.04)", "5"), s);
    EXPECT_EQ(good.nAdvice(), 0);
    EXPECT_EQ(good["bodiesToCome"], 5);

    const checkedCase part(with("(-0.02 -0.02 0.01) (0.02 0.02 0.09)", "5"), s);
    EXPECT_TRUE(part.advises("lies outside of the mesh"));

    const checkedCase wall(with("(-0.02 -0.02 0) (0.02 0.02 0.004)", "5"), s);
    EXPECT_TRUE(wall.advises("finds no room"));

    const checkedCase many
    (
        with("(-0.02 -0.02 0.01) (0.02 0.02 0.04)", "2000"), s
    );
    EXPECT_TRUE(many.advises("% of the domain"));

    const std::string far
    (
        messageOf
        (
            [&]()
            {
                checkedCase c(with("(1 1 1) (2 2 2)", "5"), s);
            }
        )
    );
    EXPECT_NE(far.find("no mesh in the region of generator rain"),
        std::string::npos) << far;
}


TEST(caseCheck, outside)
{
    std::string far(oneBody);
    far.replace(far.find("(0 0 0)"), 7, "(0 0 9)");
    caseCheck::surroundings s;
    s.deltaT = 1e-3;
    const std::string said
    (
        messageOf
        (
            [&]()
            {
                checkedCase c
                (
                    ball + far + "stepControl { type hades; }", s
                );
            }
        )
    );
    EXPECT_NE(said.find("Body 0 (ball) starts at (0 0 9)"),
        std::string::npos) << said;

    // A body of a restart may have left in its last step
    s.restart = true;
    EXPECT_NO_THROW
    (
        checkedCase c(ball + far + "stepControl { type hades; }", s)
    );
}


// ************************************************************************* //
