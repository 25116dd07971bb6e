/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "cellLaplacian.H"
#include "cyclicPolyPatch.H"
#include "processorPolyPatch.H"
#include "PstreamReduceOps.H"
#include "syncTools.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type>
void Foam::coupling::cellLaplacian::across
(
    const Field<Type>& x,
    List<Type>& other
) const
{
    if (returnReduce(coupled_.size(), sumOp<label>()))
    {
        syncTools::swapBoundaryCellList(mesh_, x, other);
    }
}


void Foam::coupling::cellLaplacian::acrossFaces(List<scalar>& values) const
{
    if (returnReduce(coupled_.size(), sumOp<label>()))
    {
        syncTools::swapBoundaryFaceList(mesh_, values);
    }
}


void Foam::coupling::cellLaplacian::findFaces()
{
    const label nInternal = mesh_.nInternalFaces();
    const vectorField& C = mesh_.cellCentres();
    const vectorField& Cf = mesh_.faceCentres();
    const vectorField& S = mesh_.faceAreas();

    // From the face to the centres on both sides, as coupled faces may be far
    // from their other side
    vectorField toOther(mesh_.nFaces(), vector(Zero));
    List<vector> swapped(mesh_.nFaces() - nInternal);
    DynamicList<label> coupled;
    for (const polyPatch& p : mesh_.boundaryMesh())
    {
        // Not by coupled(): a cyclicAMI patch says no to that
        if (!isA<coupledPolyPatch>(p))
        {
            continue;
        }
        if (!isA<processorPolyPatch>(p) && !isA<cyclicPolyPatch>(p))
        {
            FatalErrorInFunction
                << "The patch " << p.name() << " is of type " << p.type()
                << ", across which voidFraction diffusion cannot spread:"
                << " allowed are cyclic patches and those between ranks."
                << exit(FatalError);
        }
        for (label f = p.start(); f < p.start() + p.size(); ++f)
        {
            coupled.append(f);
            swapped[f - nInternal] = C[mesh_.faceOwner()[f]] - Cf[f];
        }
    }
    coupled_.transfer(coupled);
    syncTools::swapBoundaryFaceList(mesh_, swapped);

    for (label f = 0; f < nInternal; ++f)
    {
        toOther[f] = C[mesh_.faceNeighbour()[f]] - Cf[f];
    }
    for (const label f : coupled_)
    {
        toOther[f] = swapped[f - nInternal];
    }

    d_.setSize(mesh_.nFaces());
    d_ = Zero;
    conductance_.setSize(mesh_.nFaces());
    conductance_ = 0;
    scalar sine = 0;
    const auto set = [&](const label f)
    {
        d_[f] = toOther[f] - (C[mesh_.faceOwner()[f]] - Cf[f]);
        const scalar area = mag(S[f]);
        conductance_[f] = area/mag(d_[f]);
        sine = max(sine, mag(S[f] ^ d_[f])/(area*mag(d_[f])));
    };
    for (label f = 0; f < nInternal; ++f)
    {
        set(f);
    }
    for (const label f : coupled_)
    {
        set(f);
    }

    // Up to one degree the two forms differ by less than a thousandth
    orthogonal_ = returnReduce(sine, maxOp<scalar>()) < 0.0175;
    if (orthogonal_)
    {
        d_.clear();
    }
    else
    {
        findGradients();
    }
}


void Foam::coupling::cellLaplacian::findGradients()
{
    const labelUList& owner = mesh_.faceOwner();
    const labelUList& neighbour = mesh_.faceNeighbour();
    const label nInternal = mesh_.nInternalFaces();

    symmTensorField M(mesh_.nCells(), symmTensor(Zero));
    for (label f = 0; f < nInternal; ++f)
    {
        const symmTensor dd = sqr(d_[f])/magSqr(d_[f]);
        M[owner[f]] += dd;
        M[neighbour[f]] += dd;
    }
    // Nothing changes along the normal of a boundary
    for (label f = nInternal; f < mesh_.nFaces(); ++f)
    {
        const vector& S = mesh_.faceAreas()[f];
        const vector d = mag(d_[f]) > 0 ? d_[f] : S;
        M[owner[f]] += sqr(d)/max(magSqr(d), VSMALL);
    }

    const symmTensorField inverse(inv(M));
    ownG_.setSize(mesh_.nFaces());
    otherG_.setSize(nInternal);
    forAll(ownG_, f)
    {
        const vector d = d_[f]/max(magSqr(d_[f]), VSMALL);
        ownG_[f] = inverse[owner[f]] & d;
        if (f < nInternal)
        {
            otherG_[f] = -(inverse[neighbour[f]] & d);
        }
    }
}


