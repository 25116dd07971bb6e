/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "sizeLevels.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::sizeLevels::addLevels
(
    const label last,
    const scalar largest
)
{
    while (label(levels_.size()) <= last)
    {
        level grid;
        grid.radius =
            largest/std::pow(2.0, scalar(levels_.size()))*(1 + 1e-9);
        grid.perWidth = 1/(2*grid.radius + skin_);
        grid.low = labelVector::uniform(labelMax);
        grid.high = labelVector::uniform(labelMin);
        levels_.push_back(grid);
    }
}


void Foam::dem::sizeLevels::open(level& grid)
{
    if (!grid.n)
    {
        return;
    }
    scalar nCells = 1;
    for (direction d = 0; d < 3; ++d)
    {
        nCells *= scalar(grid.high[d]) - scalar(grid.low[d]) + 1;
    }
    grid.dense = nCells <= 8.0*grid.n + 1000;
    std::size_t nPlaces = 16;
    while (!grid.dense && nPlaces < std::size_t(2*grid.n))
    {
        nPlaces *= 2;
    }
    grid.begin.assign((grid.dense ? std::size_t(nCells) : nPlaces) + 1, 0);
    grid.entries.resize(grid.n);
}


void Foam::dem::sizeLevels::sum(level& grid)
{
    label sum = 0;
    for (label& b : grid.begin)
    {
        sum += b;
        b = sum;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::sizeLevels::sizeLevels
(
    const UList<point>& x,
    const UList<scalar>& r,
    const scalar skin
)
:
    sizeLevels
    (
        x.size(),
        [&](const label i) { return x[i]; },
        [&](const label i) { return r[i]; },
        skin
    )
{}


// ************************************************************************* //
