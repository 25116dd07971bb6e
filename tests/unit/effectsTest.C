/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    Which effects a scene calls for: the numbers against closed forms, and
    twelve scenes with a known answer.

\*---------------------------------------------------------------------------*/

#include "effectTable.H"
#include "effectWatch.H"
#include "demCase.H"
#include "figure.H"
#include "sceneSurvey.H"
#include "StringStream.H"
#include "wordList.H"

#include <cmath>

using namespace Foam;
using namespace styxTest;

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

const scalar target = 0.05;

const effectLaw& law(const std::string& name)
{
    for (const effectLaw& l : effectLaws::all())
    {
        if (l.name == name)
        {
            return l;
        }
    }
    throw std::runtime_error("no law " + name);
}


scalar valueOf(const std::string& name, const sceneNumbers& n)
{
    return law(name).value(n);
}


//- A sphere in a fluid, at its terminal velocity
sceneNumbers falling
(
    const scalar d,
    const scalar rhoP,
    const scalar rhoF,
    const scalar nu,
    const scalar fraction
)
{
    sceneNumbers n;
    n.d = d;
    n.rhoP = rhoP;
    n.rhoF = rhoF;
    n.nu = nu;
    n.g = 9.81;
    n.nBodies = 1000;
    n.meanFraction = fraction;
    n.fraction = fraction;
    n.cell = 5*d;
    n.slip = n.terminalSlip();
    return n;
}


//- Powder without a fluid
sceneNumbers powder(const scalar d)
{
    sceneNumbers n;
    n.d = d;
    n.rhoP = 1500;
    n.g = 9.81;
    n.nBodies = 1000;
    n.meanFraction = 0.3;
    n.fraction = 0.3;
    n.walls = true;
    return n;
}


//- A solid in a fluid with so many cells over its diameter
sceneNumbers solid(const scalar d, const scalar rhoP, const scalar cells)
{
    sceneNumbers n(falling(d, rhoP, 1000, 1e-6, 0));
    n.cell = d/cells;
    n.nBodies = 1;
    return n;
}


//- How many effects of the lists are not as they should be
void scene
(
    const std::string& name,
    const sceneNumbers& n,
    const wordList& on,
    const wordList& off
)
{
    const effectTable table(List<sceneNumbers>(1, n), target);
    label wrong = 0;
    for (const word& w : on)
    {
        if (!table.on(w))
        {
            ++wrong;
            ADD_FAILURE() << name << ": " << w << " is off, share "
                << table.share(w);
        }
    }
    for (const word& w : off)
    {
        if (table.on(w))
        {
            ++wrong;
            ADD_FAILURE() << name << ": " << w << " is on, share "
                << table.share(w);
        }
    }
    figure
    (
        "scene_" + name, wrong, 0, 0,
        "wrong of " + std::to_string(on.size() + off.size()) + " effects",
        "the scene's known answer"
    );
}


//- All forces on points
const wordList pointForces
({
    "drag", "buoyancy", "pressureGradient", "viscous", "virtualMass", "basset",
    "saffman", "magnus", "rotationalDrag"
});

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(effects, numbers)
{
    sceneNumbers n(falling(1e-4, 2000, 1, 1e-5, 0));

    // Stokes' velocity with the factor at its own Reynolds number
    const scalar W = (2000 - 1)*M_PI/6*1e-12*9.81;
    figureNear("effects_drag", n.drag(), W, 1e-9, "N", "drag = weight");
    figureNear
    (
        "effects_f", n.f(), 1 + 0.15*std::pow(n.slip*1e-4/1e-5, 0.687), 1e-9,
        "-", "Schiller & Naumann"
    );
    figureNear
    (
        "effects_relaxation", n.relaxationTime(),
        2000.5*1e-8/(18*1e-5*n.f()), 1e-9, "s", "closed form"
    );

    n.fraction = 0.4;
    figureNear
    (
        "effects_crowding", valueOf("denseDrag", n), std::pow(0.6, -2.65) - 1,
        1e-9, "-", "Wen & Yu"
    );
    n.shear = 100;
    const scalar lambda = 1/(std::cbrt(0.74/0.4) - 1);
    figureNear
    (
        "effects_Bagnold", n.Bagnold(),
        2000*1e-8*std::sqrt(lambda)*100/1e-5, 1e-9, "-", "Bagnold 1954"
    );
}


