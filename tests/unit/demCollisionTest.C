/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description

Description
    Many bodies: what is conserved when they collide, the energy of an elastic
    gas, and what stays when one of them is removed.

\*---------------------------------------------------------------------------*/

#include "demCase.H"

#include <cmath>
#include <random>

using namespace styxTest;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const std::string stuff
(
    "demSolver hades;\n"
    "materials { stuff { density 2500; youngsModulus 1e7;"
    " poissonsRatio 0.3; } }\n"
);


//- Angular momentum about the origin [kg m2/s]
vector angularMomentum(const Foam::dem::bodies& b)
{
    vector sum(Foam::Zero);
    for (label i = 0; i < b.size(); ++i)
    {
        sum += b.L(i) + (b.x[i] ^ (b.mass[i]*b.v[i]));
    }
    return sum;
}


//- Energy of the spheres' motion and of their contacts with each other and
//  with the walls of a box of that half width [J]
scalar energyOfGas(const Foam::dem::bodies& b, const scalar w)
{
    scalar e = b.kineticEnergy();

    const scalar EStar = 1e7/(2*(1 - 0.3*0.3));
    const auto spring = [&](const scalar rStar, const scalar overlap)
    {
        return
            overlap > 0
          ? 8.0/15.0*EStar*std::sqrt(rStar)*std::pow(overlap, 2.5)
          : 0;
    };

    for (label i = 0; i < b.size(); ++i)
    {
        const scalar r = b.sphereR[i];
        for (label j = 0; j < i; ++j)
        {
            e += spring(0.5*r, 2*r - mag(b.x[i] - b.x[j]));
        }
        for (int d = 0; d < 3; ++d)
        {
            e += spring(r, r - (w - std::abs(b.x[i][d])));
        }
    }
    return e;
}


