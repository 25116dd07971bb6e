/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "caseCheck.H"
#include "immersedMethod.H"
#include "ranksOf.H"
#include "rankSum.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::caseCheck::kind& Foam::caseCheck::kindOf
(
    const label shapeI,
    const label materialI
)
{
    for (kind& k : kinds_)
    {
        if (k.shapeI == shapeI && k.materialI == materialI)
        {
            return k;
        }
    }
    kinds_.append(kind{shapeI, materialI});
    return kinds_.last();
}


Foam::string Foam::caseCheck::nameOf(const kind& k) const
{
    return
        shapeOf(k).name() + " of " + dem_.mats().names()[k.materialI];
}


Foam::scalar Foam::caseCheck::cellAt(const point& p) const
{
    const label c = bins_.find(p);
    return c < 0 ? GREAT : std::cbrt(mesh_.cellVolumes()[c]);
}


void Foam::caseCheck::shareKinds()
{
    if (!dem_.group().shared())
    {
        return;
    }

    // The same kinds in the same order on all ranks
    const dem::bodies& state = dem_.state();
    const label m = dem_.mats().names().size();
    List<scalar> there(dem_.shapes().size()*m, scalar(0));
    forAll(state.x, b)
    {
        there[state.shapeI[b]*m + state.materialI[b]] = 1;
    }
    dem::maxOverRanks(there);
    forAll(there, i)
    {
        if (there[i] > 0)
        {
            kindOf(i/m, i % m);
        }
    }
}


void Foam::caseCheck::collectBodies()
{
    const dem::bodies& state = dem_.state();
    const dem::rankGroup& group = dem_.group();
    const label stride = 1 + state.size()/1000;

    shareKinds();
    const labelList cells(coupling::cellsOf(bins_, state.x));
    const boolList inside(coupling::areInMesh(mesh_, bins_, dem_, cells));
    forAll(state.x, b)
    {
        kind& k = kindOf(state.shapeI[b], state.materialI[b]);
        ++k.nStart;
        k.speed = max(k.speed, mag(state.v[b]));
        if (b % stride)
        {
            continue;
        }
        for (direction d = 0; d < 3; ++d)
        {
            vector arm(Zero);
            arm[d] = 0.5*state.shapeOf(b).equivalentDiameter();
            k.cell = min(k.cell, cellAt(state.x[b] + arm));
            k.cell = min(k.cell, cellAt(state.x[b] - arm));
        }
    }

    const label out = inside.find(false);
    if (out >= 0 && !around_.restart)
    {
        FatalErrorInFunction
            << "Body " << state.id[out] << " (" << state.shapeOf(out).name()
            << ") starts at " << state.x[out]
            << ", where there is no mesh." << nl
            << "    The mesh is in the box " << mesh_.bounds() << '.'
            << exit(FatalError);
    }

    for (kind& k : kinds_)
    {
        k.nStart = group.sum(k.nStart);
        k.speed = group.max(k.speed);
        reduce(k.cell, minOp<scalar>());
        k.cell /= scalar(1 << around_.levels);
    }
}


void Foam::caseCheck::collectPlans()
{
    for (const dem::generatorPlan& plan : dem_.plans())
    {
        const scalar cell =
            plan.where ? cellIn(plan)/scalar(1 << around_.levelsToCome) : GREAT;
        for (const dem::generatorPlan::part& p : plan.parts)
        {
            kind& k = kindOf(p.shapeI, p.materialI);
            k.nToCome += p.number;
            k.speed = max(k.speed, plan.speed);
            k.cell = min(k.cell, cell);
        }
    }
}


