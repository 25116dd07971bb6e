/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "placement.H"
#include "areMany.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// By so much of their way half as long numbers are off, at most
constexpr float roundOff = 2e-7f;

} // End anonymous namespace


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
    const std::size_t all = 3*std::size_t(n);
    if (areMany(n))
    {
        inGroup.resize(all);
        first.resize(3*(std::size_t(n)/nInGroup + 1));
        std::vector<float> off(n);
        float most = 0;
        for (label s = 0; s < n; ++s)
        {
            const point c(state.centre(s));
            scalar* const begin = first.data() + 3*(s/nInGroup);
            for (direction d = 0; d < 3; ++d)
            {
                if (s % nInGroup == 0)
                {
                    begin[d] = c[d];
                }
                inGroup[s + d*std::size_t(n)] = float(c[d] - begin[d]);
            }
            off[s] = roundOff*mag(c - point(begin[0], begin[1], begin[2]));
            most = max(most, off[s]);
        }
        if (most < 0.01*left)
        {
            for (label s = 0; s < n; ++s)
            {
                allowed[s] -= off[s];
            }
            left -= most;
            return;
        }
        freePlaces();
    }

    x.resize(all);
    for (label s = 0; s < n; ++s)
    {
        const point c(state.centre(s));
        x[s] = c.x();
        x[s + n] = c.y();
        x[s + 2*n] = c.z();
    }
}


Foam::point Foam::dem::placement::place(const label s) const
{
    const std::size_t n = allowed.size();
    if (!x.empty())
    {
        return point(x[s], x[s + n], x[s + 2*n]);
    }
    const scalar* const begin = first.data() + 3*(s/nInGroup);
    return point
    (
        begin[0] + scalar(inGroup[s]),
        begin[1] + scalar(inGroup[s + n]),
        begin[2] + scalar(inGroup[s + 2*n])
    );
}


void Foam::dem::placement::freePlaces()
{
    std::vector<scalar>().swap(x);
    std::vector<scalar>().swap(first);
    std::vector<float>().swap(inGroup);
}


void Foam::dem::placement::setPlaces
(
    const packedBodies& state,
    const placement& sooner
)
{
    const label n = state.nSpheres();
    offset.resize(3*std::size_t(n));
    float most = 0;
    for (label s = 0; s < n; ++s)
    {
        const float off = roundOff*sooner.allowed[s];
        allowed[s] -= off;
        most = max(most, off);
        const vector way(state.centre(s) - sooner.place(s));
        offset[s] = float(way.x());
        offset[s + n] = float(way.y());
        offset[s + 2*n] = float(way.z());
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
        const bool grouped = sooner.x.empty();
        left = state.wayLeft
        (
            placesBefore
            {
                grouped ? nullptr : sooner.x.data(),
                grouped ? sooner.inGroup.data() : nullptr,
                grouped ? sooner.first.data() : nullptr,
                offset.empty() ? nullptr : offset.data(),
                allowed.data()
            }
        );
        moved = 0;
    }

    // To look at all again in a few steps costs more than the way that is left
    return left < least;
}


// ************************************************************************* //