TEST(effects, shares)
{
    // Where drag is slow and balances the weight
    sceneNumbers n(falling(1e-5, 2000, 1, 1e-5, 0));
    n.shear = 10;
    n.spin = 20;

    figureNear
    (
        "effects_virtualMass", valueOf("virtualMass", n), 0.5/2000, 1e-9, "-",
        "rho_f/(2 rho_p)"
    );
    figureNear
    (
        "effects_basset", valueOf("basset", n),
        std::sqrt(9/(4001*n.f())), 1e-9, "-", "history over drag"
    );

    // Saffman's force and Rubinow and Keller's over the drag
    const scalar drag = 3*M_PI*1e-5*1e-5*n.f()*n.slip;
    figureNear
    (
        "effects_saffman", valueOf("saffman", n),
        1.615*sqr(1e-5)*std::sqrt(1e-5*10)*n.slip/drag, 2e-3, "-",
        "force over force"
    );
    figureNear
    (
        "effects_magnus", valueOf("magnus", n),
        M_PI/8*pow3(1e-5)*20*n.slip/drag, 1e-3, "-", "force over force"
    );

    // Fast and spinning fast: the measured coefficient over Cd = 0.44
    sceneNumbers ball(falling(0.04, 80, 1.2, 1.5e-5, 0));
    ball.slip = 10;
    ball.spin = 3000;
    ball.g = 0;
    figureNear
    (
        "effects_magnusFast", valueOf("magnus", ball), 0.45/0.44, 1e-3, "-",
        "C_LR = 0.45"
    );

    // The bar of a number of its own counts as the target
    n.fraction = 2e-3;
    figureNear
    (
        "effects_bar", law("contacts").share(n, target), 2*target, 1e-9, "-",
        "Elghobashi's bound twice"
    );
}


TEST(effects, turbulence)
{
    // A grain that falls through long eddies, at its terminal velocity
    sceneNumbers n(falling(1e-4, 2500, 1.2, 1.5e-5, 0));
    n.turbulent = true;
    figure
    (
        "effects_noTurbulence", valueOf("dispersion", n), 0, 0, "-",
        "a field of nothing"
    );
    n.k = 1.5*sqr(0.1);
    n.epsilon = n.k/100;
    const scalar T = 15/std::sqrt(1 + sqr(n.slip/0.1));
    const scalar v = 0.1*std::sqrt(T/(T + n.relaxationTime()));
    figureNear
    (
        "effects_dispersion", valueOf("dispersion", n),
        v/std::hypot(v, n.slip), 1e-9, "-", "Tchen, Csanady"
    );

    // Dust that follows is carried by nothing else
    n.slip = 1e-6;
    n.g = 0;
    figureNear
    (
        "effects_dispersionDust", valueOf("dispersion", n), 1, 1e-3, "-",
        "no slip"
    );

    // A ball of 10 mm does not feel eddies of 10 ms
    sceneNumbers ball(falling(0.01, 2500, 1.2, 1.5e-5, 0));
    ball.turbulent = true;
    ball.k = 1.5*sqr(0.1);
    ball.epsilon = ball.k/0.01;
    figure
    (
        "effects_dispersionBall", valueOf("dispersion", ball), 0, 0.2*target,
        "-", "far below the target"
    );
}


