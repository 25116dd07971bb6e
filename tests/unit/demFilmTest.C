/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    The film of liquid between surfaces that are near, against closed forms.

\*---------------------------------------------------------------------------*/

#include "demCase.H"

#include <cmath>

using namespace styxTest;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const scalar r = 0.001;
const scalar mass = 2000*4.0/3.0*M_PI*r*r*r;
const scalar mu = 0.1;

std::string body
(
    const std::string& name,
    const std::string& shape,
    const vector& x,
    const vector& v
)
{
    return
        "    " + name + " { shape " + shape + "; material rock; position "
      + text(x) + "; velocity " + text(v) + "; }\n";
}

//- Balls of 2 and 6 mm in a liquid, and the floor z = 0 of a kind, if any
std::string balls(const std::string& bodies, const std::string& floor)
{
    return
        "demSolver hades;\ncontact { tangential none; damping none; }\n"
        "materials\n{\n    rock { density 2000; youngsModulus 1e7;"
        " poissonsRatio 0.3; }\n"
        "    board { youngsModulus 1e7; poissonsRatio 0.3; }\n}\n"
        "pairs { rock-rock { } rock-board { } }\n"
        "shapes { ball { type sphere; diameter 0.002; }"
        " large { type sphere; diameter 0.006; } }\n"
        "stepControl { type hades; }\n"
        "bodies\n{\n" + bodies + "}\n"
      + (floor.empty() ? floor : "walls { " + floor + " }\n");
}

const std::string plane
(
    "board { type plane; point (0 0 0); normal (0 0 1); material board; }"
);

void liquid(Foam::dem::demInput& input)
{
    input.film.viscosity = mu;
    input.film.roughness = 1e-5;
    input.film.range = 1;
}

const Foam::List<Foam::dem::corners> none;

