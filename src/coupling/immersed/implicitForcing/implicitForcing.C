/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "implicitForcing.H"
#include "allowedKeys.H"
#include "checkedEntry.H"
#include "rankSum.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::coupling::implicitForcing::findCells(const label b)
{
    const dem::bodies& state = dem_.state();
    const bodyGeometry body(state, b, solved_);
    DynamicList<bodyCell>& cells = cells_[b];
    cells.clear();

    bins_.forEach
    (
        state.x[b],
        state.shapeOf(b).boundingRadius(),
        [&](const label c)
        {
            const scalar beta = fraction_(body, c, bins_.radius(c));
            if (beta > 0)
            {
                cells.append(bodyCell{c, beta, Zero});
            }
        }
    );
}


Foam::vector Foam::coupling::implicitForcing::profileTarget
(
    const label b,
    const bodyCell& bc,
    const volVectorField& U,
    const List<otherSide>& others
) const
{
    const dem::bodies& state = dem_.state();
    const bodyGeometry body(state, b, solved_);
    const point& centre = mesh_.C()[bc.cell];
    const vector Ub =
        imposed_[b].v + (imposed_[b].omega ^ (centre - state.x[b]));

    const scalar phi = body.distance(centre);
    const vector r = body.fromNearestCentre(centre);
    const vector n = r/max(mag(r), VSMALL);

    vector sum(Zero);
    scalar weights = 0;

    for (const label f : mesh_.cells()[bc.cell])
    {
        // Centre and velocity of the cell on the other side
        point other;
        vector Uf;
        if (mesh_.isInternalFace(f))
        {
            const label c =
                mesh_.faceOwner()[f] == bc.cell
              ? mesh_.faceNeighbour()[f]
              : mesh_.faceOwner()[f];
            other = mesh_.C()[c];
            Uf = U[c];
        }
        else
        {
            const label patchI = mesh_.boundaryMesh().whichPatch(f);
            if (others[patchI].U.empty())
            {
                continue;
            }
            const label k = f - mesh_.boundaryMesh()[patchI].start();
            other = centre + others[patchI].delta[k];
            Uf = others[patchI].U[k];
        }

        const vector d = body.inPlane(other - centre);
        const scalar cosine = (d & n)/max(mag(d), VSMALL);
        const scalar phif = body.distance(other);
        if (cosine < 0.1 || phif < 0.1*mag(d))
        {
            continue;
        }

        const scalar w = sqr(cosine);
        weights += w;
        sum += w*max(min(phi/phif, scalar(1)), scalar(-1))*(Uf - Ub);
    }

    return weights > 0 ? Ub + sum/weights : Ub;
}


void Foam::coupling::implicitForcing::setTargets
(
    const label b,
    const volVectorField& U,
    const List<otherSide>& others
)
{
    const dem::bodies& state = dem_.state();

    for (bodyCell& bc : cells_[b])
    {
        if (bc.beta < 1)
        {
            bc.target = profileTarget(b, bc, U, others);
        }
        else
        {
            const vector r = mesh_.C()[bc.cell] - state.x[b];
            bc.target = imposed_[b].v + (imposed_[b].omega ^ r);
        }
    }
}


