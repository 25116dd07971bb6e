/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    A domain that repeats itself: what happens at a seam is what happens in
    the middle. Mirrors: a body touches its own image.

\*---------------------------------------------------------------------------*/

#include "demCase.H"

#include <cmath>
#include <random>

using namespace styxTest;
using namespace Foam::dem;
using Foam::mag;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Periods of the box [m]
const vector box(0.1, 0.08, 0.06);

//- The box repeats itself in the first n directions
std::function<void(demInput&)> repeated(const label n)
{
    return [=](demInput& input)
    {
        for (Foam::direction d = 0; d < n; ++d)
        {
            periodicity::seam s;
            s.normal = Foam::Zero;
            s.normal[d] = 1;
            s.low = 0;
            s.separation = Foam::Zero;
            s.separation[d] = box[d];
            input.period.append(s);
        }
    };
}


//- demCloudProperties with soft material, so that contacts take long
std::string soft(const std::string& bodies, const std::string& damping)
{
    return
        "demSolver hades;\n"
        "materials { gum { density 1000; youngsModulus 1e5;"
        " poissonsRatio 0.3; } }\n"
        "contact { damping " + damping + "; }\n"
        "pairs { gum-gum { "
      + std::string(damping == "none" ? "" : "restitution 0.6; ")
      + "friction 0.4; } }\n"
        "shapes { ball { type sphere; diameter 0.01; }"
        " pair { type multisphere; spheres (((-0.003 0 0) 0.004)"
        " ((0.003 0.001 0) 0.0035)); } }\n"
        "stepControl { type hades; }\n"
        "bodies {\n" + bodies + "}\n";
}


std::string body
(
    const std::string& shape,
    const point& x,
    const vector& v,
    const vector& omega
)
{
    static int n = 0;
    return
        "b" + std::to_string(n++) + " { shape " + shape
      + "; material gum; position " + text(x) + "; velocity " + text(v)
      + "; angularVelocity " + text(omega) + "; }\n";
}


//- A vector as short as periods can make it
vector wrapped(vector d)
{
    for (Foam::direction k = 0; k < 3; ++k)
    {
        d[k] -= box[k]*std::round(d[k]/box[k]);
    }
    return d;
}


//- Largest relative difference of two bodies' motion, and of their places but
//  for a shift and whole periods
scalar difference(const bodies& a, const bodies& b, const vector& shift)
{
    scalar worst = 0;
    for (label i = 0; i < a.size(); ++i)
    {
        worst = std::max(worst, mag(a.v[i] - b.v[i])/mag(a.v[i]));
        worst =
            std::max(worst, mag(a.omega[i] - b.omega[i])/mag(a.omega[i]));
        worst = std::max
        (
            worst,
            mag(wrapped(b.x[i] - a.x[i] - shift))/box.x()
        );
    }
    return worst;
}


