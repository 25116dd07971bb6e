/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    Attraction that reaches beyond contact, against closed forms.

\*---------------------------------------------------------------------------*/

#include "demCase.H"

#include <cmath>

using namespace styxTest;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const scalar r = 0.001;
const scalar EStar = 1e7/(2*(1 - 0.09));
const scalar mass = 2000*4.0/3.0*M_PI*r*r*r;

//- Two balls on a line, or one and a plane
std::string balls
(
    const std::string& laws,
    const std::string& material,
    const std::string& pair,
    const std::string& bodies,
    const std::string& control = "type contact; contactFraction 0.02;"
)
{
    return
        std::string("demSolver hades;\n")
      + "contact { tangential none; damping "
      + (pair.find("dampingRatio") < pair.size() ? "critical; " : "none; ")
      + laws + " }\n"
        "materials\n{\n    rock { density 2000; youngsModulus 1e7;"
        " poissonsRatio 0.3; " + material + " }\n"
        "    board { youngsModulus 1e7; poissonsRatio 0.3; }\n}\n"
        "pairs { rock-rock { " + pair + " } rock-board { " + pair + " } }\n"
        "shapes { ball { type sphere; diameter 0.002; }"
        " large { type sphere; diameter 0.006; } }\n"
        "stepControl { " + control + " }\n"
        "bodies\n{\n" + bodies + "}\n";
}

const std::string plane
(
    "walls { board { type plane; point (0 0 0); normal (0 0 1);"
    " material board; } }\n"
);

std::string body
(
    const std::string& name,
    const std::string& shape,
    const vector& x,
    const vector& v
)
{
    return
        "    " + name + " { shape " + shape + "; material rock; position "
      + text(x) + "; velocity " + text(v) + "; }\n";
}

//- Of a bridge between surfaces at a distance l, with R = 2 R*
scalar bridge(const scalar R, const scalar v, const scalar l)
{
    const scalar s = l/(R*std::sqrt(v));
    return
        2*M_PI*R*0.07*std::cos(M_PI/6)/(1 + 1.05*s + 2.5*s*s);
}

//- How far it reaches
scalar longest(const scalar R, const scalar v)
{
    return
        R*(1 + M_PI/12)*(std::cbrt(v) + 0.1*std::pow(v, 2.0/3.0));
}

const std::string water
(
    "surfaceTension 0.07; contactAngle 30; bridgeVolume 1e-3;"
);