//- The integral of 1/l - 1/l1 between two gaps, where there is film
scalar narrowed(const scalar from, const scalar to, const scalar l1)
{
    const scalar start = std::min(from, l1), l = std::min(to, l1);
    return std::log(start/l) - (start - l)/l1;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(demFilm, wall)
{
    // Thrown at the floor: m dv = -beta (1/l - 1/l1) dl
    const scalar beta = 6*M_PI*mu*r*r, v0 = 0.5;
    demCase c
    (
        balls(body("a", "ball", {0, 0, 2.5*r}, {0, 0, -v0}), plane),
        Foam::Zero, none, liquid
    );
    scalar worst = 0, l = r;
    while (l > 0.05*r)
    {
        c.run(1e-5);
        l = c.state().x[0].z() - r;
        const scalar v = v0 - beta/mass*narrowed(1.5*r, l, r);
        worst = std::max(worst, std::abs(-c.state().v[0].z() - v));
    }
    figure
    (
        "film_wall", worst/v0, 0, 0.01, "-",
        "closed form, a ball thrown at a plane"
    );

    // And pulled off it, it is held back as much as it was pushed
    demCase d
    (
        balls(body("a", "ball", {0, 0, 1.05*r}, {0, 0, v0}), plane),
        Foam::Zero, none, liquid
    );
    d.run(0.02);
    figureNear
    (
        "film_parts", v0 - d.state().v[0].z(),
        beta/mass*narrowed(r, 0.05*r, r), 0.01, "m/s",
        "closed form, a ball that leaves a plane"
    );
}


TEST(demFilm, settles)
{
    // Its weight squeezes the film: beta (1/l - 1/l1) dl/dt = -W
    const scalar beta = 6*M_PI*mu*r*r, W = 0.02*mass*9.81;
    demCase c
    (
        balls(body("a", "ball", {0, 0, 1.2*r}, {0, 0, 0}), plane),
        0.02*gravity, none, liquid
    );
    const scalar t = beta/W*narrowed(0.2*r, 0.03*r, r);
    for (int n = 0; n < 200; ++n)
    {
        c.run(t/200);
    }
    figureNear
    (
        "film_settles", c.state().x[0].z() - r, 0.03*r, 0.01, "m",
        "closed form, weight against the film"
    );
}


TEST(demFilm, pair)
{
    // A small ball meets a large one that is free, aside of the axes
    const vector n = Foam::normalised(vector(1, 2, -2));
    const scalar rStar = 3*r*r/(4*r), mStar = mass*27/28;
    const scalar beta = 6*M_PI*mu*rStar*rStar, v0 = 0.2;
    demCase c
    (
        balls
        (
            body("a", "large", -3*r*n, {0, 0, 0})
          + body("b", "ball", (r + 1.1*rStar)*n, -v0*n),
            ""
        ),
        Foam::Zero, none, liquid
    );
    scalar l = r;
    while (l > 0.1*rStar)
    {
        c.run(1e-5);
        l = mag(c.state().x[1] - c.state().x[0]) - 4*r;
    }
    const vector u = c.state().v[1] - c.state().v[0];
    figureNear
    (
        "film_pair", v0 + (u & n),
        beta/mStar*narrowed(rStar, l, rStar), 0.01, "m/s",
        "closed form, balls of 2 and 6 mm"
    );
    figure
    (
        "film_momentum",
        mag(27*c.state().v[0] + c.state().v[1] + v0*n)/v0, 0, 1e-14, "-",
        "what one gets the other loses"
    );
    figure("film_normal", mag(u - (u & n)*n)/v0, 0, 1e-12, "-",
           "nothing across the line of the centres");
}


TEST(demFilm, widest)
{
    // As with cells of 0.8 mm around balls that fill them: in gaps that are
    // wider the mesh has the flow
    const auto coarse = [](Foam::dem::demInput& input)
    {
        liquid(input);
        input.film.widest = 0.8*r;
    };
    const scalar rStar = 1.5*r, v0 = 0.2;
    demCase c
    (
        balls
        (
            body("a", "large", {-3.8*r, 0, 0}, {v0, 0, 0})
          + body("b", "large", {3.8*r, 0, 0}, {-v0, 0, 0}),
            ""
        ),
        Foam::Zero, none, coarse
    );
    scalar l = r;
    while (l > 0.1*rStar)
    {
        c.run(1e-5);
        l = c.state().x[1].x() - c.state().x[0].x() - 6*r;
    }
    figureNear
    (
        "film_widest", 2*v0 + (c.state().v[1] - c.state().v[0]).x(),
        6*M_PI*mu*rStar*rStar/(13.5*mass)*narrowed(rStar, l, 0.8*r), 0.01,
        "m/s", "closed form, two balls of 6 mm, a film of 0.8 mm at most"
    );

    // A small one at a large one has its whole film, of 0.75 mm
    vector v[2];
    for (const bool whole : {false, true})
    {
        demCase d
        (
            balls
            (
                body("a", "large", {-3*r, 0, 0}, {0, 0, 0})
              + body("b", "ball", {1.9*r, 0, 0}, {-v0, 0, 0}),
                ""
            ),
            Foam::Zero, none, whole ? liquid : +coarse
        );
        d.run(4e-3);
        v[whole] = d.state().v[1];
    }
    figure
    (
        "film_widestPoint", mag(v[0] - v[1])/v0, 0, 1e-14, "-",
        "balls of 2 and 6 mm, as without a widest gap"
    );
    figure
    (
        "film_widestActs", 1 + v[0].x()/v0, 0.01, 1, "-",
        "of its velocity, which the film took"
    );
}


TEST(demFilm, manySizes)
{
    // Grains beside a ball, within its reach and not within theirs: the pairs
    // that are listed follow from R*, and what acts is the same
    std::string all(body("a", "large", {0, 0, 0}, {0, 0, 0}));
    for (int k = 0; k < 12; ++k)
    {
        const scalar angle = k*M_PI/6;
        all += body
        (
            "b" + std::to_string(k), "ball",
            4.3*r*vector(std::cos(angle), std::sin(angle), 0),
            -0.05*vector(std::cos(angle), std::sin(angle), 0)
        );
    }
    demCase c(balls(all, ""), Foam::Zero, none, liquid);
    c.run(2e-3);
    scalar least = 1, most = 0;
    for (int k = 1; k <= 12; ++k)
    {
        const scalar v = mag(c.state().v[k])/0.05;
        least = std::min(least, v);
        most = std::max(most, v);
    }
    figure("film_sizes", most, 0.01, 0.99, "-", "of its velocity, all slower");
    figure("film_sizesAlike", most - least, 0, 1e-9, "-", "a ring of twelve");
}


TEST(demFilm, rough)
{
    // Within the roughness, and beyond the range, there is no film
    demCase c
    (
        balls
        (
            body("a", "ball", {0, 0, r + 9e-6}, {0, 0, -1e-3})
          + body("b", "ball", {5*r, 0, 2.5*r}, {0, 0, -1e-3}),
            plane
        ),
        Foam::Zero, none, liquid
    );
    c.run(8e-3);
    figure
    (
        "film_rough", mag(c.state().v[0] + vector(0, 0, 1e-3))/1e-3, 0, 0,
        "-", "no force in gaps below the roughness"
    );
    figure
    (
        "film_range", mag(c.state().v[1] + vector(0, 0, 1e-3))/1e-3, 0, 0,
        "-", "nor in those above the range"
    );
}


TEST(demFilm, movingWall)
{
    // The floor comes up at a ball at rest: as the ball thrown at the floor
    const scalar beta = 6*M_PI*mu*r*r, v0 = 0.5;
    demCase c
    (
        balls
        (
            body("a", "ball", {0, 0, 2.5*r}, {0, 0, 0}),
            "board { type plane; point (0 0 0); normal (0 0 1);"
            " material board; motion { type translate; velocity (0 0 0.5); } }"
        ),
        Foam::Zero, none, liquid
    );
    scalar l = r;
    while (l > 0.1*r)
    {
        c.run(1e-5);
        l = c.state().x[0].z() - v0*c.time() - r;
    }
    figureNear
    (
        "film_movingWall", c.state().v[0].z(),
        beta/mass*narrowed(1.5*r, l, r), 0.01, "m/s",
        "closed form, a plane that comes at a ball"
    );
}


TEST(demFilm, comesIn)
{
    // Between two advances: thrown at the floor, and at another ball
    const auto film = [](const bool there)
    {
        Foam::dictionary none;
        Foam::dem::demInput input(none);
        if (there)
        {
            liquid(input);
        }
        return input.film;
    };
    const std::string bodies
    (
        body("a", "ball", {0, 0, 2.5*r}, {0, 0, -0.5})
      + body("b", "large", {20*r, 0, 20*r}, {0, 0, 0})
      + body("c", "ball", {20*r, 0, 25.5*r}, {0, 0, -0.5})
    );
    demCase always(balls(bodies, plane), Foam::Zero, none, liquid);
    demCase later(balls(bodies, plane));
    const auto advance = [&](const label n)
    {
        for (label k = 0; k < n; ++k)
        {
            always.run(1e-5);
            later.run(1e-5);
        }
    };
    const auto apart = [&]()
    {
        scalar most = 0;
        for (label b = 0; b < 3; ++b)
        {
            most = std::max
            (
                most, mag(always.state().v[b] - later.state().v[b])/0.5
            );
        }
        return most;
    };
    advance(50);
    later.solver().setFilm(film(true));
    advance(250);
    figure
    (
        "film_comesIn", apart(), 0, 1e-14, "of the velocity",
        "as one that was there from the start"
    );
    figure
    (
        "film_acts", 1 + always.state().v[0].z()/0.5, 0.1, 1, "-",
        "of its velocity, which the film took"
    );

    const vector v = later.state().v[0];
    const scalar l = later.state().x[0].z() - r;
    later.solver().setFilm(film(false));
    later.run(0.5*l/mag(v));
    figure
    (
        "film_goesOff", mag(later.state().v[0] - v)/mag(v), 0, 0, "-",
        "no force in a gap that had a film"
    );
}


TEST(demFilm, contactsStay)
{
    // A ball slides on the floor and pushes another; a film that is too thin
    // to act, which comes in and goes off, must not be seen
    const std::string dict
    (
        "demSolver hades;\n"
        "materials\n{\n    rock { density 2000; youngsModulus 1e7;"
        " poissonsRatio 0.3; }\n"
        "    board { youngsModulus 1e7; poissonsRatio 0.3; }\n}\n"
        "pairs { rock-rock { restitution 0.5; friction 0.4; }"
        " rock-board { restitution 0.5; friction 0.4; } }\n"
        "shapes { ball { type sphere; diameter 0.002; } }\n"
        "stepControl { type hades; }\n"
        "walls { " + plane + " }\nbodies\n{\n"
      + body("a", "ball", {0, 0, r}, {0.02, 0, 0})
      + body("b", "ball", {2*r, 0, r}, {0, 0, 0}) + "}\n"
    );
    demCase plain(dict, gravity), changed(dict, gravity);
    Foam::dem::squeezedFilm film;
    film.viscosity = mu;
    film.roughness = 1e-12;
    film.range = 1e-9;
    scalar slip = 0;
    for (label n = 0; n < 60; ++n)
    {
        if (n % 10 == 5)
        {
            changed.solver().setFilm
            (
                n % 20 == 5 ? film : Foam::dem::squeezedFilm()
            );
        }
        plain.run(1e-4);
        changed.run(1e-4);
        const Foam::dem::contactHistory h(changed.solver().history());
        for (const Foam::dem::wallTouch& t : h.walls)
        {
            slip = std::max(slip, mag(t.xi));
        }
    }
    scalar most = 0;
    for (label b = 0; b < 2; ++b)
    {
        most = std::max
        (
            most, mag(plain.state().x[b] - changed.state().x[b])
        );
    }
    figure
    (
        "film_contactsStay", most, 0, 0, "m",
        "contacts remember what they did"
    );
    figure
    (
        "film_contactsSlip", slip, 1e-12, 1, "m",
        "elastic slip, which they remember"
    );
}


TEST(demFilm, told)
{
    // A ball falls on the floor and bounces; the film's part of what it gets
    // is known apart, step by step
    demCase c
    (
        balls(body("a", "ball", {0, 0, 2.5*r}, {0, 0, -2}), plane),
        gravity, none, liquid
    );
    c.solver().tellFilms();
    const scalar beta = 6*M_PI*mu*r*r, v0 = 2, dt = 1e-5;
    const scalar roughness = 1e-5;
    vector film = Foam::Zero, contact = Foam::Zero, whole = Foam::Zero;
    scalar ofFilm = 0, ofContact = 0, l = 1.5*r;
    for (label n = 0; n < 1000 && c.state().v[0].z() < 0; ++n)
    {
        const vector before = mass*c.state().v[0];
        const scalar l0 = l;
        c.run(dt);
        l = c.state().x[0].z() - r;
        const vector J = c.solver().filmImpulse(0).first();
        const vector other =
            mass*c.state().v[0] - before - J - mass*dt*gravity;
        film += J;
        contact += other;
        whole += J + other;
        if (l0 > 0 && l > 0)
        {
            // In the film all but the weight is its
            ofFilm = std::max(ofFilm, mag(other)/(mass*v0));
        }
        else if (l0 < 0 && l < 0)
        {
            ofContact = std::max(ofContact, mag(J)/(mass*v0));
        }
    }
    figure
    (
        "filmTold_film", ofFilm, 0, 1e-13, "of the momentum",
        "nothing else acts before they touch"
    );
    figure
    (
        "filmTold_contact", ofContact, 0, 0, "of the momentum",
        "no film while they touch"
    );
    figureNear
    (
        "filmTold_impulse", film.z(), beta*narrowed(1.5*r, roughness, r), 0.01,
        "N s", "closed form, from its reach to the roughness"
    );
    figure
    (
        "filmTold_bounces", contact.z()/whole.z(), 0.1, 0.9, "-",
        "part of the impulse that is the contact's"
    );
}


TEST(demFilm, toldClump)
{
    // A rod turns as it comes down askew: the films' torque is all there is
    std::string dict
    (
        balls
        (
            "    a { shape rod; material rock; position (0 0 0.003);"
            " velocity (0 0 -2); }\n"
          + body("b", "ball", {0, 0.0021, 0.003}, {0, -0.02, 0}),
            plane
        )
    );
    const std::string shape("shapes { ball");
    dict.replace
    (
        dict.find(shape), shape.size(),
        "shapes { rod { type multisphere; spheres (((-0.0009 0 -0.0004) 0.001)"
        " ((0.0009 0 0.0004) 0.001)); } ball"
    );
    demCase c(dict, Foam::Zero, none, liquid);
    c.solver().tellFilms();
    vector J = Foam::Zero, JL = Foam::Zero, JBall = Foam::Zero;
    const vector v0 = c.state().v[0], vBall = c.state().v[1];
    scalar apart = 1;
    for (label n = 0; n < 1000 && apart > 2e-5; ++n)
    {
        c.run(1e-5);
        J += c.solver().filmImpulse(0).first();
        JL += c.solver().filmImpulse(0).second();
        JBall += c.solver().filmImpulse(1).first();
        for (label s = 0; s < 2; ++s)
        {
            apart = std::min(apart, c.state().sphereX()[s].z() - r);
        }
    }
    const scalar m = c.state().mass[0];
    figure
    (
        "filmTold_clump", mag(m*(c.state().v[0] - v0) - J)/mag(J), 0, 1e-12,
        "-", "change of a rod's momentum"
    );
    figure
    (
        "filmTold_torque", mag(c.state().L(0) - JL)/mag(JL), 0, 1e-12, "-",
        "change of its angular momentum"
    );
    figure
    (
        "filmTold_turns", mag(c.state().omega[0]), 10, 1000, "rad/s",
        "it turns"
    );
    figure
    (
        "filmTold_pair",
        mag(c.state().mass[1]*(c.state().v[1] - vBall) - JBall)/mag(JBall),
        0, 1e-10, "-", "a ball beside it"
    );
}



// ************************************************************************* //
