/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "impulseError.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

void copyAccelerations
(
    const Foam::dem::packedBodies& state,
    Foam::List<Foam::vector>& a
)
{
    a.resize(state.size());
    forAll(a, b)
    {
        a[b] = state.acceleration(b);
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::impulseError::step(const packedBodies& state, const scalar h)
{
    const label phase = nSteps_++ % every;
    if (phase > 2)
    {
        return;
    }
    if (phase == 0)
    {
        copyAccelerations(state, a0_);
        return;
    }
    if (a0_.size() != state.size())
    {
        restart();
        return;
    }
    if (phase == 1)
    {
        copyAccelerations(state, a1_);
        h1_ = h;
        return;
    }
    if (a1_.size() != state.size())
    {
        return;
    }

    for (label b = 0; b < state.size(); ++b)
    {
        if (state.owns(b))
        {
            const vector bend =
                2/(h1_ + h)
               *((state.acceleration(b) - a1_[b])/h - (a1_[b] - a0_[b])/h1_);
            error_ += h1_*h/12*mag(bend);
            whole_ += mag(a1_[b] - g_);
        }
    }
    ++nSamples_;
    restart();
}


Foam::scalar Foam::dem::impulseError::value(const rankGroup& group) const
{
    const scalar whole = group.sum(whole_);
    return whole > 0 ? group.sum(error_)/whole : -1;
}


// ************************************************************************* //
