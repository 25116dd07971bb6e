/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    Hard input: thousands of bodies in overlap, a wall that moves into a bed,
    sizes a million apart, steps far too long. The run is stable or stops with
    a reason, and nothing is lost.

\*---------------------------------------------------------------------------*/

#include "demCase.H"

#include <cmath>
#include <random>

using namespace styxTest;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Stuff of which balls of 1 cm and 1 m, 1 um and walls are made
std::string stuff(const std::string& contact, const std::string& pair)
{
    return
        "demSolver hades;\ncontact { " + contact + " }\n"
        "materials { stuff { density 2500; youngsModulus 1e8;"
        " poissonsRatio 0.3; } }\n"
        "pairs { stuff-stuff { " + pair + " } }\n"
        "shapes { ball { type sphere; diameter 0.01; }\n"
        "rock { type sphere; diameter 1; }\n"
        "dust { type sphere; diameter 1e-6; } }\n";
}


std::string body
(
    const std::string& name,
    const std::string& shape,
    const vector& x,
    const vector& v
)
{
    return
        name + " { shape " + shape + "; material stuff; position " + text(x)
      + "; velocity " + text(v) + "; }\n";
}


//- Bodies at random in a cube of width w [m]
std::string random
(
    const label n,
    const scalar w,
    const std::string& shape,
    const std::string& prefix = "b"
)
{
    std::mt19937 numbers(1 + label(prefix[0] == 'c'));
    const auto uniform = [&]() { return numbers()/4294967296.0; };
    std::string dict = "bodies\n{\n";
    for (label k = 0; k < n; ++k)
    {
        const vector x(uniform(), uniform(), uniform());
        dict += body(prefix + std::to_string(k), shape, w*x, Foam::Zero);
    }
    return dict + "}\n";
}


