/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    Spreading over cells: what it conserves on each kind of mesh, that the
    second operator is the adjoint of the first, and how wide and how high
    the diffused ball is.

\*---------------------------------------------------------------------------*/

#include "decay.H"
#include "figure.H"
#include "mathematicalConstants.H"
#include "packingLimit.H"
#include "Random.H"
#include "testMeshes.H"
#include "voidFraction.H"

using namespace Foam;
using namespace styxTest;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

struct kindOfMesh
{
    blockMesh::kind kind;
    const char* name;
};

const kindOfMesh kinds[] =
{
    {blockMesh::kind::hex, "hex"},
    {blockMesh::kind::tet, "tet"},
    {blockMesh::kind::refined, "refined"}
};


//- A mesh and one way of spreading on it
struct spreading
{
    blockMesh block;
    coupling::cellBins bins;
    dem::periodicity period;
    dictionary dict;
    autoPtr<coupling::voidFraction> model;

    spreading
    (
        const blockMesh::kind kind,
        const scalar edge,
        const label n,
        const std::string& entries
    )
    :
        block(kind, edge, n),
        bins(block()),
        dict(IStringStream(entries)())
    {
        model = coupling::voidFraction::New(mesh(), bins, period, dict);
    }

    const polyMesh& mesh() const
    {
        return block();
    }

    const scalarField& V() const
    {
        return mesh().cellVolumes();
    }

    void place(const List<point>& x, const scalar r)
    {
        List<coupling::cellBall> balls(x.size());
        forAll(x, i)
        {
            const label c = bins.find(x[i]);
            balls[i] = {c < 0 ? bins.nearest(x[i], GREAT) : c, x[i], r};
        }
        model->place(std::move(balls));
    }
};


List<point> somePoints(const label n, const scalar half)
{
    Random random(3);
    List<point> x(n);
    for (point& p : x)
    {
        p = half*(2*random.sample01<vector>() - vector::one);
    }
    return x;
}


scalarField someValues(const label n)
{
    Random random(5);
    scalarField q(n);
    for (scalar& v : q)
    {
        v = random.sample01<scalar>();
    }
    return q;
}


//- Second moment of a field about a point, along a direction [m2]
scalar secondMoment
(
    const polyMesh& mesh,
    const scalarField& q,
    const point& x,
    const direction d
)
{
    scalar sum = 0;
    forAll(q, c)
    {
        sum += q[c]*mesh.cellVolumes()[c]
           *sqr(mesh.cellCentres()[c][d] - x[d]);
    }
    return sum;
}


