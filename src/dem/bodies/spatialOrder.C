/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "spatialOrder.H"

#include <algorithm>
#include <cmath>
#include <vector>

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

using key = Foam::dem::spatialOrder::key;

//- Bits of an index
constexpr int nBits = 21;


//- Two zeros behind each bit
key spread(key k)
{
    k = (k | k << 32) & 0x001f00000000ffffull;
    k = (k | k << 16) & 0x001f0000ff0000ffull;
    k = (k | k << 8) & 0x100f00f00f00f00full;
    k = (k | k << 4) & 0x10c30c30c30c30c3ull;
    k = (k | k << 2) & 0x1249249249249249ull;
    return k;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::spatialOrder::spatialOrder(const scalar meanRadius)
:
    side_(std::exp2(std::ceil(std::log2(meanRadius))))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dem::spatialOrder::key Foam::dem::spatialOrder::keyOf
(
    const point& x
) const
{
    constexpr scalar half = scalar(key(1) << (nBits - 1));
    key k = 0;
    for (direction d = 0; d < 3; ++d)
    {
        const scalar index = std::floor(x[d]/side_) + half;
        k |= spread(key(min(max(index, scalar(0)), 2*half - 1))) << d;
    }
    return k;
}


Foam::scalar Foam::dem::spatialOrder::disorder(const UList<point>& x) const
{
    constexpr int coarse = 3*3;
    label n = 0;
    key before = 0;
    for (const point& p : x)
    {
        const key k = keyOf(p) >> coarse;
        n += k < before;
        before = k;
    }
    return scalar(n)/max(x.size(), label(1));
}


Foam::labelList Foam::dem::spatialOrder::order
(
    const UList<point>& x,
    const labelUList& id
) const
{
    struct place
    {
        key k;
        label id;
        label b;
    };
    std::vector<place> places(x.size());
    forAll(x, b)
    {
        places[b] = place{keyOf(x[b]), id[b], b};
    }
    std::sort
    (
        places.begin(),
        places.end(),
        [](const place& a, const place& b)
        {
            return a.k != b.k ? a.k < b.k : a.id < b.id;
        }
    );

    labelList order(x.size());
    forAll(order, n)
    {
        order[n] = places[n].b;
    }
    return order;
}


// ************************************************************************* //
