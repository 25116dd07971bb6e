/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description

Description
    Walls of triangles: seams are not felt, edges and vertices are touched
    once, a concave corner twice, and the slip goes from one triangle to the
    next.

\*---------------------------------------------------------------------------*/

#include "demCase.H"

#include "figure.H"
#include "planeWall.H"

#include <algorithm>
#include <cmath>
#include <random>

using namespace styxTest;
using namespace Foam::dem;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

typedef Foam::List<corners> triangles;


corners triangle(const point& a, const point& b, const point& c)
{
    corners t;
    t[0] = a;
    t[1] = b;
    t[2] = c;
    return t;
}


//- The square z = 0, |x|, |y| < 0.1 in n x n cells of two triangles, with
//  corners off the grid and the diagonals as they come
triangles tiles(const label n)
{
    std::mt19937 random(11);
    const auto uniform = [&]() { return random()/2147483648.0 - 1; };

    std::vector<point> p;
    for (label j = 0; j <= n; ++j)
    {
        for (label i = 0; i <= n; ++i)
        {
            const bool inside = i && j && i < n && j < n;
            const scalar shift = inside ? 0.06/n : 0;
            p.push_back
            (
                point
                (
                    0.2*i/n - 0.1 + shift*uniform(),
                    0.2*j/n - 0.1 + shift*uniform(),
                    0
                )
            );
        }
    }

    triangles list(2*n*n);
    for (label c = 0; c < n*n; ++c)
    {
        const label a = c/n*(n + 1) + c % n;
        const label b = a + 1;
        const label d = a + n + 1;
        const label e = d + 1;
        const bool turned = uniform() > 0;
        list[2*c] =
            turned ? triangle(p[a], p[b], p[e]) : triangle(p[a], p[b], p[d]);
        list[2*c + 1] =
            turned ? triangle(p[a], p[e], p[d]) : triangle(p[b], p[e], p[d]);
    }
    return list;
}


//- A ball of 1 cm over a floor, a plane or triangles
std::string ball(const bool plane, const std::string& start)
{
    return
        std::string("demSolver hades;\n")
      + "materials { stuff { density 2500; youngsModulus 1e7;"
        " poissonsRatio 0.3; } }\n"
        "pairs { stuff-stuff { restitution 0.5; friction 0.3; } }\n"
        "shapes { ball { type sphere; diameter 0.01; } }\n"
        "walls { floor { material stuff; "
      + (
            plane
          ? "type plane; point (0 0 0); normal (0 0 1);"
          : "type patch;"
        )
      + " } }\n"
        "stepControl { type fixed; deltaT 2e-5; }\n"
        "bodies { it { shape ball; material stuff; " + start + " } }\n";
}


//- Walls and one sphere of radius 1 that touches them or not
class touched
{
    Foam::PtrList<shape> shapes_;

    bodies state_;

    wallSet walls_;

public:

    explicit touched(const triangles& t)
    :
        shapes_(1),
        state_(shapes_)
    {
        shapes_.set(0, new shape(shape::sphere("ball", 2)));
        walls_.append
        (
            Foam::autoPtr<wall>(new triangleWall("w", 0, t))
        );
        newBody n;
        n.shapeI = 0;
        n.materialI = 0;
        n.density = 1;
        n.position = Foam::Zero;
        state_.append(n);
    }

    //- The contacts of the sphere at x
    const Foam::UList<wallTouch>& at(const point& x)
    {
        state_.x[0] = x;
        state_.update();
        const packedBodies packed(state_);
        const std::vector<float> may(packed.nSpheres(), 0.05f);
        walls_.build(packed, may, 0.05);
        walls_.findTouches(packed);
        return walls_.trial();
    }

    //- The same if the walls near it were sorted out where it was before
    const Foam::UList<wallTouch>& from(const point& before, const point& x)
    {
        at(before);
        walls_.narrow(packedBodies(state_), {0.02f});
        state_.x[0] = x;
        state_.update();
        walls_.findTouches(packedBodies(state_));
        return walls_.trial();
    }

