/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    What the flow around bodies that fill cells asks of the mesh and of the
    solver's correctors; what bodies do that go from cell to cell at once.

\*---------------------------------------------------------------------------*/

#include "caseCheck.H"
#include "frictionReach.H"
#include "presentBodies.H"
#include "sizeLevels.H"

#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::caseCheck::checkThickness()
{
    scalar cells = GREAT;
    for (const kind& k : kinds_)
    {
        // The shortest axis of the ellipsoid that has the body's inertia
        const dem::shape& s = shapeOf(k);
        const vector& I = s.inertiaPerDensity();
        const scalar a2 = 2.5/s.volume()*(cmptSum(I) - 2*cmptMax(I));
        const scalar thick = 2*std::sqrt(max(a2, scalar(0)));
        const scalar across = thick/k.cell;
        cells = min(cells, across);
        if (across < 2 && thick < 0.9*s.equivalentDiameter())
        {
            sentence os;
            os  << nameOf(k).c_str() << " is " << thick << " m thick, "
                << across << " cells. Below two cells across, what fluid it"
                << " takes along is 10 to 30 % too little: refine around it.";
            advice_.append(os.str());
        }
    }
    addFigure
    (
        "cellsOverThickness", cells, "-",
        "fewest cells across the thinnest side of a body"
    );
}


void Foam::caseCheck::checkGaps()
{
    // Gaps count that are narrower than a cell
    scalar widest = 0;
    for (const kind& k : kinds_)
    {
        widest = k.cell < GREAT ? max(widest, k.cell) : widest;
    }
    coupling::presentBodies present(mesh_, dem_);
    present.find
    (
        [&](const label b)
        {
            return dem_.state().shapeOf(b).boundingRadius() + widest;
        }
    );
    const dem::bodies& state = present();
    scalarField cell(state.nSpheres());
    forAll(cell, s)
    {
        const label b = state.sphereBody[s];
        cell[s] = kindOf(state.shapeI[b], state.materialI[b]).cell;
    }
    scalar narrowest = GREAT;
    scalar gap = 0;
    dem::sizeLevels
    (
        state.sphereX(),
        scalarField(scalarField(state.sphereR.list()) + 0.5*cell),
        0
    ).forEachPair
    (
        [&](const label i, const label j)
        {
            const scalar g =
                mag(state.sphereX()[i] - state.sphereX()[j])
              - state.sphereR[i] - state.sphereR[j];
            const scalar part = g/min(cell[i], cell[j]);
            if
            (
                g > 0 && part < narrowest
             && state.sphereBody[i] != state.sphereBody[j]
            )
            {
                narrowest = part;
                gap = g;
            }
        }
    );
    const scalar least = returnReduce(narrowest, minOp<scalar>());
    gap = returnReduce(narrowest > least ? GREAT : gap, minOp<scalar>());
    if (least < 1)
    {
        sentence os;
        os  << "The narrowest gap between two bodies is " << gap << " m, "
            << least << " cells: the flow in it is not resolved. Refine, or"
            << " give immersed the film in it, lubrication.";
        advice_.append(os.str());
    }
}


void Foam::caseCheck::checkCorrectors()
{
    if (!(around_.nu > 0) || around_.nCorrectors < 1)
    {
        return;
    }
    scalar cell = GREAT;
    for (const kind& k : kinds_)
    {
        cell = min(cell, k.cell);
    }

    const scalar diffusion = around_.nu*around_.deltaT/sqr(cell);
    const label wanted = coupling::frictionReach::enough(diffusion);
    addFigure
    (
        "diffusionNumber", diffusion, "-",
        "nu dt/h2 in the smallest cell at a body"
    );
    if (diffusion > 1 && around_.nCorrectors < wanted)
    {
        sentence os;
        os  << "In a step friction reaches over " << std::sqrt(diffusion)
            << " cells; with nCorrectors " << around_.nCorrectors
            << " the force on the bodies may grow without bounds: take "
            << wanted << ", or a step of "
            << around_.deltaT/diffusion
              *coupling::frictionReach::largest(around_.nCorrectors, true)
            << " s, which a solver with adjustTimeStep takes by itself.";
        advice_.append(os.str());
    }
}


void Foam::caseCheck::checkHops()
{
    // In the step in which its volume V leaves a cell as much fluid comes back
    // through the face of h2. What the body gets of V/(h2 dt): 0.044, 0.047
    // and 0.042 with steps of 0.2, 0.1 and 0.02 ms, a sphere in a still fluid
    scalar worst = 0, pulse = 0, top = 0;
    string whose;
    for (const kind& k : kinds_)
    {
        const scalar hop =
            0.045*shapeOf(k).volume()/(sqr(k.cell)*around_.deltaT);
        const scalar speed = topSpeed(k);
        if (hop > worst*speed)
        {
            worst = hop/max(speed, VSMALL);
            pulse = hop;
            top = speed;
            whose = nameOf(k);
        }
    }
    addFigure
    (
        "hopOverSpeed", worst, "-",
        "velocity that a body gets by going to another cell, over its largest"
    );
    if (worst > 0.1)
    {
        sentence os;
        os  << "voidFraction centroid moves " << whose.c_str()
            << " from cell to cell in one step: the fluid that makes room gives"
            << " it " << pulse << " m/s, and bodies go at " << top
            << " m/s at most; shorter steps make it worse. Take divided, in"
            << " which the volume goes over as the body does.";
        advice_.append(os.str());
    }
}


// ************************************************************************* //
