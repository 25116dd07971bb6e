/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    Bodies that sleep: they rest where they would rest, wake when they are hit,
    pushed or left without support, and keep the springs of their contacts.

\*---------------------------------------------------------------------------*/

#include "demCase.H"

#include <cmath>
#include <random>

using namespace styxTest;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const std::string sleeping("sleeping { speed 1e-4; time 0.02; }\n");

const std::string floorWall
(
    "floor { type plane; point (0 0 0); normal (0 0 1); material stuff; }\n"
);

const std::string ball("shapes { ball { type sphere; diameter 0.01; } }\n");

//- Bodies of one material on walls; the friction is that of all contacts
std::string scene
(
    const std::string& shapes,
    const std::string& bodies,
    const std::string& walls,
    const scalar friction,
    const std::string& more
)
{
    return
        "demSolver hades;\n" + shapes
      + "contact { tangential "
      + (friction > 0 ? "mindlin" : "none") + "; }\n"
        "materials { stuff { density 2500; youngsModulus 1e7;"
        " poissonsRatio 0.25; } }\n"
        "pairs { stuff-stuff { restitution 0.3; "
      + (friction > 0 ? "friction " + text(friction) + "; " : "")
      + "} }\nstepControl { type hades; }\n"
        "walls\n{\n" + walls + "}\nbodies\n{\n" + bodies + "}\n" + more;
}


std::string at(const std::string& name, const point& x, const vector& v)
{
    return
        name + " { shape ball; material stuff; position " + text(x)
      + "; velocity " + text(v) + "; }\n";
}


//- A tower of n balls in a narrow shaft
std::string tower(const label n)
{
    std::string s;
    for (label k = 0; k < n; ++k)
    {
        s += at("b" + std::to_string(k), {0, 0, 0.005 + 0.01*k}, Foam::Zero);
    }
    return s;
}


const std::string shaft
(
    "x1 { type plane; point (-0.00501 0 0); normal (1 0 0); material stuff; }\n"
    "x2 { type plane; point (0.00501 0 0); normal (-1 0 0); material stuff; }\n"
    "y1 { type plane; point (0 -0.00501 0); normal (0 1 0); material stuff; }\n"
    "y2 { type plane; point (0 0.00501 0); normal (0 -1 0); material stuff; }\n"
);


label nAsleep(demCase& c)
{
    return c.solver().report().nAsleep;
}

//- Least fall of all bodies since they were at x [m]
scalar leastFall(demCase& c, const std::vector<point>& x)
{
    scalar least = Foam::GREAT;
    forAll(c.state().x, b)
    {
        least = std::min(least, x[b].z() - c.state().x[b].z());
    }
    return least;
}


