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

#include "demCase.H"

#include <algorithm>
#include <cmath>

using namespace styxTest;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- An impact of two spheres, or of one on a plane
struct impact
{
    bool plane;

    //- Radius [m], closing speed [m/s]
    scalar r, speed;

    //- Young's modulus [Pa], Poisson's ratio [-], density [kg/m3]
    scalar E, nu, rho;

    std::string contact = "contact { damping none; tangential none; }";
    std::string pair = "";
    std::string stepControl = "type hades;";

    //- Gap at the start over the radius [-]
    scalar gap = 0.05;

    //- Velocity along the plane [m/s]
    scalar slide = 0;


    // Closed form of Hertz' law

    scalar EStar() const
    {
        // The plane is rigid
        return E/(1 - nu*nu)/(plane ? 1 : 2);
    }

    scalar rStar() const
    {
        return plane ? r : 0.5*r;
    }

    scalar mStar() const
    {
        const scalar m = 4.0/3.0*M_PI*r*r*r*rho;
        return plane ? m : 0.5*m;
    }

    scalar k() const
    {
        return 4.0/3.0*EStar()*std::sqrt(rStar());
    }

    scalar overlap() const
    {
        return std::pow(1.25*mStar()*speed*speed/k(), 0.4);
    }

    scalar peakForce() const
    {
        return k()*std::pow(overlap(), 1.5);
    }

    scalar contactTime() const
    {
        return 2.94327*overlap()/speed;
    }


    //- demCloudProperties
    std::string dict() const
    {
        const scalar z = r*(1 + gap);
        const std::string body =
            "{ shape ball; material ball; position (0 0 ";

        std::string s =
            "demSolver hades;\n" + contact + "\n"
            "materials\n{\n"
            "ball { density " + text(rho) + "; youngsModulus " + text(E)
          + "; poissonsRatio " + text(nu) + "; }\n"
            "rigid { youngsModulus 1e30; poissonsRatio 0.3; }\n}\n"
            "pairs { ball-ball {" + pair + "} ball-rigid {" + pair + "} }\n"
            "shapes { ball { type sphere; diameter " + text(2*r) + "; } }\n"
            "stepControl { " + stepControl + " }\n";

        if (plane)
        {
            s +=
                "walls { floor { type plane; point (0 0 0); normal (0 0 1);"
                " material rigid; } }\n"
                "bodies { a " + body + text(z) + "); velocity ("
              + text(slide) + " 0 " + text(-speed) + "); } }\n";
        }
        else
        {
            s +=
                "bodies { a " + body + text(z) + "); velocity ("
              + text(slide) + " 0 " + text(-0.5*speed) + "); }\n"
                "b " + body + text(-z) + "); velocity ("
              + text(-slide) + " 0 " + text(0.5*speed) + "); } }\n";
        }
        return s;
    }

    //- Closing time of the gap [s]
    scalar timeToTouch() const
    {
        return gap*r*(plane ? 1 : 2)/speed;
    }
};


scalar overlapOf(demCase& c, const impact& i)
{
    const auto& x = c.state().x;
    return i.plane ? i.r - x[0].z() : 2*i.r - mag(x[0] - x[1]);
}

scalar speedOf(demCase& c, const impact& i)
{
    const auto& v = c.state().v;
    return i.plane ? v[0].z() : v[0].z() - v[1].z();
}


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


//- Rebound over impact speed
scalar restitution(const impact& i)
{
    demCase c(i.dict());
    c.run(i.timeToTouch() + 3*i.contactTime());
    EXPECT_LT(overlapOf(c, i), 0);
    return speedOf(c, i)/i.speed;
}


//- Largest |e out/e in - 1| over phases of the first step in contact
scalar restitutionError(impact i, const scalar e)
{
    i.contact = "contact { tangential none; }";
    i.pair = "restitution " + text(e) + ";";

    scalar worst = 0;
    for (int phase = 0; phase < 16; ++phase)
    {
        i.gap = 0.05 + 0.00037*phase;
        worst = std::max(worst, std::abs(restitution(i)/e - 1));
    }
    return worst;
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
