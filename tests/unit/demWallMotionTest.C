/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    Walls that move by themselves: a plate that vibrates, a belt, a turntable, a
    drum, a gate; against closed forms.

\*---------------------------------------------------------------------------*/

#include "demCase.H"

#include "movingWall.H"

#include <cmath>

using namespace styxTest;
using namespace Foam::dem;
using Foam::mag;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- A case with walls and a body
std::string scene
(
    const std::string& walls,
    const std::string& start,
    const std::string& more = "",
    const scalar youngsModulus = 1e8
)
{
    return
        "demSolver hades;\n"
        "materials { stuff { density 2500; youngsModulus "
      + text(youngsModulus) + "; poissonsRatio 0.3; } }\n"
        "shapes { ball { type sphere; diameter 0.01; }\n"
        "sledge { type multisphere; spheres ( ((0.01 0.01 0) 0.005)"
        " ((-0.01 0.01 0) 0.005) ((0.01 -0.01 0) 0.005)"
        " ((-0.01 -0.01 0) 0.005) ); } }\n"
        "walls { " + walls + " }\n"
        "bodies { it { material stuff; " + start + " } }\n"
      + (
            more.empty()
          ? std::string
            (
                "pairs { stuff-stuff { restitution 0.2; friction 0.3; } }\n"
                "stepControl { type hades; }\n"
            )
          : more
        );
}


//- A floor of 1 m
std::string square(const std::string& more)
{
    return
        "floor { type rectangle; corner (-0.5 -0.5 0); edge1 (1 0 0);"
        " edge2 (0 1 0); material stuff; " + more + " }";
}


wallMotion::state stateAt(const std::string& entries, const scalar t)
{
    return wallMotion::New(dictionaryOf(entries))->at(t);
}