//- Figure of the energy of an elastic gas in a box
void elasticGas(const std::string& name, const std::string& stepControl)
{
    const scalar w = 0.02;
    std::string dict =
        stuff
      + "contact { damping none; tangential none; }\n"
        "pairs { stuff-stuff {} }\n"
        "shapes { ball { type sphere; diameter 0.002; } }\n"
        "stepControl { " + stepControl + " }\nwalls\n{\n";

    for (int d = 0; d < 6; ++d)
    {
        vector n(Foam::Zero);
        n[d/2] = d % 2 ? 1 : -1;
        dict +=
            "w" + std::to_string(d) + " { type plane; point " + text(-w*n)
          + "; normal " + text(n) + "; material stuff; }\n";
    }
    dict += "}\nbodies\n{\n";

    std::mt19937 random(1);
    const auto uniform = [&]() { return random()/2147483648.0 - 1; };
    for (int n = 0; n < 343; ++n)
    {
        const vector cell(n % 7 - 3, (n/7) % 7 - 3, n/49 - 3);
        const vector shift(uniform(), uniform(), uniform());
        dict +=
            "b" + std::to_string(n) + " { shape ball; material stuff;"
            " position " + text(0.0053*cell + 0.001*shift) + "; velocity "
          + text(vector(uniform(), uniform(), uniform())) + "; }\n";
    }
    demCase c(dict + "}\n");

    const scalar e0 = energyOfGas(c.state(), w);
    scalar worst = 0;
    for (int n = 0; n < 20; ++n)
    {
        c.run(0.01);
        const scalar e = energyOfGas(c.state(), w);
        worst = std::max(worst, std::abs(e/e0 - 1));
    }
    std::cout
        << c.nSteps << " steps, " << c.nRejected << " rejected, energy "
        << energyOfGas(c.state(), w)/e0 - 1 << std::endl;
    EXPECT_EQ(c.state().size(), 343);
    figure
    (
        name,
        worst,
        0,
        1e-3,
        "-",
        "343 spheres, 0.2 s, exact 0"
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(demCollision, momentum)
{
    // Eight cubes fly at each other, with friction and damping
    std::string dict =
        stuff + cubeOfNine
      + "pairs { stuff-stuff { restitution 0.5; friction 0.6; } }\n"
        "stepControl { type hades; }\nbodies\n{\n";

    for (int n = 0; n < 8; ++n)
    {
        const vector corner(n & 1 ? 1 : -1, n & 2 ? 1 : -1, n & 4 ? 1 : -1);
        dict +=
            "b" + std::to_string(n) + " { shape cube; material stuff;"
            " position " + text(0.02*corner + vector(0.1, 0.2, -0.1))
          + "; velocity " + text((0.5 + 0.1*n)*-corner)
          + "; angularVelocity " + text(10.0*n*vector(1, 2, -1))
          + "; rotation ((1 1 0) " + std::to_string(30*n) + "); }\n";
    }

    demCase c(dict + "}\n");
    const vector p0 = c.state().momentum();
    const vector L0 = angularMomentum(c.state());
    const scalar e0 = c.state().kineticEnergy();

    // The size of the sums, without the signs
    scalar size = 0;
    for (label i = 0; i < 8; ++i)
    {
        size += c.state().mass[i]*mag(c.state().v[i]);
    }
    c.run(0.1);

    // They did collide
    EXPECT_LT(c.state().kineticEnergy(), 0.7*e0);
    figure
    (
        "collisionMomentum",
        mag(c.state().momentum() - p0)/size,
        0,
        1e-12,
        "-",
        "exact 0"
    );
    figure
    (
        "collisionAngularMomentum",
        mag(angularMomentum(c.state()) - L0)/(size*0.25),
        0,
        1e-12,
        "-",
        "exact 0"
    );
}


TEST(demCollision, elasticGas)
{
    elasticGas("elasticGas_energy", "type hades;");
}


TEST(demCollision, elasticGasFixed)
{
    elasticGas("elasticGas_energyFixedStep", "type fixed; deltaT 1e-5;");
}


TEST(demCollision, removal)
{
    // Two balls lie on each other on the floor, turning; others, listed before
    // and between them, are taken out. Their contacts keep their slip.
    const auto dict = [](const bool others)
    {
        return
            stuff
          + "pairs { stuff-stuff { restitution 0.5; friction 0.6; } }\n"
            "shapes { ball { type sphere; diameter 0.01; } }\n"
            "stepControl { type fixed; deltaT 1e-5; }\n"
            "walls { floor { type plane; point (0 0 0); normal (0 0 1);"
            " material stuff; } }\n"
            "bodies\n{\n"
          + (
                others
              ? "c { shape ball; material stuff; position (1 0 0.005); }\n"
              : ""
            )
          + "a { shape ball; material stuff; position (0 0 0.005); }\n"
          + (
                others
              ? "d { shape ball; material stuff; position (2 0 0.005); }\n"
              : ""
            )
          + "b { shape ball; material stuff; position (0 0 0.015);"
            " angularVelocity (0 10 20); }\n}\n";
    };

    demCase with(dict(true), gravity);
    demCase without(dict(false), gravity);

    with.run(0.01);
    without.run(0.01);

    Foam::boolList marked(4, false);
    marked[0] = true;
    marked[2] = true;
    with.solver().remove(marked);
    EXPECT_EQ(with.state().size(), 2);
    EXPECT_EQ(with.state().id[0], 1);
    EXPECT_EQ(with.state().id[1], 3);

    with.run(0.01);
    without.run(0.01);

    EXPECT_EQ(without.solver().report().nContacts, 2);
    for (label i = 0; i < 2; ++i)
    {
        EXPECT_EQ(with.state().x[i], without.state().x[i]);
        EXPECT_EQ(with.state().L(i), without.state().L(i));
        EXPECT_EQ(with.state().force[i], without.state().force[i]);
    }

    // All of them
    with.solver().remove(Foam::boolList(2, true));
    EXPECT_EQ(with.state().nSpheres(), 0);
    EXPECT_NO_THROW(with.run(0.01));
}


// ************************************************************************* //
