/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    Walls that are rectangles, boxes, cylinders and surfaces from files: where
    they are touched, seams and edges, and input that is refused.

\*---------------------------------------------------------------------------*/

#include "demCase.H"

#include "planeWall.H"

#include "Fstream.H"
#include "OSspecific.H"

#include <cmath>
#include <ctime>
#include <random>

using namespace styxTest;
using namespace Foam::dem;
using Foam::mag;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Uniform in [-1, 1)
class dice
{
    std::mt19937 random_;

public:

    explicit dice(const unsigned seed)
    :
        random_(seed)
    {}

    scalar operator()()
    {
        return random_()/2147483648.0 - 1;
    }

    vector direction()
    {
        const vector v((*this)(), (*this)(), (*this)());
        return v/mag(v);
    }
};


//- A wall from its entries
Foam::autoPtr<wall> make(const std::string& entries)
{
    return wall::New("w", 0, dictionaryOf(entries), ".");
}


//- Nearest of the elements near c: distance, point and normal
scalar touch(const wall& w, const point& c, point& p, vector& n)
{
    Foam::DynamicList<label> elements;
    w.candidates(c, 100, elements);
    scalar best = Foam::GREAT;
    for (const label e : elements)
    {
        point q;
        vector m;
        const scalar d = w.nearest(c, e, q, m);
        if (d < best)
        {
            best = d;
            p = q;
            n = m;
        }
    }
    return best;
}


//- The point found must be at that distance in the direction of the normal,
//  and none of those given may be nearer
void expectNearest
(
    const wall& w,
    const point& c,
    const std::vector<point>& surface
)
{
    point p;
    vector n;
    const scalar d = touch(w, c, p, n);
    EXPECT_NEAR(mag(n), 1, 1e-12);
    EXPECT_LT(mag(p + d*n - c), 1e-12);
    for (const point& q : surface)
    {
        EXPECT_GE(mag(q - c), mag(d) - 1e-12);
    }
}


//- A ball of 1 cm and a wall
std::string ball
(
    const std::string& wall,
    const std::string& start,
    const std::string& more,
    const scalar youngsModulus = 1e9
)
{
    return
        "demSolver hades;\n"
        "materials { stuff { density 2500; youngsModulus "
      + text(youngsModulus) + "; poissonsRatio 0.3; } }\n"
        "shapes { ball { type sphere; diameter 0.01; } }\n"
        "walls { w { material stuff; " + wall + " } }\n"
        "bodies { it { shape ball; material stuff; " + start + " } }\n"
      + more;
}


//- The message of a wall that is refused must hold all of these
void refused(const std::string& wall, const std::vector<std::string>& words)
{
    const std::string bad
    (
        ball
        (
            wall,
            "position (0 0 9);",
            "pairs { stuff-stuff { restitution 0.5; friction 0.3; } }\n"
            "stepControl { type fixed; deltaT 1e-5; }\n"
        )
    );
    const std::string said = messageOf([&]() { demCase c(bad); });
    EXPECT_NE(said, "") << wall << ": no error";
    EXPECT_NE(said.find("at line 4."), std::string::npos) << said;
    for (const std::string& word : words)
    {
        EXPECT_NE(said.find(word), std::string::npos)
            << '"' << word << "\" is not in: " << said;
    }
}


//- Folder for files of this test
Foam::fileName folder()
{
    const Foam::fileName dir("demWallTypes/triSurface");
    Foam::mkDir(dir);
    return dir;
}


//- Write triangles as an STL file
void writeSTL(const Foam::fileName& file, const Foam::List<corners>& triangles)
{
    Foam::OFstream os(file);
    os << "solid s" << Foam::nl;
    for (const corners& t : triangles)
    {
        os << "facet normal 0 0 0" << Foam::nl << "outer loop" << Foam::nl;
        for (const point& p : t)
        {
            os << "vertex " << text(p.x()).c_str() << ' '
                << text(p.y()).c_str() << ' ' << text(p.z()).c_str()
                << Foam::nl;
        }
        os << "endloop" << Foam::nl << "endfacet" << Foam::nl;
    }
    os << "endsolid s" << Foam::nl;
}


//- Write triangles as an OBJ file, which has all digits
void writeOBJ(const Foam::fileName& file, const Foam::List<corners>& triangles)
{
    Foam::OFstream os(file);
    forAll(triangles, t)
    {
        for (const point& p : triangles[t])
        {
            os << "v " << text(p.x()).c_str() << ' ' << text(p.y()).c_str()
                << ' ' << text(p.z()).c_str() << Foam::nl;
        }
        os << "f " << 3*t + 1 << ' ' << 3*t + 2 << ' ' << 3*t + 3 << Foam::nl;
    }
}


