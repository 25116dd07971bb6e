/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "packingLimit.H"
#include "checkedEntry.H"
#include "cyclicPolyPatch.H"
#include "processorPolyPatch.H"
#include "PstreamReduceOps.H"
#include "syncTools.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Move the excess of each cell to its neighbours once
void moveExcess
(
    const polyMesh& mesh,
    const scalarField& capacity,
    const List<scalar>& otherCapacity,
    const scalarField& excess,
    scalarField& solids
)
{
    const labelUList& owner = mesh.faceOwner();
    const labelUList& neighbour = mesh.faceNeighbour();
    const label nInternal = mesh.nInternalFaces();
    List<scalar> other;
    syncTools::swapBoundaryCellList(mesh, excess, other);

    const scalarField& V = mesh.cellVolumes();
    for (label f = 0; f < nInternal; ++f)
    {
        const label o = owner[f], n = neighbour[f];
        const scalar flux =
            0.5*min(capacity[o], capacity[n])*(excess[o] - excess[n]);
        solids[o] -= flux/V[o];
        solids[n] += flux/V[n];
    }
    for (const polyPatch& p : mesh.boundaryMesh())
    {
        if (!isA<processorPolyPatch>(p) && !isA<cyclicPolyPatch>(p))
        {
            continue;
        }
        for (label f = p.start(); f < p.start() + p.size(); ++f)
        {
            const label o = owner[f], b = f - nInternal;
            solids[o] -= 0.5*min(capacity[o], otherCapacity[b])
               *(excess[o] - other[b])/V[o];
        }
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::packingLimit::packingLimit(const dictionary& dict)
:
    dict_(dict),
    limit_(dem::getInRange(dict, "maxPacking", 0.1, 0.999, 0.7405))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::coupling::packingLimit::report Foam::coupling::packingLimit::apply
(
    const polyMesh& mesh,
    scalarField& solids
) const
{
    // The last digits of a cell that is full are no excess
    const scalar full = limit_*(1 + 1e-9);
    report done;
    forAll(solids, c)
    {
        if (solids[c] > full)
        {
            done.excess += (solids[c] - limit_)*mesh.cellVolumes()[c];
            ++done.nCells;
        }
    }
    reduce(done.nCells, sumOp<label>());
    if (!done.nCells)
    {
        return done;
    }
    reduce(done.excess, sumOp<scalar>());

    const scalar all = gSum(mesh.cellVolumes()*solids);
    const scalar room = limit_*gSum(mesh.cellVolumes());
    if (all > 0.999*room)
    {
        FatalIOErrorInFunction(dict_)
            << "The bodies have " << all << " m3, the mesh has room for "
            << room << " m3 at a packing of " << limit_ << "." << nl
            << "    Are there too many of them, or is the limit maxPacking of"
            << " voidFraction too low?" << exit(FatalIOError);
    }

    scalarField capacity(mesh.nCells());
    forAll(capacity, c)
    {
        capacity[c] = mesh.cellVolumes()[c]/mesh.cells()[c].size();
    }
    List<scalar> otherCapacity;
    syncTools::swapBoundaryCellList(mesh, capacity, otherCapacity);

    scalarField excess(mesh.nCells());
    scalar worst = GREAT, before = GREAT;
    for (label n = 1; worst > full - limit_; ++n)
    {
        excess = max(solids - limit_, scalar(0));
        worst = gMax(excess);
        moveExcess(mesh, capacity, otherCapacity, excess, solids);

        // The largest excess never grows; where it no longer falls the room
        // is behind a wall, and this would go on for ever
        if (n % 1000 == 0)
        {
            if (worst > (1 - 1e-9)*before)
            {
                FatalIOErrorInFunction(dict_)
                    << "A part of the mesh that walls cut off from the rest"
                    << " has more bodies than room: it is full of them to "
                    << limit_ + worst << ", and maxPacking of voidFraction is "
                    << limit_ << '.' << nl
                    << "    Are there too many of them in it, or is that limit"
                    << " too low?" << exit(FatalIOError);
            }
            before = worst;
        }
    }
    return done;
}


// ************************************************************************* //
