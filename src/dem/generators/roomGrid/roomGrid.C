/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "roomGrid.H"

#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::int64_t Foam::dem::roomGrid::cellOf(const scalar x, const scalar width)
{
    // Beyond, round-off is larger than a cell; a wrong cell would be no error
    // but a whole number must hold it
    return std::floor(max(min(x/width, 1e15), -1e15));
}


Foam::label Foam::dem::roomGrid::hash
(
    const std::int64_t i,
    const std::int64_t j,
    const std::int64_t k,
    const label size
)
{
    // Odd numbers with bits everywhere
    std::uint64_t h =
        std::uint64_t(i)*0x9E3779B97F4A7C15ull
      + std::uint64_t(j)*0xC2B2AE3D27D4EB4Full
      + std::uint64_t(k)*0x165667B19E3779F9ull;
    h ^= h >> 32;
    return label(h & std::uint64_t(size - 1));
}


void Foam::dem::roomGrid::link(level& l, const label i)
{
    ball& b = l.balls[i];
    label& first = l.head
    [
        hash
        (
            cellOf(b.x.x(), l.width),
            cellOf(b.x.y(), l.width),
            cellOf(b.x.z(), l.width),
            l.head.size()
        )
    ];
    b.next = first;
    first = i;
}


void Foam::dem::roomGrid::addSphere(const label sphere)
{
    int k;
    const scalar r = state_.sphereR[sphere];
    const scalar mantissa = std::frexp(r, &k);
    k -= mantissa == 0.5;

    level& l = levels_[k];
    if (l.head.empty())
    {
        l.width = std::ldexp(2.0, k);
        l.head.setSize(64, -1);
    }
    l.largest = max(l.largest, r);
    l.balls.append(ball{state_.sphereX()[sphere], r, -1});
    link(l, l.balls.size() - 1);

    // As many hashes as balls at least
    if (l.balls.size() > l.head.size())
    {
        l.head.setSize(2*l.head.size());
        l.head = -1;
        forAll(l.balls, i)
        {
            link(l, i);
        }
    }
}


bool Foam::dem::roomGrid::touches
(
    const level& l,
    const point& x,
    const scalar r
)
{
    const auto near = [&](const ball& b)
    {
        return magSqr(x - b.x) < sqr(r + b.r);
    };
    const auto nearIn =
        [&]
        (
            const std::int64_t i,
            const std::int64_t j,
            const std::int64_t k
        )
        {
            label b = l.head[hash(i, j, k, l.head.size())];
            while (b >= 0 && !near(l.balls[b]))
            {
                b = l.balls[b].next;
            }
            return b >= 0;
        };

    const scalar reach = r + l.largest;
    std::int64_t own[3], first[3], last[3];
    scalar nCells = 1;
    for (direction d = 0; d < 3; ++d)
    {
        own[d] = cellOf(x[d], l.width);
        first[d] = cellOf(x[d] - reach, l.width);
        last[d] = cellOf(x[d] + reach, l.width);
        nCells *= scalar(last[d] - first[d] + 1);
    }

    // A sphere that is large beside these balls has more cells than they are
    if (nCells > l.balls.size())
    {
        for (const ball& b : l.balls)
        {
            if (near(b))
            {
                return true;
            }
        }
        return false;
    }

    // What is touched is most often near
    if (nearIn(own[0], own[1], own[2]))
    {
        return true;
    }
    for (std::int64_t k = first[2]; k <= last[2]; ++k)
    for (std::int64_t j = first[1]; j <= last[1]; ++j)
    for (std::int64_t i = first[0]; i <= last[0]; ++i)
    {
        if (nearIn(i, j, k))
        {
            return true;
        }
    }
    return false;
}


bool Foam::dem::roomGrid::touches(const point& x, const scalar r) const
{
    for (const auto& l : levels_)
    {
        if (touches(l.second, x, r))
        {
            return true;
        }
    }
    return false;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::roomGrid::roomGrid
(
    const bodies& state,
    const wallSet& walls,
    const periodicity& period
)
:
    state_(state),
    walls_(walls),
    period_(period)
{
    forAll(state_.sphereX(), s)
    {
        addSphere(s);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::roomGrid::add(const label b)
{
    for (label s = state_.firstSphere[b]; s < state_.firstSphere[b + 1]; ++s)
    {
        addSphere(s);
    }
}


bool Foam::dem::roomGrid::hasRoom
(
    const newBody& body,
    const scalar part
) const
{
    bool room = true;
    DynamicList<label> elements;
    forEachSphere
    (
        state_.shapes()[body.shapeI],
        body,
        [&](const point& x, const scalar radius)
        {
            const scalar r = (1 - part)*radius;
            room = room && !touches(x, r);
            if (!room)
            {
                return;
            }
            period_.forEachImage
            (
                x,
                GREAT,
                [&](const label image)
                {
                    room = room && !touches(x + period_.shift(image), r);
                }
            );
            walls_.touching(x, r, elements);
            room = room && elements.empty();
        }
    );
    return room;
}


// ************************************************************************* //
