/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    Clusters of spheres made from surfaces: the error bars of issue 2.

\*---------------------------------------------------------------------------*/

#include "figure.H"
#include "mathematicalConstants.H"
#include "multisphereErrors.H"
#include "multisphereGenerator.H"
#include "StringStream.H"
#include "testSurfaces.H"

using namespace Foam;
using namespace Foam::dem;
using namespace styxTest;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// Offset error (7.11) of a box with a corner at the origin, counted on a
// regular lattice of more than 1e6 points: independent of the generator's own
scalar offsetByPoints
(
    const vector& edges,
    const pointField& centres,
    const scalarField& radii
)
{
    constexpr label n = 128;
    boundBox bounds(point::zero, edges);
    forAll(centres, i)
    {
        bounds.add(centres[i] - radii[i]*vector::one);
        bounds.add(centres[i] + radii[i]*vector::one);
    }
    const vector h(bounds.span()/n);
    const boundBox box(point::zero, edges);

    label wrong = 0;
    for (label cell = 0; cell < n*n*n; ++cell)
    {
        const vector at(cell % n + 0.5, (cell/n) % n + 0.5, cell/(n*n) + 0.5);
        const point p(bounds.min() + cmptMultiply(h, at));

        bool inSpheres = false;
        for (label i = 0; i < centres.size() && !inSpheres; ++i)
        {
            inSpheres = (magSqr(p - centres[i]) < sqr(radii[i]));
        }
        wrong += (inSpheres != box.contains(p));
    }

    return wrong*cmptProduct(h)/cmptProduct(edges);
}


struct sizeAndBar
{
    label spheres;
    scalar bar;
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(multisphere, boxOffset)
{
    // The bars at 9 and 20 lie on the way, geometrically in the number
    const sizeAndBar bars[] = {{5, 0.35}, {9, 0.28}, {20, 0.19}, {50, 0.12}};

    for (const vector& edges : {vector(1, 1, 1), vector(1, 0.75, 0.5)})
    {
        const std::string name(edges.z() < 1 ? "slabBy" : "boxBy");
        const closedSurface body("box", box(edges, 4));
        multisphereGenerator cluster(body, multisphereGenerator::controls());

        for (const sizeAndBar& b : bars)
        {
            cluster.generate(b.spheres);
            figure
            (
                name + std::to_string(b.spheres),
                offsetByPoints(edges, cluster.centres(), cluster.radii()),
                0,
                b.bar,
                "-",
                "err_off (7.11), 2.1e6 points, issue 2"
            );
        }
    }
}


TEST(multisphere, errorsAreMeasured)
{
    const vector edges(1, 0.75, 0.5);
    const closedSurface body("box", box(edges, 4));
    multisphereGenerator cluster(body, multisphereGenerator::controls());
    cluster.generate(20);
    const multisphereErrors errors(body, cluster.centres(), cluster.radii());

    figure("errVolume", errors.volume, 0, 1e-9, "-", "(7.10), corrected");
    figureNear
    (
        "errOffset",
        errors.offset,
        offsetByPoints(edges, cluster.centres(), cluster.radii()),
        0.01,
        "-",
        "2.1e6 points"
    );

    // One sphere in the middle of a cube of edge 1, scaled to its volume:
    // corners stand out by sqrt(3)/2 - r; the sphere is farthest from the cube
    // on the diagonals, where it is 1/2 - r/sqrt(3) below the faces
    const closedSurface cube("cube", box(vector::one, 8));
    multisphereGenerator one(cube, multisphereGenerator::controls());
    one.generate(1);
    const multisphereErrors e(cube, one.centres(), one.radii());
    const scalar r = std::cbrt(0.75/constant::mathematical::pi);

    figureNear
    (
        "errSurfaceToSpheres",
        e.surfaceToSpheres,
        std::sqrt(0.75) - r,
        1e-3,
        "m",
        "closed form"
    );
    figureNear
    (
        "errSpheresToSurface",
        e.spheresToSurface,
        0.5 - r/std::sqrt(3.0),
        0.015,
        "m",
        "closed form"
    );
    figureNear
    (
        "errInertia",
        e.inertia,
        1 - 0.4*sqr(r)*6,
        1e-3,
        "-",
        "closed form"
    );
}


TEST(multisphere, fitLowersOffset)
{
    const closedSurface body("ellipsoid", ellipsoid(vector(1, 0.7, 0.5), 3));
    multisphereGenerator::controls controls;
    multisphereGenerator plain(body, controls);
    controls.fit = true;
    multisphereGenerator fitted(body, controls);

    plain.generate(10);
    fitted.generate(10);
    const multisphereErrors before(body, plain.centres(), plain.radii(), 300);
    const multisphereErrors after(body, fitted.centres(), fitted.radii(), 300);

    figure
    (
        "fitGain",
        after.offset/before.offset,
        0,
        0.8,
        "-",
        "err_off with fit over without"
    );
    figure("fitVolume", after.volume, 0, 1e-9, "-", "(7.10), corrected");
}


TEST(multisphere, reachesAnError)
{
    const closedSurface body("ellipsoid", ellipsoid(vector(1, 0.7, 0.5), 3));
    multisphereGenerator cluster(body, multisphereGenerator::controls());

    cluster.generateToError(0.1, 100);
    const multisphereErrors errors(body, cluster.centres(), cluster.radii());
    figure("errorReached", errors.offset, 0, 0.101, "-", "0.1 asked for");

    const std::string said
    (
        errorOf([&]() { cluster.generateToError(0.001, 20); })
    );
    EXPECT_NE(said.find("out of reach"), std::string::npos) << said;

    multisphereGenerator::controls coarse;
    coarse.cells = 4;
    multisphereGenerator few(body, coarse);
    EXPECT_NE
    (
        errorOf([&]() { few.generate(1000); }).find("more cells"),
        std::string::npos
    );
}


TEST(multisphere, templateIsRead)
{
    const vector edges(1, 0.75, 0.5);
    const closedSurface body("box", box(edges, 4));
    multisphereGenerator cluster(body, multisphereGenerator::controls());
    cluster.generate(9);

    OStringStream os;
    os.precision(17);
    os.writeEntry("type", word("multisphere"));
    cluster.writeEntries(os);
    IStringStream is(os.str());
    const shape rock("rock", dictionary(is), ".");

    figureNear("templateVolume", rock.volume(), 0.375, 1e-12, "m3", "box");
    figureNear("templateUnion", rock.unionVolume(), 0.375, 1e-9, "m3", "box");
    figure
    (
        "templateInertia",
        mag
        (
            rock.inertiaPerDensity()
          - 0.375/12*vector(0.8125, 1.25, 1.5625)
        ),
        0,
        1e-12,
        "m5",
        "the box' own moments"
    );
    figure
    (
        "templateCentre",
        mag(rock.centreOfMass() - 0.5*edges),
        0,
        1e-12,
        "m",
        "the box' own centroid"
    );
}


// ************************************************************************* //
