/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    multiContact share: clumps of spheres at nearly one place against the one
    sphere that they stand for.

\*---------------------------------------------------------------------------*/

#include "demCase.H"

#include <cmath>

using namespace styxTest;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const scalar r = 0.005;
const scalar u = 0.5;

//- A clump of so many spheres of radius r, at most 1e-6 r from its centre
std::string clump(const int n)
{
    std::string shape("ball { type multisphere; spheres (");
    for (int k = 0; k < n; ++k)
    {
        const scalar angle = 2*M_PI*k/n;
        shape +=
            "(" + text(1e-6*r*vector(std::cos(angle), std::sin(angle), 0))
          + " " + text(r) + ") ";
    }
    return shape + "); }";
}

const std::string elasticLaws("damping none; tangential none;");

const std::string sphere("ball { type sphere; diameter 0.01; }");

struct impactResult
{
    scalar overlap = 0;
    scalar duration = 0;
    scalar speed = 0;
    scalar spin = 0;
};

//- Something that hits a plane, or its like, at a slant
impactResult hit
(
    const std::string& shape,
    const std::string& laws,
    const bool wall,
    const scalar across = 0
)
{
    const bool elastic = laws.find("damping none") < laws.size();
    demCase c
    (
        "demSolver hades;\ncontact { " + laws + " }\n"
        "materials { rock { density 2500; youngsModulus 1e7;"
        " poissonsRatio 0.3; } }\n"
        "pairs { rock-rock { "
      + std::string(elastic ? "" : "restitution 0.5; friction 0.3;") + " } }\n"
        "shapes { " + shape + " }\n"
      + (
            wall
          ? "walls { board { type plane; point (0 0 0); normal (0 0 1);"
            " material rock; } }\n"
          : ""
        )
      + "stepControl { type hades; contactSteps 100; }\n"
        "bodies { a { shape ball; material rock; position (0 0 0.00501);"
        " velocity " + text(vector(across, 0, -u)) + "; }\n"
      + (
            wall
          ? ""
          : "b { shape ball; material rock; position (0 0 -0.00501);"
            " velocity (0 0 " + text(u) + "); }\n"
        )
      + "}\n"
    );
    impactResult result;
    for (int n = 0; n < 4000 && c.state().v[0].z() < 0.999*u; ++n)
    {
        c.run(1e-6);
        result.overlap = std::max(result.overlap, c.solver().report().overlap);
        result.duration += 1e-6*(c.solver().report().nContacts > 0);
    }
    result.speed = c.state().v[0].z();
    result.spin = c.state().omega[0].y();
    return result;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(demShare, oneSphere)
{
    // Figures "share_wall_4_overlap", "share_pair_4_overlap", ...
    for (const bool wall : {true, false})
    {
        const impactResult one = hit(sphere, "", wall);
        for (const int n : {2, 4, 9})
        {
            const impactResult many =
                hit(clump(n), "multiContact share;", wall);
            const std::string name =
                std::string("share_") + (wall ? "wall_" : "pair_")
              + std::to_string(n);
            const std::string source("one sphere of the same shape");
            figureNear
            (
                name + "_overlap", many.overlap, one.overlap, 0.002, "radii",
                source
            );
            figureNear
            (
                name + "_time", many.duration, one.duration, 0.005, "s",
                source
            );
            figureNear
            (
                name + "_restitution", many.speed/u, 0.5, 0.01, "-",
                "restitution 0.5 of the pair"
            );
        }
    }

    // What it is worth: without, the contacts are as many times as stiff
    const impactResult one = hit(sphere, elasticLaws, true);
    const impactResult four = hit(clump(4), elasticLaws, true);
    figureNear
    (
        "share_without", four.overlap/one.overlap, std::pow(0.25, 0.4), 0.01,
        "-", "closed form (1/4)^(2/5) of Hertz' law"
    );
}


TEST(demShare, oblique)
{
    const impactResult one = hit(sphere, "", true, 0.3);
    const impactResult many = hit(clump(4), "multiContact share;", true, 0.3);
    figureNear
    (
        "share_spin", many.spin, one.spin, 0.005, "rad/s",
        "one sphere of the same shape"
    );
}


TEST(demShare, cube)
{
    // Nine spheres on a slope: at rest below atan(mu), as without sharing, and
    // sunk in as one of them under the whole weight
    const scalar angle = 0.8*std::atan(0.5);
    demCase c
    (
        "demSolver hades;\ncontact { multiContact share; }\n"
        "materials { rock { density 2500; youngsModulus 1e7;"
        " poissonsRatio 0.3; } }\n"
        "pairs { rock-rock { restitution 0.3; friction 0.5; } }\n"
      + cubeOfNine
      + "walls { board { type plane; point (0 0 0); normal (0 0 1);"
        " material rock; } }\n"
        "stepControl { type hades; }\n"
        "bodies { a { shape cube; material rock; position (0 0 0.00685); } }\n",
        9.81*vector(std::sin(angle), 0, -std::cos(angle))
    );
    c.run(0.5);
    const point x = c.state().x[0];
    c.run(1);
    figure
    (
        "share_cubeRests", mag(c.state().x[0] - x)/0.012, 0, 1e-6,
        "edges in 1 s", "at rest below atan(mu)"
    );
}


TEST(demShare, energy)
{
    // The shares are no potential: what elastic impacts of cubes on a plane and
    // on each other in many orientations gain or lose. Figures
    // "shareEnergy_wall_gain", "shareEnergy_wall_loss", ...
    for (const bool wall : {true, false})
    {
        scalar gain = 0, loss = 0;
        for (int n = 0; n < 24; ++n)
        {
            demCase c
            (
                "demSolver hades;\ncontact { multiContact share;"
                " tangential none; damping none; }\n"
                "materials { rock { density 2500; youngsModulus 1e7;"
                " poissonsRatio 0.3; } }\npairs { rock-rock { } }\n"
              + cubeOfNine
              + (
                    wall
                  ? "walls { board { type plane; point (0 0 0);"
                    " normal (0 0 1); material rock; } }\n"
                  : ""
                )
              + "stepControl { type hades; contactSteps 100; }\n"
                "bodies { a { shape cube; material rock; position (0 0 0.012);"
                " velocity (0 0 -0.5); rotation ((1 2 0) "
              + text(0.75*(n + 1)) + "); }"
              + (
                    wall
                  ? ""
                  : " b { shape cube; material rock; position (0.001 0 -0.005);"
                    " rotation ((2 1 1) " + text(0.3*n) + "); }"
                )
              + " }\n"
            );
            const auto energy = [&]()
            {
                const Foam::dem::bodies& b = c.state();
                scalar sum = 0;
                for (label k = 0; k < b.size(); ++k)
                {
                    sum +=
                        0.5*b.mass[k]*magSqr(b.v[k])
                      + 0.5*(b.L(k) & b.omega[k]);
                }
                return sum;
            };
            const scalar before = energy();
            c.run(0.05);
            gain = std::max(gain, energy()/before - 1);
            loss = std::max(loss, 1 - energy()/before);
        }
        const std::string name
        (
            wall ? "shareEnergy_wall" : "shareEnergy_pair"
        );
        figure
        (
            name + "_gain", gain, 0, 0.001, "of the kinetic energy", "elastic"
        );
        figure
        (
            name + "_loss", loss, 0, 0.25, "of the kinetic energy",
            "no closed form: the share has no potential"
        );
    }
}


TEST(demShare, contacts)
{
    // Each contact by itself, which meters and the watchdog ask for, has its
    // share, too: a clump on a floor and one on top of it
    demCase c
    (
        "demSolver hades;\ncontact { damping none; rolling constant;"
        " multiContact share; }\n"
        "materials { rock { density 2500; youngsModulus 1e7;"
        " poissonsRatio 0.3; } }\n"
        "pairs { rock-rock { friction 0.3; rollingFriction 0.1; } }\n"
        "shapes { " + clump(4) + " }\n"
        "walls { board { type plane; point (0 0 0); normal (0 0 1);"
        " material rock; } }\n"
        "stepControl { type fixed; deltaT 2e-6; }\n"
        "start relax;\n"
        "bodies {\n"
        "a { shape ball; material rock; position (0 0 0.00499);"
        " velocity (0 0 -0.1); }\n"
        "b { shape ball; material rock; position (0.001 0 0.01488);"
        " velocity (0.05 0 -0.4); } }\n",
        gravity
    );
    c.run(2e-4);

    const Foam::List<Foam::dem::contactForce> all(c.solver().contacts());
    EXPECT_GE(all.size(), 8);
    Foam::vectorField sum(2, vector(Foam::Zero));
    scalar largest = 0;
    for (const Foam::dem::contactForce& f : all)
    {
        sum[f.a] += f.force;
        if (f.b >= 0)
        {
            sum[f.b] -= f.force;
        }
        largest = std::max(largest, mag(f.force));
    }
    scalar worst = 0;
    for (label b = 0; b < 2; ++b)
    {
        const vector on(sum[b] + c.state().mass[b]*gravity);
        worst = std::max(worst, mag(on - c.state().force[b])/largest);
    }
    figure
    (
        "shareContacts_sum", worst, 0, 1e-9, "-",
        "their sum and the weight against the force on the body"
    );
}


// ************************************************************************* //
