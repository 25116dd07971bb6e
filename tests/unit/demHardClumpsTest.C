/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description

Description
    Hard cases of clumps (doc/validation.md, hard): a tower of cubes, 500
    spheres against one, plates and needles that tumble, a rod that spins about
    its middle axis.

\*---------------------------------------------------------------------------*/

#include "demCase.H"
#include "rotation.H"

#include <cmath>
#include <random>

using namespace styxTest;
using namespace Foam::dem;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- A box of spheres of diameter d, a pitch of so many d apart
std::string boxOfSpheres
(
    const std::string& name,
    const scalar d,
    const scalar pitch,
    const Foam::labelVector& n
)
{
    std::string s = name + " { type multisphere; spheres (";
    for (label k = 0; k < n.x()*n.y()*n.z(); ++k)
    {
        const vector cell(k % n.x(), k/n.x() % n.y(), k/n.x()/n.y());
        s += " (" + text(pitch*d*cell) + " " + text(0.5*d) + ")";
    }
    return s + "); }\n";
}


std::string head
(
    const std::string& contact,
    const std::string& pair,
    const std::string& E,
    const std::string& stepControl,
    const std::string& shapes
)
{
    return
        "demSolver hades;\ncontact { " + contact + " }\n"
        "materials { stuff { density 1000; youngsModulus " + E
      + "; poissonsRatio 0.3; } }\npairs { stuff-stuff { " + pair + " } }\n"
        "stepControl { " + stepControl + " }\n" + shapes;
}


std::string body
(
    const std::string& name,
    const std::string& shape,
    const vector& x,
    const vector& v,
    const vector& spin
)
{
    return
        name + " { shape " + shape + "; material stuff; position " + text(x)
      + "; velocity " + text(v) + "; angularVelocity " + text(spin) + "; }\n";
}


//- Where the 27 cubes of a tower are after a time [s]
Foam::pointField tower(const scalar end, const std::string& E)
{
    std::string bodies = "bodies\n{\n";
    for (label k = 0; k < 27; ++k)
    {
        bodies += body
        (
            "b" + std::to_string(k),
            "cube",
            {0, 0, 0.00685 + 0.0137*k},
            Foam::Zero,
            Foam::Zero
        );
    }
    demCase c
    (
        head
        (
            "", "restitution 0.5; friction 0.5;", E, "type contact;", cubeOfNine
        )
      + "walls { floor { type plane; point (0 0 0); normal (0 0 1);"
        " material stuff; } }\n" + bodies + "}\n",
        gravity
    );
    c.run(end);
    return Foam::pointField(c.state().x);
}


