/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "impulseError.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::impulseError::choose
(
    const packedBodies& state,
    const UList<label>& id,
    const label nIds
)
{
    // By id, so that more ranks look at the same bodies
    const label each = 1 + max(nIds - 1, label(0))/most;
    chosen_.clear();
    for (label b = 0; b < state.size(); ++b)
    {
        if (id[b] % each == 0 && state.owns(b))
        {
            chosen_.append(b);
        }
    }
}


void Foam::dem::impulseError::copy
(
    const packedBodies& state,
    List<vector>& a
)
{
    a.resize(chosen_.size());
    forAll(chosen_, i)
    {
        a[i] = state.pushed(chosen_[i]);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::impulseError::step
(
    const packedBodies& state,
    const UList<label>& id,
    const label nIds,
    const scalar h
)
{
    const label phase = nSteps_++ % every;
    if (phase > 2)
    {
        return;
    }
    if (phase == 0)
    {
        choose(state, id, nIds);
        copy(state, a0_);
        return;
    }
    if (chosen_.empty() || chosen_.last() >= state.size())
    {
        restart();
        return;
    }
    if (phase == 1)
    {
        copy(state, a1_);
        h1_ = h;
        size_ = 0;
        forAll(chosen_, i)
        {
            size_ += mag(state.acceleration(chosen_[i]) - g_);
        }
        return;
    }

    if (a1_.empty())
    {
        return;
    }
    forAll(chosen_, i)
    {
        const vector bend =
            2/(h1_ + h)
           *(
                (state.pushed(chosen_[i]) - a1_[i])/h
              - (a1_[i] - a0_[i])/h1_
            );
        error_ += h1_*h/12*mag(bend);
    }
    whole_ += size_;
    ++nSamples_;
    restart();
}


Foam::scalar Foam::dem::impulseError::value(const rankGroup& group) const
{
    const scalar whole = group.sum(whole_);
    return whole > 0 ? group.sum(error_)/whole : -1;
}


// ************************************************************************* //