Foam::scalar Foam::coupling::cellLaplacian::findBound() const
{
    // Gershgorin's circles of the operator between two cells
    scalarField sum(mesh_.nCells(), Zero);
    forAll(conductance_, f)
    {
        sum[mesh_.faceOwner()[f]] += conductance_[f];
        if (f < mesh_.nInternalFaces())
        {
            sum[mesh_.faceNeighbour()[f]] += conductance_[f];
        }
    }
    scalar bound = 0;
    forAll(sum, c)
    {
        bound = max(bound, 2*sum[c]/mesh_.cellVolumes()[c]);
    }
    reduce(bound, maxOp<scalar>());
    if (orthogonal_)
    {
        return bound;
    }

    // The general one: the power method, from a start that has all waves
    const scalarField& V = mesh_.cellVolumes();
    scalarField x(mesh_.nCells()), y(mesh_.nCells());
    forAll(x, c)
    {
        const vector k = mesh_.cellCentres()[c]*sqrt(bound);
        x[c] = cos(3*k.x() + 1) + cos(5*k.y() + 2) + cos(7*k.z() + 3)
          + cos(11*(k.x() + k.y() + k.z()));
    }
    scalar largest = 0;
    for (label n = 0; n < 60; ++n)
    {
        applyGeneral(x, y);
        const scalar xx = gSum(sqr(x)*V);
        const scalar yy = gSum(sqr(y)*V);
        largest = sqrt(yy/max(xx, VSMALL));
        x = y/max(sqrt(yy), VSMALL);
    }

    // From below it comes within some percent by then
    return 1.15*largest;
}


void Foam::coupling::cellLaplacian::applyOrthogonal
(
    const scalarField& x,
    scalarField& y
) const
{
    const labelUList& owner = mesh_.faceOwner();
    const labelUList& neighbour = mesh_.faceNeighbour();
    const label nInternal = mesh_.nInternalFaces();

    List<scalar> other;
    across(x, other);

    y = 0;
    for (label f = 0; f < nInternal; ++f)
    {
        const label o = owner[f], n = neighbour[f];
        const scalar flux = conductance_[f]*(x[n] - x[o]);
        y[o] -= flux;
        y[n] += flux;
    }
    for (const label f : coupled_)
    {
        const label o = owner[f];
        y[o] -= conductance_[f]*(other[f - nInternal] - x[o]);
    }
    y /= mesh_.cellVolumes();
}


Foam::vectorField Foam::coupling::cellLaplacian::slopes
(
    const scalarField& x,
    const List<scalar>& otherX
) const
{
    const labelUList& owner = mesh_.faceOwner();
    const labelUList& neighbour = mesh_.faceNeighbour();
    const label nInternal = mesh_.nInternalFaces();

    vectorField g(mesh_.nCells(), vector(Zero));
    for (label f = 0; f < nInternal; ++f)
    {
        const label o = owner[f], n = neighbour[f];
        g[o] += (x[n] - x[o])*ownG_[f];
        g[n] += (x[o] - x[n])*otherG_[f];
    }
    for (const label f : coupled_)
    {
        g[owner[f]] += (otherX[f - nInternal] - x[owner[f]])*ownG_[f];
    }
    return g;
}


Foam::vectorField Foam::coupling::cellLaplacian::gradients
(
    const scalarField& x,
    const vectorField& g
) const
{
    const labelUList& owner = mesh_.faceOwner();
    const labelUList& neighbour = mesh_.faceNeighbour();
    const vectorField& S = mesh_.faceAreas();
    const vectorField& C = mesh_.cellCentres();
    const vectorField& Cf = mesh_.faceCentres();
    const label nInternal = mesh_.nInternalFaces();

    // What either side says of a face
    const auto at = [&](const label f, const label c)
    {
        return x[c] + (g[c] & (Cf[f] - C[c]));
    };

    List<scalar> otherAt(mesh_.nFaces() - nInternal, scalar(0));
    for (const label f : coupled_)
    {
        otherAt[f - nInternal] = at(f, owner[f]);
    }
    acrossFaces(otherAt);

    vectorField G(mesh_.nCells(), vector(Zero));
    for (label f = 0; f < nInternal; ++f)
    {
        const label o = owner[f], n = neighbour[f];
        const vector flux = 0.5*(at(f, o) + at(f, n))*S[f];
        G[o] += flux;
        G[n] -= flux;
    }
    for (label f = nInternal; f < mesh_.nFaces(); ++f)
    {
        G[owner[f]] += at(f, owner[f])*S[f];
    }
    for (const label f : coupled_)
    {
        G[owner[f]] +=
            0.5*(otherAt[f - nInternal] - at(f, owner[f]))*S[f];
    }
    G /= mesh_.cellVolumes();
    return G;
}


