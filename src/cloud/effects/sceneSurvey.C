/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "sceneSurvey.H"
#include "fvMesh.H"
#include "IOdictionary.H"
#include "mathematicalConstants.H"
#include "wallPolyPatch.H"

#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::sceneSurvey::makeKinds()
{
    const label m = dem_.mats().names().size();
    kinds_.setSize(dem_.shapes().size()*m);
    forAll(kinds_, i)
    {
        kind& k = kinds_[i];
        k.shapeI = i/m;
        k.materialI = i % m;
        k.numbers.shape = dem_.shapes()[k.shapeI].name();
        k.numbers.d = dem_.shapes()[k.shapeI].equivalentDiameter();
        k.numbers.rhoP = dem_.mats().density(k.materialI);
        k.numbers.g = mag(dem_.g());
        k.numbers.rhoF = fluid_.rho;
        k.numbers.nu = fluid_.nu;
        k.numbers.turbulent = returnReduce(fluid_.k.size(), sumOp<label>());
        k.numbers.cell = GREAT;
    }
}


void Foam::sceneSurvey::count()
{
    const dem::bodies& state = dem_.state();
    forAll(state.x, b)
    {
        ++kindOf(state.shapeI[b], state.materialI[b]).nNow;
    }
    for (kind& k : kinds_)
    {
        k.nNow = dem_.group().sum(k.nNow);
    }
    for (const dem::generatorPlan& plan : dem_.plans())
    {
        for (const dem::generatorPlan::part& p : plan.parts)
        {
            kind& k = kindOf(p.shapeI, p.materialI);
            k.nToCome += p.number;
            k.speed = max(k.speed, plan.speed);
        }
    }
}


void Foam::sceneSurvey::setContacts(kind& k) const
{
    // A law that is off has no values
    const dem::contactLaws& laws = dem_.mats().laws();
    if (dem_.mats().pairs().empty())
    {
        return;
    }
    const dem::pairProperties& p =
        dem_.mats().pair(k.materialI, k.materialI);
    sceneNumbers& n = k.numbers;
    const scalar r = 0.5*n.d;
    const scalar weight = max(n.rhoP*n.volume()*n.g, VSMALL);

    if (laws.coheres("capillary"))
    {
        n.capillary = p.bridgeForce*r/weight;
    }
    if (laws.coheres("vanDerWaals"))
    {
        n.vanDerWaals =
            p.hamakerConstant*r/(12*sqr(p.minSeparation))/weight;
    }
    if (laws.coheres("simplifiedJKR") && p.elasticity > 0)
    {
        // The pull at which two spheres come apart
        const scalar a =
            constant::mathematical::pi*r*p.cohesionEnergyDensity;
        n.simplifiedJKR =
            laws.normal == "hertz"
          ? 4.0/27*pow3(a)/(16.0/9*sqr(p.elasticity)*0.5*r)/weight
          : a/p.elasticity;
    }
    if (laws.coheres("electrostatic"))
    {
        // At the mean spacing
        const scalar l =
            std::cbrt(n.volume()/max(n.meanFraction, scalar(1e-12)));
        n.electrostatic = mag(p.chargePressure)*pow4(r)/sqr(l)/weight;
    }
    if (laws.rolling != "none" && p.rollingFriction > 0)
    {
        n.rolling = p.rollingFriction/max(p.friction, p.rollingFriction);
    }
}


Foam::label Foam::sceneSurvey::levelsToCome() const
{
    const IOdictionary dict
    (
        IOobject
        (
            "dynamicMeshDict",
            mesh_.time().constant(),
            mesh_,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE,
            false
        )
    );
    return
        dict.getOrDefault<word>("dynamicFvMesh", "none")
     == "dynamicRefineFvMesh" && mesh_.time().timeIndex() == 0
      ? dict.optionalSubDict("dynamicRefineFvMeshCoeffs")
       .getOrDefault<label>("maxRefinement", 0)
      : 0;
}


void Foam::sceneSurvey::share()
{
    for (kind& k : kinds_)
    {
        reduce(k.numbers.cell, minOp<scalar>());
        reduce(k.numbers.shear, maxOp<scalar>());
        reduce(k.numbers.spin, maxOp<scalar>());
        const scalar most = returnReduce(k.numbers.k, maxOp<scalar>());
        k.numbers.epsilon = returnReduce
        (
            k.numbers.k < most ? scalar(0) : k.numbers.epsilon,
            maxOp<scalar>()
        );
        k.numbers.k = most;
        reduce(k.slip, sumOp<scalar>());
        reduce(k.nSlips, sumOp<scalar>());
    }
}


void Foam::sceneSurvey::finish(kind& k) const
{
    sceneNumbers& n = k.numbers;
    n.cell = n.cell < GREAT ? n.cell : meanCell_;
    const label levels = levelsToCome();
    n.cell /= scalar(1 << levels);
    n.refines = levels > 0;
    if (!n.inFluid())
    {
        return;
    }

    scalar height = 0;
    if (n.g > 0)
    {
        height = cmptSum
        (
            cmptMag(cmptMultiply(mesh_.bounds().span(), dem_.g()/n.g))
        );
    }
    const scalar mean = k.nSlips > 0 ? k.slip/k.nSlips : k.speed;
    const scalar fallen =
        sqrt(2*n.netWeight()/(n.rhoP*n.volume())*height);
    n.slip = max(mean, min(n.terminalSlip(), fallen));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::sceneSurvey::sceneSurvey
(
    const fvMesh& mesh,
    const coupling::cellBins& bins,
    const dem::demSolver& dem,
    const sceneFluid& fluid
)
:
    mesh_(mesh),
    bins_(bins),
    dem_(dem),
    fluid_(fluid),
    domain_(gSum(mesh.V().field())),
    meanCell_
    (
        std::cbrt(domain_/returnReduce(mesh.nCells(), sumOp<label>()))
    )
{
    makeKinds();
    count();

    scalar nAll = 0, volume = 0, toCome = 0, largest = 0;
    for (const kind& k : kinds_)
    {
        const scalar v = k.numbers.volume();
        nAll += k.nNow + k.nToCome;
        volume += v*(k.nNow + k.nToCome);
        toCome += v*k.nToCome;
        largest = k.nNow > 0 ? max(largest, k.numbers.d) : largest;
    }
    const bool shared = dem.group().shared();
    const scalar crowded =
        largest > 0 && !shared
      ? crowd(dem.state(), max(3*largest, meanCell_))
      : (volume - toCome)/domain_;
    const scalar gap = shared ? GREAT : smallestGap(dem.state());
    bool walls = !dem.walls().empty();
    for (const polyPatch& p : mesh.boundaryMesh())
    {
        walls = walls || isA<wallPolyPatch>(p);
    }

    lookAtBodies();
    share();
    for (kind& k : kinds_)
    {
        // A material that only walls are of may have no density
        if (!k.any())
        {
            continue;
        }
        sceneNumbers& n = k.numbers;
        n.nBodies = nAll;
        n.meanFraction = volume/domain_;
        n.fraction =
            crowded + toCome/domain_*max(nAll - 1, scalar(0))/max(nAll, 1.0);
        n.gap = gap;
        n.walls = walls;
        setContacts(k);
        finish(k);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::List<Foam::sceneNumbers> Foam::sceneSurvey::numbers() const
{
    DynamicList<sceneNumbers> all;
    for (const kind& k : kinds_)
    {
        if (k.any())
        {
            all.append(k.numbers);
        }
    }
    return List<sceneNumbers>(std::move(all));
}


// ************************************************************************* //
