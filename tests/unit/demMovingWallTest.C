/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    Walls that move with the mesh push the bodies: a piston, a floor that
    rises, a belt, a turntable.

\*---------------------------------------------------------------------------*/

#include "demCase.H"

#include <cmath>

using namespace styxTest;
using namespace Foam::dem;
using Foam::mag;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Where a point of the floor is at a time [s]
typedef std::function<point(const point&, scalar)> motion;


//- A ball over a square floor of two triangles that moves as a mesh does, step
//  by step of the fluid
class movingFloor
{
    motion motion_;

    //- Start and end of the fluid's step [s]
    std::shared_ptr<scalar> t0_, t1_;

    std::unique_ptr<demCase> case_;


public:

    movingFloor
    (
        const motion& m,
        const std::string& more,
        const std::string& start,
        const vector& g,
        const scalar youngsModulus = 1e7
    )
    :
        motion_(m),
        t0_(new scalar(0)),
        t1_(new scalar(0))
    {
        case_.reset
        (
            new demCase
            (
                "demSolver hades;\n"
                "materials { stuff { density 2500; youngsModulus "
              + text(youngsModulus) + "; poissonsRatio 0.3; } }\n"
                "shapes { ball { type sphere; diameter 0.01; } }\n"
                "walls { floor { type patch; material stuff; } }\n"
                "bodies { it { shape ball; material stuff; " + start
              + " } }\n" + more,
                g,
                Foam::List<corners>(),
                [this](demInput& input)
                {
                    input.patchTriangles = [=]
                    (
                        const Foam::wordRes&,
                        const Foam::dictionary&,
                        const bool old
                    )
                    {
                        return floorAt(old ? *t0_ : *t1_);
                    };
                }
            )
        );
    }

    Foam::List<corners> floorAt(const scalar t) const
    {
        Foam::List<corners> floor(2);
        floor[0][0] = floor[1][0] = motion_(point(-0.5, -0.5, 0), t);
        floor[0][1] = motion_(point(0.5, -0.5, 0), t);
        floor[0][2] = floor[1][1] = motion_(point(0.5, 0.5, 0), t);
        floor[1][2] = motion_(point(-0.5, 0.5, 0), t);
        return floor;
    }

    void run(const label nSteps, const scalar dt)
    {
        for (label n = 0; n < nSteps; ++n)
        {
            *t0_ = case_->time();
            *t1_ = *t0_ + dt;
            case_->solver().updateWalls(true, *t0_, *t1_);
            case_->run(dt);
        }
    }

    demCase& operator*()
    {
        return *case_;
    }

    demCase* operator->()
    {
        return case_.get();
    }
};