TEST(effects, survey)
{
    // Three balls of 10 mm in one block of 0.1 m, and one far away
    const std::string ball(" { shape ball; material s; position ");
    demCase bodies
    (
        "demSolver hades;\n"
        "materials { s { density 2500; youngsModulus 1e7;"
        " poissonsRatio 0.25; } }\n"
        "pairs { s-s { restitution 0.9; friction 0.3; } }\n"
        "shapes { ball { type sphere; diameter 0.01; } }\n"
        "stepControl { type hades; }\n"
        "bodies { a" + ball + "(0.02 0.02 0.02); } b" + ball
      + "(0.05 0.02 0.02); } c" + ball + "(0.09 0.09 0.09); } d" + ball
      + "(0.55 0.05 0.05); } }\n"
    );
    const dem::bodies& state = bodies.solver().state();

    // Each of the three has two others, the fourth none
    const scalar ballVolume = M_PI/6*1e-6;
    figureNear
    (
        "effects_crowd", sceneSurvey::crowd(state, 0.1),
        3*2*ballVolume/1e-3/4, 1e-9, "-", "others in the block"
    );
    figureNear
    (
        "effects_gap", sceneSurvey::smallestGap(state), 0.02, 1e-9, "m",
        "30 mm less a diameter"
    );
}


TEST(effects, watch)
{
    dictionary dict;
    dict.add("effects", dictionary(IStringStream
    (
        "type auto; targetError 0.05; interval 3;"
    )()));
    effectWatch watch((effectInput(dict)));
    watch.add("magnus", false);
    watch.add("basset", true);
    watch.add("drag", true);
    const auto sample = [](const scalar magnus)
    {
        HashTable<scalar> shares;
        shares.set("magnus", magnus);
        shares.set("basset", 0);
        shares.set("drag", 0);
        return shares;
    };

    // Below the target it stays off, above it is on at once
    label n = watch.judge(sample(0.049)).size();
    n += watch.judge(sample(0.051)).size();
    figure("effectWatch_on", n == 1 && watch.on("magnus"), 1, 1, "-", "target");

    // It takes ten thorough samples far below, one after the other
    label exchanges = 0;
    const auto untilOff = [&](const scalar share)
    {
        exchanges = 0;
        while (watch.on("magnus") && exchanges < 100)
        {
            watch.judge(sample(share));
            ++exchanges;
        }
    };
    untilOff(0.011);
    figure("effectWatch_keeps", exchanges, 100, 100, "exchanges", "> E/5");

    // What is saved goes on as if nothing had happened
    for (label i = 0; i < 10; ++i)
    {
        watch.judge(sample(0.009));
    }
    effectWatch other((effectInput(dict)));
    other.add("magnus", false);
    other.add("basset", false);
    other.setState(watch.state());
    untilOff(0.009);
    const label here = exchanges;
    for (exchanges = 0; other.on("magnus"); ++exchanges)
    {
        other.judge(sample(0.009));
    }
    figure("effectWatch_restart", exchanges - here, 0, 0, "-", "the same");
    figure
    (
        "effectWatch_off", here + 10, 28, 30, "exchanges",
        "ten samples, one in three"
    );
    figure("effectWatch_basset", watch.on("basset"), 1, 1, "-", "keeps memory");
    figure("effectWatch_drag", watch.on("drag"), 1, 1, "-", "slips stay small");
}


TEST(effects, scenesOfPoints)
{
    scene
    (
        "1_dust", falling(50e-6, 2500, 1.2, 1.5e-5, 1e-7), {"drag"},
        {
            "contacts", "virtualMass", "basset", "pressureGradient", "saffman",
            "magnus", "rotation", "exchange"
        }
    );
    scene
    (
        "2_sand", falling(0.5e-3, 2650, 1000, 1e-6, 1e-4),
        {"drag", "buoyancy", "virtualMass", "basset", "exchange"},
        {"contacts", "saffman", "magnus", "rotation"}
    );

    sceneNumbers line(falling(200e-6, 2500, 1.2, 1.5e-5, 5e-4));
    line.shear = 3000;
    line.walls = true;
    scene
    (
        "3_pneumaticLine", line, {"drag", "exchange", "saffman", "walls"},
        {"virtualMass", "basset", "buoyancy", "contacts"}
    );

    sceneNumbers bead(falling(1e-3, 1260, 1260, 1e-3, 0));
    bead.nBodies = 1;
    bead.cell = 4e-3;
    bead.shear = 10;
    bead.spin = 5;
    scene
    (
        "6_beadInShear", bead,
        {
            "drag", "pressureGradient", "virtualMass", "basset",
            "rotationalDrag", "rotation"
        },
        {"contacts", "magnus", "saffman"}
    );

    sceneNumbers ball(falling(0.04, 2.7e-3/(M_PI/6*64e-6), 1.2, 1.5e-5, 0));
    ball.nBodies = 1;
    ball.slip = 10;
    ball.spin = 300;
    scene
    (
        "7_spinningBall", ball,
        {"drag", "magnus", "rotation", "rotationalDrag"},
        {"virtualMass", "basset", "saffman", "contacts"}
    );
    scene
    (
        "12_lightSpheres", falling(1e-3, 100, 1000, 1e-6, 1e-4),
        {"drag", "buoyancy", "virtualMass", "basset", "exchange"},
        {"contacts", "saffman", "magnus"}
    );
}


