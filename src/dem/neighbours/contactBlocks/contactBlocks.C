/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Class

\*---------------------------------------------------------------------------*/

#include "contactBlocks.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::contactBlocks::set
(
    const std::vector<spherePair>& pairs,
    const UList<pairHistory>& touching,
    const label nSpheres
)
{
    const label W = nLanes_;
    const label nPairs = label(pairs.size());
    nPlain_ = nPairs;
    while (nPlain_ && pairs[nPlain_ - 1].image != periodicity::original)
    {
        --nPlain_;
    }
    nImages_ = nPairs - nPlain_;
    nPlainBlocks_ = (nPlain_ + W - 1)/W;
    const label nBlocks = nPlainBlocks_ + (nImages_ + W - 1)/W;

    i_.assign(nBlocks*W, 8*nSpheres);
    j_.assign(nBlocks*W, 8*(nSpheres + 1));
    image_.assign(nImages_ ? nBlocks*W : 0, periodicity::original);
    now_.xi.zero(3*nBlocks*W);
    now_.rate.zero(4*nBlocks*W);
    now_.touched.assign(nBlocks, 0);
    trial_ = memory();
    onTrial_ = false;

    label next = 0;
    for (label p = 0; p < nPairs; ++p)
    {
        const spherePair& pair = pairs[p];
        const label k = slot(p);
        i_[k] = 8*pair.i;
        j_[k] = 8*pair.j;
        if (nImages_)
        {
            image_[k] = pair.image;
        }

        while (next < touching.size() && before(touching[next].pair, pair))
        {
            ++next;
        }
        if (next == touching.size() || before(pair, touching[next].pair))
        {
            continue;
        }
        const pairHistory& h = touching[next++];
        for (direction d = 0; d < 3; ++d)
        {
            now_.xi.data()[3*(k - k % W) + d*W + k % W] = h.xi[d];
        }
        for (direction d = 0; d < 4; ++d)
        {
            now_.rate.data()[4*(k - k % W) + d*W + k % W] = h.rate[d];
        }
        now_.touched[k/W] |= 1 << (k % W);
    }
}


Foam::List<Foam::dem::contactBlocks::pairHistory>
Foam::dem::contactBlocks::histories() const
{
    const label W = nLanes_;
    DynamicList<pairHistory> found;
    for (label p = 0; p < nPlain_ + nImages_; ++p)
    {
        const label k = slot(p);
        if (!(now_.touched[k/W] & (1 << (k % W))))
        {
            continue;
        }

        pairHistory h;
        h.pair = pairInLane(k);
        for (direction d = 0; d < 3; ++d)
        {
            h.xi[d] = now_.xi.data()[3*(k - k % W) + d*W + k % W];
        }
        for (direction d = 0; d < 4; ++d)
        {
            h.rate[d] = now_.rate.data()[4*(k - k % W) + d*W + k % W];
        }
        found.append(h);
    }
    return List<pairHistory>(std::move(found));
}


void Foam::dem::contactBlocks::give(sweepData& data, const bool onTrial)
{
    if (onTrial && trial_.touched.size() != now_.touched.size())
    {
        trial_ = now_;
    }
    onTrial_ = onTrial;
    memory& next = onTrial ? trial_ : now_;

    data.nBlocks = label(now_.touched.size());
    data.firstImage = nPlainBlocks_;
    data.i = i_.data();
    data.j = j_.data();
    data.image = image_.data();
    data.ofPairs.xiOld = now_.xi.data();
    data.ofPairs.xi = next.xi.data();
    data.ofPairs.rateOld = now_.rate.data();
    data.ofPairs.rate = next.rate.data();
    data.ofPairs.touchedOld = now_.touched.data();
    data.ofPairs.touched = next.touched.data();
}


// ************************************************************************* //
