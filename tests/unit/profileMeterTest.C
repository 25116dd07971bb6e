/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    The part of a sphere that is in a box, and the meter that fills windows
    with such parts.

\*---------------------------------------------------------------------------*/

#include "demCase.H"
#include "profileMeter.H"
#include "Random.H"
#include "sphereInBox.H"

#include <cmath>

using namespace styxTest;
using namespace Foam::dem;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const scalar far = 10;
const scalar ball = 4*M_PI/3;

//- Of the sphere of radius 1 what is above a height
scalar cap(const scalar z)
{
    return M_PI*(2/3.0 - z + z*z*z/3);
}


std::string properties(const std::string& bodies)
{
    return
        "demSolver hades;\n"
        "materials { stuff { density 1000; youngsModulus 1e6;"
        " poissonsRatio 0.3; } }\n"
        "pairs { stuff-stuff { restitution 0.5; friction 0; } }\n"
        "stepControl { type hades; }\n"
        "shapes { ball { type sphere; diameter 0.01; }\n"
        "    pair { type multisphere; spheres"
        " ( ((-0.002 0 0) 0.005) ((0.002 0 0) 0.005) ); } }\n"
        "bodies {\n" + bodies + "}\n";
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(profileMeter, sphereInBox)
{
    const point low(-far, -far, -far), high(far, far, far);
    figureNear("sphereInBox_whole",
        sphereInBox(point(1, 2, 3), 1, low, high), ball, 1e-14, "m3", "exact");

    // What is beyond a plane along each axis
    scalar off = 0;
    for (const scalar h : {-0.9, -0.3, 0.0, 0.2, 0.7, 0.999})
    {
        for (Foam::direction d = 0; d < 3; ++d)
        {
            point from(low);
            from[d] = h;
            const scalar got = sphereInBox(point(Foam::Zero), 1, from, high);
            off = std::max(off, std::abs(got - cap(h))/ball);
        }
    }
    figure("sphereInBox_cap", off, 0, 1e-5, "-", "exact, over the sphere");

    // A quarter of a cap, whichever way it looks
    off = 0;
    for (Foam::direction d = 0; d < 3; ++d)
    {
        point from(Foam::Zero);
        from[d] = 0.4;
        const scalar got = sphereInBox(point(Foam::Zero), 1, from, high);
        off = std::max(off, std::abs(got - cap(0.4)/4)/ball);
    }
    figure("sphereInBox_quarter", off, 0, 1e-5, "-", "exact");

    // Boxes of all kinds: turned about the axes, and the sum of their parts
    Foam::Random random(3);
    scalar turned = 0, parts = 0;
    for (label k = 0; k < 300; ++k)
    {
        const vector a = 3*random.sample01<vector>() - vector(2, 2, 2);
        const vector b = a + 2*random.sample01<vector>();
        const auto turn = [](const vector& v)
        {
            return vector(v.y(), v.z(), v.x());
        };
        const scalar all = sphereInBox(point(Foam::Zero), 1, a, b);
        turned = std::max(turned, std::abs
        (
            all - sphereInBox(point(Foam::Zero), 1, turn(a), turn(b))
        ));
        const scalar s = a.x() + random.sample01<scalar>()*(b.x() - a.x());
        parts = std::max(parts, std::abs
        (
            all
          - sphereInBox(point(Foam::Zero), 1, a, point(s, b.y(), b.z()))
          - sphereInBox(point(Foam::Zero), 1, point(s, a.y(), a.z()), b)
        ));
    }
    figure("sphereInBox_turned", turned/ball, 0, 1e-5, "-",
        "300 boxes, integrated along another axis");
    figure("sphereInBox_parts", parts/ball, 0, 1e-5, "-", "cut in two");
}


TEST(profileMeter, windows)
{
    // A ball on the corner of eight windows, one in a window, a clump across
    // the seam at x = 0 and 0.1
    periodicity period;
    period.append
    (
        periodicity::seam{vector(1, 0, 0), 0, vector(0.1, 0, 0)}
    );
    demCase c
    (
        properties
        (
            "a { shape ball; material stuff; position (0.05 0.05 0.05);"
            " velocity (1 0 0); }\n"
            "b { shape ball; material stuff; position (0.03 0.03 0.03);"
            " velocity (0 2 0); }\n"
            "c { shape pair; material stuff; position (0.099 0.07 0.07);"
            " velocity (0 0 3); }\n"
        ),
        Foam::Zero,
        Foam::List<corners>(),
        [&](demInput& input) { input.period = period; }
    );
    profileMeter m("m", dictionaryOf
    (
        "type profile; low (0 0 0); high (0.1 0.1 0.1); windows (2 2 2);"
    ), period);
    m.end(c.solver(), 1e-3);

    const scalar V = 0.05*0.05*0.05;
    const scalar one = M_PI/6*1e-6;
    const scalar two = c.state().shapeOf(2).volume();
    figureNear("profile_eighth", m.fraction()[1]*V, one/8, 1e-6, "m3",
        "a ball on the corner of eight windows");
    figureNear("profile_mixed", m.fraction()[0]*V, one + one/8, 1e-6, "m3",
        "and one that is in a window");
    figureNear("profile_velocity", m.velocity()[0].y(), 2/(1 + 1/8.0), 1e-6,
        "m/s", "mean by volume");

    scalar sum = 0;
    for (const scalar f : m.fraction())
    {
        sum += f*V;
    }
    figureNear("profile_sum", sum, 2*one + two, 1e-6, "m3",
        "all of it, a clump across a seam once");
    EXPECT_GT(m.fraction()[6], 1e-3);
    EXPECT_GT(m.fraction()[7], m.fraction()[6]);
}


TEST(profileMeter, interval)
{
    demCase c
    (
        properties("a { shape ball; material stuff; position (0 0 0); }\n")
    );
    const std::string dict
    (
        "type profile; low (0 0 0); high (1 1 1); windows (1 1 1);"
        " interval 0.01; "
    );
    profileMeter whole("m", dictionaryOf(dict), periodicity());
    profileMeter first("m", dictionaryOf(dict), periodicity());
    profileMeter second("m", dictionaryOf(dict), periodicity());
    label rows = 0, of40 = 0;
    for (label step = 0; step < 40; ++step)
    {
        profileMeter& now = step < 17 ? first : second;
        if (step == 17)
        {
            Foam::dictionary saved;
            first.write(saved);
            second.read(saved);
        }
        whole.end(c.solver(), 0.0007);
        now.end(c.solver(), 0.0007);
        rows += whole.fraction().size();
        of40 += whole.fraction().size() == now.fraction().size();
    }
    figure("profile_rows", rows, 2, 2, "rows", "28 ms, one in 10 ms");
    figure("profile_restart", of40, 40, 40, "steps", "as without a restart");
}


TEST(profileMeter, wrongInput)
{
    const auto expect = [](const std::string& m, const std::string& word)
    {
        const std::string said = messageOf
        (
            [&]() { meter::New("m", dictionaryOf(m), periodicity()); }
        );
        EXPECT_NE(said.find(word), std::string::npos) << m << said;
    };
    const std::string box("type profile; low (0 0 0); high (1 1 1); ");
    expect("type profile; low (0 0 0); windows (1 1 1);", "high");
    expect("type profile; low (0 0 0); high (1 0 1); windows (1 1 1);",
        "must be above low");
    expect(box + "windows (0 1 1);", "1 or more along each axis");
    expect(box + "windows (10000 10000 100);", "a million at most");
    expect(box + "windows (1 1 1); interval -1;", "interval");
    expect(box + "windows (1 1 1); every 3;", "every");
    expect(box + "window (1 1 1);", "did you mean 'windows'?");
}


// ************************************************************************* //
