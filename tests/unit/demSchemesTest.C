/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    All integrators: the tables of thesis 4.4, with steps of one length and of
    several; turning clumps; contacts with and without slip; undone steps; the
    energy of an elastic gas.

\*---------------------------------------------------------------------------*/

#include "demCase.H"
#include "topShape.H"

#include <cmath>
#include <cstdio>
#include <random>

using namespace styxTest;
using namespace Foam::dem;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

struct scheme
{
    std::string name;
    label order;
};

const std::vector<scheme> schemes
{
    {"explicitEuler", 1},
    {"symplecticEuler", 1},
    {"stormerVerlet", 2},
    {"stormerVerletPosition", 2},
    {"implicitTrapezoidal", 2},
    {"rk4", 4},
    {"forestRuth", 4},
    {"pefrl", 4}
};


Foam::autoPtr<integrator> schemeOf(const std::string& name)
{
    return integrator::New(dictionaryOf("integrator " + name + ";"));
}


//- A body of mass 1
class oneBody
{
    Foam::PtrList<shape> shapes_;

    bodies state_;

public:

    explicit oneBody(const bool clump)
    :
        shapes_(1),
        state_(shapes_)
    {
        if (clump)
        {
            shapes_.set(0, styxTest::topShape());
        }
        else
        {
            shapes_.set(0, new shape(shape::sphere("ball", 1)));
        }
        newBody n;
        n.shapeI = 0;
        n.materialI = 0;
        n.density = 1/shapes_[0].volume();
        n.position = Foam::Zero;
        state_.append(n);
    }

    bodies& state()
    {
        return state_;
    }

    //- Move to t = 1 by n steps, of one length or of lengths 1, 1.5 and 0.5
    //  by turns. A function of time, position, velocity and rotation is the
    //  force; the torque is a function of time and rotation
    template<class Force, class Torque>
    void run
    (
        const std::string& name,
        const label n,
        const bool even,
        const Force& f,
        const Torque& T
    )
    {
        const auto method = schemeOf(name);
        packedBodies packed(state_);

        const integrator::forces force =
            [&](const scalar t, const scalar)
            {
                packed.unpackPositions(state_);
                state_.force[0] = f(t, state_.x[0], packed.velocity(0));
                state_.torque[0] = T(t, state_.q[0]);
                packed.setForces(state_);
            };

        scalar t = 0;
        force(0, 0);
        for (label i = 0; i < n; ++i)
        {
            const scalar part = even ? 1 : i % 3 == 0 ? 1 : i % 3 == 1 ? 1.5
              : 0.5;
            method->step(packed, t, part/n, false, force);
            t += part/n;
        }
        packed.unpack(state_);
    }
};


//- Error at t = 1 of y'' = cos(t) + y from rest, thesis (4.46), (4.47)
scalar partitionedError(const std::string& name, const label n, const bool even)
{
    oneBody b(false);
    b.run
    (
        name,
        n,
        even,
        [](const scalar t, const vector& x, const vector&)
        {
            return vector(std::cos(t) + x.x(), 0, 0);
        },
        [](const scalar, const Foam::quaternion&)
        {
            return vector(Foam::Zero);
        }
    );
    const scalar y = 0.5*std::cosh(1.0) - 0.5*std::cos(1.0);
    const scalar z = 0.5*std::sinh(1.0) + 0.5*std::sin(1.0);
    return std::hypot(b.state().x[0].x() - y, b.state().v[0].x() - z);
}


//- Error at t = 1 of y' = cos(t) + y from 0, thesis (4.41), (4.42): the
//  velocity under a force that depends on it
scalar generalError(const std::string& name, const label n, const bool even)
{
    oneBody b(false);
    b.run
    (
        name,
        n,
        even,
        [](const scalar t, const vector&, const vector& v)
        {
            return vector(std::cos(t) + v.x(), 0, 0);
        },
        [](const scalar, const Foam::quaternion&)
        {
            return vector(Foam::Zero);
        }
    );
    const scalar y =
        0.5*std::exp(1.0) + 0.5*(std::sin(1.0) - std::cos(1.0));
    return std::abs(b.state().v[0].x() - y);
}


//- Where a clump points after a torque that depends on that
vector turned(const std::string& name, const label n)
{
    oneBody b(true);
    bodies& s = b.state();
    s.q.set
    (
        0, Foam::quaternion(vector(1, 2, 3)/std::sqrt(14.0), scalar(0.7))
    );
    s.setL(0, vector(2, 3, 1));
    s.update();
    b.run
    (
        name,
        n,
        true,
        [](const scalar, const vector&, const vector&)
        {
            return vector(Foam::Zero);
        },
        [](const scalar t, const Foam::quaternion& q)
        {
            return
                (1 + 0.3*std::sin(t))
               *(vector(0, 0, 1) ^ q.transform(vector(1, 0.5, 0.2)));
        }
    );
    return s.q[0].transform(vector(1, 1, 1)) + s.L(0);
}


