/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "weightedFraction.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::coupling::weightedFraction::placed()
{
    visitors_.find
    (
        mesh_,
        period_,
        balls_,
        [this](const cellBall& ball) { return reach(ball); }
    );

    const List<cellBall> guests(visitors_.visitors());
    const label nOwn = balls_.size();
    const label n = nOwn + guests.size();
    start_.setSize(n + 1);
    cells_.clear();
    weights_.clear();
    scalarList sums(n, scalar(0));
    for (label i = 0; i < n; ++i)
    {
        start_[i] = cells_.size();
        weigh(i < nOwn ? balls_[i] : guests[i - nOwn], cells_, weights_);
        if (i < nOwn)
        {
            holdOwn(i);
        }
        for (label k = start_[i]; k < cells_.size(); ++k)
        {
            sums[i] += weights_[k];
        }
    }
    start_[n] = cells_.size();

    List<scalar> whole(SubList<scalar>(sums, nOwn));
    visitors_.collect(SubList<scalar>(sums, n - nOwn, nOwn), whole);
    const List<scalar> guestsWhole(visitors_.send(whole));
    for (label i = 0; i < n; ++i)
    {
        const scalar all = i < nOwn ? whole[i] : guestsWhole[i - nOwn];
        for (label k = start_[i]; k < start_[i + 1]; ++k)
        {
            weights_[k] /= max(all, VSMALL);
        }
    }
}


void Foam::coupling::weightedFraction::holdOwn(const label i)
{
    // Far below any weight that counts
    const label c = balls_[i].cell;
    const scalar least = ROOTVSMALL*mesh_.cellVolumes()[c];
    for (label k = start_[i]; k < cells_.size(); ++k)
    {
        if (cells_[k] == c)
        {
            weights_[k] = max(weights_[k], least);
            return;
        }
    }
    cells_.append(c);
    weights_.append(least);
}


template<class Type>
void Foam::coupling::weightedFraction::spreadAll
(
    const UList<Type>& q,
    Field<Type>& density
) const
{
    const List<Type> guests(visitors_.send(q));
    for (label i = 0; i < start_.size() - 1; ++i)
    {
        const Type& qi = i < q.size() ? q[i] : guests[i - q.size()];
        for (label k = start_[i]; k < start_[i + 1]; ++k)
        {
            const label c = cells_[k];
            density[c] += weights_[k]*qi/mesh_.cellVolumes()[c];
        }
    }
}


template<class Type>
void Foam::coupling::weightedFraction::gatherAll
(
    const Field<Type>& field,
    UList<Type>& q
) const
{
    List<Type> seen(start_.size() - 1, pTraits<Type>::zero);
    forAll(seen, i)
    {
        for (label k = start_[i]; k < start_[i + 1]; ++k)
        {
            seen[i] += weights_[k]*field[cells_[k]];
        }
    }
    forAll(q, i)
    {
        q[i] = seen[i];
    }
    visitors_.collect
    (
        SubList<Type>(seen, seen.size() - q.size(), q.size()),
        q
    );
}


void Foam::coupling::weightedFraction::doSpread
(
    const UList<scalar>& q,
    scalarField& d
) const
{
    spreadAll(q, d);
}


void Foam::coupling::weightedFraction::doSpread
(
    const UList<vector>& q,
    vectorField& d
) const
{
    spreadAll(q, d);
}


void Foam::coupling::weightedFraction::doGather
(
    const scalarField& f,
    UList<scalar>& q
) const
{
    gatherAll(f, q);
}


void Foam::coupling::weightedFraction::doGather
(
    const vectorField& f,
    UList<vector>& q
) const
{
    gatherAll(f, q);
}


// ************************************************************************* //