TEST(effects, scenesWithContacts)
{
    // Goldschmidt's bed: glass of 2.5 mm in air at 1.25 m/s, half full
    sceneNumbers bed(falling(2.5e-3, 2526, 1.2, 1.5e-5, 0.25));
    bed.fraction = 0.45;
    bed.slip = 1.25;
    bed.shear = 2*1.25/0.15;
    bed.spin = 0.5*bed.shear;
    bed.walls = true;
    bed.cell = 5e-3;
    scene
    (
        "4_fluidisedBed", bed,
        {
            "drag", "denseDrag", "pressureGradient", "contacts", "friction",
            "rotation", "walls", "exchange", "averaging"
        },
        {"virtualMass", "basset", "saffman", "lubrication", "immersed"}
    );

    const wordList fluidEffects
    ({
        "drag", "buoyancy", "pressureGradient", "viscous", "virtualMass",
        "basset", "saffman", "magnus", "rotationalDrag", "exchange",
        "averaging", "immersed", "refinement", "lubrication"
    });
    wordList off(fluidEffects);
    off.append("electrostatic");
    sceneNumbers sticky(powder(100e-6));
    sticky.capillary = 10;
    scene
    (
        "8_stickyPowder", sticky,
        {"contacts", "friction", "rotation", "capillary", "walls"}, off
    );

    off = fluidEffects;
    off.append("capillary");
    sceneNumbers charged(powder(100e-6));
    charged.electrostatic = 1;
    scene
    (
        "9_chargedPowder", charged,
        {"contacts", "friction", "rotation", "electrostatic"}, off
    );

    off = fluidEffects;
    off.append
    (
        wordList({"capillary", "vanDerWaals", "simplifiedJKR", "electrostatic"})
    );
    scene
    (
        "10_hopper", powder(6e-3),
        {"contacts", "friction", "rotation", "walls"}, off
    );
}


TEST(effects, scenesOfSolids)
{
    wordList off(pointForces);
    off.append(wordList({"averaging", "contacts", "lubrication"}));

    // ten Cate E4 in its tank of 100 x 100 x 160 mm
    sceneNumbers sphere(solid(15e-3, 1120, 12));
    sphere.meanFraction = M_PI/6*pow3(0.015)/(0.1*0.1*0.16);
    scene("5_sphereInTank", sphere, {"immersed", "refinement"}, off);
    sphere.gap = 1.9*sphere.cell;
    sphere.nBodies = 2;
    scene("5_gapOfTwoCells", sphere, {"immersed", "contacts"}, pointForces);

    off = pointForces;
    off.append(wordList({"averaging", "lubrication"}));
    sceneNumbers rocks(solid(0.02, 2650, 8));
    rocks.nBodies = 8;
    rocks.meanFraction = 4e-3;
    rocks.fraction = 4e-3*7/8;
    rocks.walls = true;
    rocks.gap = 3*rocks.cell;
    const wordList on
    ({
        "immersed", "contacts", "friction", "rotation", "walls", "refinement"
    });
    scene("11_rocks", rocks, on, off);
    rocks.gap = 0.9*rocks.cell;
    scene("11_rocksNear", rocks, {"lubrication"}, pointForces);
}


// ************************************************************************* //