void Foam::coupling::implicitForcing::checkScheme() const
{
    const word scheme
    (
        mesh_.ddtScheme("ddt(U)")
    );
    if (dem_.moves() && scheme != "Euler")
    {
        FatalErrorInFunction
            << "Bodies that move need ddtSchemes { default Euler; } in "
            << mesh_.thisDb().time().system() << "/fvSchemes, not " << scheme
            << "." << nl
            << "    With backward and CrankNicolson the motion of a body is"
            << " not stable." << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::implicitForcing::implicitForcing
(
    const fvMesh& mesh,
    const cellBins& bins,
    dem::demSolver& dem,
    const scalar rho,
    const dictionary& dict
)
:
    mesh_(mesh),
    bins_(bins),
    dem_(dem),
    rho_(rho),
    kappa_(1000),
    virtualMass_(0.5),
    solved_(vector::one),
    fraction_(mesh),
    volumeError_(0),
    slip_(0)
{
    dem::checkKeys(dict, {"type", "kappa", "virtualMass"});
    dem::getChoice(dict, "type", {"implicitForcing"});
    kappa_ = dem::getPositive(dict, "kappa", 1000);
    virtualMass_ = dem::getInRange(dict, "virtualMass", 0, 2, 0.5);

    for (direction d = 0; d < 3; ++d)
    {
        solved_[d] = mesh.solutionD()[d] > 0 ? 1 : 0;
    }

    checkScheme();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::coupling::implicitForcing::project(const volVectorField& U)
{
    const dem::bodies& state = dem_.state();
    const label n = state.size();

    cells_.setSize(n);
    imposed_.setSize(n);
    List<scalar> volume(n, scalar(0));

    for (label b = 0; b < n; ++b)
    {
        findCells(b);
        imposed_[b] = imposedMotion{state.v[b], state.omega[b]};
        for (const bodyCell& bc : cells_[b])
        {
            volume[b] += bc.beta*mesh_.V()[bc.cell];
        }
    }

    dem::sumOverRanks(volume);
    volumeError_ = 0;
    if (solved_ == vector::one)
    {
        forAll(volume, b)
        {
            const scalar exact = state.shapeOf(b).unionVolume();
            volumeError_ = max(volumeError_, mag(volume[b]/exact - 1));
        }
    }

    startImposed(U);
}


void Foam::coupling::implicitForcing::addTo(fvMatrix<vector>& eqn)
{
    const volVectorField& U = eqn.psi();

    // Values across processor and cyclic patches
    List<otherSide> others(mesh_.boundary().size());
    forAll(others, p)
    {
        if (mesh_.boundary()[p].coupled())
        {
            others[p].U = U.boundaryField()[p].patchNeighbourField();
            others[p].delta = mesh_.boundary()[p].delta();
        }
    }

    diagonal_.setSize(mesh_.nCells());
    diagonal_ = 0;
    source_.setSize(mesh_.nCells());
    source_ = vector(Zero);

    forAll(cells_, b)
    {
        setTargets(b, U, others);
        for (const bodyCell& bc : cells_[b])
        {
            const scalar KV = rate()*bc.beta*mesh_.V()[bc.cell];
            diagonal_[bc.cell] += KV;
            source_[bc.cell] += KV*bc.target;
        }
    }

    // The solver subtracts eqn from its own equation
    eqn.diag() -= diagonal_;
    eqn.source() -= source_;
}


void Foam::coupling::implicitForcing::sumForces(const volVectorField& U)
{
    const dem::bodies& state = dem_.state();

    force_.setSize(state.size());
    torque_.setSize(state.size());

    forAll(cells_, b)
    {
        vector F(Zero);
        vector T(Zero);
        for (const bodyCell& bc : cells_[b])
        {
            const vector f =
                (rho_*rate()*bc.beta*mesh_.V()[bc.cell])
               *(U[bc.cell] - bc.target);
            F += f;
            T += (mesh_.C()[bc.cell] - state.x[b]) ^ f;
        }
        force_[b] = F;
        torque_[b] = T;
    }

    dem::sumOverRanks(force_);
    dem::sumOverRanks(torque_);
}


Foam::vector Foam::coupling::implicitForcing::forceOnFluid
(
    const volVectorField& U
) const
{
    vector F(Zero);
    forAll(source_, c)
    {
        if (diagonal_[c] > 0)
        {
            F += source_[c] - diagonal_[c]*U[c];
        }
    }
    return rho_*returnReduce(F, sumOp<vector>());
}


Foam::vector Foam::coupling::implicitForcing::forceOnBodies() const
{
    return sum(force_);
}


// ************************************************************************* //
