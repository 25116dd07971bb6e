/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "sizeLevels.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::sizeLevels::sizeLevels
(
    const UList<point>& x,
    const UList<scalar>& r,
    const scalar skin
)
:
    x_(x),
    r_(r),
    skin_(skin),
    levelOf_(x.size()),
    next_(x.size(), -1),
    cell_(x.size())
{
    const scalar rMax = max(r);

    forAll(x, i)
    {
        const label l = label(std::floor(std::log2(rMax/r[i]) + 1e-9));
        levelOf_[i] = l;

        for (label k = levels_.size(); k <= l; ++k)
        {
            level grid;
            grid.radius = rMax/std::pow(2.0, scalar(k))*(1 + 1e-9);
            grid.width = 2*grid.radius + skin_;
            levels_.append(grid);
        }
        ++levels_[l].n;
    }

    for (level& grid : levels_)
    {
        label size = 16;
        while (size < 2*grid.n)
        {
            size *= 2;
        }
        grid.head.setSize(grid.n ? size : 0, -1);
    }

    // Backwards, so that each bucket lists its spheres in rising order
    for (label i = x.size() - 1; i >= 0; --i)
    {
        level& grid = levels_[levelOf_[i]];
        cell_[i] = gridCell(x[i], grid.width);
        label& head = grid.head[bucket(cell_[i], grid.head.size())];
        next_[i] = head;
        head = i;
    }
}


// ************************************************************************* //
