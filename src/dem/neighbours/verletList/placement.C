/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "placement.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::placement::start
(
    const packedBodies& state,
    const scalar distance,
    const scalar part,
    const scalar worth
)
{
    const label n = state.nSpheres();
    scalar fastest = VSMALL;
    for (label s = 0; s < n; ++s)
    {
        fastest = max(fastest, state.speed(s));
    }
    constexpr scalar down = 1 - 1e-6;
    allowed.resize(n);
    for (label s = 0; s < n; ++s)
    {
        allowed[s] = float
        (
            down*distance*(part + (1 - part)*state.speed(s)/fastest)
        );
    }

    moved = 0;
    left = down*part*distance;
    least = worth*part*distance;
}


void Foam::dem::placement::setPlaces(const packedBodies& state)
{
    const label n = state.nSpheres();
    x.resize(3*std::size_t(n));
    for (label s = 0; s < n; ++s)
    {
        const point c(state.centre(s));
        x[s] = c.x();
        x[s + n] = c.y();
        x[s + 2*n] = c.z();
    }
}


void Foam::dem::placement::setPlaces
(
    const packedBodies& state,
    const placement& sooner
)
{
    // By so much of their way places are off, at most
    constexpr float roundOff = 2e-7f;
    const label n = state.nSpheres();
    offset.resize(3*std::size_t(n));
    float most = 0;
    for (label s = 0; s < n; ++s)
    {
        const float off = roundOff*sooner.allowed[s];
        allowed[s] -= off;
        most = max(most, off);
        const point c(state.centre(s));
        offset[s] = float(c.x() - sooner.x[s]);
        offset[s + n] = float(c.y() - sooner.x[s + n]);
        offset[s + 2*n] = float(c.z() - sooner.x[s + 2*n]);
    }
    left -= most;
}


bool Foam::dem::placement::over
(
    const packedBodies& state,
    const placement& sooner
)
{
    if (moved > left)
    {
        // The bound is used up: how far have they really moved?
        left = state.wayLeft
        (
            sooner.x.data(),
            offset.empty() ? nullptr : offset.data(),
            allowed.data()
        );
        moved = 0;
    }

    // To look at all again in a few steps costs more than the way that is left
    return left < least;
}


// ************************************************************************* //
