/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "verletList.H"
#include "sizeLevels.H"

#include <algorithm>

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

//- Is a pair within its own reach? That follows from the effective radius R*,
//  so that small spheres do not have all those around them that a large one
//  would reach
inline bool within
(
    const Foam::vector& d,
    const Foam::scalar allowed,
    const Foam::scalar a,
    const Foam::scalar b,
    const Foam::scalar least,
    const Foam::scalar perRadius
)
{
    using namespace Foam;
    return magSqr(d) < sqr(allowed + max(least, perRadius*a*b/(a + b)));
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::verletList::search(const packedBodies& state)
{
    pairs_.clear();
    const label n = state.nSpheres();
    if (n < 2 || !meets_)
    {
        return;
    }
    if (periodic())
    {
        searchImages(state);
        return;
    }

    scalarList r(n);
    for (label s = 0; s < n; ++s)
    {
        r[s] = state.radius(s) + far_.allowed[s];
    }
    sizeLevels(far_.x, r, reach_).forEachPair
    (
        [&](const label i, const label j)
        {
            const bool near =
                !reaches()
             || within
                (
                    far_.x[i] - far_.x[j], r[i] + r[j],
                    state.radius(i), state.radius(j),
                    leastReach_, reachPerRadius_
                );
            if (near && state.mayTouch(state.bodyOf(i), state.bodyOf(j)))
            {
                pairs_.push_back(spherePair(min(i, j), max(i, j)));
            }
        }
    );
}


void Foam::dem::verletList::searchImages(const packedBodies& state)
{
    const label n = state.nSpheres();

    // The spheres, and behind them the images of those near a seam
    DynamicList<point> x(far_.x);
    DynamicList<scalar> r(n);
    DynamicList<label> source(identity(n));
    DynamicList<label> image(labelList(n, label(periodicity::original)));

    scalar overhang = 0;
    for (label s = 0; s < n; ++s)
    {
        r.append(state.radius(s) + far_.allowed[s]);
        overhang = max(overhang, period_.overhang(x[s], r[s]));
    }
    for (label s = 0; s < n; ++s)
    {
        const scalar radius = r[s];
        period_.forEachImage
        (
            far_.x[s],
            radius + reach_ + overhang,
            [&](const label m)
            {
                x.append(far_.x[s] + period_.shift(m));
                r.append(radius);
                source.append(s);
                image.append(m);
            }
        );
    }

    sizeLevels(x, r, reach_).forEachPair
    (
        [&](label i, label j)
        {
            // A pair through a seam is found twice, from either side: it is
            // taken where the lower sphere is the original
            if (source[i] > source[j])
            {
                Swap(i, j);
            }
            const label a = source[i], b = source[j];
            const bool near =
                !reaches()
             || within
                (
                    x[i] - x[j], r[i] + r[j], state.radius(a),
                    state.radius(b), leastReach_, reachPerRadius_
                );
            if
            (
                near && image[i] == periodicity::original
             && state.mayTouch
                (
                    state.bodyOf(source[i]),
                    state.bodyOf(source[j])
                )
            )
            {
                pairs_.push_back(spherePair(source[i], source[j], image[j]));
            }
        }
    );
}


void Foam::dem::verletList::sortPairs(const label n)
{
    const auto seam = std::partition
    (
        pairs_.begin(),
        pairs_.end(),
        [](const spherePair& p) { return p.image == periodicity::original; }
    );
    const label nPlain = label(seam - pairs_.begin());
    std::sort(seam, pairs_.end(), contactBlocks::before);

    // Into buckets by the first sphere, in which few are left to sort
    std::vector<label> end(n + 1, 0);
    for (label p = 0; p < nPlain; ++p)
    {
        ++end[pairs_[p].i + 1];
    }
    for (label s = 0; s < n; ++s)
    {
        end[s + 1] += end[s];
    }
    sorted_.resize(nPlain);
    for (label p = 0; p < nPlain; ++p)
    {
        sorted_[end[pairs_[p].i]++] = pairs_[p];
    }
    label begin = 0;
    for (label s = 0; s < n; ++s)
    {
        std::sort
        (
            sorted_.begin() + begin,
            sorted_.begin() + end[s],
            [](const spherePair& a, const spherePair& b) { return a.j < b.j; }
        );
        begin = end[s];
    }
    std::copy(sorted_.begin(), sorted_.end(), pairs_.begin());

    const auto same = [](const spherePair& a, const spherePair& b)
    {
        return a.i == b.i && a.j == b.j && a.image == b.image;
    };
    pairs_.erase
    (
        std::unique(pairs_.begin(), pairs_.end(), same),
        pairs_.end()
    );
}


// ************************************************************************* //