std::vector<point> places(demCase& c)
{
    return std::vector<point>(c.state().x.begin(), c.state().x.end());
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(demSleep, ball)
{
    demCase c
    (
        scene
        (
            ball,
            at("first", {0, 0, 0.006}, Foam::Zero)
          + at("second", {0.1, 0, 0.005}, {-0.1, 0, 0}),
            floorWall,
            0,
            sleeping
        ),
        gravity
    );
    c.run(0.5);
    figure("sleep_asleep", nAsleep(c), 1, 1, "balls",
        "one rests, one slides on");

    // 4/3 E* sqrt(R) d^1.5 = m g
    const scalar E = 1e7/(2*(1 - 0.0625));
    const scalar rest = std::pow
    (
        c.state().mass[0]*9.81/(4.0/3.0*E*std::sqrt(0.005)),
        2.0/3.0
    );
    figureNear("sleep_overlap", 0.005 - c.state().x[0].z(), rest, 1e-3, "m",
        "Hertz under its own weight");
    EXPECT_EQ(c.solver().history().walls.size(), 2);
    EXPECT_EQ(c.solver().contacts().size(), 2);
    figureNear("sleep_force", c.solver().contacts()[0].normal(),
        c.state().mass[0]*9.81, 1e-3, "N",
        "the contact of who sleeps is in the output");

    // 0.1 m apart less a diameter, at 0.1 m/s: hit at 0.9 s
    c.run(0.3);
    EXPECT_EQ(nAsleep(c), 1);
    c.run(0.2);
    const Foam::dem::bodies& b = c.state();
    figure("sleep_wakes", nAsleep(c), 0, 0, "balls", "hit");
    figure
    (
        "sleep_momentum",
        std::abs(b.v[0].x() + b.v[1].x() + 0.1)/0.1,
        0,
        1e-6,
        "of what was there",
        "momentum is conserved"
    );
    figureNear("sleep_restitution", b.v[1].x() - b.v[0].x(), 0.03, 0.01,
        "m/s", "restitution 0.3");
}


TEST(demSleep, slope)
{
    const scalar mu = 0.5;
    const scalar slope = 0.8*std::atan(mu);
    const scalar half = 0.0032 + 0.00365;
    const vector normal(-std::sin(slope), 0, std::cos(slope));
    demCase c
    (
        scene
        (
            cubeOfNine,
            "cube { shape cube; material stuff; position " + text(half*normal)
          + "; rotation ((0 1 0) " + text(-slope*180/M_PI) + "); }\n",
            "slope { type plane; point (0 0 0); normal " + text(normal)
          + "; material stuff; }\n",
            mu,
            sleeping
        ),
        gravity
    );
    c.run(2);
    EXPECT_EQ(nAsleep(c), 1);
    EXPECT_EQ(c.solver().report().nContacts, 4);
    const point x = c.state().x[0];
    c.run(1);
    figure("sleep_slope", mag(c.state().x[0] - x)/0.012, 0, 0, "edges in 1 s",
        "held by friction, asleep");
    figure("sleep_slope_steps", c.solver().report().nSteps, 1, 1, "steps",
        "of the fluid's step: nothing limits it");
}


TEST(demSleep, shares)
{
    // Cubes whose contacts share a stiffness: if those of who sleeps did not,
    // they would push as four times as many and wake it at once
    std::string dict
    (
        scene
        (
            cubeOfNine,
            "low { shape cube; material stuff; position (0 0 0.00685); }\n"
            "high { shape cube; material stuff; position (0 0 0.02055); }\n",
            floorWall,
            0.5,
            sleeping
        )
    );
    dict.replace(dict.find("mindlin;"), 8, "mindlin; multiContact share;");
    demCase c(dict, gravity);
    c.run(2);
    const label before = nAsleep(c);
    c.run(0.5);
    figure("sleep_shares", before + nAsleep(c), 4, 4, "cubes",
        "two asleep, twice");
    EXPECT_EQ(c.solver().report().nSteps, 1);
}


TEST(demSleep, springs)
{
    // A ball that its springs of slip and of rolling hold on a slope; gravity
    // is tilted. Pushed down, it goes down as if it had not slept: without
    // them it would go as far as it did at first, five times that
    const vector g = 9.81*vector(std::sin(0.05), 0, -std::cos(0.05));
    scalar way[2];
    label n = 0;
    const std::string light("sleeping { speed 1e-5; time 0.02;"
        " acceleration 0.02; }\n");
    for (const std::string more : {light, std::string()})
    {
        std::string dict
        (
            scene
            (
                ball,
                at("b", {0, 0, 0.005}, Foam::Zero),
                floorWall,
                0.5,
                more
            )
        );
        dict.replace(dict.find("mindlin;"), 8,
            "mindlin; rolling elasticPlastic;");
        dict.replace(dict.find("friction 0.5;"), 13,
            "friction 0.5; rollingFriction 0.1;");
        demCase c(dict, g);
        c.run(2);
        EXPECT_EQ(nAsleep(c), n ? -1 : 1);
        const scalar first = c.state().x[0].x();
        c.state().fluidForce[0] = {0.01*9.81*c.state().mass[0], 0, 0};
        c.run(2);
        way[n++] = c.state().x[0].x() - first;
        EXPECT_LT(way[n - 1], 0.25*first);
    }
    figureNear("sleep_springs", way[0], way[1], 0.02, "m",
        "pushed down the slope, without sleeping");
}


TEST(demSleep, gate)
{
    const std::string gate
    (
        "gate { type rectangle; corner (-0.1 -0.1 0); edge1 (0.2 0 0);"
        " edge2 (0 0.2 0); material stuff; open 1.0; }\n"
    );
    demCase c(scene(ball, tower(6), shaft + gate, 0, sleeping), gravity);
    demCase awake(scene(ball, tower(6), shaft + gate, 0, ""), gravity);
    for (demCase* k : {&c, &awake})
    {
        k->run(0.99);
    }
    figure("sleep_tower", nAsleep(c), 6, 6, "balls", "all rest on a gate");
    const std::vector<point> x(places(c)), y(places(awake));
    for (demCase* k : {&c, &awake})
    {
        k->run(0.11);
    }
    figure("sleep_gate", nAsleep(c), 0, 0, "balls",
        "asleep when it has opened");
    figureNear("sleep_gate_first", x[0].z() - c.state().x[0].z(),
        y[0].z() - awake.state().x[0].z(), 0.01, "m", "without sleeping");
    EXPECT_NEAR(leastFall(c, x), 0.5*9.81*0.01, 0.003);
    figureNear("sleep_gate_last", leastFall(c, x), leastFall(awake, y), 0.01,
        "m", "without sleeping");
}


TEST(demSleep, supportGoes)
{
    const std::string walls(shaft + floorWall);
    demCase c(scene(ball, tower(6), walls, 0, sleeping), gravity);
    demCase awake(scene(ball, tower(6), walls, 0, ""), gravity);
    for (demCase* k : {&c, &awake})
    {
        k->run(0.9);
    }
    EXPECT_EQ(nAsleep(c), 6);

    // First of all the one at the top
    Foam::boolList marked(6, false);
    marked[5] = true;
    c.solver().remove(marked);
    awake.solver().remove(marked);
    c.run(1e-6);
    awake.run(1e-6);
    figure("sleep_top", nAsleep(c), 2, 2, "balls",
        "who has lost the weight of one on it wakes up, and two below it");
    for (demCase* k : {&c, &awake})
    {
        k->run(0.5);
    }
    EXPECT_EQ(nAsleep(c), 5);

    marked = Foam::boolList(5, false);
    marked[0] = true;
    const std::vector<point> x(places(c)), y(places(awake));
    scalar falls[2];
    label k = 0;
    for (demCase* d : {&c, &awake})
    {
        const scalar z = d->state().x[4].z();
        d->solver().remove(marked);
        d->run(0.03);
        falls[k++] = z - d->state().x[3].z();
    }
    EXPECT_EQ(nAsleep(c), 0);
    figureNear("sleep_support", falls[0], falls[1], 0.01, "m",
        "the last of four, without sleeping");
    EXPECT_GT(falls[0], 0.8*0.5*9.81*0.0009);
    c.run(1);
    figure("sleep_again", nAsleep(c), 4, 4, "balls", "rest on the floor");
}


TEST(demSleep, walls)
{
    // A floor that begins to move under who sleeps
    demCase c
    (
        scene
        (
            ball,
            at("b", {0, 0, 0.005}, Foam::Zero),
            "floor { type rectangle; corner (-1 -1 0); edge1 (2 0 0);"
            " edge2 (0 2 0); material stuff;"
            " motion { type vibrate; amplitude (0 0 1e-3); frequency 5;"
            " start 1; } }\n",
            0,
            sleeping
        ),
        gravity
    );
    c.run(0.9);
    EXPECT_EQ(nAsleep(c), 1);
    c.run(0.15);
    figureNear("sleep_lifted", c.state().x[0].z() - 0.005, 1e-3, 0.02,
        "m", "on a floor at the top of its way");
    EXPECT_EQ(nAsleep(c), 0);

    // One that appears where one sleeps
    demCase lid
    (
        scene
        (
            ball,
            at("b", {0, 0, 0.005}, Foam::Zero),
            floorWall + "lid { type rectangle; corner (-1 -1 0.008);"
            " edge1 (2 0 0); edge2 (0 2 0); material stuff; close 1; }\n",
            0,
            sleeping
        ),
        gravity
    );
    lid.run(0.5);
    EXPECT_EQ(nAsleep(lid), 1);
    const std::string why(messageOf([&]() { lid.run(0.6); }));
    EXPECT_NE(why.find("lid appears where"), std::string::npos) << why;
}


TEST(demSleep, forces)
{
    const std::string walls(shaft + floorWall);
    demCase c(scene(ball, tower(3), walls, 0, sleeping), gravity);
    demCase awake(scene(ball, tower(3), walls, 0, ""), gravity);
    for (demCase* k : {&c, &awake})
    {
        k->run(0.9);
    }
    EXPECT_EQ(nAsleep(c), 3);

    // Held forces of a fluid, below and above what wakes
    const scalar weight = 9.81*c.state().mass[0];
    c.state().fluidForce[2] = {0, 0, 0.03*weight};
    c.run(0.01);
    EXPECT_EQ(nAsleep(c), 3);
    figureNear("sleep_pushed", c.solver().contacts().last().normal(), 3*weight,
        1e-3, "N", "who sleeps does not move for 0.03 of its weight");

    scalar way[2];
    label n = 0;
    for (demCase* k : {&c, &awake})
    {
        k->state().fluidForce[2] = {0, 0, 1.5*weight};
        const scalar z = k->state().x[2].z();
        k->run(0.1);
        way[n++] = k->state().x[2].z() - z;
    }
    figureNear("sleep_fluid", way[0], way[1], 0.01, "m",
        "lifted by 1.5 of its weight, without sleeping");
}


TEST(demSleep, refused)
{
    const auto say = [](const std::string& more, const std::string& walls)
    {
        return messageOf
        (
            [&]()
            {
                demCase
                (
                    scene
                    (
                        ball,
                        at("b", {0, 0, 0.1}, Foam::Zero),
                        walls,
                        0,
                        more
                    ),
                    gravity
                );
            }
        );
    };
    EXPECT_NE(say("sleeping { speed 1e-4; time 0.02; angle 3; }", floorWall)
        .find("angle"), std::string::npos);
    EXPECT_NE(say(sleeping + "integrator rk4;", floorWall)
        .find("stages"), std::string::npos);
    EXPECT_NE(say(sleeping, "").find("nothing to rest on"),
        std::string::npos);
    EXPECT_NE(say("sleeping { speed 1; time 0.02; }", floorWall)
        .find("in the air"), std::string::npos);
    EXPECT_NE(say("sleeping { speed 0; time 0.02; }", floorWall)
        .find("speed"), std::string::npos);
    EXPECT_EQ(say(sleeping, floorWall), "");
}


// ************************************************************************* //
