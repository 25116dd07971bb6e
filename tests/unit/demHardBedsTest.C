/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description

Description
    Hard cases of beds of spheres (doc/validation.md, hard): steel that is
    dropped, fine grains under a coarse one, a bed that is left alone for a
    million steps, a gas without losses, no bodies at all.

\*---------------------------------------------------------------------------*/

#include "demCase.H"

#include <cmath>
#include <random>

using namespace styxTest;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- n x n x nz spheres on a lattice of a pitch over the diameter, each shaken
//  by a twentieth of the diameter and with a random velocity up to speed
std::string lattice
(
    const std::string& shape,
    const scalar d,
    const scalar pitch,
    const label n,
    const label nz,
    const point& corner,
    const scalar speed
)
{
    std::mt19937 random(3);
    const auto uniform = [&]() { return random()/2147483648.0 - 1; };
    std::string s;
    for (label k = 0; k < n*n*nz; ++k)
    {
        const vector cell(k % n + 0.5, k/n % n + 0.5, k/n/n + 0.5);
        const vector shake(uniform(), uniform(), uniform());
        const vector v(uniform(), uniform(), uniform());
        s += shape + std::to_string(k) + " { shape " + shape
          + "; material stuff; position "
          + text(corner + d*(pitch*cell + 0.05*shake)) + "; velocity "
          + text(speed*v) + "; }\n";
    }
    return s;
}


std::string stuff
(
    const std::string& density,
    const std::string& E,
    const std::string& contact,
    const std::string& pair,
    const std::string& shapes
)
{
    return
        "demSolver hades;\ncontact { " + contact + " }\n"
        "materials { stuff { density " + density + "; youngsModulus " + E
      + "; poissonsRatio 0.3; } }\npairs { stuff-stuff { " + pair + " } }\n"
        "shapes { " + shapes + " }\n";
}


//- Potential energy of gravity [J]
scalar height(const Foam::dem::bodies& b)
{
    scalar e = 0;
    forAll(b.x, i)
    {
        e += 9.81*b.mass[i]*b.x[i].z();
    }
    return e;
}


//- Steel spheres of 1 mm dropped into a box; figures of their energy
void dropSteel(const std::string& name, const label n, const scalar end)
{
    const scalar w = 0.0013*n;
    demCase c
    (
        stuff
        (
            "7800", "2e11", "", "restitution 0.7; friction 0.3;",
            "ball { type sphere; diameter 0.001; }"
        )
      + "stepControl { type contact; }\nwalls { box { type box; min (0 0 0);"
        " max " + text(vector(w, w, 1)) + "; side inside; material stuff; } }"
        "\nbodies\n{\n" + lattice("ball", 0.001, 1.3, n, n, {0, 0, 0.01}, 0)
      + "}\n",
        gravity
    );
    const scalar start = height(c.state());

    scalar worst = 0;
    while (c.time() < end - 1e-9)
    {
        c.run(0.002);
        const scalar released = start - height(c.state());
        worst = std::max(worst, c.state().kineticEnergy()/released);
    }
    figure(name + "_energy", worst, 0.5, 1 + 1e-9,
        "of what was released", "kinetic energy, largest of all times");
    label nLost = 0;
    for (const point& x : c.state().x)
    {
        nLost += !(x.z() > 0.0004 && x.x() > 0 && x.x() < w && x.y() > 0
          && x.y() < w && x.z() < 0.02 + w);
    }
    figure(name + "_lost", nLost, 0, 0, "spheres", "all are in the box");
    if (end > 0.9)
    {
        figure
        (
            name + "_rest",
            c.state().kineticEnergy()/(start - height(c.state())),
            0,
            1e-6,
            "of what was released",
            "at rest at 1 s"
        );
    }
}