void Foam::coupling::cellLaplacian::applyGeneral
(
    const scalarField& x,
    scalarField& y
) const
{
    const labelUList& owner = mesh_.faceOwner();
    const labelUList& neighbour = mesh_.faceNeighbour();
    const scalarField& V = mesh_.cellVolumes();
    const label nInternal = mesh_.nInternalFaces();

    List<scalar> otherX;
    across(x, otherX);
    const vectorField G(gradients(x, slopes(x, otherX)));
    List<vector> otherG;
    across(G, otherG);

    // Derivatives of the second term by the values, of both by the gradients
    y = 0;
    vectorField H(V*G);
    for (label f = 0; f < nInternal; ++f)
    {
        const label o = owner[f], n = neighbour[f];
        const scalar r =
            conductance_[f]*(x[n] - x[o] - 0.5*((G[o] + G[n]) & d_[f]));
        y[o] -= r;
        y[n] += r;
        H[o] -= 0.5*r*d_[f];
        H[n] -= 0.5*r*d_[f];
    }
    for (const label f : coupled_)
    {
        const label o = owner[f], b = f - nInternal;
        const scalar r = conductance_[f]
           *(otherX[b] - x[o] - 0.5*((G[o] + otherG[b]) & d_[f]));
        y[o] -= r;
        H[o] -= 0.5*r*d_[f];
    }
    H /= V;
    addSlopes(addGradients(H, y), y);
    y /= V;
}


Foam::vectorField Foam::coupling::cellLaplacian::addGradients
(
    const vectorField& H,
    scalarField& y
) const
{
    const labelUList& owner = mesh_.faceOwner();
    const labelUList& neighbour = mesh_.faceNeighbour();
    const vectorField& S = mesh_.faceAreas();
    const vectorField& C = mesh_.cellCentres();
    const vectorField& Cf = mesh_.faceCentres();
    const label nInternal = mesh_.nInternalFaces();

    List<scalar> otherSH(mesh_.nFaces() - nInternal, scalar(0));
    for (const label f : coupled_)
    {
        otherSH[f - nInternal] = S[f] & H[owner[f]];
    }
    acrossFaces(otherSH);

    vectorField h(mesh_.nCells(), vector(Zero));
    const auto add = [&](const label c, const label f, const scalar byFace)
    {
        y[c] += byFace;
        h[c] += byFace*(Cf[f] - C[c]);
    };
    for (label f = 0; f < nInternal; ++f)
    {
        const label o = owner[f], n = neighbour[f];
        const scalar byFace = 0.5*(S[f] & (H[o] - H[n]));
        add(o, f, byFace);
        add(n, f, byFace);
    }
    for (label f = nInternal; f < mesh_.nFaces(); ++f)
    {
        add(owner[f], f, S[f] & H[owner[f]]);
    }
    for (const label f : coupled_)
    {
        // Its area vector is the other way there
        const scalar own = S[f] & H[owner[f]];
        add(owner[f], f, 0.5*(otherSH[f - nInternal] + own) - own);
    }
    return h;
}


void Foam::coupling::cellLaplacian::addSlopes
(
    const vectorField& h,
    scalarField& y
) const
{
    const labelUList& owner = mesh_.faceOwner();
    const labelUList& neighbour = mesh_.faceNeighbour();
    const label nInternal = mesh_.nInternalFaces();

    for (label f = 0; f < nInternal; ++f)
    {
        const label o = owner[f], n = neighbour[f];
        const scalar s = (ownG_[f] & h[o]) - (otherG_[f] & h[n]);
        y[o] -= s;
        y[n] += s;
    }

    List<scalar> mine(mesh_.nFaces() - nInternal, scalar(0));
    for (const label f : coupled_)
    {
        mine[f - nInternal] = ownG_[f] & h[owner[f]];
    }
    List<scalar> other(mine);
    acrossFaces(other);
    for (const label f : coupled_)
    {
        y[owner[f]] += other[f - nInternal] - mine[f - nInternal];
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::cellLaplacian::cellLaplacian(const polyMesh& mesh)
:
    mesh_(mesh),
    orthogonal_(true),
    bound_(0)
{
    findFaces();
    bound_ = findBound();
}


// ************************************************************************* //
