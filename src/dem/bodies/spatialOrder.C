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

//- Bits of an index that tell places within a beam
constexpr int inBeam = 3;

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::spatialOrder::spatialOrder(const scalar meanRadius)
:
    side_(std::exp2(std::round(std::log2(2*meanRadius))))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dem::spatialOrder::key Foam::dem::spatialOrder::keyOf
(
    const point& x
) const
{
    constexpr int nBits = 21;
    constexpr scalar half = scalar(key(1) << (nBits - 1));
    key k[3];
    for (direction d = 0; d < 3; ++d)
    {
        const scalar index = std::floor(x[d]/side_) + half;
        k[d] = key(min(max(index, scalar(0)), 2*half - 1));
    }

    // Beam, slice, and place in the slice
    const key beam = (k[2] >> inBeam << (nBits - inBeam)) | k[1] >> inBeam;
    const key across = (k[2] & 7) << inBeam | (k[1] & 7);
    return beam << (nBits + 2*inBeam) | k[0] << 2*inBeam | across;
}


Foam::scalar Foam::dem::spatialOrder::disorder(const UList<point>& x) const
{
    label n = 0;
    key before = 0;
    for (const point& p : x)
    {
        const key k = keyOf(p) >> 3*inBeam;
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
