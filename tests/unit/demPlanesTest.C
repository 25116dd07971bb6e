/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    Contacts with planes at rest: which spheres have them, that what they
    remember comes back to the list of all walls, and that they move bodies as
    that list does.

\*---------------------------------------------------------------------------*/

#include "demCase.H"

#include "figure.H"
#include "planeWall.H"

#include <algorithm>

using namespace styxTest;
using namespace Foam::dem;
using Foam::mag;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Twelve balls that fall, slide and spin in a box of five planes, on to each
//  other, with what is added to each plane. A wall that may open is none of
//  the planes at rest, though it is the same wall while it is closed
std::string box(const std::string& added, const bool sides)
{
    const auto plane = [&](const char* name, const char* p, const char* n)
    {
        return
            std::string(name) + " { type plane; material s; point (" + p
          + "); normal (" + n + "); " + added + " }\n";
    };
    std::string walls = plane("floor", "0 0 0", "0 0 1");
    if (sides)
    {
        walls +=
            plane("x0", "0 0 0", "1 0 0") + plane("x1", "0.05 0 0", "-1 0 0")
          + plane("y0", "0 0 0", "0 1 0") + plane("y1", "0 0.05 0", "0 -1 0");
    }

    std::string bodies;
    for (int k = 0; k < 12; ++k)
    {
        bodies += "b" + std::to_string(k)
          + " { shape ball; material s; position "
          + text(vector(0.0065 + 0.012*(k % 4), 0.0065 + 0.0125*(k/4), 0.006))
          + "; velocity "
          + text(vector(0.3 - 0.1*(k % 5), 0.2 - 0.1*(k % 3), -0.5))
          + "; angularVelocity "
          + text(vector(10*(k % 2), 5 - k, 3)) + "; }\n";
    }
    return
        "demSolver hades;\n"
        "materials { s { density 2500; youngsModulus 5e6;"
        " poissonsRatio 0.25; } }\n"
        "pairs { s-s { restitution 0.5; friction 0.4; } }\n"
        "shapes { ball { type sphere; diameter 0.01; } }\n"
        "walls {\n" + walls + "}\n"
        "stepControl { type contact; }\n"
        "bodies {\n" + bodies + "}\n";
}


//- Largest distance of a ball's places with planes at rest from those in the
//  list of all walls, after t [m]; the contacts with walls must be as many
scalar distance(const bool sides, const scalar t)
{
    demCase atRest(box("", sides), gravity);
    demCase listed(box("open 1000;", sides), gravity);
    atRest.run(t);
    listed.run(t);
    EXPECT_EQ(atRest.nSteps, listed.nSteps);
    EXPECT_EQ
    (
        atRest.solver().history().walls.size(),
        listed.solver().history().walls.size()
    );
    EXPECT_GT(atRest.solver().history().walls.size(), 0);

    scalar most = 0;
    forAll(atRest.state().x, b)
    {
        most = std::max
        (
            most,
            mag(atRest.state().x[b] - listed.state().x[b])
        );
    }
    return most;
}


//- Walls and one sphere of radius 1
class oneBall
{
    Foam::PtrList<shape> shapes_;

    bodies state_;

public:

    wallSet walls;

    oneBall()
    :
        shapes_(1),
        state_(shapes_)
    {
        shapes_.set(0, new shape(shape::sphere("ball", 2)));
        newBody n;
        n.shapeI = 0;
        n.materialI = 0;
        n.density = 1;
        n.position = Foam::Zero;
        state_.append(n);
        walls.activatePlanes(8, true);
    }

    void add(const point& p, const vector& n)
    {
        walls.append(Foam::autoPtr<wall>(new planeWall("w", 0, p, n)));
    }

    //- How many of the elements near it at x are planes at rest
    label nPlanes(const point& x)
    {
        state_.x[0] = x;
        state_.update();
        const packedBodies packed(state_);
        walls.build(packed, {0.05f}, 0.05);
        walls.narrow(packed, {0.02f});
        walls.findTouches(packed);
        return walls.planes().size();
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(demPlanes, whichSpheres)
{
    oneBall b;
    b.add(point(0, 0, 0), vector(0, 0, 1));
    b.add(point(0, 0, 0), vector(1, 0, 0));
    EXPECT_EQ(b.nPlanes(point(5, 0, 5)), 0);
    EXPECT_EQ(b.nPlanes(point(5, 0, 0.99)), 1);
    EXPECT_EQ(b.nPlanes(point(0.98, 0, 0.99)), 2);
    EXPECT_EQ(b.walls.trial().size(), 0);

    // A second floor in the first is the same face, which is touched once
    b.add(point(0, 0, 0), vector(0, 0, 1));
    EXPECT_EQ(b.nPlanes(point(5, 0, 0.99)), 0);
    EXPECT_EQ(b.walls.trial().size(), 1);
}


TEST(demPlanes, memoryComesBack)
{
    // What a contact of the list remembers goes to the planes and back
    oneBall b;
    b.add(point(0, 0, 0), vector(0, 0, 1));
    wallTouch t = {};
    t.n = vector(0, 0, 1);
    t.xi = vector(1e-3, 2e-3, 0);
    t.rate[0] = 7;
    b.walls.setTouches
    (
        Foam::List<wallTouch>(1, t),
        Foam::List<wallRolled>(),
        Foam::List<wallTouch>()
    );
    ASSERT_EQ(b.nPlanes(point(0, 0, 0.99)), 1);
    b.walls.accept();
    const touchList all(b.walls.together());
    ASSERT_EQ(all.accepted.size(), 1);
    EXPECT_EQ(all.accepted[0].xi, t.xi);
    EXPECT_EQ(all.accepted[0].rate[0], t.rate[0]);
    EXPECT_NEAR(all.accepted[0].overlap, 0.01, 1e-12);
}


TEST(demPlanes, asInTheList)
{
    // On a floor to the last digit; in corners the forces of two walls are
    // added in another order
    figure("planes_floor", distance(false, 0.1), 0, 0, "m", "list of walls");
    figure("planes_box", distance(true, 0.1), 0, 1e-9, "m", "list of walls");
}


// ************************************************************************* //