//- Figures of a start in overlap: what is left, how fast it flies apart, how
//  far it has gone
void relaxed
(
    const std::string& name,
    demCase& c,
    const label n
)
{
    figure
    (
        name + "_start",
        c.solver().report().overlap,
        0,
        1e-4,
        "radii",
        "overlap after start relax"
    );
    scalar fastest = 0, overlap = 0;
    for (label k = 0; k < 4; ++k)
    {
        c.run(5e-4);
        overlap = std::max(overlap, c.solver().report().overlap);
        for (const vector& v : c.state().v)
        {
            fastest = std::max(fastest, mag(v));
        }
    }
    figure(name + "_speed", fastest, 0, 1, "m/s", "2 ms after the start");
    figure(name + "_overlap", overlap, 0, 0.01, "radii", "the same");
    figure(name + "_lost", n - c.state().size(), 0, 0, "bodies", "all stay");
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(demHard, startInOverlap)
{
    // 10,000 at random where 3,000 would have room
    const std::string dict = stuff("", "restitution 0.5; friction 0.5;")
      + "stepControl { type contact; }\n" + random(10000, 0.15, "ball");

    const std::string said = messageOf([&]() { demCase c(dict); });
    for (const char* const part : {"overlap at the start", "body ", "%"})
    {
        EXPECT_NE(said.find(part), std::string::npos) << part << said;
    }

    demCase c("start relax;\n" + dict);
    relaxed("hard05_open", c, 10000);
}


TEST(demHard, relaxInBox)
{
    // 10,000 in a box, of which they fill 0.55
    const scalar w = 0.212;
    demCase c
    (
        "start relax;\n" + stuff("", "restitution 0.5; friction 0.5;")
      + "stepControl { type contact; }\n"
      + "walls { box { type box; min (0 0 0); max " + text(vector(w, w, w))
      + "; side inside; material stuff; } }\n" + random(10000, w, "ball")
    );
    relaxed("hard05_box", c, 10000);
    scalar least = 1;
    for (const point& x : c.state().x)
    {
        least = std::min({least, cmptMin(x), w - cmptMax(x)});
    }
    figure("hard05_box_walls", least/0.005, 0.99, styxTest::noBar, "radii",
        "least distance of a centre to the walls");
}


TEST(demHard, relaxClumps)
{
    // Cubes of nine spheres and balls through each other, sides periodic,
    // and a grain of dust in the middle of a ball
    const scalar w = 0.1;
    Foam::dem::periodicity period;
    for (const vector& n : {vector(1, 0, 0), vector(0, 1, 0), vector(0, 0, 1)})
    {
        period.append(Foam::dem::periodicity::seam{n, 0, w*n});
    }
    std::string shapes = cubeOfNine;
    shapes.insert
    (
        shapes.find('{') + 1,
        " ball { type sphere; diameter 0.01; }"
        " dust { type sphere; diameter 1e-4; } "
    );
    std::string dict = stuff("", "restitution 0.5; friction 0.5;");
    dict.replace(dict.find("shapes"), std::string::npos, shapes);
    std::string bodies = random(200, w, "cube");
    bodies.erase(bodies.rfind('}'));
    bodies += random(200, w, "ball", "c");
    bodies.erase(bodies.rfind("bodies"), 9);
    bodies.erase(bodies.rfind('}'));
    bodies += body("q", "ball", {0.05, 0.05, 0.05}, Foam::Zero)
      + body("r", "dust", {0.05, 0.05, 0.05}, Foam::Zero) + "}\n";

    demCase c
    (
        "start relax;\n" + dict + "stepControl { type contact; }\n" + bodies,
        Foam::Zero,
        Foam::List<Foam::dem::corners>(),
        [&](Foam::dem::demInput& input) { input.period = period; }
    );
    relaxed("hard05_clumps", c, 402);
}


TEST(demHard, relaxNoRoom)
{
    // Eight balls where there is room for one
    const std::string said = messageOf([&]()
    {
        demCase c
        (
            "start relax;\n" + stuff("", "restitution 0.5; friction 0.5;")
          + "stepControl { type contact; }\n"
            "walls { box { type box; min (0 0 0); max (0.011 0.011 0.011);"
            " side inside; material stuff; } }\n" + random(8, 0.011, "ball")
        );
    });
    for (const char* const part : {"still overlap by", "not enough room"})
    {
        EXPECT_NE(said.find(part), std::string::npos) << part << said;
    }
}


TEST(demHard, wallIntoBed)
{
    // 4 x 4 x 6 balls in a box, on which a lid comes down at 1 m/s until the
    // bed is 2 % shorter. Its work is in the balls
    const scalar w = 0.04, h = 0.0606;
    std::string dict =
        stuff("damping none; tangential none;", "")
      + "stepControl { type contact; }\nwalls\n{\n"
        "box { type box; min (0 0 0); max " + text(vector(w, w, 1))
      + "; side inside; material stuff; }\n"
        "lid { type rectangle; corner " + text(vector(0, 0, h))
      + "; edge1 " + text(vector(w, 0, 0)) + "; edge2 "
      + text(vector(0, w, 0)) + "; material stuff;\n"
        "motion { type translate; velocity (0 0 -1); stop "
      + text(0.02*h) + "; } }\n}\nbodies\n{\n";
    for (int n = 0; n < 96; ++n)
    {
        const vector x(n % 4, n/4 % 4, n/16);
        dict += body
        (
            "b" + std::to_string(n),
            "ball",
            0.01*x + vector(0.005, 0.005, 0.005 + 1e-4*x.z()),
            Foam::Zero
        );
    }
    demCase c(dict + "}\n");
    // Hertz' force on the lid and energy of all springs, from where the
    // balls are
    const scalar r = 0.005, E = 1e8/(2*(1 - 0.3*0.3));
    const auto spring = [&](const scalar rStar, const scalar overlap)
    {
        return 8.0/15.0*E*std::sqrt(rStar)
           *std::pow(std::max(overlap, scalar(0)), 2.5);
    };
    const auto energy = [&](const scalar lid)
    {
        scalar e = c.state().kineticEnergy();
        for (label i = 0; i < 96; ++i)
        {
            const point& x = c.state().x[i];
            for (label j = 0; j < i; ++j)
            {
                e += spring(0.5*r, 2*r - mag(x - c.state().x[j]));
            }
            e += spring(r, r - x.z()) + spring(r, r - (lid - x.z()));
            for (int d = 0; d < 2; ++d)
            {
                e += spring(r, r - x[d]) + spring(r, r - (w - x[d]));
            }
        }
        return e;
    };
    const auto push = [&](const scalar lid)
    {
        scalar F = 0;
        for (const point& x : c.state().x)
        {
            const scalar depth = std::max(r - (lid - x.z()), scalar(0));
            F += 4.0/3.0*E*std::sqrt(r)*std::pow(depth, 1.5);
        }
        return F;
    };
    scalar overlap = 0, F = push(h), work = 0, peak = 0, jump = 0;
    const scalar e0 = energy(h), dt = 2e-6;
    for (int n = 1; n <= 606; ++n)
    {
        c.run(dt);
        overlap = std::max(overlap, c.solver().report().overlap);
        const scalar now = push(h - n*dt);
        work += 0.5*(now + F)*dt;
        jump = std::max(jump, std::abs(now - F));
        peak = std::max(peak, now);
        F = now;
    }
    figureNear("hard06_energy", energy(0.98*h) - e0, work, 0.01, "J",
        "work of the lid");
    figure("hard06_smooth", jump/peak, 1e-4, 0.02, "of the largest force",
        "largest change of the lid's force in 2e-6 s");
    for (int n = 0; n < 18; ++n)
    {
        c.run(1e-4);
        overlap = std::max(overlap, c.solver().report().overlap);
    }
    label nOut = 0;
    for (label b = 0; b < 96; ++b)
    {
        const point& x = c.state().x[b];
        nOut += !(x.z() > 0.004 && x.z() < 0.98*h && std::abs(x.x() - 0.5*w)
          < 0.5*w && std::abs(x.y() - 0.5*w) < 0.5*w);
    }
    figure("hardLid_lost", nOut, 0, 0, "balls", "all are below the lid");
    figure
    (
        "hardLid_overlap",
        overlap,
        0.005,
        0.1,
        "radii",
        "pressed by 2 % of the height: 0.04 a contact, more in the wave"
    );

    // No energy but what the lid gave while it moved
    const auto speed2 = [&]()
    {
        return c.state().kineticEnergy();
    };
    scalar most = 0;
    for (int n = 0; n < 20; ++n)
    {
        c.run(1e-4);
        most = std::max(most, speed2());
    }
    scalar later = 0;
    for (int n = 0; n < 100; ++n)
    {
        c.run(1e-4);
        later = std::max(later, speed2());
    }
    figure
    (
        "hardLid_energy",
        later/most,
        0,
        2,
        "-",
        "kinetic energy does not grow after the lid has stopped"
    );
}


TEST(demHard, headOn)
{
    // Two balls of 1 cm meet at 100 m/s
    demCase c
    (
        stuff("", "restitution 0.9; friction 0.5;")
      + "stepControl { type contact; }\nbodies\n{\n"
      + body("a", "ball", {0, 0, 0}, {50, 0, 0})
      + body("b", "ball", {0.02, 0, 0}, {-50, 0, 0}) + "}\n"
    );
    c.run(2e-3);
    EXPECT_EQ(c.solver().report().nContacts, 0);
    figureNear("hard02_restitution",
        (c.state().v[1].x() - c.state().v[0].x())/100, 0.9, 0.01, "-",
        "given, at 100 m/s");
}


TEST(demHard, thousandAtTriangle)
{
    // A ball at 1,000 m/s against one triangle, with both step controls that
    // choose; also where it starts right before it
    const Foam::List<Foam::dem::corners> triangle
    (
        1,
        Foam::dem::corners{{-1, -1, 0}, {1, -1, 0}, {0, 2, 0}}
    );
    scalar worst = 0;
    for (const char* const control : {"hades", "contact"})
    {
        for (const scalar z : {0.00501, 0.02, 1.7})
        {
            demCase c
            (
                "demSolver hades;\ncontact { damping none;"
                " tangential none; }\nmaterials { stuff { density 2500;"
                " youngsModulus 1e11; poissonsRatio 0.3; } }\n"
                "pairs { stuff-stuff {} }\n"
                "shapes { ball { type sphere; diameter 0.01; } }\n"
                "walls { w { type patch; material stuff; } }\n"
                "stepControl { type " + std::string(control) + "; }\n"
                "bodies\n{\n"
              + body("b", "ball", {0.1, 0.2, z}, {0, 0, -1000}) + "}\n",
                Foam::Zero,
                triangle
            );
            c.run(2*z/1000 + 1e-4);
            EXPECT_GT(c.state().x[0].z(), 0);
            worst = std::max(worst, std::abs(c.state().v[0].z()/1000 - 1));
        }
    }
    figure("hard07_bounce", worst, 0, 0.01, "of 1,000 m/s",
        "comes back as fast");
}


TEST(demHard, sizesMillionApart)
{
    // Dust of 1 um flies onto a rock of 1 m that lies on the floor
    demCase c
    (
        stuff("damping none; tangential none;", "")
      + "stepControl { type contact; }\n"
        "walls { floor { type plane; point (0 0 0); normal (0 0 1);"
        " material stuff; } }\nbodies\n{\n"
      + body("r", "rock", {0, 0, 0.5 - 1e-6}, Foam::Zero)
      + body("d", "dust", {0, 0, 1 + 1e-5}, {0, 0, -1})
      + "}\n",
        gravity
    );
    c.run(3e-5);
    figure
    (
        "hardSizes_bounce",
        c.state().v[1].z(),
        0.99,
        1.01,
        "m/s",
        "comes back as it came, 1 m/s"
    );
    EXPECT_LT(mag(c.state().v[0]), 1e-3);
}


TEST(demHard, fixedHundredTimesTooLong)
{
    // A twentieth of the contact would do
    const std::string said = messageOf([&]()
    {
        demCase c
        (
            stuff("", "restitution 0.5; friction 0.5;")
          + "stepControl { type fixed; deltaT 1e-3; }\n"
            "walls { floor { type plane; point (0 0 0); normal (0 0 1);"
            " material stuff; } }\nbodies\n{\n"
          + body("b", "ball", {0, 0, 0.02}, {0, 0, -1}) + "}\n",
            gravity
        );
        c.run(0.1);
    });
    for (const char* const part : {"fixed deltaT is 0.001", "body 0", "need"})
    {
        EXPECT_NE(said.find(part), std::string::npos) << part << said;
    }
}


// ************************************************************************* //
