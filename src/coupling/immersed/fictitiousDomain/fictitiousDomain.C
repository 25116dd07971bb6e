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

    if (dict.getOrDefault<word>("outerCorrectors", "once") != "once")
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

void Foam::coupling::fictitiousDomain::setForcing(const knownFlow&)
{
    // The equation knows nothing of the bodies
    for (auto& cells : cells_)
    {
        for (bodyCell& bc : cells)
        {
            bc.K = 0;
            bc.push = Zero;
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
    immersedMethod(scene, checked(dict))
{
    dem::checkKeys(dict, commonKeys({}));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::coupling::fictitiousDomain::impose(volVectorField& U)
{
    const scalar dt = mesh_.time().deltaTValue();
    {
        const knownFlow flow(sides_, U);
        forAll(cells_, b)
        {
            for (bodyCell& bc : cells_[b])
            {
                bodyCell law(bc);
                law.push = Zero;
                setLaw(b, law, flow);
                bc.push =
                    (law.K*(law.target - U[bc.cell]) + law.push)
                   /(1 + law.K*dt);
            }
        }
    }
    assemble();
    U.primitiveFieldRef() += dt*source_/mesh_.V().field();
    U.correctBoundaryConditions();
}


// ************************************************************************* //
