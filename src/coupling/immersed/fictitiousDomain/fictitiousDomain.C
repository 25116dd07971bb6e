/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "fictitiousDomain.H"
#include "allowedKeys.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace coupling
{
    defineTypeNameAndDebug(fictitiousDomain, 0);
    addToRunTimeSelectionTable(immersedMethod, fictitiousDomain, dictionary);
}
}


// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

//- A dictionary that does not ask for what this method cannot do. Looked at
//  before the base says what the outer correctors would need
const Foam::dictionary& checked(const Foam::dictionary& dict)
{
    using namespace Foam;

    if (dict.getOrDefault<word>("outerCorrectors", "once") == "repeat")
    {
        dem::badEntry
        (
            dict,
            "outerCorrectors",
            "asks for the force in each outer corrector, but fictitiousDomain"
            " has it after the last one; take once"
        );
    }
    return dict;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::coupling::fictitiousDomain::cellsFound()
{
    const dem::bodies& state = dem_.state();
    for (label b = 0; dem_.moves() && b < state.size(); ++b)
    {
        if (!kinds_.resolved(b) || !stable_.insert(state.id[b]))
        {
            continue;
        }
        const dem::shape& s = state.shapeOf(b);
        const addedMass added(s.volume(), s.inertiaPerDensity());
        const scalar k = cmptMax(added.mass());
        const scalar ratio =
            state.mass[b]/(rho_.uniform()*s.fluidVolume());
        if (stable(ratio, k, virtualMass_, projections_))
        {
            continue;
        }
        label enough = projections_ + 1;
        while (enough < 1000 && !stable(ratio, k, virtualMass_, enough))
        {
            ++enough;
        }
        FatalErrorInFunction
            << "Body " << state.id[b] << " (" << s.name() << ") has "
            << ratio << " of the mass and " << k << " of the added mass of"
            << " the fluid that it displaces. With fictitiousDomain and"
            << " projections " << projections_
            << " its motion swings up from step to step." << nl
            << "    Take projections " << enough << " or more, or type"
            << " implicitForcing" << exit(FatalError);
    }
}


void Foam::coupling::fictitiousDomain::setForcing(const knownFlow&)
{
    // The equation knows nothing of the bodies
    laws_.clear();
    for (auto& cells : cells_)
    {
        for (bodyCell& bc : cells)
        {
            bc.K = 0;
            bc.push = Zero;
        }
    }
}


void Foam::coupling::fictitiousDomain::findLaws(const volVectorField& U)
{
    const knownFlow flow(sides_, U);
    laws_ = cells_;
    forAll(laws_, b)
    {
        for (bodyCell& law : laws_[b])
        {
            law.push = Zero;
            setLaw(b, law, flow);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::fictitiousDomain::fictitiousDomain
(
    const immersedScene& scene,
    const dictionary& dict
)
:
    immersedMethod(scene, checked(dict)),
    projections_(dem::getLabel(dict, "projections", 1, 3))
{
    dem::checkKeys(dict, commonKeys({"projections"}));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::coupling::fictitiousDomain::stable
(
    const scalar ratio,
    const scalar added,
    const scalar C,
    const label n
)
{
    // z^3 + a z^2 + b z + c, see the header
    const scalar left = std::pow(added/(1 + added), n);
    const scalar M = ratio + C*added;
    const scalar p = (1 + added)*(1 - left) - (1 + C*added);
    const scalar q = (1 + C*added)*left;
    const scalar a = 2*p/M - left;
    const scalar b = (2*q - p)/M;
    const scalar c = -q/M;
    return
        1 + a + b + c > 0
     && 1 - a + b - c > 0
     && mag(c) < 1
     && 1 - sqr(c) > mag(a*c - b);
}


Foam::vector Foam::coupling::fictitiousDomain::force
(
    const bodyCell& law,
    const vector& free,
    const scalar dt
)
{
    return (law.K*(law.target - free) + law.push)/(1 + law.K*dt);
}



void Foam::coupling::fictitiousDomain::impose(volVectorField& U)
{
    const scalar dt = mesh_.time().deltaTValue();
    if (laws_.empty())
    {
        findLaws(U);
    }
    forAll(cells_, b)
    {
        forAll(cells_[b], k)
        {
            bodyCell& bc = cells_[b][k];
            bc.push = force(laws_[b][k], U[bc.cell] - dt*bc.push, dt);
        }
    }
    const vectorField before(source_);
    assemble();
    U.primitiveFieldRef() += dt*(source_ - before)/mesh_.V().field();
    U.correctBoundaryConditions();
}


// ************************************************************************* //
