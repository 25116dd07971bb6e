/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "refinementInterface.H"
#include "bodyGeometry.H"
#include "allowedKeys.H"
#include "bitSet.H"
#include "checkedEntry.H"
#include "dynamicRefineFvMesh.H"
#include "syncTools.H"

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

// What the field is where fine cells stay fine
const scalar keep = 0.7;

// dynamicRefineFvMesh takes the mean over the cells around a point, of which
// a rank may have any; with n cells of which one is not marked that is at
// most 1 - (1 - keep)/n. A point has 8 cells; here it may have 15.
const scalar leastRefineLevel = 0.98;

// A ball around any point of a cube with this radius over the cube's own
// reaches a corner or the centre: sqrt(5)/4 of the edge
const scalar cover = 0.65;


//- Choose the points of a cell that a layer around a body covers; all of them
//  if the body is too small to reach one
void choosePoints
(
    const fvMesh& mesh,
    const coupling::bodyGeometry& body,
    const label cell,
    const scalar centreDistance,
    const scalar radius,
    const scalar layer,
    bitSet& chosen
)
{
    const scalar reach = max(layer, cover*radius);
    if (centreDistance > reach + radius)
    {
        return;
    }

    const labelList& points = mesh.cellPoints()[cell];
    bool any = centreDistance + radius < reach;
    const bool all = any;
    for (const label p : points)
    {
        // The distance to the body differs by no more than that to the centre
        const point& x = mesh.points()[p];
        const scalar toCentre = all ? 0 : mag(x - mesh.cellCentres()[cell]);
        if
        (
            all
         || centreDistance + toCentre < reach
         || (centreDistance - toCentre < reach && body.distance(x) < reach)
        )
        {
            chosen.set(p);
            any = true;
        }
    }
    if (!any && centreDistance < reach)
    {
        chosen.set(points);
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::refinementInterface::refinementInterface
(
    const fvMesh& mesh,
    const cellBins& bins,
    const dictionary& dict
)
:
    mesh_(mesh),
    bins_(bins),
    layer_(0.3),
    field_
    (
        IOobject
        (
            "interface",
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        ),
        mesh,
        dimensionedScalar(dimless, Zero)
    )
{
    dem::checkKeys(dict, {"layer"});
    layer_ = dem::getNonNegative(dict, "layer", 0.3);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::coupling::refinementInterface::asked(const fvMesh& mesh)
{
    const IOdictionary meshDict
    (
        IOobject
        (
            "dynamicMeshDict",
            mesh.time().constant(),
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE,
            false
        )
    );
    return
        isA<dynamicRefineFvMesh>(mesh)
     || meshDict.getOrDefault<word>("dynamicFvMesh", "none")
     == dynamicRefineFvMesh::typeName;
}


void Foam::coupling::refinementInterface::mark
(
    const dem::demSolver& dem,
    const bodyKinds& kinds,
    const scalar ahead
)
{
    // How far around it a body reaches, moving on: all is refined, or kept
    const auto innerOf = [&](const dem::bodies& state, const label b)
    {
        const dem::shape& s = state.shapeOf(b);
        const scalar motion =
            ahead
           *(mag(state.v[b]) + mag(state.omega[b])*s.fluidRadius());
        return layer_*s.equivalentDiameter() + motion;
    };
    const auto reachOf = [&](const dem::bodies& state, const label b)
    {
        return state.shapeOf(b).fluidRadius() + 1.5*innerOf(state, b);
    };
    const scalar cell = dem.group().max(bins_.maxRadius());
    presentBodies present(mesh_, dem);
    present.find
    (
        [&](const label b) { return reachOf(dem.state(), b) + 2*cell; }
    );
    const dem::bodies& state = present();
    const dem::periodicity& period = dem.period();

    scalarField& value = field_.primitiveFieldRef();
    value = 0;
    bitSet chosen(mesh_.nPoints());

    vector solved(vector::one);
    for (direction d = 0; d < 3; ++d)
    {
        solved[d] = mesh_.solutionD()[d] > 0 ? 1 : 0;
    }

    forAll(state.x, b)
    {
        if (!kinds.resolved(b))
        {
            continue;
        }
        const scalar inner = innerOf(state, b);
        const scalar outer = 1.5*inner;
        const scalar reach = reachOf(state, b);

        // A body, or an image of it beyond a seam
        const auto markAround = [&](const vector& shift)
        {
            const bodyGeometry body(state, b, solved, shift);
            const auto markCell = [&](const label c)
            {
                const scalar distance = body.distance(mesh_.cellCentres()[c]);
                const scalar radius = bins_.radius(c);

                choosePoints(mesh_, body, c, distance, radius, inner, chosen);

                // The cell's edge over its diagonal is 0.58 for a cube
                if (distance - 0.6*radius < outer)
                {
                    value[c] = keep;
                }
            };
            bins_.forEach(state.x[b] + shift, reach, markCell);
        };

        markAround(Zero);
        period.forEachImage
        (
            state.x[b],
            reach,
            [&](const label image) { markAround(period.shift(image)); }
        );
    }

    // All cells around a chosen point, whichever rank has them: the mean over
    // any of them is 1
    syncTools::syncPointList(mesh_, chosen, orEqOp<unsigned int>(), 0u);
    const labelListList& pointCells = mesh_.pointCells();
    for (const label p : chosen)
    {
        for (const label c : pointCells[p])
        {
            value[c] = 1;
        }
    }

    field_.correctBoundaryConditions();
}


void Foam::coupling::refinementInterface::checkLevels
(
    const dictionary& dict
) const
{
    if (dict.get<word>("field") != field_.name())
    {
        return;
    }

    dem::getInRange(dict, "lowerRefineLevel", leastRefineLevel, 0.9999);
    dem::getInRange(dict, "upperRefineLevel", 1.01, GREAT);
    dem::getInRange(dict, "unrefineLevel", 0.01, keep);
}


// ************************************************************************* //