//- Print a table of the experimental order of convergence, and its last entry
//  as a figure: errors fall to 1e-10, where round-off sets in
void eocTable
(
    const std::string& figureName,
    const scheme& s,
    const scalar tolerance,
    const std::function<scalar(const label)>& error
)
{
    std::printf("%s\nTau           error          EOC\n", s.name.c_str());
    label n = 10;
    scalar old = error(n);
    scalar eoc = 0;
    while (n < 1280 && old > 1e-9)
    {
        const scalar now = error(2*n);
        eoc = std::log2(old/now);
        std::printf("%-12.7g  %-13.6e  %.4f\n", 1.0/n, old, eoc);
        old = now;
        n *= 2;
    }
    figure
    (
        figureName + "_" + s.name,
        eoc,
        s.order - tolerance,
        s.order + tolerance,
        "-",
        "thesis 4.4"
    );
}


//- A ball on a floor, with an integrator and with steps of deltaT [s]
std::string onFloor
(
    const std::string& integrator,
    const std::string& contact,
    const std::string& pair,
    const std::string& stepControl,
    const vector& v
)
{
    return
        "demSolver hades;\n"
        "integrator " + integrator + ";\n"
        "contact { " + contact + " }\n"
        "materials { stuff { density 2500; youngsModulus 1e6;"
        " poissonsRatio 0.3; } }\n"
        "pairs { stuff-stuff { " + pair + " } }\n"
        "shapes { ball { type sphere; diameter 0.01; } }\n"
        "walls { floor { type plane; point (0 0 0); normal (0 0 1);"
        " material stuff; } }\n"
        "stepControl { " + stepControl + " }\n"
        "bodies { b { shape ball; material stuff; position (0 0 "
      + text(0.005 - 4.5e-6) + "); velocity " + text(v) + "; } }\n";
}


