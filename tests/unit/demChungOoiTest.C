/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    The tests of Chung & Ooi 2011 after the first two: restitution, oblique
    impacts that slide all the time, spinning spheres. Friction pushes no
    longer than the normal force, so that these have no pull (pulling no).

\*---------------------------------------------------------------------------*/

#include "demImpact.H"

using namespace styxTest;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const char* const chungOoi = "closed form, Chung & Ooi 2011";

const char* const pushing = "contact { pulling no; }";

//- Velocity of the point that touches the plane [m/s]
scalar slipOf(demCase& c, const impact& i)
{
    return c.state().v[0].x() - i.r*c.state().omega[0].y();
}

//- Run an impact to its end
void hit(demCase& c, const impact& i)
{
    c.run(i.timeToTouch() + 3*i.contactTime());
    EXPECT_LT(overlapOf(c, i), 0);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(demChungOoi, test3)
{
    // Figures "chungOoi3_oxide", "chungOoi3_iron"
    const impact materials[] =
    {
        {true, 0.0025, 3.9, 380e9, 0.23, 4000},
        {true, 0.0025, 3.9, 100e9, 0.25, 7000}
    };
    for (impact i : materials)
    {
        scalar worst = 0;
        for (const scalar e : {0.2, 0.4, 0.6, 0.8, 1.0})
        {
            i.contact = "contact { tangential none; pulling no; }";
            i.pair = "restitution " + text(e) + ";";
            worst = std::max(worst, restitutionError(i, e));
        }
        figure
        (
            i.E > 2e11 ? "chungOoi3_oxide" : "chungOoi3_iron",
            100*worst,
            0,
            1,
            "% of e",
            "e in = e out, Chung & Ooi 2011"
        );
    }
}


TEST(demChungOoi, test4)
{
    // All angles from the normal [deg]: tangential restitution, spin [rad/s],
    // and direction of the rebound of the touching point [deg], as digitised
    // for references of other codes; of oxide and of alloy. Figures
    // "chungOoi4_oxide_restitution", ...
    const struct {scalar angle, e[2], spin[2], rebound;} curve[] =
    {
        {5, {0.948, 0.899}, {19.3, 35.3}, 3.76},
        {10, {0.687, 0.671}, {213.0, 223.7}, -1.56},
        {15, {0.624, 0.613}, {377.8, 389.6}, -5.54},
        {20, {0.616, 0.609}, {510.6, 519.1}, -7.54},
        {25, {0.634, 0.633}, {599.4, 599.4}, -7.54},
        {30, {0.684, 0.683}, {616.5, 617.6}, -3.55},
        {35, {0.737, 0.736}, {582.3, 582.3}, 3.43},
        {40, {0.781, 0.780}, {544.8, 544.8}, 11.57},
        {50, {0.845, 0.844}, {457.0, 458.1}, 29.35},
        {60, {0.893, 0.891}, {357.5, 358.6}, 47.79},
        {70, {0.932, 0.932}, {246.2, 245.1}, 64.58},
        {80, {0.966, 0.966}, {126.3, 125.2}, 78.70},
        {85, {0.983, 0.983}, {63.1, 64.2}, 84.52}
    };
    for (const int m : {0, 1})
    {
        impact i =
            m == 0
          ? impact{true, 0.0025, 1, 380e9, 0.23, 4000}
          : impact{true, 0.0025, 1, 70e9, 0.33, 2700};
        i.contact = pushing;
        i.pair = "restitution 0.98; friction 0.092;";

        scalar worst[3] = {0, 0, 0};
        for (const auto& at : curve)
        {
            const scalar theta = at.angle*M_PI/180;
            i.speed = 3.9*std::cos(theta);
            i.slide = 3.9*std::sin(theta);
            demCase c(i.dict());
            hit(c, i);
            const scalar rebound =
                std::atan2(slipOf(c, i), c.state().v[0].z())*180/M_PI;
            const scalar errors[3] =
            {
                (c.state().v[0].x()/i.slide - at.e[m])/0.983,
                (c.state().omega[0].y() - at.spin[m])/617,
                (rebound - at.rebound)/84.52
            };
            for (int n = 0; n < 3; ++n)
            {
                worst[n] = std::max(worst[n], 100*std::abs(errors[n]));
            }
        }
        const char* const of[3] = {"restitution", "spin", "rebound"};
        for (int n = 0; n < 3; ++n)
        {
            figure
            (
                std::string("chungOoi4_") + (m ? "alloy_" : "oxide_") + of[n],
                worst[n],
                0,
                5,
                "% of the curve's largest",
                "Chung & Ooi 2011, test 4, 5 to 85 degrees"
            );
        }
    }
}


TEST(demChungOoi, test5)
{
    // X, Y, W: velocity across before, that of the touching point and of the
    // spin after, over mu v_n. Figures "chungOoi5_steel_8_slip", ... The soft
    // one has an overlap of 2.7 % of its radius, by which the arm of the
    // friction is shorter than in the closed form: it has a bar against the
    // closed form of that arm, r less the overlap as the impulse weights it,
    // 0.8176 of the largest in Hertz' law without loss
    const impact materials[] =
    {
        {true, 1e-5, 5, 208e9, 0.3, 7850},
        {true, 1e-5, 5, 1e9, 0.4, 1400}
    };
    for (impact i : materials)
    {
        i.contact = pushing;
        i.pair = "restitution 1; friction 0.3;";
        const bool steel = i.E > 1e10;
        for (const int X : {8, 12, 20})
        {
            i.slide = X*0.3*i.speed;
            demCase c(i.dict());
            hit(c, i);

            const std::string name =
                std::string("chungOoi5_")
              + (steel ? "steel_" : "polyethylene_") + std::to_string(X);
            const scalar change = X - slipOf(c, i)/(0.3*i.speed);
            const scalar W = -i.r*c.state().omega[0].y()/(0.3*i.speed);
            figure
            (
                name + "_slip",
                change,
                steel ? 6.93 : -noBar,
                steel ? 7.07 : noBar,
                "X - Y",
                "7; " + std::string(chungOoi)
            );
            figure
            (
                name + "_W",
                W,
                steel ? -5.05 : -noBar,
                steel ? -4.95 : noBar,
                "W",
                "-5; " + std::string(chungOoi)
            );
            figureNear
            (
                name + "_arm",
                W,
                -5*(1 - 0.8176*i.overlap()/i.r),
                0.002,
                "W",
                "closed form with the arm that the overlap leaves"
            );
        }
    }
}


TEST(demChungOoi, test5Limit)
{
    // The closed form is that of a sphere that does not flatten: the soft one
    // of test 5 comes to it as its overlap vanishes, which is 2.7 % of the
    // radius at the 5 m/s of the test, and smaller as the speed to the 0.8th.
    // Steps ten times as fine change nothing
    const scalar nominal = 0.8176*5;
    for (const scalar speed : {5.0, 0.5, 0.05})
    {
        for (const std::string control :
            {"type hades;", "type hades; contactSteps 200;"})
        {
            impact i{true, 1e-5, speed, 1e9, 0.4, 1400};
            i.contact = pushing;
            i.pair = "restitution 1; friction 0.3;";
            i.stepControl = control;
            i.slide = 12*0.3*i.speed;
            demCase c(i.dict());
            hit(c, i);
            const scalar change = 12 - slipOf(c, i)/(0.3*i.speed);
            const bool fine = control.size() > 12;
            const std::string name = "chungOoi5_limit_"
              + std::to_string(int(std::lround(100*speed)));
            if (fine)
            {
                figureNear
                (
                    name,
                    (7 - change)/(nominal*i.overlap()/i.r),
                    1,
                    0.01,
                    "of 5 0.818 delta_max/r",
                    "what the arm r - 0.818 delta_max leaves of 7"
                );
            }
            if (speed < 0.1)
            {
                figureNear
                (
                    name + (fine ? "_fine" : "_slip"), change, 7, 0.01,
                    "X - Y", chungOoi
                );
            }
        }
    }
}


TEST(demChungOoi, test6)
{
    // A sphere that spins but does not slide: A = 3.5 mu (1 + e) v_n/v_t,
    // -v_t'/v_t = A - 1. Steps of 1/40 contact. Figures
    // "chungOoi6_alloy_0.175", ...
    const impact materials[] =
    {
        {true, 0.1, 0.2, 70e9, 0.33, 2700},
        {true, 0.1, 0.2, 2.5e9, 0.4, 1000}
    };
    for (impact i : materials)
    {
        i.contact = pushing;
        i.pair = "restitution 0.5; friction 0.4;";
        i.stepControl = "type hades; contactSteps 40;";
        for (const scalar A : {0.176, 0.5, 0.75})
        {
            const scalar slip = 2.1*i.speed/A;
            i.spin = -slip/i.r;
            demCase c(i.dict());
            hit(c, i);
            figureNear
            (
                std::string("chungOoi6_") + (i.E > 1e10 ? "alloy_" : "nylon_")
              + text(A).substr(0, 5),
                -slipOf(c, i)/slip,
                A - 1,
                0.01,
                "-",
                chungOoi
            );
            figureNear
            (
                std::string("chungOoi6_") + (i.E > 1e10 ? "alloy_" : "nylon_")
              + text(A).substr(0, 5) + "_tanOut",
                slipOf(c, i)/c.state().v[0].z(),
                (slip/i.speed - 2.1)/0.5,
                0.01,
                "-",
                chungOoi
            );
        }
    }
}


TEST(demChungOoi, test7)
{
    // Opposite spins: the surfaces do not slip
    impact i{false, 0.1, 0.4, 70e9, 0.33, 2700};
    i.contact = pushing;
    i.pair = "restitution 0.5; friction 0.4;";
    scalar worst = 0, across = 0;
    for (const scalar spin : {1.0, 10.0, 24.0})
    {
        i.spin = spin;
        i.otherSpin = -spin;
        demCase c(i.dict());
        hit(c, i);
        for (const label b : {0, 1})
        {
            worst = std::max
            (
                worst,
                std::abs(c.state().omega[b].y()/(b ? -spin : spin) - 1)
            );
            across = std::max(across, std::abs(c.state().v[b].x()));
        }
        EXPECT_NEAR(speedOf(c, i)/i.speed, 0.5, 0.005);
    }
    figure
    (
        "chungOoi7_spin", worst, 0, 0.01, "of the spin before", chungOoi
    );
    figure
    (
        "chungOoi7_velocity", across, 0, 0.002, "m/s", chungOoi
    );
}


TEST(demChungOoi, test8)
{
    // A large sphere, 1000 times as heavy and as stiff, for the plane of 6
    for (const scalar A : {0.176, 0.5, 0.75})
    {
        const scalar u = 0.2, slip = 2.1*u/A;
        demCase c
        (
            "demSolver hades;\n" + std::string(pushing) + "\n"
            "materials {\n"
            "    alloy { density 2700; youngsModulus 70e9;"
            " poissonsRatio 0.33; }\n"
            "    wall { density 2700e3; youngsModulus 70e12;"
            " poissonsRatio 0.33; } }\n"
            "pairs { alloy-alloy { restitution 0.5; friction 0.4; }"
            " alloy-wall { restitution 0.5; friction 0.4; }"
            " wall-wall { restitution 0.5; friction 0.4; } }\n"
            "shapes { small { type sphere; diameter 0.2; }"
            " large { type sphere; diameter 1; } }\n"
            "stepControl { type hades; }\n"
            "bodies { a { shape small; material alloy;"
            " position (0 0 0.6002); velocity (0 0 -0.2);"
            " angularVelocity (0 " + text(-slip/0.1) + " 0); }"
            " b { shape large; material wall; position (0 0 0); } }\n"
        );
        c.run(0.005);
        const scalar w = c.state().v[0].z();
        EXPECT_NEAR(w/u, 0.5, 0.005);
        figureNear
        (
            "chungOoi8_" + text(A).substr(0, 5),
            -(c.state().v[0].x() - 0.1*c.state().omega[0].y())/slip,
            A - 1,
            0.01,
            "-",
            chungOoi
        );
    }
}


// ************************************************************************* //
