/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "rungeKutta.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(rungeKutta, 0);
    addNamedToRunTimeSelectionTable
        (integrator, rungeKutta, word, explicitEuler);
    addNamedToRunTimeSelectionTable(integrator, rungeKutta, word, rk4);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::rungeKutta::rungeKutta(const word& name)
{
    if (name == "explicitEuler")
    {
        a_ = {{}};
        b_ = {1};
        order_ = 1;
    }
    else
    {
        const scalar third = 1.0/3;
        a_ = {{}, {third}, {-third, 1}, {1, -1, 1}};
        b_ = {0.125, 0.375, 0.375, 0.125};
        order_ = 4;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::rungeKutta::step
(
    packedBodies& state,
    const scalar t,
    const scalar dt,
    const bool,
    const forces& force
) const
{
    state.keep();

    std::vector<packedBodies::slope> K(b_.size());
    const auto moveBy = [&](const scalarList& parts)
    {
        std::vector<std::pair<scalar, const packedBodies::slope*>> terms;
        forAll(parts, j)
        {
            terms.emplace_back(parts[j]*dt, &K[j]);
        }
        state.moveBy(terms);
        const scalar part = sum(parts);
        force(t + part*dt, part*dt);
    };

    K[0] = state.slopes();
    for (label i = 1; i < b_.size(); ++i)
    {
        moveBy(a_[i]);
        K[i] = state.slopes();
    }
    moveBy(b_);
}

// ************************************************************************* //
