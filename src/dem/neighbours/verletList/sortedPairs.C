/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "sortedPairs.H"
#include "setFresh.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::sortedPairs::set
(
    const pairRuns& found,
    const label n
)
{
    seam_.clear();
    setFresh(begin_, n + 1);
    std::fill(begin_.begin(), begin_.end(), 0);
    found.forEach([&](const spherePair& p)
    {
        if (p.image == periodicity::original)
        {
            ++begin_[min(p.i, p.j)];
        }
        else
        {
            seam_.push_back(p);
        }
    });
    std::sort(seam_.begin(), seam_.end(), contactBlocks::before);
    const auto same = [](const spherePair& a, const spherePair& b)
    {
        return a.i == b.i && a.j == b.j && a.image == b.image;
    };
    seam_.erase(std::unique(seam_.begin(), seam_.end(), same), seam_.end());

    // Into buckets by the first sphere, in which few are left to sort
    label sum = 0;
    for (label& b : begin_)
    {
        const label count = b;
        b = sum;
        sum += count;
    }
    setFresh(j_, found.nPlain());
    found.forEach([&](const spherePair& p)
    {
        if (p.image == periodicity::original)
        {
            j_[begin_[min(p.i, p.j)]++] = max(p.i, p.j);
        }
    });

    // Where a bucket began is now where it ends
    label from = 0, to = 0;
    for (label i = 0; i < n; ++i)
    {
        const label end = begin_[i];
        std::sort(j_.begin() + from, j_.begin() + end);
        begin_[i] = to;
        for (label last = -1; from < end; ++from)
        {
            if (j_[from] != last)
            {
                last = j_[from];
                j_[to++] = last;
            }
        }
    }
    begin_[n] = to;
    j_.resize(to);
}


// ************************************************************************* //
