/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.


\*---------------------------------------------------------------------------*/

#include "couplingInterval.H"
#include "allowedKeys.H"
#include "checkedEntry.H"
#include "volFields.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::couplingInterval::couplingInterval
(
    const fvMesh& mesh,
    const cellBins& bins,
    const dictionary& dict
)
:
    mesh_(mesh),
    bins_(bins),
    dict_(dict),
    maxCo_(0),
    thickness_(0),
    asked_(false)
{
    dem::checkKeys(dict, {"maxCo"});
    maxCo_ = dem::getPositive(dict, "maxCo");

    for (direction d = 0; d < 3; ++d)
    {
        if (mesh.solutionD()[d] < 0)
        {
            thickness_ = mesh.bounds().span()[d];
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::coupling::couplingInterval::maxDeltaT
(
    const dem::bodies& state
)
{
    asked_ = true;

    scalar least = GREAT;
    forAll(state.x, b)
    {
        const dem::shape& s = state.shapeOf(b);
        const scalar speed =
            mag(state.v[b])
          + (s.isSphere() ? 0 : mag(state.omega[b])*s.boundingRadius());

        scalar V = GREAT;
        bins_.forEach
        (
            state.x[b],
            s.boundingRadius(),
            [&](const label c)
            {
                V = min(V, mesh_.V()[c]);
            }
        );
        if (V < GREAT)
        {
            const scalar h = thickness_ > 0 ? sqrt(V/thickness_) : cbrt(V);
            least = min(least, h/max(speed, VSMALL));
        }
    }
    return maxCo_*returnReduce(least, minOp<scalar>());
}


void Foam::coupling::couplingInterval::checkAsked() const
{
    if (!asked_)
    {
        FatalIOErrorInFunction(dict_)
            << "maxCo bounds the fluid's deltaT, but this solver has not"
            << " asked for a bound: its step is fixed." << nl
            << "    Set  adjustTimeStep yes;  in controlDict, if the solver"
            << " has it (pimpleFoam, not pisoFoam or icoFoam);" << nl
            << "    otherwise take couplingInterval out and choose deltaT"
            << " yourself." << exit(FatalIOError);
    }
}


// ************************************************************************* //
