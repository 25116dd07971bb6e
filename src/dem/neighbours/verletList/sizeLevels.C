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

void Foam::dem::sizeLevels::sort(level& grid)
{
    const label n = label(grid.entries.size());
    if (!n)
    {
        return;
    }
    grid.low = labelVector::uniform(labelMax);
    grid.high = labelVector::uniform(labelMin);
    for (const entry& e : grid.entries)
    {
        const labelVector c
        (
            gridIndex(e.x*grid.perWidth),
            gridIndex(e.y*grid.perWidth),
            gridIndex(e.z*grid.perWidth)
        );
        grid.low = min(grid.low, c);
        grid.high = max(grid.high, c);
    }
    scalar nCells = 1;
    for (direction d = 0; d < 3; ++d)
    {
        nCells *= scalar(grid.high[d]) - scalar(grid.low[d]) + 1;
    }
    grid.dense = nCells <= 8.0*n + 1000;
    std::size_t nPlaces = 16;
    while (!grid.dense && nPlaces < std::size_t(2*n))
    {
        nPlaces *= 2;
    }
    grid.begin.assign((grid.dense ? std::size_t(nCells) : nPlaces) + 1, 0);

    // Backwards into their places, so that each has them in the order of
    // their numbers
    for (const entry& e : grid.entries)
    {
        ++grid.begin[place(grid, e)];
    }
    label sum = 0;
    for (label& b : grid.begin)
    {
        sum += b;
        b = sum;
    }
    std::vector<entry> sorted(n);
    for (label k = n - 1; k >= 0; --k)
    {
        sorted[--grid.begin[place(grid, grid.entries[k])]] = grid.entries[k];
    }
    grid.entries.swap(sorted);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::sizeLevels::sizeLevels
(
    const UList<point>& x,
    const UList<scalar>& r,
    const scalar skin
)
:
    skin_(skin)
{
    const scalar rMax = max(r);
    forAll(x, i)
    {
        const std::size_t l(std::floor(std::log2(rMax/r[i]) + 1e-9));
        while (levels_.size() <= l)
        {
            level grid;
            grid.radius =
                rMax/std::pow(2.0, scalar(levels_.size()))*(1 + 1e-9);
            grid.perWidth = 1/(2*grid.radius + skin_);
            levels_.push_back(grid);
        }
        levels_[l].entries.push_back
        (
            entry{x[i].x(), x[i].y(), x[i].z(), r[i], i}
        );
    }
    for (level& grid : levels_)
    {
        sort(grid);
    }
}


// ************************************************************************* //
