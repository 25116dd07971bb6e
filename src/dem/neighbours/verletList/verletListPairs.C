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
    const label n = state.nSpheres();
    found_.clear();
    if (n < 2 || !meets_)
    {
        return;
    }

    // More than there mostly are: room that is not used takes no memory
    found_.reserve(8*std::size_t(n), n);
    if (periodic())
    {
        searchImages(state);
        return;
    }

    const auto x = [&](const label s) { return state.centre(s); };
    const auto r = [&](const label s)
    {
        return state.radius(s) + far_.allowed[s];
    };
    sizeLevels(n, x, r, reach_).forEachPair
    (
        [&](const label i, const label j)
        {
            const bool near =
                !reaches()
             || within
                (
                    x(i) - x(j), r(i) + r(j),
                    state.radius(i), state.radius(j),
                    leastReach_, reachPerRadius_
                );
            if (near && state.mayTouch(state.bodyOf(i), state.bodyOf(j)))
            {
                found_.add(i, j);
            }
        }
    );
}


void Foam::dem::verletList::searchImages(const packedBodies& state)
{
    const label n = state.nSpheres();

    // The spheres, and behind them the images of those near a seam
    const auto r = [&](const label s)
    {
        return state.radius(s) + far_.allowed[s];
    };
    scalar overhang = 0;
    for (label s = 0; s < n; ++s)
    {
        overhang = max(overhang, period_.overhang(state.centre(s), r(s)));
    }
    DynamicList<point> imageX;
    DynamicList<label> source, image;
    for (label s = 0; s < n; ++s)
    {
        period_.forEachImage
        (
            state.centre(s),
            r(s) + reach_ + overhang,
            [&](const label m)
            {
                imageX.append(state.centre(s) + period_.shift(m));
                source.append(s);
                image.append(m);
            }
        );
    }
    const auto sourceOf = [&](const label i)
    {
        return i < n ? i : source[i - n];
    };
    const auto imageOf = [&](const label i)
    {
        return i < n ? label(periodicity::original) : image[i - n];
    };
    const auto x = [&](const label i)
    {
        return i < n ? state.centre(i) : imageX[i - n];
    };

    sizeLevels
    (
        n + imageX.size(),
        x,
        [&](const label i) { return r(sourceOf(i)); },
        reach_
    ).forEachPair
    (
        [&](label i, label j)
        {
            // A pair through a seam is found twice, from either side: it is
            // taken where the lower sphere is the original
            const label first = i, second = j;
            if (sourceOf(i) > sourceOf(j))
            {
                Swap(i, j);
            }
            const label a = sourceOf(i), b = sourceOf(j);
            const bool near =
                !reaches()
             || within
                (
                    x(i) - x(j), r(a) + r(b), state.radius(a),
                    state.radius(b), leastReach_, reachPerRadius_
                );
            if
            (
                near && imageOf(i) == periodicity::original
             && state.mayTouch(state.bodyOf(a), state.bodyOf(b))
            )
            {
                // As the search goes, first spheres follow each other
                imageOf(j) == periodicity::original
              ? found_.add(first, second)
              : found_.add(spherePair(a, b, imageOf(j)));
            }
        }
    );
}


// ************************************************************************* //
