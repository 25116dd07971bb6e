/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    Impacts of spheres: Hertz' law in closed form (tests 1 and 2 of Chung &
    Ooi 2011), the restitution that is asked for, and gross sliding.

\*---------------------------------------------------------------------------*/

#include "demImpact.H"

using namespace styxTest;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Figures of an elastic impact
void hertz(const std::string& name, const impact& i, const std::string& source)
{
    demCase c(i.dict());

    const scalar tc = i.contactTime();
    scalar force = 0;
    scalar overlap = 0;

    for (label n = 0; n < 100000 && speedOf(c, i) < i.speed*0.999999; ++n)
    {
        // Not to wait for the gap to close in such small steps
        c.run(n ? 0.005*tc : 0.99*i.timeToTouch());
        force = std::max(force, c.state().force[0].z());
        overlap = std::max(overlap, overlapOf(c, i));
        if (n > 1000)
        {
            break;
        }
    }
    ASSERT_LT(overlapOf(c, i), 0);
    const scalar time =
        c.time() + overlapOf(c, i)/speedOf(c, i) - i.timeToTouch();

    figureNear(name + "_peakForce", force, i.peakForce(), 0.005, "N", source);
    figureNear(name + "_overlap", overlap, i.overlap(), 0.005, "m", source);
    figureNear(name + "_contactTime", time, tc, 0.005, "s", source);
}


const char* const chungOoi = "closed form, Chung & Ooi 2011";

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(demImpact, chungOoi1Glass)
{
    // Figures "chungOoi1_glass_peakForce", "chungOoi1_glass_overlap",
    // "chungOoi1_glass_contactTime"
    hertz
    (
        "chungOoi1_glass",
        impact{false, 0.01, 20, 48e9, 0.2, 2800},
        chungOoi
    );
}


TEST(demImpact, chungOoi1Limestone)
{
    // Figures "chungOoi1_limestone_peakForce", "chungOoi1_limestone_overlap",
    // "chungOoi1_limestone_contactTime"
    hertz
    (
        "chungOoi1_limestone",
        impact{false, 0.01, 20, 20e9, 0.25, 2500},
        chungOoi
    );
}


TEST(demImpact, chungOoi2Aluminium)
{
    // Figures "chungOoi2_aluminium_peakForce", "chungOoi2_aluminium_overlap",
    // "chungOoi2_aluminium_contactTime"
    hertz
    (
        "chungOoi2_aluminium",
        impact{true, 0.1, 0.2, 70e9, 0.3, 2699},
        chungOoi
    );
}


TEST(demImpact, chungOoi2Magnesium)
{
    // Figures "chungOoi2_magnesium_peakForce", "chungOoi2_magnesium_overlap",
    // "chungOoi2_magnesium_contactTime"
    hertz
    (
        "chungOoi2_magnesium",
        impact{true, 0.1, 0.2, 40e9, 0.35, 1800},
        chungOoi
    );
}


TEST(demImpact, restitution)
{
    // With the default steps, and with small fixed ones: figures
    // "restitution_plane_slow", "restitution_plane_fast",
    // "restitution_spheres_slow", "restitution_spheres_fast"
    for (const bool fixed : {false, true})
    for (const bool plane : {true, false})
    for (const scalar speed : {0.1, 3.9})
    {
        scalar worst = 0;
        scalar worstE = 0;
        for (int n = 1; n <= 10; ++n)
        {
            impact i{plane, 0.0025, speed, 1e9, 0.25, 2500};
            if (fixed)
            {
                i.stepControl =
                    "type fixed; deltaT " + text(0.005*i.contactTime())
                  + ";";
            }

            i.contact = "contact { tangential none; }";
            i.pair = "restitution " + text(0.1*n) + ";";
            const scalar error = restitutionError(i, 0.1*n);
            if (error > worst)
            {
                worst = error;
                worstE = 0.1*n;
            }
        }
        figure
        (
            std::string("restitution_")
          + (fixed ? "fixed_" : "")
          + (plane ? "plane_" : "spheres_")
          + (speed < 1 ? "slow" : "fast"),
            100*worst,
            0,
            1,
            "% (at e = " + text(worstE).substr(0, 3) + ")",
            "Tsuji et al. 1992"
        );
    }
}


TEST(demImpact, restitutionFractions)
{
    // What coarser steps cost: figures "restitutionFraction_0.05",
    // "restitutionFraction_0.1", "restitutionFraction_0.2"
    for (const scalar fraction : {0.05, 0.1, 0.2})
    {
        scalar worst = 0;
        scalar worstE = 0;
        for (int n = 1; n <= 10; ++n)
        {
            impact i{false, 0.006, 1, 5e6, 0.25, 1200};
            i.stepControl =
                "type contact; rayleighFraction 1; contactFraction "
              + text(fraction) + ";";
            i.contact = "contact { tangential none; }";
            i.pair = "restitution " + text(0.1*n) + ";";
            const scalar error = restitutionError(i, 0.1*n);
            if (error > worst)
            {
                worst = error;
                worstE = 0.1*n;
            }
        }
        figure
        (
            "restitutionFraction_" + text(fraction).substr(0, 4),
            100*worst,
            0,
            fraction < 0.1 ? 1 : fraction < 0.2 ? 3 : 8,
            "% (at e = " + text(worstE).substr(0, 3) + ")",
            "Tsuji et al. 1992"
        );
    }
}


TEST(demImpact, restitutionSteps)
{
    // What an impact costs with the default steps, its damped end included:
    // figures "restitutionSteps_1", "restitutionSteps_0.5",
    // "restitutionSteps_0.1"
    impact i{true, 0.0025, 3.9, 1e9, 0.25, 2500};
    i.contact = "contact { tangential none; }";
    i.gap = 1e-6;

    for (const scalar e : {1.0, 0.5, 0.1})
    {
        i.pair = "restitution " + text(e) + ";";
        demCase c(i.dict());
        for (label n = 0; n < 10000 && overlapOf(c, i) > -1e-4*i.r; ++n)
        {
            c.run(i.contactTime());
        }
        figure
        (
            "restitutionSteps_" + text(e).substr(0, 3),
            c.nSteps + c.nRejected,
            20,
            e == 1 ? 60 : e == 0.5 ? 100 : 250,
            "steps",
            "stepControl hades, defaults"
        );
    }
}


TEST(demImpact, grossSliding)
{
    // Chung & Ooi test 4: oblique impact of a sphere on a plane
    impact i{true, 0.0025, 1, 70e9, 0.33, 2700};
    i.contact = "contact {}";
    i.pair = "restitution 0.98; friction 0.092;";

    for (const int degrees : {40, 60, 80})
    {
        const scalar theta = degrees*M_PI/180;
        i.speed = 3.9*std::cos(theta);
        i.slide = 3.9*std::sin(theta);

        demCase c(i.dict());
        c.run(i.timeToTouch() + 2*i.contactTime());

        const scalar impulse = 0.092*1.98*i.speed;
        const std::string name = "chungOoi4_" + std::to_string(degrees);
        figureNear
        (
            name + "_tangentialRestitution",
            c.state().v[0].x()/i.slide,
            1 - impulse/i.slide,
            0.005,
            "-",
            "closed form of gross sliding"
        );
        figureNear
        (
            name + "_spin",
            c.state().omega[0].y(),
            2.5*impulse/i.r,
            0.005,
            "rad/s",
            "closed form of gross sliding"
        );
    }
}


// ************************************************************************* //