//- Two bodies that meet, together on their way in x; once in the middle, once
//  at the seam. Returns how different the outcomes are
void meet
(
    const std::string& shape,
    const vector& gap,
    const vector& travel,
    const std::string& name
)
{
    const point middle(0.045, 0.04, 0.03);
    const vector shift(0.05, 0.0011, 0.001);

    const auto run = [&](const vector& off, const label n)
    {
        return std::make_shared<demCase>
        (
            soft
            (
                body
                (
                    shape,
                    middle + off - gap,
                    travel + vector(0.5, 0, 0),
                    vector(10, -20, 30)
                )
              + body
                (
                    shape,
                    middle + off + gap,
                    travel - vector(0.5, 0, 0.1),
                    vector(5, 8, -9)
                ),
                "restitution"
            ),
            Foam::Zero,
            Foam::List<corners>(),
            repeated(n)
        );
    };

    // The first moves in a domain without seams
    const auto bulk = run(Foam::Zero, 0);
    const auto seam = run(shift, 1);

    label crossings = 0;
    scalar slip = 0;
    label touching = 0;
    for (int k = 0; k < 40; ++k)
    {
        const point before = seam->state().x[0];
        bulk->run(2.5e-4);
        seam->run(2.5e-4);
        const contactHistory h = seam->solver().history();
        for (const auto& pair : h.pairs)
        {
            ++touching;
            slip = std::max(slip, mag(pair.xi));
            crossings +=
                mag(seam->state().x[0] - before) > 0.5*box.x() ? 1 : 0;
        }
    }

    std::cout
        << touching << " times in contact, slip up to " << slip << " m, "
        << crossings << " crossings while they touch" << std::endl;
    EXPECT_GT(touching, 2);
    EXPECT_GT(slip, 1e-6);
    EXPECT_EQ(seam->solver().report().nContacts, 0);
    if (mag(travel) > 0)
    {
        EXPECT_GE(crossings, 1);
    }
    figure
    (
        name,
        difference(bulk->state(), seam->state(), shift),
        0,
        1e-11,
        "-",
        "the same pair in the middle"
    );
    figure
    (
        name + "_momentum",
        mag(bulk->state().momentum() - seam->state().momentum())
       /mag(bulk->state().momentum()),
        0,
        1e-12,
        "-",
        "exact"
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(demPeriodic, collision)
{
    const vector gap(0.0058, 0.0020, 0.0007);
    meet("ball", gap, Foam::Zero, "seamCollision");
}


TEST(demPeriodic, crossingInContact)
{
    const vector gap(0.0058, 0.0020, 0.0007);
    meet("ball", gap, vector(2.2, 0, 0), "seamCrossing");
}


TEST(demPeriodic, clumpCrossingInContact)
{
    const vector gap(0.0078, 0.0010, 0.0007);
    meet("pair", gap, vector(2.2, 0, 0), "seamClump");
}


TEST(demPeriodic, historyGoesOn)
{
    // Stopped in the middle of the contact and continued from what a restart
    // keeps
    const auto make = []()
    {
        return std::make_shared<demCase>
        (
            soft
            (
                body("ball", point(0.0945, 0.04, 0.03), vector(2, 0, 0),
                    vector(10, -20, 30))
              + body("ball", point(0.0052, 0.042, 0.03), vector(1, 0, 0),
                    vector(5, 8, -9)),
                "restitution"
            ),
            Foam::Zero,
            Foam::List<corners>(),
            repeated(3)
        );
    };
    const auto a = make();
    while (a->solver().history().pairs.empty())
    {
        a->run(1e-4);
    }
    a->run(1e-4);
    const contactHistory saved = a->solver().history();
    ASSERT_EQ(saved.pairs.size(), 1);
    EXPECT_NE(saved.pairs[0].pair.image, label(periodicity::original));

    const auto b = make();
    b->state().x = a->state().x;
    b->state().v = a->state().v;
    forAll(b->state().x, k)
    {
        b->state().setL(k, a->state().L(k));
    }
    b->state().update();
    b->solver().setHistory(saved);
    Foam::dictionary counters;
    a->solver().writeCounters(counters);
    b->solver().readCounters(counters);

    a->run(0.01);
    b->run(0.01);
    figure
    (
        "seamRestart",
        difference(a->state(), b->state(), Foam::Zero),
        0,
        1e-14,
        "-",
        "run through, where the clock shows another time"
    );
}


TEST(demPeriodic, bruteForce)
{
    // Balls and pairs of all sizes in a box that repeats itself in one, two
    // and three directions: the list has what all images give
    std::mt19937 random(5);
    const auto uniform = [&]() { return random()/4294967296.0; };

    Foam::PtrList<shape> shapes;
    for (const char* s :
    {
        "type sphere; diameter 0.002;",
        "type sphere; diameter 0.03;",
        "type multisphere; spheres (((-0.003 0 0) 0.004) ((0.003 0 0) 0.002));"
    })
    {
        shapes.append
        (
            new shape("s" + std::to_string(shapes.size()), dictionaryOf(s), ".")
        );
    }

    label wrong = 0;
    label throughSeams = 0;
    for (label n = 1; n <= 3; ++n)
    {
        demInput input((Foam::dictionary()));
        repeated(n)(input);

        bodies state(shapes);
        for (int k = 0; k < 150; ++k)
        {
            newBody b;
            b.shapeI = k % 3;
            b.materialI = 0;
            b.density = 1;
            b.position = cmptMultiply
            (
                box,
                vector(uniform(), uniform(), uniform())
            );
            state.append(b);
        }

        verletList list(0.2);
        list.setPeriodicity(input.period);
        list.build(packedBodies(state));

        std::vector<std::array<label, 3>> expected;
        for (label i = 0; i < state.nSpheres(); ++i)
        for (label j = i + 1; j < state.nSpheres(); ++j)
        for (label m = 0; m < 27; ++m)
        {
            const scalar reach =
                state.sphereR[i] + state.sphereR[j] + list.skin();
            const Foam::labelVector turns(m % 3 - 1, m/3 % 3 - 1, m/9 - 1);
            if
            (
                (n < 3 && turns.z()) || (n < 2 && turns.y())
             || state.sphereBody[i] == state.sphereBody[j]
            )
            {
                continue;
            }
            const vector d =
                state.sphereX()[i] - state.sphereX()[j]
              - input.period.shift(turns);
            if (mag(d) < reach)
            {
                expected.push_back({i, j, m});
                throughSeams += m != periodicity::original;
            }
        }

        // The list has pairs through seams behind the others
        std::stable_sort
        (
            expected.begin(),
            expected.end(),
            [](const auto& a, const auto& b)
            {
                return
                    (a[2] != periodicity::original)
                  < (b[2] != periodicity::original);
            }
        );
        const sortedPairs& pairs = list.pairs();
        wrong += mag(label(expected.size()) - pairs.size());

        // Either way round
        const auto compare = [&](const verletList::spherePair& p, label k)
        {
            if (k < 0 || k >= label(expected.size()))
            {
                return;
            }
            const auto& e = expected[k];
            wrong +=
                p.i != e[0] || p.j != e[1]
             || mag(list.shiftOf(p) - input.period.shift(e[2])) > 1e-15;
        };
        label k = 0;
        pairs.forEach
        (
            [&](const verletList::spherePair& p) { compare(p, k++); }
        );
        pairs.forEachBackwards
        (
            [&](const verletList::spherePair& p) { compare(p, --k); }
        );
    }
    EXPECT_GT(throughSeams, 100);
    figure
    (
        "seamBruteForce",
        wrong,
        0,
        0,
        "pairs",
        "all pairs with all images"
    );
}


TEST(demPeriodic, gas)
{
    // An elastic gas in a box without walls keeps its momentum and energy
    std::mt19937 random(3);
    const auto uniform = [&]() { return random()/2147483648.0 - 1; };

    std::string bodies;
    for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 4; ++j)
    for (int k = 0; k < 3; ++k)
    {
        bodies += body
        (
            (i + j + k) % 2 ? "ball" : "pair",
            point(0.0101 + 0.02*i, 0.01 + 0.02*j, 0.0099 + 0.02*k),
            vector(uniform(), uniform(), uniform()),
            vector(10*uniform(), 10*uniform(), 10*uniform())
        );
    }
    std::string dict = soft(bodies, "none");
    dict.replace(dict.find("contact {"), 9, "contact { tangential none;");
    dict.replace(dict.find("friction 0.4;"), 13, "");

    demCase c(dict, Foam::Zero, Foam::List<corners>(), repeated(3));
    const vector p0 = c.state().momentum();
    const scalar e0 = c.state().kineticEnergy();
    scalar scale = 0;
    forAll(c.state().v, b)
    {
        scale += c.state().mass[b]*mag(c.state().v[b]);
    }

    for (int k = 0; k < 50; ++k)
    {
        c.run(0.01);
    }
    while (c.solver().report().nContacts)
    {
        c.run(1e-4);
    }

    label out = 0;
    forAll(c.state().x, b)
    {
        const point& x = c.state().x[b];
        out += Foam::cmptMin(x) < 0 || Foam::cmptMax(x - box) > 0;
    }
    std::cout << c.nSteps << " steps, " << c.time() << " s" << std::endl;
    EXPECT_EQ(out, 0);
    figure
    (
        "seamGas_momentum",
        mag(c.state().momentum() - p0)/scale,
        0,
        1e-12,
        "-",
        "exact"
    );
    figure
    (
        "seamGas_energy",
        mag(c.state().kineticEnergy()/e0 - 1),
        0,
        1e-3,
        "-",
        "exact"
    );
}


TEST(demPeriodic, floorAcrossSeam)
{
    // A floor that ends at the seam: a pair of spheres, one of them beyond,
    // does not feel it
    const auto make = [](const bool plane)
    {
        Foam::List<corners> floor(2);
        floor[0][0] = floor[1][0] = point(0, 0, 0);
        floor[0][1] = point(box.x(), 0, 0);
        floor[0][2] = floor[1][1] = point(box.x(), box.y(), 0);
        floor[1][2] = point(0, box.y(), 0);

        std::string dict = soft
        (
            body("pair", point(0.09, 0.04, 0.0044), vector(0.3, 0, 0),
                vector(0, 30, 0)),
            "restitution"
        );
        dict += std::string("walls { floor { material gum; ")
          + (plane ? "type plane; point (0 0 0); normal (0 0 1);"
                   : "type patch;") + " } }\n";
        return std::make_shared<demCase>(dict, gravity, floor, repeated(1));
    };
    const auto patch = make(false);
    const auto plane = make(true);
    patch->run(0.2);
    plane->run(0.2);

    EXPECT_GT(patch->solver().report().nContacts, 0);
    EXPECT_LT(patch->state().x[0].x(), 0.09);
    figure
    (
        "seamFloor",
        difference(patch->state(), plane->state(), Foam::Zero),
        0,
        1e-9,
        "-",
        "the same on an endless plane"
    );
}


TEST(demMirror, ownImage)
{
    // A ball that meets a mirror, and two balls that are images of each other
    Foam::List<corners> mirror(2);
    mirror[0][0] = mirror[1][0] = point(0, -1, -1);
    mirror[0][1] = point(0, 1, -1);
    mirror[0][2] = mirror[1][1] = point(0, 1, 1);
    mirror[1][2] = point(0, -1, 1);

    const vector v(-0.5, 0.3, 0.1);
    const vector w(10, 20, -30);
    demCase one
    (
        soft(body("ball", point(0.006, 0, 0), v, w), "restitution"),
        Foam::Zero,
        Foam::List<corners>(),
        [&](demInput& input)
        {
            input.mirrors = Foam::wordList(1, "plane");
            input.mirrorTriangles =
                [&](const Foam::word&, const bool) { return mirror; };
        }
    );
    demCase two
    (
        soft
        (
            body("ball", point(0.006, 0, 0), v, w)
          + body
            (
                "ball",
                point(-0.006, 0, 0),
                vector(-v.x(), v.y(), v.z()),
                vector(w.x(), -w.y(), -w.z())
            ),
            "restitution"
        )
    );
    one.run(0.02);
    two.run(0.02);

    EXPECT_EQ(one.solver().report().nContacts, 0);
    EXPECT_GT(one.state().v[0].x(), 0.1);
    figure
    (
        "mirror_velocity",
        mag(one.state().v[0] - two.state().v[0])/mag(v),
        0,
        1e-12,
        "-",
        "two balls that are images of each other"
    );
    figure
    (
        "mirror_tangential",
        mag(one.state().v[0].y() - v.y()) + mag(one.state().v[0].z() - v.z())
      + 0.005*mag(one.state().omega[0] - w),
        0,
        1e-12,
        "m/s",
        "no friction"
    );
    figure
    (
        "mirror_restitution",
        -one.state().v[0].x()/v.x(),
        0.59,
        0.61,
        "-",
        "that of the material with itself, 0.6"
    );
}


TEST(demPeriodic, wrongInput)
{
    const std::string small =
        body("ball", point(0.01, 0.01, 0.01), Foam::Zero, Foam::Zero);
    const auto said = [&](const std::string& dict)
    {
        return messageOf
        (
            [&]()
            {
                demCase c(dict, Foam::Zero, Foam::List<corners>(), repeated(1));
            }
        );
    };

    std::string large = soft(small, "restitution");
    large.replace(large.find("diameter 0.01"), 13, "diameter 0.11");
    const std::string a = said(large);
    EXPECT_NE(a.find("ball"), std::string::npos) << a;
    EXPECT_NE(a.find("repeats itself after 0.1"), std::string::npos) << a;
    EXPECT_NE(a.find("demCloudProperties"), std::string::npos) << a;

    const std::string b = said
    (
        soft(small, "restitution")
      + "walls { lid { type plane; point (0.02 0 0); normal (1 0 0);"
        " material gum; } }\n"
    );
    EXPECT_NE(b.find("normal"), std::string::npos) << b;
    EXPECT_NE(b.find("cut the seam"), std::string::npos) << b;

    // Overlap at the start, through the seam
    const std::string c = said
    (
        soft
        (
            body("ball", point(0.002, 0.01, 0.01), Foam::Zero, Foam::Zero)
          + body("ball", point(0.096, 0.01, 0.01), Foam::Zero, Foam::Zero),
            "restitution"
        )
    );
    EXPECT_NE(c.find("overlap at the start"), std::string::npos) << c;
    std::cout << a << b << c << std::endl;
}


// ************************************************************************* //