//- Where the start of x is at a time
point at(const std::string& entries, const point& x, const scalar t)
{
    const wallMotion::state s(stateAt(entries, t));
    return (s.R & x) + s.d;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(demWallMotion, places)
{
    const point x(0.1, 0.2, 0.3);
    const std::string go("type translate; velocity (1 2 3); start 1; stop 3;");
    EXPECT_LT(mag(at(go, x, 0.5) - x), 1e-15);
    EXPECT_LT(mag(at(go, x, 2) - x - vector(1, 2, 3)), 1e-15);
    EXPECT_LT(mag(at(go, x, 9) - x - 2*vector(1, 2, 3)), 1e-15);
    EXPECT_EQ(stateAt(go, 0.5).v, vector::zero);
    EXPECT_EQ(stateAt(go, 1).v, vector(1, 2, 3));
    EXPECT_EQ(stateAt(go, 3).v, vector::zero);

    // A quarter turn, right-handed
    const std::string turn
    (
        "type rotate; origin (0 0 5); axis (2 0 0); omega "
      + text(0.5*M_PI) + ";"
    );
    EXPECT_LT(mag(at(turn, point(1, 0, 6), 1) - point(1, -1, 5)), 1e-14);
    EXPECT_LT(mag(at(turn, point(1, 0, 6), 1e6) - point(1, 0, 6)), 1e-9);

    const std::string shake
    (
        "type vibrate; amplitude (0 0 2); frequency 0.25; phase 90;"
    );
    EXPECT_LT(mag(at(shake, x, 0) - x), 1e-15);
    EXPECT_LT(mag(at(shake, x, 2) - x + vector(0, 0, 4)), 1e-14);
    EXPECT_LT(mag(stateAt(shake, 0).v), 1e-15);

    const std::string rows
    (
        "type table; displacements"
        " ((0 (0 0 0)) (1 (2 0 0)) (3 (2 0 4)));"
    );
    EXPECT_LT(mag(at(rows, x, 0.5) - x - vector(1, 0, 0)), 1e-15);
    EXPECT_LT(mag(at(rows, x, 2) - x - vector(2, 0, 2)), 1e-15);
    EXPECT_LT(mag(at(rows, x, 7) - x - vector(2, 0, 4)), 1e-15);
    EXPECT_EQ(stateAt(rows, 1).v, vector(0, 0, 2));
    EXPECT_EQ(stateAt(rows, 4).v, vector::zero);

    // Velocities are the derivatives of the places
    for (const std::string& m : {go, turn, shake, rows})
    {
        const scalar h = 1e-5;
        const scalar t = 1.7;
        const wallMotion::state s(stateAt(m, t));
        const point p = at(m, x, t);
        const vector u = (at(m, x, t + h) - at(m, x, t - h))/(2*h);
        EXPECT_LT(mag(s.v + (s.omega ^ (p - s.origin)) - u), 1e-8) << m;
    }
}


TEST(demWallMotion, vibratingPlate)
{
    // It starts upwards from the lowest point, at rest. Soft balls leave later
    const scalar omega = 2*M_PI*20;
    const auto plate = [&](const scalar strength)
    {
        return scene
        (
            square
            (
                "motion { type vibrate; amplitude (0 0 "
              + text(strength*9.81/(omega*omega))
              + "); frequency 20; phase -90; }"
            ),
            "shape ball; position (0 0 0.00499998);",
            "",
            1e11
        );
    };

    // It stays on the plate below g; it has settled after some ms
    demCase stays(plate(0.7), gravity);
    stays.run(0.01);
    label least = 1;
    while (stays.time() < 0.2)
    {
        stays.run(1e-4);
        least = std::min(least, stays.solver().report().nContacts);
    }
    figure("plate_stays", least, 1, 1, "contacts", "0.7 g: it never lifts off");

    // Above it lifts off where the plate is as much slower
    demCase lifts(plate(1.6), gravity);
    lifts.run(0.01);
    while (lifts.solver().report().nContacts && lifts.time() < 0.1)
    {
        lifts.run(1e-5);
    }
    figureNear
    (
        "plate_liftsOff",
        lifts.time(),
        (std::asin(1/1.6) + 0.5*M_PI)/omega,
        0.01,
        "s",
        "closed form: A omega^2 sin = g"
    );
}


TEST(demWallMotion, belt)
{
    // What slides on four feet is at the velocity of the belt after U/(mu g),
    // and stays with it
    const scalar U = 0.5;
    demCase c
    (
        scene
        (
            square
            (
                "motion { type translate; velocity (" + text(U) + " 0 0); }"
            ),
            "shape sledge; position (-0.3 0 0.00499895);"
        ),
        gravity
    );
    const scalar T = U/(0.3*9.81);
    c.run(0.25*T);
    const scalar v1 = c.state().v[0].x();
    c.run(0.5*T);
    figureNear
    (
        "beltSledge_acceleration",
        (c.state().v[0].x() - v1)/(0.5*T),
        0.3*9.81,
        0.005,
        "m/s2",
        "closed form mu g"
    );
    c.run(0.5*T);
    figureNear
    (
        "beltSledge_velocity",
        c.state().v[0].x(),
        U,
        1e-3,
        "m/s",
        "that of the belt"
    );
}


TEST(demWallMotion, turntable)
{
    // A sphere that rolls on a turntable goes in circles at 2/7 of its rate,
    // wherever it starts and however fast
    const scalar Omega = 10;
    const point x0(0.1, 0, 0.005 - 1.1e-6);
    const vector v0(0, 0.4, 0);
    const vector w = (vector(0, 0, Omega) ^ x0) - v0;

    // So that the foot has the velocity of the table
    const vector spin = (vector(0, 0, 1) ^ (-w))/0.005;
    demCase c
    (
        scene
        (
            square
            (
                "motion { type rotate; origin (0 0 0); axis (0 0 1); omega "
              + text(Omega) + "; }"
            ),
            "shape ball; position " + text(x0) + "; velocity " + text(v0)
          + "; angularVelocity " + text(spin) + ";",
            "pairs { stuff-stuff { restitution 0.2; friction 2; } }\n"
            "stepControl { type fixed; deltaT 5e-6; }\n"
        ),
        gravity
    );

    // The velocity turns at the same rate
    c.run(0.01);
    const vector v1 = c.state().v[0];
    const scalar T = 0.3;
    c.run(T);
    const vector v2 = c.state().v[0];
    figureNear
    (
        "turntable_rate",
        std::atan2((v1 ^ v2).z(), v1 & v2)/T,
        2*Omega/7,
        0.005,
        "rad/s",
        "closed form 2/7 Omega"
    );
    figureNear
    (
        "turntable_velocity",
        mag(v2),
        mag(v1),
        0.005,
        "m/s",
        "it stays the same"
    );
}


TEST(demWallMotion, drum)
{
    // A sphere that rolls in a drum that turns swings as in one at rest, and
    // its spin on average is that of the drum times R/r
    const scalar R = 0.05;
    const scalar r = 0.005;
    const scalar Omega = 4;
    const scalar angle = 0.1;
    const scalar away = R - r + 1.1e-6;
    const std::string walls
    (
        "drum { type cylinder; point (0 0 0); axis (0 1 0); radius "
      + text(R) + "; side inside; material stuff;"
        " motion { type rotate; origin (0 0 0); axis (0 1 0); omega "
      + text(Omega) + "; } }"
    );
    demCase c
    (
        scene
        (
            walls,
            "shape ball; position "
          + text(away*vector(std::sin(angle), 0, -std::cos(angle)))
          + "; angularVelocity (0 " + text(Omega*R/r) + " 0);",
            "pairs { stuff-stuff { restitution 0.2; friction 1; } }\n"
            "stepControl { type fixed; deltaT 5e-6; }\n"
        ),
        gravity
    );

    // Times at which it goes through the lowest point, to the left
    std::vector<scalar> through;
    scalar spin = 0;
    scalar mean = 0;
    label n = 0;
    scalar last = c.state().x[0].x();
    while (through.size() < 4 && c.time() < 3)
    {
        c.run(1e-4);
        const scalar x = c.state().x[0].x();
        if (last > 0 && x <= 0)
        {
            through.push_back(c.time() + 1e-4*x/(last - x));
        }
        if (through.size() && through.size() < 4)
        {
            spin += c.state().omega[0].y();
            mean += x/(R - r);
            ++n;
        }
        last = x;
    }
    ASSERT_EQ(through.size(), 4u);
    figureNear
    (
        "drum_period",
        (through[3] - through[0])/3,
        2*M_PI*std::sqrt(1.4*(R - r)/9.81)*(1 + angle*angle/16),
        0.005,
        "s",
        "closed form of a sphere that rolls in a cylinder"
    );
    figureNear
    (
        "drum_spin",
        spin/n,
        Omega*R/r,
        0.005,
        "rad/s",
        "closed form Omega R/r"
    );
    figure
    (
        "drum_angle",
        mean/n,
        -1e-3,
        1e-3,
        "rad",
        "closed form 0: nothing resists its rolling"
    );
}


TEST(demWallMotion, gateOpens)
{
    // A ball at rest on a gate falls freely when it has opened
    demCase c
    (
        scene(square("open 0.1;"), "shape ball; position (0 0 0.0049985);"),
        gravity
    );
    c.run(0.06);
    const scalar z0 = c.state().x[0].z();
    EXPECT_EQ(c.solver().report().nContacts, 1);
    c.run(0.09);
    EXPECT_EQ(c.solver().report().nContacts, 0);
    figureNear
    (
        "gate_falls",
        z0 - c.state().x[0].z(),
        0.5*9.81*0.05*0.05,
        0.01,
        "m",
        "free fall from when the gate opened"
    );
}


TEST(demWallMotion, gateCloses)
{
    // The gate is there only from 0.1 s to 0.3 s: the first ball has gone
    // through, the second is held for a while
    const std::string gate(square("close 0.1; open 0.3;"));
    demCase early
    (
        scene(gate, "shape ball; position (0 0 0.03);"),
        gravity
    );
    early.run(0.2);
    EXPECT_LT(early.state().x[0].z(), -0.1);

    demCase late
    (
        scene(gate, "shape ball; position (0 0 0.07);"),
        gravity
    );
    late.run(0.28);
    EXPECT_NEAR(late.state().x[0].z(), 0.005, 5e-4);
    late.run(0.12);
    EXPECT_LT(late.state().x[0].z(), -0.02);

    // One that is in its way stops the run, from where it was
    demCase held
    (
        scene(gate, "shape ball; position (0 0 0.0495);"),
        gravity
    );
    held.run(0.099);
    const std::string said = messageOf([&]() { held.run(0.01); });
    for (const char* word : {"wall floor", "appears", "body 0 (ball)"})
    {
        EXPECT_NE(said.find(word), std::string::npos) << word << said;
    }
    EXPECT_EQ(held.nSaves(), 1);
}


TEST(demWallMotion, patchOfItsOwn)
{
    // A patch of a mesh at rest may move as any wall does, also after the mesh
    // has got other faces; if the mesh moves as well that is an error
    Foam::List<corners> floor(2);
    floor[0][0] = floor[1][0] = point(-0.5, -0.5, 0);
    floor[0][1] = point(0.5, -0.5, 0);
    floor[0][2] = floor[1][1] = point(0.5, 0.5, 0);
    floor[1][2] = point(-0.5, 0.5, 0);
    demCase c
    (
        scene
        (
            "floor { type patch; material stuff;"
            " motion { type translate; velocity (0 0 0.1); } }",
            "shape ball; position (0.1 0.2 0.0049985);"
        ),
        gravity,
        floor
    );
    c.run(0.1);
    c.solver().updateWalls(false, c.time(), c.time());
    c.run(0.1);
    EXPECT_NEAR(c.state().x[0].z(), 0.025, 1e-5);
    EXPECT_NEAR(c.state().v[0].z(), 0.1, 1e-6);

    const std::string said = messageOf
    (
        [&]() { c.solver().updateWalls(true, c.time(), c.time() + 0.1); }
    );
    EXPECT_NE(said.find("mesh that moves"), std::string::npos) << said;
}


TEST(demWallMotion, intoPackedBed)
{
    // A piston that is driven into 8 balls between it and the floor, as far as
    // a tenth of their radius: the forces stay finite and nothing is lost. As
    // it draws back all come to rest
    std::string bodies;
    for (label k = 0; k < 8; ++k)
    {
        bodies +=
            "b" + std::to_string(k) + " { shape ball; material stuff;"
            " position " + text(vector(0, 0, 0.005 + 0.01*k)) + "; }\n";
    }
    demCase c
    (
        "demSolver hades;\n"
        "materials { stuff { density 2500; youngsModulus 1e8;"
        " poissonsRatio 0.3; } }\n"
        "shapes { ball { type sphere; diameter 0.01; } }\n"
        "pairs { stuff-stuff { restitution 0.2; friction 0.3; } }\n"
        "stepControl { type hades; }\n"
        "walls {\n"
        "floor { type plane; point (0 0 0); normal (0 0 1);"
        " material stuff; }\n"
        "tube { type cylinder; point (0 0 0); axis (0 0 1); radius 0.0051;"
        " side inside; material stuff; }\n"
        "piston { type plane; point (0 0 0.0801); normal (0 0 -1);"
        " material stuff; motion { type table; displacements ((0 (0 0 0))"
        " (0.1 (0 0 -0.0045)) (0.2 (0 0 0))); } } }\n"
        "bodies {\n" + bodies + "}\n",
        gravity
    );
    c.run(0.1);
    scalar squeezed = 0;
    for (label k = 0; k < 8; ++k)
    {
        squeezed = std::max(squeezed, mag(c.state().force[k]));
    }
    EXPECT_GT(c.solver().report().overlap, 0.05);
    EXPECT_LT(c.solver().report().overlap, 0.2);
    c.run(1);
    scalar fastest = 0;
    scalar top = 0;
    for (label k = 0; k < 8; ++k)
    {
        const point& x = c.state().x[k];
        fastest = std::max(fastest, mag(c.state().v[k]));
        top = std::max(top, x.z());
        EXPECT_LT(std::hypot(x.x(), x.y()), 2e-4);
    }
    figure("piston_bed", top, 0.0745, 0.0751, "m", "the eighth ball is back");
    EXPECT_LT(fastest, 1e-3);
    EXPECT_TRUE(std::isfinite(squeezed));
}


TEST(demWallMotion, throughTheSteps)
{
    // A piston that starts to move amid a long step of the fluid does not jump
    // over a ball at rest
    demCase c
    (
        scene
        (
            "floor { type plane; point (0 0 0); normal (0 0 1); material"
            " stuff; motion { type translate; velocity (0 0 40);"
            " start 1e-3; stop 2e-3; } }",
            "shape ball; position (0 0 0.0251);",
            "pairs { stuff-stuff { friction 0.3; } }\n"
            "contact { damping none; }\n"
            "stepControl { type hades; contactSteps 200; }\n"
        )
    );
    c.run(4e-3);
    figureNear
    (
        "piston_started",
        c.state().v[0].z(),
        80,
        1e-3,
        "m/s",
        "closed form 2 V"
    );
}


TEST(demWallMotion, restsAgain)
{
    // Once a motion is over the wall costs no step; before it has begun too
    const std::string m
    (
        "type plane; point (0 0 0); normal (0 0 1);"
        "motion { type translate; velocity (0 0 1); start 2; stop 3; }"
    );
    const Foam::dictionary d(dictionaryOf(m));
    auto w = movingWall::New(wall::New("w", 0, d, "."), d);
    EXPECT_EQ(w->speed(), 1);
    for (const scalar t : {0.5, 2.5, 3.5})
    {
        w->beginAdvance(t, t + 0.5);
        w->moveTo(t + 0.5);
        EXPECT_EQ(w->speed(), t == 2.5 ? 1 : 0);
        EXPECT_EQ(w->moving(), t == 2.5);
    }

    // A wall without the entries is not wrapped
    const Foam::dictionary still
    (
        dictionaryOf("type plane; point (0 0 0); normal (0 0 1);")
    );
    const auto s = movingWall::New(wall::New("w", 0, still, "."), still);
    EXPECT_FALSE(s->timed());
}


TEST(demWallMotion, refused)
{
    const auto refused =
        [](const std::string& more, const std::vector<std::string>& words)
    {
        const std::string said = messageOf
        (
            [&]()
            {
                demCase c(scene(square(more), "shape ball; position (0 0 1);"));
            }
        );
        EXPECT_NE(said.find("at line 5."), std::string::npos) << more << said;
        for (const std::string& word : words)
        {
            EXPECT_NE(said.find(word), std::string::npos)
                << '"' << word << "\" is not in: " << said;
        }
    };
    refused("motion { type spin; }", {"spin", "rotate", "vibrate", "table"});
    refused("motion { type translate; velocty (1 0 0); }",
        {"velocty", "velocity", "start", "stop"});
    refused("motion { type translate; velocity (1 nan 0); }", {"velocity"});
    refused("motion { type rotate; origin (0 0 0); axis (0 0 0); omega 1; }",
        {"axis", "no length"});
    refused("motion { type vibrate; amplitude (0 0 1); frequency 0; }",
        {"frequency", "0"});
    refused("motion { type translate; velocity (1 0 0); start 2; stop 1; }",
        {"stop", "after the start"});
    refused("motion { type table; displacements ((0 (0 0 0))); }",
        {"displacements", "two rows"});
    refused
    (
        "motion { type table; displacements"
        " ((0 (0 0 0)) (1 (0 0 1)) (1 (0 0 2))); }",
        {"displacements", "in place 2"}
    );
    refused("open 1; close 1;", {"close", "opens"});
    refused("open now;", {"open"});

    const std::string turns
    (
        messageOf
        (
            []()
            {
                demCase c
                (
                    scene
                    (
                        "floor { type plane; point (0 0 0); normal (0 0 1);"
                        " material stuff; motion { type rotate;"
                        " origin (0 0 0); axis (0 0 1); omega 1; } }",
                        "shape ball; position (0 0 1);"
                    )
                );
            }
        )
    );
    EXPECT_NE(turns.find("does not end"), std::string::npos) << turns;
}


// ************************************************************************* //