//- Energy of bodies without damping that tumble in a box: the largest drift
//  while nothing touches
scalar tumble
(
    const std::string& shapes,
    const std::string& bodies,
    const std::string& control,
    label& nSteps
)
{
    nSteps = 0;
    demCase c
    (
        head
        (
            "damping none; tangential none;", "", "1e7",
            "type contact; " + control,
            "shapes {\n" + shapes + "}\n"
        )
      + "walls { box { type box; min (0 0 0); max (0.05 0.05 0.05);"
        " side inside; material stuff; } }\nbodies\n{\n" + bodies + "}\n"
    );
    const scalar e0 = c.state().kineticEnergy();
    scalar worst = 0;
    label nHits = 0;
    for (label k = 0; k < 200; ++k)
    {
        c.run(1e-3);
        nSteps += c.solver().report().nSteps;
        if (c.solver().report().nContacts == 0)
        {
            worst = std::max
            (
                worst,
                std::abs(c.state().kineticEnergy()/e0 - 1)
            );
        }
        else
        {
            ++nHits;
        }
    }
    EXPECT_GT(nHits, 1);
    return worst;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(demHardClumps, towerFull)
{
    // Of 1e7 Pa it buckles by its own weight, as a column of that stiffness at
    // the contacts must from 0.24 m on (q L^3 = 7.8 E I)
    const Foam::pointField x = tower(10, "1e9");
    const vector moved = x[26] - vector(0, 0, 0.00685 + 0.0137*26);
    figure
    (
        "hard09_top",
        std::hypot(moved.x(), moved.y())/0.0137,
        0,
        0.1,
        "edges",
        "27 cubes upon each other stand for 10 s"
    );
    figure("hard09_sinks", -moved.z()/0.0137, 0, 0.5, "edges",
        "they give way to their weight");
}


TEST(demHardClumps, fiveHundredOnOne)
{
    // 500 spheres at random in a ball of 10 mm, a sphere that hits it
    std::mt19937 random(2);
    const auto uniform = [&]() { return random()/2147483648.0 - 1; };
    std::string shapes = "shapes {\nlump { type multisphere; spheres (";
    for (label n = 0; n < 500;)
    {
        const vector x(uniform(), uniform(), uniform());
        if (magSqr(x) < 1)
        {
            shapes += " (" + text(0.004*x) + " 0.001)";
            ++n;
        }
    }
    shapes += "); }\nball { type sphere; diameter 0.004; } }\n";
    demCase c
    (
        head
        (
            "damping none; tangential none;", "", "1e8",
            "type contact; contactFraction 0.005; rayleighFraction 0.05;",
            shapes
        )
      + "bodies\n{\n"
      + body("l", "lump", Foam::Zero, Foam::Zero, Foam::Zero)
      + body("b", "ball", {0.001, 0.0005, 0.01}, {0, 0, -1}, Foam::Zero)
      + "}\n"
    );
    const vector p0 = c.state().momentum();
    const auto spin = [&]()
    {
        vector L(Foam::Zero);
        for (label b = 0; b < 2; ++b)
        {
            L += c.state().L(b)
              + c.state().mass[b]*(c.state().x[b] ^ c.state().v[b]);
        }
        return L;
    };
    const vector L0 = spin();
    const scalar e0 = c.state().kineticEnergy();
    c.run(0.01);

    EXPECT_GT(mag(c.state().v[0]), 0.01);
    EXPECT_EQ(c.solver().report().nContacts, 0);
    figure("hard10_momentum", mag(c.state().momentum() - p0)/mag(p0), 0, 1e-12,
        "-", "exact");
    figure("hard10_angular", mag(spin() - L0)/mag(L0), 0, 1e-10, "-", "exact");
    figure("hard10_energy", std::abs(c.state().kineticEnergy()/e0 - 1), 0,
        1e-3, "-", "without a loss");
}


TEST(demHardClumps, plateAndNeedle)
{
    const std::string plate = boxOfSpheres("plate", 0.001, 1, {20, 20, 1});
    const std::string needle = boxOfSpheres("needle", 0.001, 0.5, {39, 1, 1});
    const vector x(0.024, 0.025, 0.026), v(0.7, 0.4, 0.9), spin(60, 40, 20);
    const std::string thrownPlate = body("p", "plate", x, v, spin);
    const std::string thrownNeedle = body("n", "needle", x, v, spin);
    const std::string fine = "contactFraction 0.001;";
    label nSteps = 0;

    figure("hard11_plate", tumble(plate, thrownPlate, "", nSteps), 0, 1e-4,
        "-", "energy, 20:20:1, no damping, default steps");
    figure("hard11_needle", tumble(needle, thrownNeedle, "", nSteps), 0, 1e-4,
        "-", "energy, 20:1, the same");
    figure("hard11_needle_steps", nSteps, 500, 10000, "steps",
        "a flight is not bounded by |L| over the least moment");
    figure("hard11_plate_fine", tumble(plate, thrownPlate, fine, nSteps), 0,
        1e-5, "-", "1,000 steps a contact");
    figure("hard11_needle_fine", tumble(needle, thrownNeedle, fine, nSteps),
        0, 1e-5, "-", "the same");
}


TEST(demHardClumps, spinBound)
{
    // All free rotations of a body stay below it, and some come close
    using namespace Foam::dem;
    const vector I(1, 7, 7.5);
    scalar most = 0;
    std::mt19937 random(4);
    const auto uniform = [&]() { return random()/2147483648.0 - 1; };
    for (label trial = 0; trial < 200; ++trial)
    {
        Foam::quaternion q(Foam::quaternion::I);
        const vector spin(uniform(), uniform(), uniform());
        const vector L(cmptMultiply(I, spin));
        const scalar bound = largestSpin(L, spin, I);
        for (label k = 0; k < 5000; ++k)
        {
            turn(q, L, I, 0.01);
            const scalar part = mag(angularVelocity(q, L, I))/bound;
            most = std::max(most, part);
        }
    }
    figure("spinBound_most", most, 0.99, 1 + 1e-4, "of the bound",
        "200 free bodies, all moments different");
    figureNear
    (
        "spinBound_needle",
        largestSpin(vector(0, 700, 0), vector(0, 1, 0), vector(1, 700, 700)),
        1,
        1e-10,
        "rad/s",
        "a needle that spins across its axis at 1 rad/s"
    );
}


TEST(demHardClumps, rodAboutMiddleAxis)
{
    // 5 x 3 x 1 spheres: three different moments. A turn of 10 ms about the
    // middle one, in which it flips over and over
    demCase c
    (
        head
        (
            "damping none; tangential none;", "", "1e7",
            "type fixed; deltaT 2.5e-6;",
            "shapes {\n" + boxOfSpheres("rod", 0.001, 0.8, {5, 2, 1}) + "}\n"
        )
      + "bodies\n{\n" + body("r", "rod", Foam::Zero, Foam::Zero, {0, 0, 0})
      + "}\n"
    );
    bodies& b = c.state();
    const vector I = b.inertia(0);
    const scalar middle = I.x() + I.y() + I.z() - cmptMax(I) - cmptMin(I);
    const scalar omega = Foam::constant::mathematical::twoPi/0.01;
    vector inBody(1e-3, 1e-3, 1e-3);
    for (Foam::direction d = 0; d < 3; ++d)
    {
        inBody[d] = I[d]*omega*(I[d] == middle ? 1 : 1e-3);
    }
    b.setL(0, b.q[0].R() & inBody);
    b.update();

    const vector L0 = b.L(0);
    const scalar e0 = b.kineticEnergy();
    scalar energy = 0;
    label nFlips = 0;
    bool up = true;
    for (label k = 0; k < 1000; ++k)
    {
        c.run(0.01);
        energy = std::max(energy, std::abs(b.kineticEnergy()/e0 - 1));
        for (Foam::direction d = 0; d < 3; ++d)
        {
            if (I[d] == middle)
            {
                const bool now = (b.q[0].R().T() & b.L(0))[d] > 0;
                nFlips += now != up;
                up = now;
            }
        }
    }
    EXPECT_GT(nFlips, 50);
    figure("hard12_energy", energy, 0, 1e-6, "-",
        "1,000 turns about the middle axis, 4,000 steps a turn");
    figure("hard12_angularMomentum", mag(b.L(0) - L0)/mag(L0), 0, 1e-10, "-",
        "the same");
}


// ************************************************************************* //