//- The state of a ball after 0.001 s in contact
vector afterContact
(
    const std::string& integrator,
    const std::string& contact,
    const std::string& pair,
    const label n,
    const vector& v
)
{
    demCase c
    (
        onFloor
        (
            integrator,
            contact,
            pair,
            "type fixed; deltaT " + text(0.001/n) + ";",
            v
        ),
        gravity
    );
    c.run(0.001);
    return c.state().x[0] + 1e-3*c.state().v[0] + 1e-6*c.state().omega[0];
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(demSchemes, partitioned)
{
    for (const scheme& s : schemes)
    {
        eocTable("eoc", s, 0.02, [&](const label n)
        {
            return partitionedError(s.name, n, true);
        });
    }
}


TEST(demSchemes, general)
{
    for (const scheme& s : schemes)
    {
        // Those for forces of the position alone are left out
        if
        (
            s.name == "explicitEuler"
         || s.name == "implicitTrapezoidal"
         || s.name == "rk4"
        )
        {
            eocTable("eocGeneral", s, 0.02, [&](const label n)
            {
                return generalError(s.name, n, true);
            });
        }
    }
}


TEST(demSchemes, stepsOfSeveralLengths)
{
    for (const scheme& s : schemes)
    {
        // n is a multiple of three
        eocTable("eocAdaptive", s, 0.1, [&](const label n)
        {
            return partitionedError(s.name, 3*n, false);
        });
    }
}


TEST(demSchemes, rotation)
{
    for (const scheme& s : schemes)
    {
        const label n = s.order == 1 ? 2000 : s.order == 2 ? 200 : 40;
        const vector a = turned(s.name, n);
        const vector b = turned(s.name, 2*n);
        const vector c = turned(s.name, 4*n);
        figure
        (
            "eocRotation_" + s.name,
            std::log2(mag(a - b)/mag(b - c)),
            s.order - 0.1,
            s.order + 0.1,
            "-",
            "Richardson"
        );
    }
}


TEST(demSchemes, contact)
{
    // In the middle of an elastic impact
    for (const scheme& s : schemes)
    {
        const auto end = [&](const label n)
        {
            return afterContact
            (
                s.name,
                "damping none; tangential none;",
                "",
                n,
                vector(0, 0, -0.1)
            );
        };
        const label n = s.order == 1 ? 4000 : s.order == 2 ? 400 : 100;
        const vector a = end(n), b = end(2*n), c = end(4*n);
        figure
        (
            "eocContact_" + s.name,
            std::log2(mag(a - b)/mag(b - c)),
            s.order - 0.1,
            s.order + 0.1,
            "-",
            "Richardson, in an elastic impact"
        );
    }
}


TEST(demSchemes, dampedContact)
{
    // A force that depends on the velocity, too. The position form sees it
    // with the velocity before the kick
    for (const scheme& s : schemes)
    {
        if (schemeOf(s.name)->goesBack())
        {
            continue;
        }
        const auto end = [&](const label n)
        {
            return afterContact
            (
                s.name,
                "damping hades; tangential none;",
                "normalDamping 1e4;",
                n,
                vector(0, 0, -0.02)
            );
        };
        const label order = s.name == "stormerVerletPosition" ? 1 : s.order;
        const label n = order == 1 ? 4000 : order == 2 ? 400 : 40;
        const vector a = end(n), b = end(2*n), c = end(4*n);
        figure
        (
            "eocDamped_" + s.name,
            std::log2(mag(a - b)/mag(b - c)),
            order - 0.1,
            order + 0.1,
            "-",
            "Richardson, in a damped impact"
        );
    }
}


TEST(demSchemes, contactWithSlip)
{
    // Oblique and damped, sticking
    const auto end = [&](const std::string& name, const label n)
    {
        return afterContact
        (
            name,
            "damping hades;",
            "friction 10; normalDamping 1e4; tangentialDamping 1e4;",
            n,
            vector(0.05, 0, -0.1)
        );
    };
    const vector exact = end("stormerVerlet", 40000);
    for (const scheme& s : schemes)
    {
        if (schemeOf(s.name)->goesBack())
        {
            continue;
        }
        const bool first = s.order == 1 || s.name == "stormerVerletPosition";
        figure
        (
            "slipError_" + s.name,
            mag(end(s.name, 200) - exact)/mag(exact - vector(0, 0, 0.005)),
            0,
            first ? 1e-2 : 1e-5,
            "-",
            "200 steps, over the way; own run of 40,000"
        );
    }
}


TEST(demSchemes, twoStep)
{
    // Positions of stormerVerlet in the two-step form (4.9)
    const scalar h = 0.01;
    oneBody b(false);
    bodies& s = b.state();
    const auto method = schemeOf("stormerVerlet");
    packedBodies packed(s);
    const integrator::forces force = [&](const scalar t, const scalar)
    {
        packed.unpackPositions(s);
        s.force[0] = vector(std::cos(t) + s.x[0].x(), 0, 0);
        packed.setForces(s);
    };
    force(0, 0);

    scalar worst = 0;
    scalar x0 = 0, x1 = 0;
    for (int n = 0; n < 200; ++n)
    {
        const scalar f = s.force[0].x();
        method->step(packed, n*h, h, false, force);
        const scalar x2 = s.x[0].x();
        if (n > 0)
        {
            worst = std::max
            (
                worst,
                std::abs(x2 - 2*x1 + x0 - h*h*f)/std::max(x2, scalar(1))
            );
        }
        x0 = x1;
        x1 = x2;
    }
    figure
    (
        "twoStepForm",
        worst,
        0,
        1e-15,
        "-",
        "thesis (4.9), over the position"
    );
}


TEST(demSchemes, undone)
{
    // Six balls that tumble in a corner; every second step is undone
    const auto corner = [](const scheme& s, const std::string& control)
    {
        const bool back = s.order == 4 && s.name != "rk4";
        std::string d =
            "demSolver hades;\nintegrator " + s.name + ";\n"
            "contact { " + (back ? "damping none; tangential none;" : "")
          + " }\n"
            "materials { stuff { density 2500; youngsModulus 1e6;"
            " poissonsRatio 0.3; } }\n"
            "pairs { stuff-stuff { "
          + (back ? "" : "restitution 0.7; friction 0.4;") + " } }\n"
            "shapes { ball { type sphere; diameter 0.01; }\n"
            "two { type multisphere; spheres (((0 0 0.003) 0.005)"
            " ((0 0 -0.003) 0.005)); } }\n"
            "stepControl { type " + control + "; deltaT 2e-5; }\nwalls {\n";
        for (const std::string n : {"1 0 0", "0 1 0", "0 0 1"})
        {
            d += "w" + n.substr(0, 1) + n.substr(2, 1) + n.substr(4, 1)
              + " { type plane; point (0 0 0); normal (" + n
              + "); material stuff; }\n";
        }
        d += "}\nbodies {\n";
        for (int n = 0; n < 6; ++n)
        {
            d += "b" + std::to_string(n) + " { shape "
              + (n % 2 ? "two" : "ball") + "; material stuff; position "
              + text(vector(0.012, 0.013, 0.012 + 0.018*n))
              + "; velocity (-0.1 -0.13 -0.7); }\n";
        }
        return d + "}\n";
    };

    for (const scheme& s : schemes)
    {
        demCase a(corner(s, "fixed"), gravity);
        demCase b(corner(s, "rejecting"), gravity);
        label nContacts = 0;
        for (int n = 0; n < 10; ++n)
        {
            a.run(0.01);
            b.run(0.01);
            nContacts += a.solver().report().nContacts;
        }
        EXPECT_GT(nContacts, 10) << s.name;
        EXPECT_GT(b.nRejected, 4000) << s.name;

        label nDifferent = 0;
        for (label i = 0; i < a.state().size(); ++i)
        {
            nDifferent +=
                a.state().x[i] != b.state().x[i]
             || a.state().v[i] != b.state().v[i]
             || a.state().L(i) != b.state().L(i)
             || a.state().q[i] != b.state().q[i];
        }
        figure
        (
            "schemeUndone_" + s.name,
            nDifferent,
            0,
            0,
            "bodies that differ in a bit",
            "a run without rejected steps"
        );
    }
}


TEST(demSchemes, wrongInput)
{
    const auto said = [](const std::string& i, const std::string& control)
    {
        return messageOf([&]()
        {
            demCase
            (
                onFloor(i, "", "restitution 0.5; friction 0.5;", control,
                    Foam::Zero)
            );
        });
    };
    const std::string fixed("type fixed; deltaT 1e-5;");
    EXPECT_NE(said("leapfrog", fixed).find("stormerVerlet"),
        std::string::npos);
    EXPECT_NE(said("forestRuth", fixed).find("goes back in time"),
        std::string::npos);
    EXPECT_NE(said("pefrl", fixed).find("goes back in time"),
        std::string::npos);
    EXPECT_NE(said("explicitEuler", "type contact;").find("first order"),
        std::string::npos);
}


TEST(demSchemes, elasticGasFull)
{
    // 1,000 spheres in a box, 1e5 steps; half of them touch something now and
    // then. The energy counts motion and springs
    const scalar w = 0.02, r = 0.001;
    std::string dict =
        "demSolver hades;\ncontact { damping none; tangential none; }\n"
        "materials { stuff { density 2500; youngsModulus 1e7;"
        " poissonsRatio 0.3; } }\npairs { stuff-stuff {} }\n"
        "shapes { ball { type sphere; diameter 0.002; } }\n"
        "stepControl { type fixed; deltaT 1e-6; }\n"
        "walls { box { type box; min " + text(vector(-w, -w, -w)) + "; max "
      + text(vector(w, w, w)) + "; side inside; material stuff; } }\n"
        "bodies\n{\n";
    std::mt19937 random(1);
    const auto uniform = [&]() { return random()/2147483648.0 - 1; };
    for (int n = 0; n < 1000; ++n)
    {
        const vector cell(n % 10 - 4.5, (n/10) % 10 - 4.5, n/100 - 4.5);
        const vector shift(uniform(), uniform(), uniform());
        dict += "b" + std::to_string(n) + " { shape ball; material stuff;"
            " position " + text(0.0036*cell + 0.0007*shift) + "; velocity "
          + text(vector(uniform(), uniform(), uniform())) + "; }\n";
    }
    demCase c(dict + "}\n");

    const scalar EStar = 1e7/(2*(1 - 0.3*0.3));
    const auto spring = [&](const scalar rStar, const scalar overlap)
    {
        return
            overlap > 0
          ? 8.0/15.0*EStar*std::sqrt(rStar)*std::pow(overlap, 2.5)
          : 0;
    };
    const auto energy = [&]()
    {
        const bodies& b = c.state();
        scalar e = b.kineticEnergy();
        for (label i = 0; i < b.size(); ++i)
        {
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
    };

    const scalar e0 = energy();
    scalar worst = 0;
    for (int n = 0; n < 20; ++n)
    {
        c.run(0.005);
        worst = std::max(worst, std::abs(energy()/e0 - 1));
    }
    EXPECT_EQ(c.state().size(), 1000);
    EXPECT_GE(c.nSteps, 100000);
    figure
    (
        "elasticGas_1000",
        worst,
        0,
        1e-4,
        "-",
        "1,000 spheres, 1e5 steps, exact 0"
    );
    for (int n = 0; n < 180; ++n)
    {
        c.run(0.005);
        worst = std::max(worst, std::abs(energy()/e0 - 1));
    }
    EXPECT_GE(c.nSteps, 1000000);
    figure("hard14_energy", worst, 0, 1e-3, "-", "1e6 steps, exact 0");
}


// ************************************************************************* //
