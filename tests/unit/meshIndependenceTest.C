/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    The void fraction of balls that stay where they are, on cells of four
    diameters down to half of one: with diffusion the profile is the same, with
    each ball in its own cell it is not, and cells are more than full.

\*---------------------------------------------------------------------------*/

#include "figure.H"
#include "mathematicalConstants.H"
#include "Random.H"
#include "testMeshes.H"
#include "transform.H"
#include "voidFraction.H"

#include <cmath>

using namespace Foam;
using namespace styxTest;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// In diameters
const scalar edge = 24;
const scalar coarsest = 4;


//- A fluidised bed: a lattice that is shaken and lies aslant, as no bed has
//  its layers along those of the cells; a part is missing, most where bubbles
//  rise in its middle
List<point> bed()
{
    Random random(17);
    const tensor aslant
    (
        rotationTensor(vector(1, 0, 0), vector(0.36, 0.48, 0.8))
    );
    const scalar pitch = 1.1;
    const label half = label(edge/pitch);
    DynamicList<point> x;
    for (label i = -half; i <= half; ++i)
    {
        for (label j = -half; j <= half; ++j)
        {
            for (label k = -half; k <= half; ++k)
            {
                const vector shaken
                (
                    vector(i, j, k)*pitch
                  + 0.05*(2*random.sample01<vector>() - vector::one)
                );
                const point p = aslant & shaken;
                const scalar turn =
                    2*constant::mathematical::pi*p.x()/edge;
                const scalar keep = 0.8 - 0.15*(1 + std::cos(turn));
                const bool there = random.sample01<scalar>() < keep;
                if (there && cmptMax(cmptMag(p)) < 0.5*edge)
                {
                    x.append(p);
                }
            }
        }
    }
    return List<point>(std::move(x));
}


struct profile
{
    //- At the centres of the widest cells [-]
    scalarField alpha;

    //- In the emptiest cell of the fluid [-]
    scalar least;
};


//- The void fraction over x, mean over y and over a layer in z of the widest
//  cells, on cells of a width
profile profileOf(const std::string& type, const scalar width)
{
    const label n = label(edge/width + 0.5);
    const blockMesh block(blockMesh::kind::hex, edge, n);
    const polyMesh& mesh = block();
    const coupling::cellBins bins(mesh);
    const dem::periodicity period;
    IStringStream entries(type);
    const dictionary dict(entries);
    autoPtr<coupling::voidFraction> model
    (
        coupling::voidFraction::New(mesh, bins, period, dict)
    );

    const List<point> x(bed());
    List<coupling::cellBall> balls(x.size());
    forAll(x, i)
    {
        balls[i] = {bins.find(x[i]), x[i], 0.5};
    }
    model->place(std::move(balls));
    const scalarField solids
    (
        model->spread(scalarField(x.size(), constant::mathematical::pi/6))
    );

    scalarField sum(n, 0), number(n, 0);
    forAll(solids, c)
    {
        const vector at = mesh.cellCentres()[c];
        if (at.z() > 0 && at.z() < coarsest)
        {
            const label i = label((at.x() + 0.5*edge)/width);
            sum[i] += 1 - solids[c];
            ++number[i];
        }
    }
    sum /= number;

    // Linear between the middles of cells
    profile found{scalarField(label(edge/coarsest)), 1 - max(solids)};
    forAll(found.alpha, k)
    {
        const scalar s = (k + 0.5)*coarsest/width - 0.5;
        const label i = min(label(s), n - 2);
        found.alpha[k] = sum[i] + (s - i)*(sum[i + 1] - sum[i]);
    }
    return found;
}


//- Largest difference to the profile on cells of half a diameter
scalar differenceOf(const std::string& type, const List<scalar>& widths)
{
    const scalarField finest(profileOf(type, 0.5).alpha);
    scalar most = 0;
    for (const scalar width : widths)
    {
        const profile p(profileOf(type, width));
        most = max(most, max(mag(p.alpha - finest)));
    }
    return most;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(meshIndependence, frozenBed)
{
    const std::string wide("type diffusion; bandwidth 6;");
    const std::string narrow("type diffusion; bandwidth 3;");
    const std::string none("type centroid;");

    figure("meshIndependence_6d", differenceOf(wide, {4, 2, 1}), 0, 0.01, "-",
        "b = 6 d, profiles on cells of 4, 2, 1 d against 0.5 d");
    figure("meshIndependence_3d", differenceOf(narrow, {4, 2, 1}), 0, 0.01,
        "-", "b = 3 d");
    figure("meshIndependence_centroid", differenceOf(none, {4, 2, 1}), 0.01,
        noBar, "-", "fails, as each ball is in one cell");

    figure("meshIndependence_3d_least", profileOf(narrow, 0.5).least, 0.3, 1,
        "-", "fullest cell of half a diameter");
    figure("meshIndependence_centroid_least", profileOf(none, 0.5).least,
        -noBar, 0, "-", "a cell of half a diameter has more than it can hold");
}


// ************************************************************************* //
