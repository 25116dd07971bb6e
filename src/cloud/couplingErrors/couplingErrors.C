/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Function

\*---------------------------------------------------------------------------*/

#include "couplingErrors.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::couplingErrors::exchanged
(
    const dem::bodies& state,
    const coupling::pointForces& points
)
{
    const label phase = nExchanges_++ % every;
    if (phase > 1)
    {
        return;
    }

    // By id, so that more ranks look at the same bodies
    const label each = 1 + max(state.nextId() - 1, label(0))/most;
    forAll(state.x, b)
    {
        const label id = state.id[b];
        if (id % each != 0)
        {
            continue;
        }
        const vector F =
            state.fluidForce[b]
          + points.dragCoefficient(b)
           *(points.fluidVelocity(b) - state.v[b]);
        if (phase == 0)
        {
            forces_.set(id, F);
        }
        else if (forces_.found(id))
        {
            const vector& before = forces_[id];
            change_ += magSqr(F - before);
            size_ += 0.5*(magSqr(F) + magSqr(before));
        }
    }
    if (phase == 1)
    {
        forces_.clear();
    }
}


Foam::Pair<Foam::scalar> Foam::couplingErrors::moved
(
    const volScalarField& alpha,
    const coupling::voidFraction& spread
)
{
    const fvMesh& mesh = alpha.mesh();
    const scalarField& V = mesh.V();

    // Of x as of alpha, but for the sign
    scalarField flux(mesh.nCells(), 0);
    const surfaceScalarField& magSf = mesh.magSf();
    const surfaceScalarField& inverse = mesh.deltaCoeffs();
    forAll(mesh.owner(), f)
    {
        const label P = mesh.owner()[f], N = mesh.neighbour()[f];
        const scalar q = magSf[f]*inverse[f]*(alpha[N] - alpha[P]);
        flux[P] += q;
        flux[N] -= q;
    }
    forAll(mesh.boundary(), p)
    {
        const fvPatchScalarField& here = alpha.boundaryField()[p];
        if (!here.coupled())
        {
            continue;
        }
        const scalarField other(here.patchNeighbourField());
        const labelUList& cells = here.patch().faceCells();
        forAll(cells, f)
        {
            flux[cells[f]] +=
                magSf.boundaryField()[p][f]*inverse.boundaryField()[p][f]
               *(other[f] - alpha[cells[f]]);
        }
    }

    Pair<scalar> sums(0, 0);
    forAll(flux, c)
    {
        if (flux[c] != 0)
        {
            sums.first() += 0.5*spread.width(c)*mag(flux[c]);
        }
        sums.second() += V[c]*(1 - alpha[c]);
    }
    return sums;
}


void Foam::couplingErrors::averaged
(
    const volScalarField& alpha,
    const coupling::voidFraction& spread
)
{
    if (nAveraged_++ % every == 0)
    {
        const Pair<scalar> sums(moved(alpha, spread));
        moved_ += sums.first();
        averaged_ += sums.second();
    }
}


void Foam::couplingErrors::note(ledger& book) const
{
    const scalar size = returnReduce(size_, sumOp<scalar>());
    const scalar change = returnReduce(change_, sumOp<scalar>());
    book.setError
    (
        "errorSeen",
        "forces on points",
        size > 0 ? 0.5*sqrt(change/size) : -1,
        "held between exchanges: half of their change"
    );
    const scalar all = returnReduce(averaged_, sumOp<scalar>());
    const scalar part = returnReduce(moved_, sumOp<scalar>());
    book.setError
    (
        "errorSeen",
        "bandwidth of the averaging",
        all > 0 ? part/all : -1,
        "of the solids, what averaging once more would move"
    );
}


// ************************************************************************* //