Foam::scalar Foam::caseCheck::cellIn(const dem::generatorPlan& plan)
{
    const label n = 5;
    boolList inside(n*n*n);
    scalar largest = 0;
    forAll(inside, i)
    {
        const vector part(i % n, (i/n) % n, i/(n*n));
        const scalar h = cellAt(plan.where->at(part/scalar(n - 1)));
        inside[i] = h < GREAT;
        largest = max(largest, inside[i] ? h : 0);
    }
    dem::anyOverRanks(inside);
    reduce(largest, maxOp<scalar>());
    const label nInside = std::count(inside.begin(), inside.end(), true);

    sentence where;
    where << "the region of generator " << plan.name << ", "
        << plan.where->low() << " to " << plan.where->high();
    if (!nInside)
    {
        FatalErrorInFunction
            << "There is no mesh in " << where.str().c_str() << '.' << nl
            << "    The mesh is in the box " << mesh_.bounds() << '.'
            << exit(FatalError);
    }
    if (nInside < inside.size())
    {
        advice_.append
        (
            "A part of " + where.str() + " lies outside of the mesh: bodies"
            " that come there are taken out at once. Make it smaller."
        );
    }
    return largest;
}


void Foam::caseCheck::checkSizes()
{
    scalar volume = 0, largest = 0, allVolume = 0, cells = GREAT;
    for (const kind& k : kinds_)
    {
        const dem::shape& s = shapeOf(k);
        const scalar d = s.equivalentDiameter();
        volume += s.volume()*k.nStart;
        allVolume += s.volume()*(k.nStart + k.nToCome);
        largest = max(largest, 2*s.boundingRadius());
        cells = min(cells, d/k.cell);

        if (around_.points && !around_.mixed && d > k.cell)
        {
            sentence os;
            os  << nameOf(k).c_str() << ", " << d << " m, is a point to the"
                << " fluid but larger than a cell,"
                << " " << k.cell << " m: it sees the velocity at its centre"
                << " only.";
            advice_.append(os.str());
        }
        if (resolved() && d < 8*k.cell)
        {
            sentence os;
            os  << "There are " << d/k.cell << " cells over the diameter of "
                << nameOf(k).c_str() << ", " << d << " m. The fluid's forces"
                << " want 8, better 16: refine around the bodies.";
            advice_.append(os.str());
        }
    }

    const scalar domain =
        returnReduce(sum(mesh_.cellVolumes()), sumOp<scalar>());
    const scalar extent = cmptMin(mesh_.bounds().span());

    addFigure
    (
        "domainOverBody", extent/largest, "-",
        "shortest edge of the domain over the largest body"
    );
    addFigure
    (
        "solidFraction", allVolume/domain, "-",
        "volume of all bodies, also those to come, over the domain's"
    );
    if (around_.rho > 0 || around_.points)
    {
        addFigure
        (
            "cellsOverDiameter", cells, "-",
            "fewest cells over a body's diameter"
        );
    }

    if (around_.points && !around_.felt && allVolume > 0.01*domain)
    {
        sentence os;
        os  << "The bodies that are there and those to come fill "
            << 100*allVolume/domain << " % of the domain. As points"
            << " (coupling fluidToParticles) each has the drag of one that is"
            << " alone, and the fluid does not feel them: up to 1 % is usual.";
        advice_.append(os.str());
    }
    if (allVolume > 0.6*domain)
    {
        sentence os;
        os  << "The bodies that are there and those to come fill "
            << 100*allVolume/domain << " % of the domain; packed at random"
            << " they fill 64 %. Do enough of them leave?";
        advice_.append(os.str());
    }
    forAll(dem_.shapes(), i)
    {
        bool used = false;
        for (const kind& k : kinds_)
        {
            used =
                used || k.shapeI == i
             || shapeOf(k).ofName() == dem_.shapes()[i].name();
        }
        if (!used)
        {
            advice_.append
            (
                "No body and no generator has the shape "
              + dem_.shapes()[i].name() + '.'
            );
        }
    }
}


