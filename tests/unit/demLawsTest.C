/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    The contact laws one by one: the linear spring, the dashpots with and
    without pull, friction without a memory.

\*---------------------------------------------------------------------------*/

#include "dampingRatio.H"
#include "demImpact.H"

using namespace styxTest;
using Foam::dem::dampingRatioOf;
using Foam::dem::restitutionOf;
using Foam::dem::viscousPerRatio;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- A sphere of 5 mm that hits a plane or its like
impact ball(const bool plane, const scalar speed, const bool hooke)
{
    impact i{plane, 0.0025, speed, 1e9, 0.25, 2500};
    i.stiffness = hooke ? 1e5 : 0;
    return i;
}

std::string laws(const bool hooke, const std::string& damping)
{
    return
        std::string("contact { normal ") + (hooke ? "hooke" : "hertz")
      + "; tangential none; damping " + damping + "; }";
}


//- Restitution of an impact with force F(x, v) a mass, by Runge and Kutta
template<class Force>
scalar integrated(const scalar speed, const scalar h, const Force& F)
{
    scalar x = 0, v = speed;
    while (x >= 0)
    {
        const scalar k1 = F(x, v);
        const scalar k2 = F(x + 0.5*h*v, v + 0.5*h*k1);
        const scalar k3 = F(x + 0.5*h*(v + 0.5*h*k1), v + 0.5*h*k2);
        const scalar k4 = F(x + h*(v + 0.5*h*k2), v + h*k3);
        x += h*(v + h*(k1 + k2 + k3)/6);
        v += h*(k1 + 2*k2 + 2*k3 + k4)/6;
    }
    return -v/speed;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(demLaws, hooke)
{
    // Figures "hooke_peakForce", "hooke_overlap", "hooke_contactTime"
    impact i = ball(false, 0.5, true);
    i.contact = laws(true, "none");

    demCase c(i.dict());
    const scalar tc = i.contactTime();
    scalar force = 0, overlap = 0;
    c.run(0.99*i.timeToTouch());
    for (label n = 0; n < 1000 && speedOf(c, i) < 0.999999*i.speed; ++n)
    {
        c.run(0.005*tc);
        force = std::max(force, c.state().force[0].z());
        overlap = std::max(overlap, overlapOf(c, i));
    }
    const scalar time =
        c.time() + overlapOf(c, i)/speedOf(c, i) - i.timeToTouch();

    const std::string source("closed form of the linear spring");
    figureNear("hooke_peakForce", force, i.peakForce(), 0.005, "N", source);
    figureNear("hooke_overlap", overlap, i.overlap(), 0.005, "m", source);
    figureNear("hooke_contactTime", time, tc, 0.005, "s", source);
}


TEST(demLaws, hookeSteps)
{
    // As many steps as Hertz' contacts get
    impact i = ball(true, 0.5, true);
    i.contact = laws(true, "none");
    i.gap = 1e-6;

    demCase c(i.dict());
    while (overlapOf(c, i) > -1e-4*i.r)
    {
        c.run(i.contactTime());
    }
    figure
    (
        "hookeSteps", c.nSteps + c.nRejected, 20, 60, "steps",
        "stepControl hades, defaults"
    );
}


TEST(demLaws, hookeSlip)
{
    // A ball at rest that is pushed sidewards swings on the tangential
    // spring: 7 k_t/(2 m) is the square of its frequency
    impact i = ball(true, 0, true);
    i.contact = "contact { normal hooke; damping none; }";
    i.pair = "friction 10;";
    i.slide = 1e-5;
    i.gap = -i.mStar()*9.81/(i.stiffness*i.r);

    // The plane is rigid: 1/E* = (1 - nu^2)/E, 1/G* = (2 - nu) 2 (1 + nu)/E
    const scalar ratio = 2*(1 - i.nu)/(2 - i.nu);
    const scalar period =
        2*M_PI/std::sqrt(3.5*ratio*i.stiffness/i.mStar());

    demCase c(i.dict(), gravity);
    std::vector<scalar> crossed;
    const scalar dt = period/200;
    scalar last = i.slide*5.0/7.0, t = 0;
    for (int n = 0; n < 2100; ++n)
    {
        c.run(dt);
        t += dt;

        // What is left when the even rolling, 5/7 of the slide, is taken off
        const scalar u = c.state().v[0].x() - 5.0/7.0*i.slide;
        if (last > 0 && u <= 0)
        {
            crossed.push_back(t - dt*u/(u - last));
        }
        last = u;
    }
    ASSERT_GE(crossed.size(), 9u);
    figureNear
    (
        "hookeSlip_period",
        (crossed.back() - crossed[0])/(crossed.size() - 1),
        period,
        0.005,
        "s",
        "closed form 2 pi sqrt(2 m/(7 k_t))"
    );
}


TEST(demLaws, ratioOfRestitution)
{
    // With the tail of the pull in closed form for the linear spring, without
    // it and for Hertz by an integration that knows neither
    for (const bool pulling : {true, false})
    for (const bool hertz : {true, false})
    for (const scalar e : {0.9, 0.5, 0.2, 0.05})
    {
        const scalar beta = dampingRatioOf(e, pulling);
        EXPECT_NEAR(restitutionOf(beta, pulling), e, 1e-12);

        const scalar eta = viscousPerRatio(hertz)*beta;
        const scalar found = integrated
        (
            1,
            1e-4,
            [&](const scalar x, const scalar v)
            {
                const scalar y = std::max(x, scalar(0));
                const scalar k = hertz ? 1.5*std::sqrt(y) : 1;
                const scalar F =
                    (hertz ? y*std::sqrt(y) : y) + eta*std::sqrt(k)*v;
                return -(pulling ? F : std::max(F, scalar(0)));
            }
        );
        EXPECT_NEAR(found, e, 2e-3*e)
            << (pulling ? "pulling " : "") << (hertz ? "hertz " : "hooke ");
    }

    // Beyond the critical ratio, and smooth across it
    EXPECT_EQ(restitutionOf(1.2, true), 0);
    EXPECT_NEAR(restitutionOf(1, false), std::exp(-2.0), 1e-12);
    EXPECT_NEAR(restitutionOf(1 - 1e-6, false), std::exp(-2.0), 1e-6);
    EXPECT_NEAR(restitutionOf(1 + 1e-6, false), std::exp(-2.0), 1e-6);
    EXPECT_EQ(dampingRatioOf(1, true), 0);
    EXPECT_NEAR(dampingRatioOf(1, false), 0, 1e-15);
}


TEST(demLaws, restitution)
{
    // Where the existing test has hertz with pull: figures
    // "restitution_hooke", "restitution_hooke_pushing",
    // "restitution_hertz_pushing"
    const std::pair<bool, bool> cases[] =
        {{true, true}, {true, false}, {false, false}};

    for (const auto& k : cases)
    {
        const bool hooke = k.first, pulling = k.second;
        scalar worst = 0;
        std::string at;
        for (const bool plane : {true, false})
        for (const scalar speed : {0.1, 3.9})
        for (const scalar e : {1.0, 0.9, 0.7, 0.5, 0.3, 0.1})
        {
            impact i = ball(plane, speed, hooke);
            i.contact =
                laws(hooke, "restitution; pulling " + std::string
                (
                    pulling ? "yes" : "no"
                ));
            i.pair = "restitution " + text(e) + ";";
            const scalar error = restitutionError(i, e);
            if (error > worst)
            {
                worst = error;
                at = text(e).substr(0, 3);
            }
        }
        figure
        (
            std::string("restitution_") + (hooke ? "hooke" : "hertz")
          + (pulling ? "" : "_pushing"),
            100*worst,
            0,
            1,
            "% (at e = " + at + ")",
            "e in = e out"
        );
    }
}


TEST(demLaws, critical)
{
    // Figures "critical_hooke", "critical_hertz": largest error with parts
    // of the critical damping up to 1; without pull, as e is 0 with it
    for (const bool hooke : {true, false})
    {
        scalar worst = 0;
        std::string at;
        for (const scalar part : {0.1, 0.5, 1.0})
        {
            impact i = ball(true, 0.5, hooke);
            i.contact = laws(hooke, "critical; pulling no");
            i.pair = part < 1 ? "dampingRatio " + text(part) + ";" : "";
            const scalar e =
                restitutionOf(2*part/viscousPerRatio(!hooke), false);
            const scalar error = restitutionError(i, e);
            if (error > worst)
            {
                worst = error;
                at = text(part).substr(0, 3);
            }
        }
        figure
        (
            std::string("critical_") + (hooke ? "hooke" : "hertz"),
            100*worst,
            0,
            1,
            "% (at part " + at + ")",
            "closed form"
        );
    }

    // With pull nothing comes back
    impact i = ball(true, 0.5, true);
    i.contact = laws(true, "critical");
    demCase c(i.dict());
    c.run(i.timeToTouch() + 10*i.contactTime());
    figure
    (
        "critical_stays",
        std::abs(c.state().v[0].z())/i.speed,
        0,
        1e-3,
        "of the impact speed",
        "closed form: 0"
    );
}


TEST(demLaws, hades)
{
    // Figures "hades_hertz", "hades_hertz_pushing", "hades_hooke"
    const std::pair<bool, bool> cases[] =
        {{false, true}, {false, false}, {true, true}};

    for (const auto& k : cases)
    {
        const bool hooke = k.first, pulling = k.second;
        scalar worst = 0;
        for (const scalar speed : {0.1, 3.9})
        for (const scalar part : {0.2, 1.0})
        {
            impact i = ball(true, speed, hooke);
            i.contact = laws(hooke, pulling ? "hades" : "hades; pulling no");

            // A number of the size of 1/(contact time sqrt(overlap))
            const scalar c =
                part/(i.contactTime()*std::sqrt(i.overlap()))*3;
            i.pair = "normalDamping " + text(c) + ";";

            const scalar k = hooke ? i.stiffness : i.k();
            const scalar e = integrated
            (
                speed,
                2e-5*i.contactTime(),
                [&](const scalar x, const scalar v)
                {
                    const scalar y = std::max(x, scalar(0));
                    const scalar F =
                        k*(hooke ? y : y*std::sqrt(y))/i.mStar()
                      + c*std::sqrt(y)*v;
                    return -(pulling ? F : std::max(F, scalar(0)));
                }
            );
            EXPECT_TRUE(e > 0.3 && e < 0.85) << e;
            worst = std::max(worst, restitutionError(i, e));
        }
        figure
        (
            std::string("hades_") + (hooke ? "hooke" : "hertz")
          + (pulling ? "" : "_pushing"),
            100*worst,
            0,
            1,
            "% of e",
            "Runge-Kutta of the impact"
        );
    }
}


TEST(demLaws, coulombImpact)
{
    // An oblique impact that slides all the time, as of test 4 of Chung & Ooi
    impact i{true, 0.0025, 1, 70e9, 0.33, 2700};
    i.contact = "contact { tangential coulomb; }";
    i.pair = "restitution 0.98; friction 0.092;";

    for (const int degrees : {40, 60})
    {
        const scalar theta = degrees*M_PI/180;
        i.speed = 3.9*std::cos(theta);
        i.slide = 3.9*std::sin(theta);

        demCase c(i.dict());
        c.run(i.timeToTouch() + 2*i.contactTime());

        const scalar impulse = 0.092*1.98*i.speed;
        const std::string name = "coulomb_" + std::to_string(degrees);
        figureNear
        (
            name + "_tangentialRestitution",
            c.state().v[0].x()/i.slide,
            1 - impulse/i.slide,
            0.01,
            "-",
            "closed form of gross sliding"
        );
        figureNear
        (
            name + "_spin",
            c.state().omega[0].y(),
            2.5*impulse/i.r,
            0.01,
            "rad/s",
            "closed form of gross sliding"
        );
    }

    // And one that stops sliding: nothing turns it back as a spring does
    i.speed = 3.9;
    i.slide = 0.2;
    i.pair = "restitution 0.98; friction 0.5;";
    demCase c(i.dict());
    c.run(i.timeToTouch() + 2*i.contactTime());
    figureNear
    (
        "coulomb_sticks",
        c.state().v[0].x(),
        5.0/7.0*i.slide,
        0.01,
        "m/s",
        "closed form 5/7 v0"
    );
}


TEST(demLaws, coulombRolls)
{
    // Sliding that turns into rolling, and rolling down a slope
    const scalar v0 = 0.2, mu = 0.3, r = 0.005;
    for (const bool slope : {false, true})
    {
        const scalar angle = slope ? 0.3 : 0;
        const vector down(std::sin(angle), 0, -std::cos(angle));
        demCase c
        (
            "demSolver hades;\ncontact { tangential coulomb; }\n"
            "materials { rock { density 1200; youngsModulus 1e7;"
            " poissonsRatio 0.3; } }\n"
            "pairs { rock-rock { restitution 0.3; friction " + text(mu)
          + "; } }\n"
            "shapes { ball { type sphere; diameter " + text(2*r) + "; } }\n"
            "walls { board { type plane; point (0 0 0); normal (0 0 1);"
            " material rock; } }\n"
            "stepControl { type hades; }\n"
            "bodies { it { material rock; shape ball; position (0 0 "
          + text(r) + "); velocity (" + text(slope ? 0 : v0) + " 0 0); } }\n",
            9.81*down
        );
        if (slope)
        {
            c.run(0.1);
            const scalar v1 = c.state().v[0].x();
            c.run(0.4);
            figureNear
            (
                "coulombSlope",
                (c.state().v[0].x() - v1)/0.4,
                5.0/7.0*9.81*std::sin(angle),
                0.01,
                "m/s2",
                "closed form 5/7 g sin"
            );
            continue;
        }

        const scalar rolls = 2*v0/(7*mu*9.81);
        c.run(0.5*rolls);
        figureNear
        (
            "coulombRolling_halfWay", c.state().v[0].x(), v0*6.0/7.0, 0.01,
            "m/s", "closed form v0 - mu g t"
        );
        c.run(1.5*rolls);
        figureNear
        (
            "coulombRolling", c.state().v[0].x(), 5.0/7.0*v0, 0.01,
            "m/s", "closed form 5/7 v0"
        );
    }
}


// ************************************************************************* //