//- n x n squares of two triangles over the square z = 0, |x|, |y| < a
Foam::List<corners> squares(const label n, const scalar a)
{
    Foam::List<corners> t(2*n*n);
    const scalar h = 2*a/n;
    forAll(t, k)
    {
        const scalar x = h*(k/2 % n) - a;
        const scalar y = h*(k/2/n) - a;
        t[k][0] = point(x, y, 0);
        t[k][1] = k % 2 ? point(x + h, y + h, 0) : point(x + h, y, 0);
        t[k][2] = k % 2 ? point(x, y + h, 0) : point(x + h, y + h, 0);
    }
    return t;
}


//- The cosine of the angle at which a ball leaves the edge of a table
scalar leavesEdge
(
    const std::string& wall,
    const scalar friction,
    const scalar startCosine,
    const Foam::List<corners>& triangles = Foam::List<corners>()
)
{
    // Its weight is on the edge already. Soft ones leave later
    const scalar r = 0.005;
    const scalar E = 1e11;
    const scalar EStar = E/(2*(1 - 0.3*0.3));
    const scalar weight = 2500*M_PI/6*1e-6*9.81;
    const scalar overlap = std::pow
    (
        0.75*weight*startCosine/(EStar*std::sqrt(r)),
        2.0/3.0
    );
    const vector n(std::sqrt(1 - startCosine*startCosine), 0, startCosine);

    demCase c
    (
        ball
        (
            wall,
            "position " + text((r - overlap)*n) + ";",
            "pairs { stuff-stuff { restitution 0.5; friction "
          + text(friction) + "; } }\n"
            "stepControl { type fixed; deltaT 5e-7; }\n",
            E
        ),
        gravity,
        triangles
    );
    scalar cosine = 1;
    while (c.time() < 0.3)
    {
        c.run(1e-5);
        if (!c.solver().report().nContacts)
        {
            return cosine;
        }
        const point& x = c.state().x[0];
        cosine = x.z()/mag(x);
    }
    return 2;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(demWallTypes, rectangle)
{
    const auto w = make
    (
        "type rectangle; corner (0.1 0 0); edge1 (0 2 0); edge2 (0 0 -3);"
    );
    std::vector<point> surface;
    for (label k = 0; k < 400; ++k)
    {
        surface.push_back(point(0.1, 2*(k % 20)/19.0, -3*(k/20)/19.0));
    }
    dice u(3);
    for (label k = 0; k < 200; ++k)
    {
        expectNearest(*w, vector(0.5*u(), 1 + 2*u(), -1.5 + 3*u()), surface);
    }

    // Face, edge, corner, the other side
    point p;
    vector n;
    EXPECT_NEAR(touch(*w, point(0.3, 1, -1), p, n), 0.2, 1e-14);
    EXPECT_LT(mag(n - vector(1, 0, 0)), 1e-14);
    EXPECT_NEAR(touch(*w, point(0.1, 1, 0.2), p, n), 0.2, 1e-14);
    EXPECT_LT(mag(n - vector(0, 0, 1)), 1e-14);
    EXPECT_NEAR(touch(*w, point(0.2, 2.2, 0.2), p, n), 0.3, 1e-14);
    EXPECT_LT(mag(p - point(0.1, 2, 0)), 1e-14);
    EXPECT_NEAR(touch(*w, point(-0.3, 1, -1), p, n), 0.4, 1e-14);
    EXPECT_LT(mag(n - vector(-1, 0, 0)), 1e-14);
}


TEST(demWallTypes, box)
{
    const auto solid =
        make("type box; min (0 0 0); max (1 2 3); side outside;");
    std::vector<point> surface;
    for (label k = 0; k < 1331; ++k)
    {
        const label i = k % 11, j = k/11 % 11, l = k/121;
        if (i % 10 == 0 || j % 10 == 0 || l % 10 == 0)
        {
            surface.push_back(point(0.1*i, 0.2*j, 0.3*l));
        }
    }
    dice u(5);
    for (label k = 0; k < 500; ++k)
    {
        const point c(0.5 + u(), 1 + 2*u(), 1.5 + 3*u());
        expectNearest(*solid, c, surface);
        Foam::DynamicList<label> elements;
        solid->candidates(c, 100, elements);
        EXPECT_EQ(elements.size(), 1);
    }

    // Within it is pushed out
    point p;
    vector n;
    EXPECT_NEAR(touch(*solid, point(0.9, 1, 1), p, n), -0.1, 1e-14);
    EXPECT_LT(mag(n - vector(1, 0, 0)), 1e-14);

    // Inside: a face each, and pushed back from behind
    const auto tank = make("type box; min (0 0 0); max (1 2 3); side inside;");
    Foam::DynamicList<label> elements;
    tank->candidates(point(0.05, 1.97, 0.06), 0.1, elements);
    EXPECT_EQ(elements.size(), 3);
    EXPECT_NEAR(touch(*tank, point(0.5, -0.1, 1), p, n), -0.1, 1e-14);
    EXPECT_LT(mag(n - vector(0, 1, 0)), 1e-14);
    for (label k = 0; k < 100; ++k)
    {
        const point c(0.5 + 0.5*u(), 1 + u(), 1.5 + 1.5*u());
        expectNearest(*tank, c, surface);
    }
}


TEST(demWallTypes, cylinder)
{
    const std::string start
    (
        "type cylinder; point (1 0 0); axis (0 2 0); radius 0.5; "
    );
    const vector y(0, 1, 0);
    std::vector<point> side, ends;
    for (label k = 0; k < 3600; ++k)
    {
        const scalar a = 2*M_PI*(k % 60)/60;
        const vector out(std::cos(a), 0, std::sin(a));
        side.push_back(point(1, 0, 0) + 0.5*out + (k/60)/59.0*2*y);
        ends.push_back(point(1, 0, 0) + 0.5*(k/120)/29.0*out + k % 2*2*y);
    }
    std::vector<point> all(side);
    all.insert(all.end(), ends.begin(), ends.end());

    const auto rod = make(start + "length 2; side outside;");
    const auto tube = make(start + "length 2; ends open;");
    const auto can = make(start + "length 2; side inside;");
    const auto drum = make(start + "side inside;");
    const auto pole = make(start + "side outside;");
    dice u(8);
    point p;
    vector n;
    for (label k = 0; k < 300; ++k)
    {
        const point c(1 + u(), 1 + 2*u(), u());
        const vector r(c.x() - 1, 0, c.z());
        expectNearest(*rod, c, all);
        expectNearest(*tube, c, side);
        EXPECT_NEAR(touch(*drum, c, p, n), 0.5 - mag(r), 1e-14);
        EXPECT_LT(mag(n + r/mag(r)), 1e-12);
        EXPECT_NEAR(touch(*pole, c, p, n), mag(r) - 0.5, 1e-14);
        EXPECT_LT(mag(n - r/mag(r)), 1e-12);
        if (mag(r) < 0.5 && c.y() > 0 && c.y() < 2)
        {
            expectNearest(*can, c, all);
            EXPECT_LT(touch(*rod, c, p, n), 0);
        }
        else
        {
            EXPECT_LE(touch(*can, c, p, n), 0);
            EXPECT_GE(touch(*rod, c, p, n), 0);
        }
    }

    // The rim, from outside; the corner of the can has two contacts
    EXPECT_NEAR(touch(*rod, point(1, 2.3, 0.9), p, n), 0.5, 1e-14);
    EXPECT_LT(mag(p - point(1, 2, 0.5)), 1e-14);
    Foam::DynamicList<label> elements;
    can->candidates(point(1, 1.95, 0.45), 0.1, elements);
    EXPECT_EQ(elements.size(), 2);

    // On the axis, and farthest points
    EXPECT_NEAR(touch(*drum, point(1, 7, 0), p, n), 0.5, 1e-14);
    EXPECT_NEAR(touch(*rod, point(1, 1, 0), p, n), -0.5, 1e-14);
    EXPECT_NEAR(drum->farthest(point(1, 3, 0), y), 0.5, 1e-12);
    EXPECT_GE(drum->farthest(point(1, 3, 0), vector(1, 0, 0)), Foam::GREAT);
    EXPECT_NEAR(rod->farthest(point(1, 0, 0), vector(1, 0, 0)), 2.5, 1e-12);
}


TEST(demWallTypes, seamsOfFile)
{
    // Figures "wallSeams_stl_sliding", "wallSeams_stl_rolling" on a floor;
    // "wallSeams_obj_sliding", "wallSeams_obj_rolling" down a slope of 15
    // degrees, whose digits do not fit into an STL file
    const scalar weight = 2500*M_PI/6*1e-6*9.81;
    const std::string more
    (
        "pairs { stuff-stuff { restitution 0.5; friction 0.3; } }\n"
        "stepControl { type fixed; deltaT 2e-6; }\n"
    );
    const auto inFolder =
        [](demInput& input) { input.directory = "demWallTypes"; };

    for (const std::string& kind : {"stl", "obj"})
    {
        const bool slope = kind == "obj";
        const scalar angle = slope ? M_PI/12 : 0;
        const vector x(std::cos(angle), 0, -std::sin(angle));
        const vector y(0, 1, 0);
        const vector n(std::sin(angle), 0, std::cos(angle));

        Foam::List<corners> floor(squares(40, 100));
        for (corners& t : floor)
        {
            for (point& p : t)
            {
                p = p.x()*x + p.y()*y;
            }
        }
        const Foam::fileName file(folder()/("floor." + kind));
        slope ? writeOBJ(file, floor) : writeSTL(file, floor);

        for (const bool rolls : {false, true})
        {
            // Over seams in x and in y
            const std::string start
            (
                "position " + text(-0.083*x - 0.031*y + 0.00499988*n) + "; "
              + (
                    rolls
                  ? "velocity " + text(0.4*x + 0.1*y)
                  + "; angularVelocity " + text(-20*x + 80*y) + ";"
                  : "velocity " + text(0.8*x + 0.34*y) + ";"
                )
            );
            demCase plane
            (
                ball
                (
                    "type plane; point (0 0 0); normal " + text(n) + ";",
                    start,
                    more
                ),
                gravity
            );
            demCase tiled
            (
                ball
                (
                    "type triSurface; file \"floor." + kind
                  + "\"; scale 0.001;",
                    start,
                    more
                ),
                gravity,
                Foam::List<corners>(),
                inFolder
            );
            scalar kick = 0;
            for (label k = 0; k < 3500; ++k)
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
            figure
            (
                "wallSeams_" + kind + (rolls ? "_rolling" : "_sliding"),
                kick/weight,
                0,
                1e-6,
                "weights",
                "the same on a plane"
            );
        }
    }
}


TEST(demWallTypes, offAnEdge)
{
    // A ball that starts at rest on an edge, 5 degrees off, leaves it where
    // its weight no longer gives the centripetal force: cos = 2/3 of that of
    // the start if it slides, 10/17 if it rolls
    const scalar start = std::cos(5*M_PI/180);
    const std::string table
    (
        "type rectangle; corner (0 -1 0); edge1 (-1 0 0); edge2 (0 2 0);"
    );
    figureNear
    (
        "wallEdge_slides",
        leavesEdge(table, 0, start),
        2*start/3,
        0.01,
        "cosine",
        "closed form 2/3"
    );
    figureNear
    (
        "wallEdge_rolls",
        leavesEdge(table, 5, start),
        10*start/17,
        0.01,
        "cosine",
        "closed form 10/17"
    );

    // The edge of a block of triangles, shared by two faces
    Foam::List<corners> block(4);
    const point a(0, -1, 0), b(0, 1, 0);
    block[0][0] = block[1][0] = block[2][0] = block[3][0] = a;
    block[0][1] = block[1][1] = point(-1, 1, 0);
    block[0][2] = block[2][1] = b;
    block[1][2] = point(-1, -1, 0);
    block[2][2] = block[3][1] = point(0, 1, -1);
    block[3][2] = point(0, -1, -1);
    figureNear
    (
        "wallEdge_triangles",
        leavesEdge("type patch;", 5, start, block),
        10*start/17,
        0.01,
        "cosine",
        "closed form 10/17"
    );
}


TEST(demWallTypes, manyTriangles)
{
    // Figure "wallTriangles": a search among 100 times as many triangles of
    // the same size per sphere takes no longer but for the depth of the tree
    const auto visits = [](const label n)
    {
        const triangleWall w("w", 0, squares(n, 0.01*n));
        dice u(1);
        label found = 0;
        for (label k = 0; k < 1000; ++k)
        {
            Foam::DynamicList<label> elements;
            w.candidates
            (
                0.008*n*vector(u(), u(), 0),
                0.02,
                elements
            );
            found += elements.size();
        }
        return found/1000.0;
    };
    figureNear
    (
        "wallTriangles",
        visits(300),
        visits(30),
        0.05,
        "triangles near a sphere",
        "a hundredth as many"
    );
}


TEST(demWallTypes, pairCostFull)
{
    // Figure "wallPairCost": a bed of 10,584 spheres of 2 mm that fills a box
    // of 42 mm and presses on its five walls, the best of 20 sweeps
    Foam::PtrList<shape> shapes(1);
    shapes.set(0, new shape(shape::sphere("ball", 0.002)));
    bodies state(shapes);
    dice u(6);
    for (label k = 0; k < 21*21*24; ++k)
    {
        newBody n;
        n.shapeI = 0;
        n.materialI = 0;
        n.density = 1;
        n.position =
            2e-3*vector(k % 21 + 0.5, k/21 % 21 + 0.5, k/441 + 0.5)
          + 1e-6*vector(u(), u(), u());
        state.append(n);
    }

    wallSet walls;
    for (const vector& n :
        {
            vector(1, 0, 0), vector(-1, 0, 0), vector(0, 1, 0),
            vector(0, -1, 0), vector(0, 0, 1)
        })
    {
        const scalar back = n.x() + n.y() < 0 ? 0.042 : 0;
        walls.append
        (
            Foam::autoPtr<wall>(new planeWall("w", 0, -back*n, n))
        );
    }
    const packedBodies packed(state);
    walls.build(packed, std::vector<float>(packed.nSpheres(), 1e-4f), 1e-4);
    const label nNear = 4*21*24 + 21*21;

    scalar best = Foam::GREAT;
    for (label k = 0; k < 20; ++k)
    {
        const std::clock_t start = std::clock();
        for (label step = 0; step < 200; ++step)
        {
            walls.findTouches(packed);
            walls.accept();
        }
        best = std::min
        (
            best,
            scalar(std::clock() - start)/CLOCKS_PER_SEC/200/nNear
        );
    }
    EXPECT_GT(walls.together().accepted.size(), nNear/3);
    figure("wallPairCost", 1e9*best, 0, 25, "ns", "own bar");
}


TEST(demWallTypes, refused)
{
    const std::string rect("type rectangle; corner (0 0 0); edge1 (1 0 0); ");
    refused("type rectangel;", {"rectangel", "cylinder", "triSurface"});
    refused(rect + "edge2 (2 0 0);", {"edge2", "parallel", "edge1"});
    refused(rect + "edge2 (1 1 0);", {"edge2", "right angle"});
    refused(rect + "edge2 (0 0 0);", {"edge2", "no length"});
    refused(rect + "edge2 (0 1 0); egde3 1;", {"egde3", "edge1", "motion"});
    refused("type plane; point (0 0 0); normal (0 0 0);", {"normal", "length"});
    refused("type box; min (0 0 0); max (1 1 0); side inside;",
        {"max", "greater than min"});
    refused("type box; min (0 0 0); max (1 1 1); side within;",
        {"within", "inside", "outside"});
    const std::string cyl("type cylinder; point (0 0 0); ");
    refused(cyl + "axis (0 0 1); radius -1; side inside;", {"radius", "-1"});
    refused(cyl + "axis (0 0 0); radius 1; side inside;", {"axis", "length"});
    refused(cyl + "axis (0 0 1); radius 1; side inside; ends open;",
        {"ends", "length"});
    refused(cyl + "axis (0 0 1); radius 1; length 0; side inside;",
        {"length", "0"});
    refused
    (
        cyl + "axis (0 0 1); radius 1; length 1; ends open; side inside;",
        {"side", "open ends"}
    );
    refused(cyl + "axis (0 0 1); radius 1;", {"side"});
    refused("type triSurface; file \"none.stl\";", {"none.stl", "missing"});
    refused("type triSurface; file \"a.stl\"; scale 0;", {"scale", "0"});
    refused("type triSurface; fiel \"a.stl\";", {"fiel", "file", "scale"});
}


TEST(demWallTypes, refusedFiles)
{
    const Foam::fileName dir(folder());
    const auto said = [](const std::string& name)
    {
        return messageOf
        (
            [&]()
            {
                wall::New
                (
                    "w",
                    0,
                    dictionaryOf("type triSurface; file \"" + name + "\";"),
                    "demWallTypes"
                );
            }
        );
    };
    writeSTL(dir/"good.stl", squares(2, 1));
    EXPECT_EQ(said("good.stl"), "");

    Foam::List<corners> flat(squares(2, 1));
    flat[3][2] = flat[3][1];
    writeSTL(dir/"flat.stl", flat);
    EXPECT_NE(said("flat.stl").find("degenerate"), std::string::npos);

    writeSTL(dir/"empty.stl", Foam::List<corners>());
    EXPECT_NE(said("empty.stl").find("empty.stl"), std::string::npos);

    Foam::OFstream(dir/"text.stl")() << "this is no surface" << Foam::endl;
    EXPECT_NE(said("text.stl").find("text.stl"), std::string::npos);

    Foam::OFstream(dir/"kind.xyz")() << "1 2 3" << Foam::endl;
    EXPECT_NE(said("kind.xyz").find("kind"), std::string::npos);
}


// ************************************************************************* //