//- A bed that has settled for 0.6 s, and so many steps after that
void leaveAlone(const std::string& name, const label n, const label nSteps)
{
    const scalar d = 0.002, w = 1.1*d*n, dt = 1e-5;
    demCase c
    (
        stuff
        (
            "2500", "5e6", "", "restitution 0.5; friction 0.5;",
            "ball { type sphere; diameter 0.002; }"
        )
      + "stepControl { type fixed; deltaT 1e-5; }\n"
        "walls { box { type box; min (0 0 0); max " + text(vector(w, w, 1))
      + "; side inside; material stuff; } }\nbodies\n{\n"
      + lattice("ball", d, 1.1, n, n, {0, 0, 0}, 0) + "}\n",
        gravity
    );
    c.run(0.6);
    const auto top = [&]()
    {
        scalar z = 0;
        for (const point& x : c.state().x)
        {
            z = std::max(z, x.z());
        }
        return z;
    };
    const scalar before = top();
    scalar early = 0, late = 0;
    for (label k = 0; k < 20; ++k)
    {
        c.run(0.05*nSteps*dt);
        (k < 10 ? early : late) += c.state().kineticEnergy();
    }
    figure(name + "_top", std::abs(top() - before)/d, 0, 1e-3, "d",
        "how far the top moves");

    // The weight of a ball over a millionth of its size: nothing at all
    const scalar least = 1e-6*9.81*c.state().mass[0]*d;
    figure
    (
        name + "_growth",
        late/std::max(early, 10*least),
        0,
        1.05,
        "-",
        "kinetic energy of the second half over that of the first"
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(demHardBeds, steel)
{
    dropSteel("hard01_few", 4, 0.15);
}


TEST(demHardBeds, steelFull)
{
    dropSteel("hard01", 10, 1);
}


TEST(demHardBeds, coarseOnFineFull)
{
    // A ball of 1 mm is put on grains of 10 um that have settled in a cup
    const scalar d = 1e-5, R = 5e-4, cup = 1.05e-4;
    const auto grain = [](const label k, const point& x)
    {
        return
            "g" + std::to_string(k)
          + " { shape grain; material stuff; position " + text(x) + "; }\n";
    };
    const std::string head =
        "start relax;\n"
      + stuff
        (
            "2500", "2e9", "", "restitution 0.5; friction 0.5;",
            "grain { type sphere; diameter 1e-5; }"
            " ball { type sphere; diameter 1e-3; }"
        )
      + "stepControl { type contact; }\nwalls\n{\n"
        "floor { type plane; point (0 0 0); normal (0 0 1); material stuff; }\n"
        "cup { type cylinder; point (0 0 -1e-5); axis (0 0 1); radius "
      + text(cup) + "; length 3e-5; ends open; material stuff; }\n}\n"
        "bodies\n{\n";
    std::string bodies;
    label n = 0;
    std::mt19937 random(5);
    const auto uniform = [&]() { return random()/2147483648.0 - 1; };
    for (label k = 0; k < 16*16*3; ++k)
    {
        const vector cell(k % 16 - 7.5, k/16 % 16 - 7.5, k/256 + 0.6);
        const vector shake(uniform(), uniform(), uniform());
        const point x = 1.3*d*cell + 0.1*d*shake;
        if (std::hypot(x.x(), x.y()) < cup - 0.6*d)
        {
            bodies += grain(n++, x);
        }
    }
    demCase bed(head + bodies + "}\n", gravity);
    bed.run(3e-3);

    bodies = "";
    scalar low = 0;
    for (label k = 0; k < n; ++k)
    {
        const point& x = bed.state().x[k];
        bodies += grain(k, x);
        const scalar r = std::hypot(x.x(), x.y());
        low = std::max(low, x.z() + std::sqrt(std::pow(R + 0.5*d, 2) - r*r));
    }
    demCase c
    (
        head + bodies + "ball { shape ball; material stuff; position "
      + text(vector(0, 0, low + 0.02*d)) + "; }\n}\n",
        gravity
    );

    scalar overlap = 0;
    for (label k = 0; k < 50; ++k)
    {
        c.run(1e-4);
        overlap = std::max(overlap, c.solver().report().overlap);
    }
    figure("hard03_overlap", overlap, 1e-4, 0.05, "radii of a grain",
        "largest on the way to rest");

    // It bounces for long, as grains so light damp little
    EXPECT_GT(c.state().x[n].z(), R + 0.9*d);
    EXPECT_LT(c.state().x[n].z(), low + d);
}


TEST(demHardBeds, coarseRests)
{
    // A ball of 1 mm on a layer of 10 x 10 grains of 10 um
    const scalar d = 1e-5, R = 5e-4, pitch = 1.001*d;
    std::string bodies;
    for (label k = 0; k < 100; ++k)
    {
        bodies += "g" + std::to_string(k)
          + " { shape grain; material stuff; position "
          + text(vector(pitch*(k % 10), pitch*(k/10), 0.5*d)) + "; }\n";
    }
    const scalar side = std::sqrt(0.5)*pitch;
    const scalar z = 0.5*d + std::sqrt(std::pow(R + 0.5*d, 2) - side*side);
    demCase c
    (
        stuff
        (
            "2500", "1e9", "", "restitution 0.3; friction 0.5;",
            "grain { type sphere; diameter 1e-5; }"
            " ball { type sphere; diameter 1e-3; }"
        )
      + "stepControl { type contact; }\nwalls { floor { type plane;"
        " point (0 0 0); normal (0 0 1); material stuff; } }\nbodies\n{\n"
      + bodies + "ball { shape ball; material stuff; position "
      + text(vector(4.5*pitch, 4.5*pitch, z)) + "; }\n}\n",
        gravity
    );
    scalar overlap = 0;
    for (label k = 0; k < 30; ++k)
    {
        c.run(1e-4);
        overlap = std::max(overlap, c.solver().report().overlap);
    }
    label nUnder = 0;
    for (label k = 0; k < 100; ++k)
    {
        nUnder += mag(c.state().x[k] - c.state().x[100]) < R + 0.5*d;
    }
    figure("hard04_inside", 0.5*overlap, 1e-4, 0.01, "d of a grain",
        "deepest, largest of 3 ms");
    figure("hard04_carry", nUnder, 3, noBar, "grains", "that carry it");
    figure("hard04_sinks", z - c.state().x[100].z(), 0, 0.05*d, "m",
        "of the ball");
}


TEST(demHardBeds, leftAlone)
{
    leaveAlone("hard13_few", 4, 100000);
}


TEST(demHardBeds, leftAloneFull)
{
    leaveAlone("hard13", 6, 1000000);
}


TEST(demHardBeds, noBody)
{
    // None, then one after half of the run
    const std::string dict =
        stuff
        (
            "2500", "1e7", "", "restitution 0.5; friction 0.5;",
            "ball { type sphere; diameter 0.01; }"
        )
      + "stepControl { type contact; }\n";
    {
        demCase c(dict, gravity);
        c.run(1);
        figure("hard28_none", c.nSteps, 0, 0, "steps", "without a body");
        c.solver().enter(1);
        EXPECT_EQ(c.state().size(), 0);
    }

    demCase c
    (
        dict + "generators { late { type batch; times (0.5); number 1;"
        " shape ball; material stuff; region { box (0 0 1) (0 0 1); } } }\n",
        gravity
    );
    label before = 0;
    for (label k = 0; k < 10; ++k)
    {
        c.solver().enter(c.time());
        c.run(0.1);
        before += c.time() < 0.55 ? c.nSteps : 0;
    }
    figure("hard28_before", before, 0, 0, "steps", "before the first body");
    EXPECT_EQ(c.state().size(), 1);
    figureNear("hard28_falls", 1 - c.state().x[0].z(), 0.5*9.81*0.25, 1e-9,
        "m", "g t^2/2 since it came in at 0.5 s");
}


// ************************************************************************* //
