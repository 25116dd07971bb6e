/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "twoGridFraction.H"
#include "allowedKeys.H"
#include "checkedEntry.H"
#include "rankSum.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace coupling
{
    defineTypeNameAndDebug(twoGridFraction, 0);
    addToRunTimeSelectionTable(voidFraction, twoGridFraction, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::coupling::twoGridFraction::placed()
{
    if (box_.size() == mesh_.nCells())
    {
        return;
    }

    // All ranks number the boxes of the whole domain
    const boundBox& domain = mesh_.bounds();
    labelVector n;
    for (direction d = 0; d < 3; ++d)
    {
        const scalar width = domain.span()[d];
        n[d] = max(label(width/size_ + 0.5), 1);
    }
    if (scalar(n.x())*n.y()*n.z() > 1e8)
    {
        FatalErrorInFunction
            << "The boxes of voidFraction twoGrid, " << size_
            << " m wide, would be " << n << " along the domain." << nl
            << "    Take boxes of three diameters or more."
            << exit(FatalError);
    }

    box_.setSize(mesh_.nCells());
    volume_ = scalarList(n.x()*n.y()*n.z(), scalar(0));
    forAll(box_, c)
    {
        labelVector at;
        for (direction d = 0; d < 3; ++d)
        {
            const scalar part =
                (mesh_.cellCentres()[c][d] - domain.min()[d])
               /max(domain.span()[d], VSMALL);

            // A centre between two boxes is in the upper one, whatever its
            // last digit
            at[d] = min(max(label(part*n[d] + 1e-6), 0), n[d] - 1);
        }
        box_[c] = (at.z()*n.y() + at.y())*n.x() + at.x();
        volume_[box_[c]] += mesh_.cellVolumes()[c];
    }
    dem::sumOverRanks(volume_);
}


template<class Type>
void Foam::coupling::twoGridFraction::spreadAll
(
    const UList<Type>& q,
    Field<Type>& density
) const
{
    List<Type> sums(volume_.size(), pTraits<Type>::zero);
    forAll(balls_, i)
    {
        sums[box_[balls_[i].cell]] += q[i];
    }
    dem::sumOverRanks(sums);
    forAll(density, c)
    {
        density[c] = sums[box_[c]]/volume_[box_[c]];
    }
}


template<class Type>
void Foam::coupling::twoGridFraction::gatherAll
(
    const Field<Type>& field,
    UList<Type>& q
) const
{
    List<Type> sums(volume_.size(), pTraits<Type>::zero);
    forAll(field, c)
    {
        sums[box_[c]] += mesh_.cellVolumes()[c]*field[c];
    }
    dem::sumOverRanks(sums);
    forAll(balls_, i)
    {
        const label b = box_[balls_[i].cell];
        q[i] = sums[b]/volume_[b];
    }
}


void Foam::coupling::twoGridFraction::doSpread
(
    const UList<scalar>& q,
    scalarField& d
) const
{
    spreadAll(q, d);
}


void Foam::coupling::twoGridFraction::doSpread
(
    const UList<vector>& q,
    vectorField& d
) const
{
    spreadAll(q, d);
}


void Foam::coupling::twoGridFraction::doGather
(
    const scalarField& f,
    UList<scalar>& q
) const
{
    gatherAll(f, q);
}


void Foam::coupling::twoGridFraction::doGather
(
    const vectorField& f,
    UList<vector>& q
) const
{
    gatherAll(f, q);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::twoGridFraction::twoGridFraction
(
    const polyMesh& mesh,
    const cellBins& bins,
    const dem::periodicity& period,
    const dictionary& dict
)
:
    voidFraction(mesh, bins, period),
    size_(dem::getPositive(dict, "boxSize"))
{
    dem::checkKeys(dict, commonKeys({"boxSize"}));
}


// ************************************************************************* //