void Foam::caseCheck::checkMemory()
{
    // What spheres of a bed with friction take during an advance, as measured:
    // records and memory of contacts, both of which a step that may be undone
    // has twice; lists of neighbours and what the watchdog keeps
    const bool twice = dem_.control() && dem_.control()->undoes();
    const scalar sphereBytes = 270.0*(twice ? 2 : 1) + 125;

    // The state of a body and its cell; what a clump has besides, as a whole
    // and of each sphere
    const scalar bodyBytes = 95;
    const scalar clumpBytes = 330.0*(twice ? 2 : 1) + 60;
    const scalar clumpSphereBytes = 32;

    scalar bodies = 0, cells = 0;
    for (const kind& k : kinds_)
    {
        const scalar n = scalar(k.nStart) + scalar(k.nToCome);
        const dem::shape& s = shapeOf(k);
        const label nSpheres = s.radii().size();
        bodies += n*(bodyBytes + nSpheres*sphereBytes);
        if (!s.isSphere())
        {
            bodies += n*(clumpBytes + nSpheres*clumpSphereBytes);
        }
        if (resolved())
        {
            // Those inside and those that the surface cuts
            const scalar across = s.equivalentDiameter()/k.cell;
            cells +=
                n*constant::mathematical::pi*sqr(across)*(across/6 + 1)
               *sizeof(coupling::bodyCell);
        }
    }

    const bool shared = dem_.group().shared();
    bodies /= shared ? Pstream::nProcs() : 1;
    addFigure
    (
        "memoryBodies", bodies/1048576, "MB",
        shared
      ? "bodies and their contacts, on each rank"
      : "all bodies and their contacts, on each rank"
    );
    if (resolved())
    {
        addFigure
        (
            "memoryCells", cells/1048576, "MB",
            "cells that the bodies fill, on all ranks together"
        );
    }
    if (bodies + cells > 1e9)
    {
        sentence os;
        os  << "The bodies will take some " << (bodies + cells)/1e9
            << " GB of memory when all of them are there. Is there so much?";
        advice_.append(os.str());
    }
}


void Foam::caseCheck::checkRoom()
{
    const List<dem::generatorPlan> plans(dem_.plans());
    forAll(plans, i)
    {
        if (!dem_.hasRoomFor(i))
        {
            advice_.append
            (
                "The next body of generator " + plans[i].name + " finds no"
                " room in its region now: bodies or walls are in the way, or"
                " it is nearer to a wall than the body is large."
            );
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::caseCheck::caseCheck
(
    const polyMesh& mesh,
    const coupling::cellBins& bins,
    const dem::demSolver& dem,
    const surroundings& around,
    const bool thorough
)
:
    mesh_(mesh),
    bins_(bins),
    dem_(dem),
    around_(around)
{
    collectBodies();
    collectPlans();

    scalar toCome = 0;
    for (const kind& k : kinds_)
    {
        toCome += k.nToCome;
    }
    addFigure("bodies", dem.nBodies(), "-", "bodies at the start");
    addFigure
    (
        "bodiesToCome", std::round(toCome), "-", "bodies that generators bring"
    );
    if (kinds_.empty())
    {
        advice_.append("There is no body and no generator.");
        return;
    }

    checkSizes();
    checkMemory();
    checkRayleigh();
    checkImpacts();
    checkFluidStep();
    if (around_.hops)
    {
        checkHops();
    }
    if (resolved())
    {
        checkThickness();
        checkCorrectors();
        if (!around_.film)
        {
            checkGaps();
        }
    }
    if (thorough)
    {
        checkRoom();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::caseCheck::writeFigures(Ostream& os) const
{
    for (const figure& f : figures_)
    {
        os  << "    " << f.name.c_str();
        for (label i = f.name.size(); i < 20; ++i)
        {
            os  << ' ';
        }
        os  << f.value << ' ' << f.unit.c_str() << "  ("
            << f.meaning.c_str() << ')' << nl;
    }
}


void Foam::caseCheck::writeAdvice(Ostream& os) const
{
    for (const string& a : advice_)
    {
        os  << "    Advice: " << a.c_str() << nl;
    }
}


// ************************************************************************* //
