/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    The exact volume, centroid and inertia of unions of spheres.

\*---------------------------------------------------------------------------*/

#include "boundBox.H"
#include "figure.H"
#include "mathematicalConstants.H"
#include "quaternion.H"
#include "Random.H"
#include "shape.H"
#include "sphereUnion.H"

#include <chrono>
#include <cmath>

using namespace Foam;
using namespace Foam::dem;
using namespace styxTest;

using constant::mathematical::pi;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

massProperties unionOf(const List<point>& c, const List<scalar>& r)
{
    return sphereUnion(pointField(c), scalarField(r)).properties();
}


// By a regular lattice of n points along each edge of the bounding box
massProperties sampled
(
    const pointField& centres,
    const scalarField& radii,
    const label n
)
{
    boundBox box(centres, false);
    box = boundBox
    (
        box.min() - max(radii)*vector::one,
        box.max() + max(radii)*vector::one
    );
    const vector h(box.span()/n);
    const point middle(box.centre());

    label count = 0;
    vector first(Zero);
    symmTensor second(Zero);

    for (label cell = 0; cell < n*n*n; ++cell)
    {
        const vector at(cell % n + 0.5, (cell/n) % n + 0.5, cell/(n*n) + 0.5);
        const point p(box.min() + cmptMultiply(h, at));

        forAll(centres, i)
        {
            if (magSqr(p - centres[i]) < sqr(radii[i]))
            {
                ++count;
                first += p - middle;
                second += sqr(p - middle);
                break;
            }
        }
    }

    const scalar dV = h.x()*h.y()*h.z();
    return massProperties::fromMoments
    (
        count*dV,
        first*dV,
        second*dV,
        middle
    );
}


// A sphere, twice the same, one inside another, two that touch
scalar oddCasesError()
{
    const scalar one = 4*pi/3;
    const point o(0.1, -0.2, 0.3);
    const point far(o + vector(2, 0, 0));
    const point near(o + vector(0, 0.5, 0));

    scalar worst = 0;
    for
    (
        const scalar error :
        {
            unionOf({o}, {1}).volume/one - 1,
            unionOf({o, o}, {1, 1}).volume/one - 1,
            unionOf({near, o}, {0.5, 1}).volume/one - 1,
            unionOf({o, near, o}, {0.2, 0.3, 1}).volume/one - 1,
            unionOf({o, far}, {1, 1}).volume/(2*one) - 1,
            unionOf({o, o + vector(0, 0, 2)}, {1, 1}).volume/(2*one) - 1
        }
    )
    {
        worst = max(worst, mag(error));
    }
    return worst;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(sphereUnion, twoSpheres)
{
    // Two spheres less their common lens; any direction of the pair
    const scalar R = 1, r = 0.7, d = 1.1;
    const scalar lens =
        pi*sqr(R + r - d)*(d*d + 2*d*r - 3*r*r + 2*d*R + 6*r*R - 3*R*R)/(12*d);
    const scalar expected = 4*pi/3*(pow3(R) + pow3(r)) - lens;

    scalar worst = 0;
    for
    (
        const vector& way :
        {vector(0, 0, 1), vector(1, 0, 0), vector(1, 2, 3)}
    )
    {
        const point o(3, -4, 5);
        const massProperties body
        (
            unionOf({o, point(o + d*way/mag(way))}, {R, r})
        );
        worst = max(worst, mag(body.volume/expected - 1));
    }

    figure("unionOfTwo", worst, 0, 1e-7, "-", "closed form of the lens");
}


TEST(sphereUnion, oddCases)
{
    figure("unionOddCases", oddCasesError(), 0, 1e-7, "-", "sum of spheres");
}


TEST(sphereUnion, turningMakesNoDifference)
{
    Random random(7);
    pointField c(50);
    scalarField r(50);
    forAll(c, i)
    {
        c[i] = random.sample01<vector>();
        r[i] = 0.1 + 0.2*random.sample01<scalar>();
    }

    const auto start = std::chrono::steady_clock::now();
    const massProperties a(sphereUnion(c, r).properties());
    const std::chrono::duration<double> time =
        std::chrono::steady_clock::now() - start;

    const tensor T(quaternion(vector(1, 2, 3)/std::sqrt(14.0), 1.2).R());
    const massProperties b(sphereUnion(pointField(T & c), r).properties());

    figure
    (
        "unionTurned",
        mag(symm(T & a.inertia & T.T()) - b.inertia)/mag(b.inertia),
        0,
        1e-6,
        "-",
        "50 spheres, inertia turned with the frame"
    );
    figure("unionTime", time.count(), 0, 1, "s", "50 spheres, design");
}


TEST(sphereUnion, thesisClump)
{
    // Nine spheres for a cube of edge 12 mm, thesis 8.1
    pointField c(9, point(Zero));
    scalarField r(9, 0.00365);
    r[0] = 0.0065;
    for (label k = 0; k < 8; ++k)
    {
        c[k + 1] =
            0.0032*vector(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
    }

    List<shape::sphereData> spheres(9);
    forAll(c, i)
    {
        spheres[i] = shape::sphereData(c[i], r[i]);
    }
    const shape clump("clump", spheres);
    const massProperties reference(sampled(c, r, 300));

    figureNear
    (
        "clumpVolume",
        clump.unionVolume(),
        reference.volume,
        0.002,
        "m3",
        "2.7e7 sample points"
    );
    figureNear
    (
        "clumpInertia",
        clump.inertiaPerDensity().x(),
        reference.inertia.xx(),
        0.002,
        "m5",
        "2.7e7 sample points"
    );
    figure
    (
        "clumpSymmetry",
        cmptMax(clump.inertiaPerDensity())/cmptMin(clump.inertiaPerDensity())
      - 1,
        -1e-9,
        1e-9,
        "-",
        "equal moments of a cube"
    );
    figure
    (
        "clumpAxes",
        mag(clump.toUser() - tensor::I),
        0,
        1e-12,
        "-",
        "a cube keeps the user's axes"
    );
}


// ************************************************************************* //