//- Value in the cell of one ball over that of the Gaussian at its centre
scalar peakRatio(const scalar bOverCell, const std::string& entries)
{
    const label n = 2*label(2.5*bOverCell) + 1;
    const scalar h = 1;
    std::ostringstream all;
    all << "type diffusion; bandwidth " << bOverCell*h << "; " << entries;
    spreading s(blockMesh::kind::hex, n*h, n, all.str());
    s.place(List<point>(1, point(Zero)), 0.5);
    const scalarField q(s.model->spread(scalarField(1, scalar(1))));
    const scalar b = bOverCell*h;
    return q[s.bins.find(Zero)]
       *pow3(std::sqrt(constant::mathematical::pi)*b);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(voidFraction, conserves)
{
    const std::pair<const char*, const char*> types[] =
    {
        {"centroid", "type centroid;"},
        {"divided", "type divided;"},
        {"twoGrid", "type twoGrid; boxSize 0.25;"},
        {"kernel", "type kernel; bandwidth 0.3;"},
        {"diffusion", "type diffusion; bandwidth 0.3;"},
        {"implicitEuler",
            "type diffusion; bandwidth 0.3; scheme implicitEuler; steps 3;"}
    };
    for (const auto& type : types)
    {
        scalar lost = 0, adjoint = 0, constant = 0;
        for (const kindOfMesh& k : kinds)
        {
            spreading s(k.kind, 1, 9, type.second);
            const List<point> x(somePoints(500, 0.499));
            s.place(x, 0.02);
            const scalarField q(someValues(x.size()));
            const scalarField density(s.model->spread(q));
            lost = max(lost, mag(sum(density*s.V())/sum(q) - 1));

            // <S q, f> is <q, S' f>
            const scalarField f(someValues(s.mesh().nCells()));
            const scalarField seen(s.model->gather(f));
            const scalar left = sum(density*f*s.V());
            adjoint = max(adjoint, mag(sum(q*seen)/left - 1));

            const scalarField one
            (
                s.model->gather(scalarField(f.size(), scalar(1)))
            );
            constant = max(constant, max(mag(one - 1)));
        }
        const std::string name(std::string("voidFraction_") + type.first);
        figure(name + "_volume", lost, 0, 1e-12, "-", "hex, tet, refined");
        figure(name + "_adjoint", adjoint, 0, 1e-12, "-", "what one gains"
            " the other loses");
        figure(name + "_constant", constant, 0, 1e-12, "-", "a uniform field");
    }
}


TEST(voidFraction, noCellsAround)
{
    // Far smaller than a cell, and outside of the mesh: the nearest cell has it
    scalar lost = 0;
    for (const char* type : {"centroid;", "divided;", "twoGrid; boxSize 0.4;",
        "kernel; bandwidth 1e-3;", "diffusion; bandwidth 1e-3;"})
    {
        spreading s
        (
            blockMesh::kind::hex,
            1,
            5,
            std::string("type ") + type
        );
        List<point> x(somePoints(20, 0.499));
        x.append(point(0.9, 0, 0));
        s.place(x, 1e-4);
        const scalarField q(someValues(x.size()));
        const scalarField density(s.model->spread(q));
        lost = max(lost, mag(sum(density*s.V())/sum(q) - 1));
    }
    figure("voidFraction_noCellsAround", lost, 0, 1e-12, "-",
        "nothing is lost, all five models");
}


TEST(voidFraction, secondMoment)
{
    for (const kindOfMesh& k : kinds)
    {
        scalar worst = 0;
        const scalar b = 0.2;
        spreading s
        (
            k.kind,
            1,
            k.kind == blockMesh::kind::tet ? 18 : 27,
            "type diffusion; bandwidth 0.2;"
        );
        const point x(0.01, -0.005, 0.02);
        s.place(List<point>(1, x), 0.01);
        const scalarField q(s.model->spread(scalarField(1, scalar(1))));

        // The ball is all over the cell that holds it, before it is spread
        const label c = s.bins.find(x);
        scalarField cell(q.size(), scalar(0));
        cell[c] = 1/s.V()[c];
        for (direction d = 0; d < 3; ++d)
        {
            const scalar own = secondMoment(s.mesh(), cell, x, d);
            const scalar m = secondMoment(s.mesh(), q, x, d) - own;
            worst = max(worst, mag(m/(0.5*sqr(b)) - 1));
        }
        figure
        (
            std::string("voidFraction_secondMoment_") + k.name,
            worst,
            0,
            0.01,
            "-",
            "b^2/2 a direction"
        );
    }
}


// Cells of one diameter, b of 3 and 6 diameters; far from walls and in the cell
// at a wall, about the wall, where the image makes it the same
TEST(voidFraction, secondMomentOfDiameters)
{
    for (const label b : {3, 6})
    {
        const label n = 8*b + 1;
        const std::string name = Foam::name(b);
        spreading s
        (
            blockMesh::kind::hex,
            n,
            n,
            "type diffusion; bandwidth " + name + ";"
        );

        for (const bool atWall : {false, true})
        {
            const scalar end = 0.5*n;
            const point x(atWall ? 0.5 - end : 0, 0, 0);
            const point about(atWall ? -end : 0, 0, 0);
            s.place(List<point>(1, x), 0.5);
            const scalarField q(s.model->spread(scalarField(1, scalar(1))));
            scalar worst = 0;
            for (direction d = 0; d < 3; ++d)
            {
                const scalar m =
                    secondMoment(s.mesh(), q, about, d)
                  - sqr(x[d] - about[d]);
                worst = max(worst, mag(m/(0.5*b*b) - 1));
            }
            const std::string where = atWall ? "Wall" : "";
            figure("voidFraction_secondMoment" + where + "_" + name + "d",
                worst, 0, 0.01, "-", "b^2/2 a direction");
            if (!atWall)
            {
                continue;
            }

            // The value there, against the Gaussian with its image
            const scalar g = 1/pow3(std::sqrt(constant::mathematical::pi)*b);
            figureNear("voidFraction_wall_" + name + "d",
                q[s.bins.find(x)]/(g*(1 + std::exp(-sqr(1.0/b)))), 1,
                b == 6 ? 0.03 : 0.12, "-",
                "Gaussian with its image; the mesh's error is of order"
                " (h/b)^2");
        }
    }
}


TEST(voidFraction, atWall)
{
    // Half the ball's image is inside: twice the Gaussian at the wall
    const scalar b = 10, h = 1;
    spreading s
    (
        blockMesh::kind::hex,
        41*h,
        41,
        "type diffusion; bandwidth 10;"
    );
    const point wall(-20, 0, 0);
    s.place(List<point>(1, wall), 0.5);
    const scalarField q(s.model->spread(scalarField(1, scalar(1))));

    const scalar g = 1/pow3(std::sqrt(constant::mathematical::pi)*b);
    const scalar image = 1 + std::exp(-sqr(h/b));
    figureNear
    (
        "voidFraction_wall",
        q[s.bins.find(wall)]/(g*image),
        1,
        0.02,
        "-",
        "Gaussian with its image, references 13"
    );
    figure
    (
        "voidFraction_wall_volume",
        mag(sum(q*s.V()) - 1),
        0,
        1e-12,
        "-",
        "all of it"
    );
}


TEST(voidFraction, implicitSteps)
{
    // A wave of the mesh keeps its form: the closed form of N steps
    const label n = 24;
    const scalar b = 6;
    scalar worst = 0;
    for (const label waves : {1, 2, 4, 8})
    {
        const scalar k = constant::mathematical::pi*waves/n;
        const scalar k2 = 4*sqr(std::sin(0.5*k));
        const scalar exact = std::pow(1 + k2*sqr(b)/12, -3);

        spreading s
        (
            blockMesh::kind::hex,
            n,
            n,
            "type diffusion; bandwidth 6; scheme implicitEuler; steps 3;"
        );
        scalarField wave(s.mesh().nCells());
        forAll(wave, c)
        {
            wave[c] = std::cos(k*(s.mesh().cellCentres()[c].x() + 0.5*n));
        }
        s.place(List<point>(1, point(-11.5, 0.5, 0.5)), 0.5);
        const scalar seen =
            s.model->gather(wave)[0]/wave[s.model->balls()[0].cell];
        worst = max(worst, mag(seen/exact - 1));
    }
    figure("voidFraction_3steps", worst, 0, 0.02, "-",
        "(1 + k^2 b^2/4N)^-N");
}


TEST(voidFraction, peak)
{
    const std::string euler("scheme implicitEuler; steps ");
    const scalar at3 = peakRatio(12, euler + "3;");
    const scalar at10 = peakRatio(12, euler + "10;");
    const scalar at50 = peakRatio(12, euler + "50;");
    figureNear("voidFraction_peak_3", at3, 2.3, 0.05, "-",
        "over the Gaussian, closed form 2.30");
    figureNear("voidFraction_peak_50", at50, 1.04, 0.02, "-",
        "over the Gaussian");
    figureNear("voidFraction_peak_10", at10, 1.223, 0.03, "-",
        "over the Gaussian, N^1.5 gamma(N - 1.5)/gamma(N)");
    figure("voidFraction_peak_1", peakRatio(12, euler + "1;"), at3, noBar,
        "-", "above that of 3: one step has no bound without a mesh");
    figure("voidFraction_peak_order",
        std::log((at10 - 1)/(at50 - 1))/std::log(5.0), 0.8, 1.3, "-",
        "falls as 1/N");
    figureNear("voidFraction_peak_LStable", peakRatio(12,
        "scheme LStable; steps 3;"), 1, 0.1, "-", "3 solves");
    figureNear("voidFraction_peak_exact", peakRatio(12, ""), 1, 0.01, "-",
        "the Gaussian of references 13, b = 12 cells");

    // Coarser meshes hold shorter waves than the Gaussian has: second order
    const scalar coarse = peakRatio(6, "") - 1;
    const scalar fine = peakRatio(12, "") - 1;
    figure("voidFraction_peak_order2", std::log(coarse/fine)/std::log(2.0),
        1.8, 2.3, "-", "error of the mesh, b = 6 and 12 cells");
}


TEST(voidFraction, packingLimit)
{
    for (const kindOfMesh& k : kinds)
    {
        spreading s(k.kind, 1, 7, "type centroid; maxPacking 0.6;");
        s.place(somePoints(400, 0.1), 0.02);
        scalarField solids
        (
            s.model->spread(scalarField(400, scalar(0.2/400)))
        );
        const scalar before = max(solids);
        const auto done = coupling::packingLimit(s.dict).apply
        (
            s.mesh(),
            solids
        );
        const std::string name(std::string("packingLimit_") + k.name);
        EXPECT_GT(before, 1);
        EXPECT_GT(done.excess, 0);
        figure(name, max(solids), 0.59, 0.6*(1 + 1e-8), "-", "maxPacking");
        figure(name + "_volume", mag(sum(solids*s.V())/0.2 - 1), 0, 1e-12,
            "-", "nothing is cut");
        EXPECT_GE(min(solids), 0);
    }

    spreading s(blockMesh::kind::hex, 1, 3, "type centroid; maxPacking 0.6;");
    scalarField full(27, scalar(0.7));
    EXPECT_THROW
    (
        coupling::packingLimit(s.dict).apply(s.mesh(), full),
        Foam::IOerror
    );
}


TEST(voidFraction, packingLimitBehindWall)
{
    // Two cells that share nothing: one is too full, the other cannot help
    pointField points(16);
    forAll(points, p)
    {
        points[p] = vector((p & 1) ^ ((p >> 1) & 1), (p >> 1) & 1, (p >> 2) & 1)
          + vector(p/8*3, 0, 0);
    }
    cellShapeList cells(2);
    forAll(cells, c)
    {
        cells[c] = cellShape(cellModel::ref(cellModel::HEX), identity(8, 8*c));
    }
    const autoPtr<Time> time(Time::New());
    const polyMesh mesh
    (
        IOobject("mesh", time->timeName(), *time),
        std::move(points),
        cells,
        faceListList(),
        wordList(),
        wordList(),
        "outside",
        "patch",
        wordList()
    );

    dictionary dict(IStringStream("type centroid; maxPacking 0.6;")());
    scalarField solids(2, scalar(0.2));
    solids[0] = 0.7;
    EXPECT_THROW
    (
        coupling::packingLimit(dict).apply(mesh, solids),
        Foam::IOerror
    );
}


// ************************************************************************* //
