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
        a[i] =
            inStages_
          ? state.acceleration(chosen_[i])
          : state.pushed(chosen_[i]);
    }
}


Foam::scalar Foam::dem::impulseError::off
(
    const packedBodies& state,
    const label i,
    const scalar h
) const
{
    const label b = chosen_[i];
    if (!inStages_)
    {
        const vector bend =
            2/(h1_ + h)*((state.pushed(b) - a1_[i])/h - (a1_[i] - a0_[i])/h1_);
        return h1_*h/12*mag(bend);
    }
    const scalar both = h1_ + h;
    const vector mean =
    (
        (2 - h/h1_)*a0_[i]
      + sqr(both)/(h1_*h)*a1_[i]
      + (2 - h1_/h)*state.acceleration(b)
    )/6;
    return mag((state.velocity(b) - v0_[i])/both - mean);
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
        if (inStages_)
        {
            v0_.resize(chosen_.size());
            forAll(chosen_, i)
            {
                v0_[i] = state.velocity(chosen_[i]);
            }
        }
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
        error_ += off(state, i, h);
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