motion steady(const vector& v)
{
    return [=](const point& p, const scalar t) { return p + t*v; };
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(demMovingWall, piston)
{
    // Elastic: v' = 2 V - v. The second comes so fast, and in so long a step
    // of the fluid, that it would be through the ball in one
    for (const scalar V : {0.3, 40.0})
    {
        movingFloor c
        (
            steady(vector(0, 0, V)),
            "contact { damping none; }\n"
            "pairs { stuff-stuff { friction 0.3; } }\n"
            "stepControl { type hades; contactSteps 200; }\n",
            "position (0.01 0.02 0.0251); velocity (0 0 -0.2);",
            Foam::Zero,
            V < 1 ? 1e7 : 1e10
        );
        c.run(V < 1 ? 100 : 2, V < 1 ? 1e-3 : 2e-3);
        EXPECT_EQ(c->solver().report().nContacts, 0);
        figureNear
        (
            V < 1 ? "piston_slow" : "piston_fast",
            c->state().v[0].z(),
            2*V + 0.2,
            1e-4,
            "m/s",
            "closed form 2 V - v"
        );
        EXPECT_LT
        (
            mag(c->state().v[0].x()) + mag(c->state().v[0].y())
          + 0.005*mag(c->state().omega[0]),
            1e-9*V
        );
    }
}


TEST(demMovingWall, pistonRestitution)
{
    const scalar V = 0.5;
    movingFloor c
    (
        steady(vector(0, 0, V)),
        "pairs { stuff-stuff { restitution 0.6; friction 0.3; } }\n"
        "stepControl { type hades; }\n",
        "position (0.01 0.02 0.0251);",
        Foam::Zero
    );
    c.run(60, 1e-3);
    figureNear
    (
        "piston_restitution",
        c->state().v[0].z(),
        1.6*V,
        0.01,
        "m/s",
        "closed form (1 + e) V"
    );
}


TEST(demMovingWall, risingFloor)
{
    // A ball that rests on a floor goes with it, whether it rises steadily or
    // is shaken by less than g
    const std::string sticky
    (
        "pairs { stuff-stuff { restitution 0.3; friction 0.3; } }\n"
        "stepControl { type hades; }\n"
    );
    const auto heightOver = [&](const motion& m, const label n, scalar& v)
    {
        movingFloor c(m, sticky, "position (0.01 0.02 0.005);", gravity);
        c.run(n, 1e-3);
        v = c->state().v[0].z();
        return
            c->state().x[0].z() - m(point(0, 0, 0), c->time()).z() - 0.005;
    };

    // In rest the overlap carries the weight
    scalar v;
    const scalar still = heightOver(steady(Foam::Zero), 300, v);
    EXPECT_LT(mag(v), 1e-9);

    const scalar rising = heightOver(steady(vector(0, 0, 0.1)), 300, v);
    figureNear
    (
        "risingFloor_velocity",
        v,
        0.1,
        1e-6,
        "m/s",
        "that of the floor"
    );
    figureNear
    (
        "risingFloor_overlap",
        rising,
        still,
        1e-6,
        "m",
        "at rest, with the same weight"
    );

    // 10 Hz with 0.5 mm: 0.2 g. The floor is where it should be at the end of
    // each of the fluid's steps, so its velocity is that of the middle of one
    const scalar omega = 2*M_PI*10;
    const motion shaken = [=](const point& p, const scalar t)
    {
        return p + vector(0, 0, 5e-4*(1 - std::cos(omega*t)));
    };
    heightOver(shaken, 520, v);
    figureNear
    (
        "shakenFloor_velocity",
        v,
        5e-4*omega*std::sin(omega*0.52),
        0.05,
        "m/s",
        "that of the floor"
    );
}


TEST(demMovingWall, belt)
{
    // A ball on a belt is pulled along with mu g until it rolls at 2/7 of the
    // belt's velocity
    const scalar U = 0.5;
    const scalar mu = 0.2;
    movingFloor c
    (
        steady(vector(U, 0, 0)),
        "pairs { stuff-stuff { restitution 0.3; friction " + text(mu)
      + "; } }\n"
        "stepControl { type hades; }\n",
        "position (0 0.02 0.005);",
        gravity
    );

    // So that it has settled; then over a time in which it slides
    c.run(20, 1e-3);
    const scalar v1 = c->state().v[0].x();
    c.run(40, 1e-3);
    figureNear
    (
        "belt_acceleration",
        (c->state().v[0].x() - v1)/0.04,
        mu*9.81,
        0.005,
        "m/s2",
        "closed form mu g"
    );
    c.run(240, 1e-3);

    // The foot is nearer to the centre than the radius, by the overlap
    const scalar arm = c->state().x[0].z();
    const scalar ratio = 1 + 2.5*arm*arm/(0.005*0.005);
    figureNear
    (
        "belt_rolling",
        c->state().v[0].x(),
        U/ratio,
        1e-4,
        "m/s",
        "closed form 2/7 U, less the overlap"
    );
    figureNear
    (
        "belt_spin",
        c->state().omega[0].y(),
        (U/ratio - U)/arm,
        1e-4,
        "rad/s",
        "closed form -5/7 U/r, less the overlap"
    );
}


TEST(demMovingWall, stopsAgain)
{
    // A mesh that moves no more: the floor rests where it has come to
    movingFloor c
    (
        steady(vector(0, 0, 0.1)),
        "pairs { stuff-stuff { restitution 0.3; friction 0.3; } }\n"
        "stepControl { type hades; }\n",
        "position (0.01 0.02 0.005);",
        gravity
    );
    c.run(50, 1e-3);
    c->solver().updateWalls(false, c->time(), c->time());
    c->run(0.3);

    // Less the overlap that carries the weight
    EXPECT_NEAR(c->state().x[0].z(), 0.005 + 0.005 - 8.5e-6, 1e-7);
    EXPECT_LT(mag(c->state().v[0]), 1e-9);
}


TEST(demMovingWall, velocityOfTriangle)
{
    // A turn about an axis: velocity w ^ r and spin w.n in the middle of the
    // step, but for the chord
    const vector w(1, -2, 3);
    const scalar dt = 1e-4;
    corners c;
    c[0] = point(0.1, 0.2, 0.3);
    c[1] = point(1.1, 0.1, 0.2);
    c[2] = point(0.3, 0.9, 0.7);

    Foam::List<corners> old(1), now(1);
    for (label k = 0; k < 3; ++k)
    {
        old[0][k] = Foam::quaternion(w/mag(w), -0.5*dt*mag(w)).transform(c[k]);
        now[0][k] = Foam::quaternion(w/mag(w), 0.5*dt*mag(w)).transform(c[k]);
    }
    triangleWall wall("w", 0, old);
    EXPECT_FALSE(wall.moving());
    wall.setMotion(old, now, 2, 2 + dt);
    wall.moveTo(2 + 0.5*dt);
    EXPECT_TRUE(wall.moving());

    const point p = 0.2*c[0] + 0.5*c[1] + 0.3*c[2];
    point q;
    vector n;
    EXPECT_NEAR(wall.nearest(p, 0, q, n), 0, 1e-8);
    EXPECT_LT(mag(wall.velocity(0, p) - (w ^ p)), 1e-6);
    EXPECT_NEAR(wall.spin(0, n), w & n, 1e-6);
    EXPECT_GE(wall.speed(), mag(w ^ c[1])*(1 - 1e-6));
}


// ************************************************************************* //