    wallSet& walls()
    {
        return walls_;
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(demWalls, seams)
{
    // Figures "wallSeams_sliding", "wallSeams_rolling", "wallSeams_rest".
    // Sliding over 5 seams, rolling over 20 of them, at rest over a corner.
    // The sliding ends before it turns into rolling, a moment that round-off
    // may shift by a step.
    struct motion
    {
        std::string name;
        std::string start;
        scalar time;
    };
    const scalar weight = 2500*M_PI/6*1e-6*9.81;

    for
    (
        const motion& m :
        {
            motion
            {
                "sliding",
                "position (-0.08 -0.03 0.0049975); velocity (0.8 0.34 0);",
                0.08
            },
            motion
            {
                "rolling",
                "position (-0.08 -0.03 0.0049975); velocity (0.4 0.1 0);"
                " angularVelocity (-20 80 0);",
                0.25
            },
            motion{"rest", "position (0 0 0.0049975);", 0.2}
        }
    )
    {
        demCase plane(ball(true, m.start), gravity);
        demCase tiled(ball(false, m.start), gravity, tiles(37));

        scalar kick = 0;
        while (plane.time() < m.time)
        {
            plane.run(2e-5);
            tiled.run(2e-5);
            kick = std::max
            (
                kick,
                mag(plane.state().force[0] - tiled.state().force[0])
            );
            ASSERT_EQ(tiled.solver().report().nContacts, 1);
        }
        EXPECT_LT(mag(plane.state().x[0] - tiled.state().x[0]), 1e-11);
        figure
        (
            "wallSeams_" + m.name,
            kick/weight,
            0,
            1e-6,
            "weights",
            "the same on a plane"
        );
    }
}


TEST(demWalls, convexEdgeOnce)
{
    // A roof of two triangles a side; its ridge is the y axis
    const point a(0, -3, 0);
    const point b(0, 3, 0);
    triangles roof(4);
    roof[0] = triangle(a, b, point(2, 3, -2));
    roof[1] = triangle(a, point(2, 3, -2), point(2, -3, -2));
    roof[2] = triangle(a, b, point(-2, 3, -2));
    roof[3] = triangle(a, point(-2, 3, -2), point(-2, -3, -2));
    touched t(roof);

    std::mt19937 random(2);
    const auto uniform = [&]() { return random()/2147483648.0 - 1; };
    for (int n = 0; n < 1000; ++n)
    {
        // Above the ridge, anywhere in the wedge of its normals
        const scalar angle = 0.25*M_PI*uniform();
        const point foot(0, 2*uniform(), 0);
        const vector normal(std::sin(angle), 0, std::cos(angle));
        const auto& touches = t.at(foot + 0.97*normal);
        ASSERT_EQ(touches.size(), 1);
        EXPECT_NEAR(touches[0].overlap, 0.03, 1e-12);
        EXPECT_LT(mag(touches[0].n - normal), 1e-12);
        EXPECT_LT(mag(touches[0].p - foot), 1e-12);
    }

    // Beside it, on a face
    const auto& face = t.at(vector(1, 0, -1) + vector(1, 0, 1)*0.69);
    ASSERT_EQ(face.size(), 1);
    EXPECT_NEAR(face[0].overlap, 1 - 0.69*std::sqrt(2.0), 1e-12);
    EXPECT_EQ(t.at(vector(0, 0, 1.0001)).size(), 0);
}


TEST(demWalls, vertexOnce)
{
    // The top of a pyramid of seven faces
    const point top(0, 0, 0);
    triangles pyramid(7);
    for (label k = 0; k < 7; ++k)
    {
        const scalar a = 2*M_PI*k/7;
        const scalar b = 2*M_PI*((k + 1) % 7)/7;
        pyramid[k] = triangle
        (
            top,
            point(2*std::cos(a), 2*std::sin(a), -1),
            point(2*std::cos(b), 2*std::sin(b), -1)
        );
    }
    touched t(pyramid);
    const auto& touches = t.at(0.95*vector(0.02, -0.1, 1)/mag(
        vector(0.02, -0.1, 1)));
    ASSERT_EQ(touches.size(), 1);
    EXPECT_NEAR(touches[0].overlap, 0.05, 1e-12);
    EXPECT_LT(mag(touches[0].p), 1e-12);
}


// Walls that were sorted out for a short way are all there at its end
TEST(demWalls, narrowed)
{
    triangles fine(tiles(20));
    for (corners& c : fine)
    {
        for (point& p : c)
        {
            p *= 30;
        }
    }
    touched t(fine);
    std::mt19937 random(5);
    const auto uniform = [&]() { return random()/2147483648.0 - 1; };
    label differ = 0;
    label touching = 0;
    for (int n = 0; n < 1000; ++n)
    {
        const point x(uniform(), uniform(), 1 + 0.03*uniform());
        vector way(uniform(), uniform(), uniform());
        way *= 0.0199/mag(way);
        const Foam::List<wallTouch> expected(t.at(x + way));
        const Foam::List<wallTouch> found(t.from(x, x + way));
        touching += expected.size();
        differ +=
            found.size() != expected.size()
         || (found.size() && found[0].overlap != expected[0].overlap);
    }
    EXPECT_GT(touching, 300);
    EXPECT_LT(touching, 700);
    figure("walls_narrowed", differ, 0, 0, "contacts",
        "the same walls, all looked at");
}


TEST(demWalls, forceOfAnEdge)
{
    // A contact with an edge is one Hertz contact of the sphere's radius
    const scalar overlap = 5e-6;
    const vector w(0.1, 0, 0.2);
    triangles roof(2);
    roof[0] = triangle(point(0, -1, 0), point(0, 1, 0), w);
    roof[1] = triangle(point(0, -1, 0), point(0, 1, 0), vector(-0.1, 0, 0.2));

    // The roof upside down is a keel, under which the ball hangs
    demCase c
    (
        ball(false, "position (0 0 " + text(overlap - 0.005) + ");"),
        Foam::Zero,
        roof
    );
    c.run(1e-12);

    const scalar EStar = 1e7/(2*(1 - 0.3*0.3));
    figureNear
    (
        "wallEdgeForce",
        -c.state().force[0].z(),
        4.0/3.0*EStar*std::sqrt(0.005)*std::pow(overlap, 1.5),
        1e-6,
        "N",
        "one Hertz contact"
    );
}


TEST(demWalls, concaveCorner)
{
    // Floor and wall; then three walls that meet
    triangles floorAndWall(4);
    floorAndWall[0] =
        triangle(point(0, -5, 0), point(5, -5, 0), point(5, 5, 0));
    floorAndWall[1] =
        triangle(point(0, -5, 0), point(5, 5, 0), point(0, 5, 0));
    floorAndWall[2] =
        triangle(point(0, -5, 0), point(0, 5, 0), point(0, 5, 5));
    floorAndWall[3] =
        triangle(point(0, -5, 0), point(0, 5, 5), point(0, -5, 5));

    touched t(floorAndWall);
    const auto& touches = t.at(vector(0.98, 0, 0.99));
    ASSERT_EQ(touches.size(), 2);
    EXPECT_NEAR(touches[0].overlap, 0.02, 1e-12);
    EXPECT_NEAR(touches[1].overlap, 0.01, 1e-12);
    EXPECT_LT(mag(touches[0].n - vector(1, 0, 0)), 1e-12);
    EXPECT_LT(mag(touches[1].n - vector(0, 0, 1)), 1e-12);

    triangles three(floorAndWall);
    three.append
    (
        triangle(point(0, -0.5, 0), point(5, -0.5, 0), point(5, -0.5, 5))
    );
    three.append
    (
        triangle(point(0, -0.5, 0), point(5, -0.5, 5), point(0, -0.5, 5))
    );
    touched t3(three);
    EXPECT_EQ(t3.at(vector(0.98, 0.47, 0.99)).size(), 3);
}


TEST(demWalls, slipGoesAlong)
{
    // Each contact keeps its own slip, in the corner of a gutter too whose
    // sides rise by 30 degrees
    const scalar c = std::sqrt(0.75);
    const vector right(-0.5, 0, c);
    const vector left(0.5, 0, c);
    triangles gutter(2);
    gutter[0] = triangle(point(0, -9, 0), point(0, 9, 0), 9*vector(c, 0, 0.5));
    gutter[1] =
        triangle(point(0, -9, 0), point(0, 9, 0), 9*vector(-c, 0, 0.5));
    touched t(gutter);

    const point onRight = 3*vector(c, 0, 0.5) + 0.99*right;
    const point onLeft = 3*vector(-c, 0, 0.5) + 0.99*left;
    const point inCorner(0, 0, 0.99/c);

    // On the right side only: one contact, with a slip
    const vector slip(0, 1e-3, 0);
    ASSERT_EQ(t.at(onRight).size(), 1);
    t.walls().trial()[0].xi = slip;
    t.walls().accept();

    // Then in the corner: the contact with the left side is a new one
    const auto& both = t.at(inCorner);
    ASSERT_EQ(both.size(), 2);
    for (const wallTouch& touch : both)
    {
        const bool old = (touch.n & right) > 0.9;
        EXPECT_EQ(touch.xi, old ? slip : vector::zero);
    }

    // On the left side only: what is left of the old contact is not its own
    ASSERT_EQ(t.at(onLeft).size(), 1);
    EXPECT_EQ(t.walls().trial()[0].xi, vector::zero);

    // A trial that is not accepted changes nothing
    t.walls().trial()[0].xi = vector(7, 7, 7);
    ASSERT_EQ(t.at(onRight).size(), 1);
    EXPECT_EQ(t.walls().trial()[0].xi, slip);
}


TEST(demWalls, nearestPoint)
{
    // Against a search over the triangle
    std::mt19937 random(4);
    const auto uniform = [&]() { return random()/2147483648.0 - 1; };
    const auto any = [&]() { return point(uniform(), uniform(), uniform()); };

    for (int trial = 0; trial < 50; ++trial)
    {
        const corners t = triangle(any(), any(), any());
        const point c = 2*any();
        const scalar d = mag(c - triangleWall::nearestPoint(t, c));

        scalar best = Foam::GREAT;
        const int n = 200;
        for (int i = 0; i <= n; ++i)
        {
            for (int j = 0; j <= n - i; ++j)
            {
                const point p =
                    t[0] + (i*(t[1] - t[0]) + j*(t[2] - t[0]))/n;
                best = std::min(best, mag(c - p));
            }
        }
        EXPECT_LE(d, best + 1e-12);
        EXPECT_GE(d, best - 0.02);
    }
}


//- A corner of a finer face stands on the edge of a coarser one: a triangle
//  without an area, which is nowhere nearer than its longest edge
TEST(demWalls, sliver)
{
    std::mt19937 random(5);
    const auto uniform = [&]() { return random()/2147483648.0 - 1; };
    const auto any = [&]() { return point(uniform(), uniform(), uniform()); };

    scalar nearer = 0, off = 0;
    for (int trial = 0; trial < 20000; ++trial)
    {
        const point a = 4*any();
        vector edge = 0.01*any();
        const vector away = 0.02*any();
        if (trial % 2)
        {
            // Along an axis and halved, as meshes are, it has no normal at all
            edge = vector(0, 0.01, 0);
        }
        const scalar part = trial % 2 ? 0.5 : 0.5 + 0.5*uniform();
        point p[3] = {a, a + part*edge, a + edge};
        std::shuffle(p, p + 3, random);
        const point c = a + 0.5*edge + away;

        const corners t = triangle(p[0], p[1], p[2]);
        const point q = triangleWall::nearestPoint(t, c);
        const scalar along =
            std::min
            (
                std::max(((c - a) & edge)/magSqr(edge), scalar(0)),
                scalar(1)
            );
        nearer = std::max(nearer, mag(c - a - along*edge) - mag(c - q));
        off = std::max(off, mag((q - a) ^ edge)/mag(edge));
    }
    figure
    (
        "wallSliver_nearer", nearer, -noBar, 1e-12, "m",
        "how much nearer than its edge a sliver is taken for, at most"
    );
    figure
    (
        "wallSliver_off", off, -noBar, 1e-12, "m",
        "how far the nearest point is beside the edge, at most"
    );
}


TEST(demWalls, tree)
{
    // The tree finds what a look at each triangle finds
    const triangles all = tiles(30);
    const triangleWall w("w", 0, all);
    std::mt19937 random(9);
    const auto uniform = [&]() { return random()/2147483648.0 - 1; };

    for (int n = 0; n < 200; ++n)
    {
        const point c(0.12*uniform(), 0.12*uniform(), 0.02*uniform());
        const scalar reach = 0.015*(1.1 + uniform());
        Foam::DynamicList<label> elements;
        w.candidates(c, reach, elements);
        label exact = 0;
        for (const corners& t : all)
        {
            exact += mag(c - triangleWall::nearestPoint(t, c)) < reach;
        }
        EXPECT_EQ(elements.size(), exact);
    }
}


// ************************************************************************* //
