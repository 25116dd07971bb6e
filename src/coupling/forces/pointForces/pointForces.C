/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.


\*---------------------------------------------------------------------------*/

#include "pointForces.H"
#include "allowedKeys.H"
#include "checkedEntry.H"
#include "interpolation.H"
#include "mathematicalConstants.H"
#include "rankSum.H"
#include "Switch.H"
#include "volFields.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::pointForces::pointForces
(
    const fvMesh& mesh,
    const cellBins& bins,
    dem::demSolver& dem,
    const fluidDensity& rho,
    const dictionary& fluid,
    const dictionary& forces
)
:
    mesh_(mesh),
    bins_(bins),
    dem_(dem),
    rho_(rho),
    nu_(mesh, fluid),
    drag_(dragLaw::New(forces)),
    buoyancy_(forces.getOrDefault<Switch>("buoyancy", true)),
    interpolation_
    (
        dem::getChoice
        (
            forces,
            "interpolation",
            Foam::interpolation<vector>::dictionaryConstructorTablePtr_
          ->sortedToc(),
            "cellPoint"
        )
    )
{
    dem::checkKeys(forces, {"drag", "buoyancy", "interpolation"});

    Info<< "    forces: drag "
        << (drag_.valid() ? drag_->type() : word("none")) << ", buoyancy "
        << Switch(buoyancy_) << ", interpolation " << interpolation_ << endl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::coupling::pointForces::sample
(
    const volVectorField& U,
    const volScalarField* alpha,
    const averagedEquations equations
)
{
    dem::bodies& state = dem_.state();
    const label n = state.size();

    // The bodies of this rank. One on the boundary of two ranks is on both,
    // so that what is summed below is a mean
    DynamicList<label> mine, cells;
    List<scalar> share(n, scalar(0));
    forAll(state.x, b)
    {
        const label c = bins_.find(state.x[b]);
        if (c >= 0)
        {
            mine.append(b);
            cells.append(c);
            share[b] = 1;
        }
    }
    dem::sumOverRanks(share);

    List<vector> u(n, vector(Zero));
    List<scalar> rho(n, scalar(0));
    List<scalar> nu(n, scalar(0));
    List<scalar> voids(n, scalar(alpha ? 0 : 1));
    {
        // Decomposition of cells and point values are made by all ranks
        mesh_.tetBasePtIs();
        const auto at = Foam::interpolation<vector>::New(interpolation_, U);
        const scalarField cellNu(nu_(cells));
        forAll(mine, k)
        {
            const label b = mine[k];
            u[b] = at->interpolate(state.x[b], cells[k])/share[b];
            rho[b] = rho_[cells[k]]/share[b];
            nu[b] = cellNu[k]/share[b];
            if (alpha)
            {
                voids[b] = (*alpha)[cells[k]]/share[b];
            }
        }
    }
    dem::sumOverRanks(u);
    dem::sumOverRanks(rho);
    dem::sumOverRanks(nu);
    if (alpha)
    {
        dem::sumOverRanks(voids);
    }

    fluidVelocity_.transfer(u);
    alpha_.transfer(voids);
    ReOverSlip_.setSize(n);
    stokesRate_.setSize(n);
    forAll(state.x, b)
    {
        const dem::shape& s = state.shapeOf(b);
        const scalar d = s.equivalentDiameter();

        ReOverSlip_[b] = d/max(nu[b], VSMALL);
        stokesRate_[b] =
            3*constant::mathematical::pi*rho[b]*nu[b]*d/state.mass[b];
        if (equations == averagedEquations::B)
        {
            stokesRate_[b] /= alpha_[b];
        }
        state.fluidForce[b] =
            buoyancy_ ? -rho[b]*s.volume()*dem_.g() : vector(Zero);
        state.fluidTorque[b] = Zero;
    }
    state.drag = drag_.valid() ? this : nullptr;
}


Foam::scalar Foam::coupling::pointForces::largestRe() const
{
    const dem::bodies& state = dem_.state();

    scalar largest = 0;
    forAll(fluidVelocity_, b)
    {
        largest = max
        (
            largest,
            ReOverSlip_[b]*mag(fluidVelocity_[b] - state.v[b])
        );
    }
    return largest;
}


// ************************************************************************* //
