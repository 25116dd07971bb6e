/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "frictionReach.H"
#include "volFields.H"

#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::coupling::frictionReach::timeOfCell
(
    const dem::bodies& state
) const
{
    scalar thickness = 0;
    for (direction d = 0; d < 3; ++d)
    {
        if (mesh_.solutionD()[d] < 0)
        {
            thickness = mesh_.bounds().span()[d];
        }
    }
    present_.find
    (
        [&](const label b) { return state.shapeOf(b).boundingRadius(); }
    );
    const dem::bodies& here = present_();
    scalar V = GREAT;
    forAll(here.x, b)
    {
        if (kinds_.resolved(b))
        {
            bins_.forEach
            (
                here.x[b],
                here.shapeOf(b).boundingRadius(),
                [&](const label c)
                {
                    V = min(V, mesh_.V()[c]);
                }
            );
        }
    }
    V = returnReduce(V, minOp<scalar>());
    return
        V < GREAT
      ? (thickness > 0 ? V/thickness : sqr(cbrt(V)))/nu_
      : GREAT;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::frictionReach::frictionReach
(
    const fvMesh& mesh,
    const cellBins& bins,
    const bodyKinds& kinds,
    const scalar nu,
    const label nCorrectors,
    const dem::demSolver& dem
)
:
    mesh_(mesh),
    bins_(bins),
    kinds_(kinds),
    nu_(nu),
    nCorrectors_(nCorrectors),
    moves_(dem.moves()),
    present_(mesh, dem)
{}


Foam::autoPtr<Foam::coupling::frictionReach> Foam::coupling::frictionReach::New
(
    const fvMesh& mesh,
    const cellBins& bins,
    const bodyKinds& kinds,
    const scalar nu,
    const dem::demSolver& dem
)
{
    const label n = correctorsOf(mesh);
    const label nOuter =
        mesh.solutionDict().subOrEmptyDict("PIMPLE")
       .getOrDefault<label>("nOuterCorrectors", 1);
    if (!(nu > 0) || nOuter > 1 || n < 1 || largest(n, dem.moves()) >= GREAT)
    {
        return nullptr;
    }
    return autoPtr<frictionReach>
    (
        new frictionReach(mesh, bins, kinds, nu, n, dem)
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::coupling::frictionReach::correctorsOf(const fvMesh& mesh)
{
    label n = 0;
    for (const char* control : {"PISO", "PIMPLE"})
    {
        if (mesh.solutionDict().found(control))
        {
            n = mesh.solutionDict().subDict(control)
               .getOrDefault<label>("nCorrectors", 1);
        }
    }
    return n;
}


Foam::scalar Foam::coupling::frictionReach::largest
(
    const label nCorrectors,
    const bool moves
)
{
    return
        !moves && nCorrectors > 2
      ? GREAT
      : max(scalar(1), sqr((nCorrectors - 1)/1.2));
}


Foam::label Foam::coupling::frictionReach::enough(const scalar diffusion)
{
    return std::ceil(1 + 1.2*std::sqrt(diffusion));
}


Foam::scalar Foam::coupling::frictionReach::maxDeltaT
(
    const dem::bodies& state
) const
{
    const scalar cell = timeOfCell(state);
    return cell < GREAT ? largest(nCorrectors_, moves_)*cell : GREAT;
}


void Foam::coupling::frictionReach::checkFixed(const dem::bodies& state) const
{
    const scalar cell = timeOfCell(state);
    const scalar diffusion = mesh_.time().deltaTValue()/cell;
    const scalar most = largest(nCorrectors_, moves_);
    if (diffusion > 8*most)
    {
        FatalErrorInFunction
            << "In a step of " << mesh_.time().deltaTValue()
            << " s friction reaches over " << std::sqrt(diffusion)
            << " cells around bodies; with nCorrectors " << nCorrectors_
            << " the force on them grows without bounds." << nl
            << "    Take nCorrectors " << enough(diffusion) << " in "
            << mesh_.time().system() << "/fvSolution, or a step of "
            << most*cell << " s, or let the solver choose it:" << nl
            << "    adjustTimeStep yes; in controlDict, if it has that."
            << exit(FatalError);
    }
}


// ************************************************************************* //