//- Run until two bodies are so far apart along x [m]; their speed [m/s]
scalar speedAt(demCase& c, const scalar distance, const scalar dt)
{
    for (int n = 0; n < 20000; ++n)
    {
        if (c.state().x[1].x() - c.state().x[0].x() > distance)
        {
            return c.state().v[1].x() - c.state().v[0].x();
        }
        c.run(dt);
    }
    return 0;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(demAttraction, capillaryAtWall)
{
    // Hangs on a plane: the limit of (2.17) is 4 pi r gamma cos theta
    const scalar F0 = bridge(2*r, 1e-3, 0);
    const scalar k = 4.0/3.0*EStar*std::sqrt(r);
    const auto height = [&](const scalar pull)
    {
        demCase c
        (
            balls
            (
                "cohesion capillary;", "",
                water + " dampingRatio 0.5;",
                body("a", "ball", {0, 0, r*(1 - 5e-4)}, {0, 0, 0}),
                "type hades;"
            )
          + plane
        );
        for (int n = 1; n <= 20; ++n)
        {
            c.state().fluidForce[0] = vector(0, 0, 0.05*n*pull);
            c.run(0.005);
        }
        c.run(0.05);
        return c.state().x[0].z();
    };
    figureNear
    (
        "capillary_rests", r - height(0), std::pow(F0/k, 2.0/3.0), 0.001, "m",
        "closed form (4 pi r gamma cos theta/k)^(2/3)"
    );
    figure
    (
        "capillary_holds", height(0.99*F0)/r, 0.9, 1, "r",
        "on at 0.99 of 4 pi r gamma cos theta"
    );
    figure
    (
        "capillary_comesOff", height(1.01*F0)/r, 1.2, noBar, "r",
        "off at 1.01"
    );
}


TEST(demAttraction, capillaryPair)
{
    // A small one leaves a large one: its bridge takes its work and ruptures
    const scalar R = 2*r*3*r/(4*r), v = 1e-3;
    const scalar lc = longest(R, v);
    scalar work = 0;
    const int steps = 20000;
    for (int n = 0; n < steps; ++n)
    {
        work += bridge(R, v, lc*(n + 0.5)/steps)*lc/steps;
    }
    const scalar mStar = mass*27/28;
    const scalar escape = std::sqrt(2*work/mStar);

    for (const scalar part : {0.9, 1.2})
    {
        demCase c
        (
            balls
            (
                "cohesion capillary;", "", water,
                body("a", "large", {-3*r, 0, 0}, {0, 0, 0})
              + body("b", "ball", {r*(1 - 1e-6), 0, 0}, {part*escape, 0, 0})
            )
        );
        if (part < 1)
        {
            c.run(0.05);
            figure
            (
                "capillary_caught",
                (c.state().x[1] - c.state().x[0]).x() - 4*r,
                -r, lc, "m", "bound below the escape velocity"
            );
            EXPECT_EQ(c.solver().history().pairsBridged.size(), 1);
            continue;
        }

        // Where it ruptures
        scalar gap = 0;
        while (c.solver().history().pairsBridged.size() || c.time() == 0)
        {
            c.run(1e-6);
            gap = (c.state().x[1] - c.state().x[0]).x() - 4*r;
            ASSERT_LT(gap, 2*lc);
        }
        figureNear
        (
            "capillary_ruptures", gap, lc, 0.01, "m",
            "(1 + theta/2)(v^1/3 + v^2/3/10) R, Willett et al. 2000"
        );
        figureNear
        (
            "capillary_work",
            std::sqrt(part*part - 1),
            speedAt(c, 4*r + 2*lc, 1e-4)/escape,
            0.005, "escape velocities",
            "work of the bridge in closed form; Willett et al. 2000"
        );
    }
}


TEST(demAttraction, capillaryNeedsTouch)
{
    // Passes at half of the reach, in a straight line
    const scalar lc = longest(r, 1e-3);
    demCase c
    (
        balls
        (
            "cohesion capillary;", "", water,
            body("a", "ball", {0, 0, 0}, {0, 0, 0})
          + body("b", "ball", {-3*r, 2*r + 0.5*lc, 0}, {0.1, 0, 0})
        )
    );
    c.run(0.06);
    figure
    (
        "capillary_passes", mag(c.state().v[1] - vector(0.1, 0, 0)), 0, 0,
        "m/s", "no bridge without touch"
    );
}


TEST(demAttraction, vanDerWaals)
{
    const scalar A = 1e-12, l0 = 1e-7, l1 = 1e-6;
    const std::string pair
    (
        "hamakerConstant 1e-12; minSeparation 1e-7; maxSeparation 1e-6;"
    );

    // Sticks to a plane
    const scalar F0 = A*r/(6*l0*l0);
    demCase c
    (
        balls
        (
            "cohesion vanDerWaals;", "", pair + " dampingRatio 0.5;",
            body("a", "ball", {0, 0, r}, {0, 0, 0}), "type hades;"
        )
      + plane
    );
    c.run(0.1);
    figureNear
    (
        "vanDerWaals_rests", r - c.state().x[0].z(),
        std::pow(F0/(4.0/3.0*EStar*std::sqrt(r)), 2.0/3.0), 0.001, "m",
        "closed form (A r/(6 l0^2)/k)^(2/3)"
    );

    // Two leave each other
    const scalar work = A*r/12*(1/l0 - 1/l1) + A*r/(12*l0*l0)*l0;
    const scalar escape = std::sqrt(2*work/(0.5*mass));
    demCase d
    (
        balls
        (
            "cohesion vanDerWaals;", "", pair,
            body("a", "ball", {-r, 0, 0}, {-0.6*escape, 0, 0})
          + body("b", "ball", {r*(1 + 1e-9), 0, 0}, {0.6*escape, 0, 0})
        )
    );
    figureNear
    (
        "vanDerWaals_work", speedAt(d, 2*r + 2*l1, 1e-4)/escape,
        std::sqrt(1.44 - 1), 0.01, "escape velocities",
        "A R/12 (1/l0 - 1/l1) + F0 l0 in closed form"
    );

    // And fall on each other from far, at several speeds: what the attraction
    // gives it takes again
    scalar worst = 0;
    for (const scalar speed : {0.3, 1.0, 5.0, 30.0})
    {
        const scalar u = speed*escape;
        demCase e
        (
            balls
            (
                "cohesion vanDerWaals;", "", pair,
                body("a", "ball", {-1.5*r, 0, 0}, {0.5*u, 0, 0})
              + body("b", "ball", {1.5*r, 0, 0}, {-0.5*u, 0, 0}),
                "type contact;"
            )
        );
        e.run(4*r/u);
        const scalar end = e.state().v[1].x() - e.state().v[0].x();
        worst = std::max(worst, std::abs(end*end - u*u)/(u*u + escape*escape));
    }
    figure
    (
        "vanDerWaals_energy", worst, 0, 0.02,
        "of the kinetic energy at contact", "elastic: leaves as it came"
    );
}


TEST(demAttraction, electrostatic)
{
    // Opposite charges on a circle around each other
    const scalar d = 3*r, sigma = 1e-4;
    const scalar q = 4*M_PI*r*r*sigma;
    const scalar k = q*q/(4*M_PI*8.8541878128e-12*2);
    const scalar speed = std::sqrt(k/(0.5*mass*d));
    std::string dict = balls
    (
        "cohesion electrostatic; chargeCutOff 0.05; relativePermittivity 2;",
        "surfaceCharge 1e-4;", "",
        body("a", "ball", {-0.5*d, 0, 0}, {0, -0.5*speed, 0})
      + body("b", "ball", {0.5*d, 0, 0}, {0, 0.5*speed, 0}),
        "type contact; maxDeltaT 2e-4;"
    );
    const auto change = [&](const std::string& from, const std::string& to)
    {
        const size_t at = dict.find(from);
        ASSERT_NE(at, std::string::npos);
        dict.replace(at, from.size(), to);
    };
    change("board {", "other { density 2000; youngsModulus 1e7;"
        " poissonsRatio 0.3; surfaceCharge -1e-4; } board {");
    change("rock-board {  }", "rock-other {} other-other {} rock-board {}"
        " other-board {}");
    const size_t b = dict.find("material rock", dict.find("    b {"));
    dict.replace(b, 13, "material other");

    demCase c(dict);
    const scalar period = 2*M_PI*d/speed;
    c.run(period);
    figure
    (
        "electrostatic_orbit",
        mag(c.state().x[1] - vector(0.5*d, 0, 0))/d,
        0, 0.01, "of the distance", "Kepler's circle after a turn"
    );

    // Equal charges repel each other
    demCase e
    (
        balls
        (
            "cohesion electrostatic; chargeCutOff 0.05;",
            "surfaceCharge 1e-4;", "",
            body("a", "ball", {-1.5*r, 0, 0}, {0, 0, 0})
          + body("b", "ball", {1.5*r, 0, 0}, {0, 0, 0})
        )
    );
    const scalar far = 20*r;
    const scalar v = speedAt(e, far, 1e-5);
    const scalar at = e.state().x[1].x() - e.state().x[0].x();
    figureNear
    (
        "electrostatic_repels", v,
        std::sqrt(2*2*k*(1/d - 1/at)/(0.5*mass)), 0.001, "m/s",
        "energy in closed form"
    );
}


TEST(demAttraction, throughSeams)
{
    // A pair at the sides of a box that repeats itself in all directions moves
    // as the same pair in the open, and crosses the seam meanwhile
    const scalar w = 0.05;
    const auto repeated = [&](Foam::dem::demInput& input)
    {
        for (Foam::direction d = 0; d < 3; ++d)
        {
            Foam::dem::periodicity::seam s;
            s.normal = Foam::Zero;
            s.normal[d] = 1;
            s.low = 0;
            s.separation = w*s.normal;
            input.period.append(s);
        }
    };
    struct law
    {
        std::string name, laws, material, pair;
        scalar gap;
        vector v;
    };
    const law laws[] =
    {
        {
            "electrostatic", "cohesion electrostatic; chargeCutOff 0.01;",
            "surfaceCharge 1e-4;", "", r, {-0.05, 0.02, 0.01}
        },
        {
            "vanDerWaals", "cohesion vanDerWaals;", "",
            "hamakerConstant 1e-14; minSeparation 1e-7;", 3e-7,
            {-0.02, 0, 1e-3}
        }
    };
    const std::string fixed("type fixed; deltaT 1e-6;");
    for (const law& l : laws)
    {
        // At the corner of the box, of which the far side is around the first
        const vector n = vector(2, 1, 2)/3;
        const point middle(1e-4, 0.3*w, w - 2e-4);
        const point a = middle - (r + 0.5*l.gap)*n;
        const point b = middle + (r + 0.5*l.gap)*n;
        const auto inBox = [&](point x)
        {
            for (Foam::direction d = 0; d < 3; ++d)
            {
                x[d] -= w*std::floor(x[d]/w);
            }
            return x;
        };
        demCase open
        (
            balls(l.laws, l.material, l.pair,
                body("a", "ball", a, l.v) + body("b", "ball", b, l.v), fixed)
        );
        demCase seam
        (
            balls(l.laws, l.material, l.pair,
                body("a", "ball", inBox(a), l.v)
              + body("b", "ball", inBox(b), l.v), fixed),
            Foam::Zero,
            Foam::List<Foam::dem::corners>(),
            repeated
        );
        open.run(1e-9);
        seam.run(1e-9);
        const vector v0 = open.state().v[0];
        scalar worst = 0, change = 0;
        for (int k = 0; k < 40; ++k)
        {
            open.run(2.5e-4);
            seam.run(2.5e-4);
            for (const label i : {0, 1})
            {
                worst = std::max
                (
                    worst,
                    mag(seam.state().v[i] - open.state().v[i])
                );
            }
            change = std::max(change, mag(open.state().v[0] - v0));
        }

        // A coordinate of 0.05 m is rounded by 7e-18 m, 1e-10 of the gaps of
        // van der Waals' forces, and each of the impacts makes that larger
        figure
        (
            "seam_" + l.name, worst/change, 0, l.gap < 1e-6 ? 1e-6 : 1e-9,
            "of the change of velocity", "the same pair without a seam"
        );
        EXPECT_GT(change, 1e-4);
        EXPECT_GT(mag(seam.state().x[0] - open.state().x[0]), 0.9*w);
    }
}


TEST(demAttraction, chargedClump)
{
    // The charge of a body is in the centre of its one sphere
    std::string dict = balls
    (
        "cohesion electrostatic; chargeCutOff 0.01;", "surfaceCharge 1e-4;",
        "", body("a", "ball", {0, 0, 0}, {0, 0, 0})
    );
    const size_t at = dict.find("large {");
    dict.replace(at, 7, "two { type multisphere; spheres (((0 0 0) 0.001)"
        " ((0.001 0 0) 0.001)); } large {");
    const std::string why(messageOf([&]() { demCase c(dict); }));
    for (const std::string word : {"electrostatic", "shape two", "several"})
    {
        EXPECT_NE(why.find(word), std::string::npos) << word << ": " << why;
    }
}


// ************************************************************************* //
