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
#include "allowedKeys.H"
#include "checkedEntry.H"

#include <algorithm>
#include <tuple>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- In the order of the list: pairs through seams last, so that the order in
//  which forces are added, and with it their round-off, does not depend on
//  when the list was made
bool before
(
    const Foam::dem::verletList::pairHistory& a,
    const Foam::dem::verletList::pairHistory& b
)
{
    const bool seamA = a.image != Foam::dem::periodicity::original;
    const bool seamB = b.image != Foam::dem::periodicity::original;
    return
        std::tie(seamA, a.pair.i, a.pair.j, a.image)
      < std::tie(seamB, b.pair.i, b.pair.j, b.image);
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::verletList::search
(
    const packedBodies& state,
    DynamicList<pairHistory>& plain,
    DynamicList<pairHistory>& images
) const
{
    const label n = state.nSpheres();
    if (n < 2)
    {
        return;
    }
    if (periodic())
    {
        searchImages(state, plain, images);
        return;
    }

    scalarList r(n);
    for (label s = 0; s < n; ++s)
    {
        r[s] = state.radius(s);
    }
    sizeLevels(built_, r, skin_).forEachPair
    (
        [&](const label i, const label j)
        {
            if (state.bodyOf(i) != state.bodyOf(j))
            {
                plain.append
                (
                    pairHistory{spherePair{min(i, j), max(i, j)}, Zero}
                );
            }
        }
    );
}


void Foam::dem::verletList::searchImages
(
    const packedBodies& state,
    DynamicList<pairHistory>& plain,
    DynamicList<pairHistory>& images
) const
{
    const label n = state.nSpheres();

    // The spheres, and behind them the images of those near a seam
    DynamicList<point> x(built_);
    DynamicList<scalar> r(n);
    DynamicList<label> source(identity(n));
    DynamicList<label> image(labelList(n, label(periodicity::original)));

    scalar overhang = 0;
    for (label s = 0; s < n; ++s)
    {
        r.append(state.radius(s));
        overhang = max(overhang, period_.overhang(x[s], r[s]));
    }
    for (label s = 0; s < n; ++s)
    {
        const scalar radius = r[s];
        period_.forEachImage
        (
            built_[s],
            radius + skin_ + overhang,
            [&](const label m)
            {
                x.append(built_[s] + period_.shift(m));
                r.append(radius);
                source.append(s);
                image.append(m);
            }
        );
    }

    sizeLevels(x, r, skin_).forEachPair
    (
        [&](label i, label j)
        {
            // A pair through a seam is found twice, from either side: it is
            // taken where the lower sphere is the original
            if (source[i] > source[j])
            {
                Swap(i, j);
            }
            if
            (
                image[i] == periodicity::original
             && state.bodyOf(source[i]) != state.bodyOf(source[j])
            )
            {
                const bool seam = image[j] != periodicity::original;
                (seam ? images : plain).append
                (
                    pairHistory{{source[i], source[j]}, Zero, image[j]}
                );
            }
        }
    );
}


void Foam::dem::verletList::fill
(
    const UList<pairHistory>& pairs,
    const label nSpheres
)
{
    const label W = nLanes_;
    const label nBlocks =
        nPlainBlocks_ + (nImages_ + W - 1)/W;

    i_.assign(nBlocks*W, 4*nSpheres);
    j_.assign(nBlocks*W, 4*(nSpheres + 1));
    image_.clear();
    if (periodic())
    {
        image_.assign(nBlocks*W, periodicity::original);
    }
    now_.xi.assign(3*nBlocks*W, 0);
    now_.rate.assign(4*nBlocks*W, 0);
    now_.touched.assign(nBlocks, 0);

    forAll(pairs, p)
    {
        const label k = slot(p);
        const pairHistory& h = pairs[p];
        i_[k] = 4*h.pair.i;
        j_[k] = 4*h.pair.j;
        if (periodic())
        {
            image_[k] = h.image;
        }
        for (direction d = 0; d < 3; ++d)
        {
            now_.xi[3*(k - k % W) + d*W + k % W] = h.xi[d];
        }
        for (direction d = 0; d < 4; ++d)
        {
            now_.rate[4*(k - k % W) + d*W + k % W] = h.rate[d];
        }
        now_.touched[k/W] |= h.touches << (k % W);
    }
    trial_ = memory();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::verletList::verletList(const scalar relativeSkin)
:
    relativeSkin_(relativeSkin)
{}


Foam::dem::verletList::verletList(const dictionary& dict)
:
    verletList(0.1)
{
    checkKeys(dict, {"type", "skin"});
    getChoice(dict, "type", {"verletList"});
    relativeSkin_ = getPositive(dict, "skin", 0.1);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::dem::verletList::outdated(const packedBodies& state)
{
    if (!valid_ || built_.size() != state.nSpheres())
    {
        return true;
    }
    if (moved_ <= 0.5*skin_)
    {
        return false;
    }

    // The bound is used up: how far have they really moved?
    scalar furthest = 0;
    forAll(built_, s)
    {
        furthest = max(furthest, magSqr(state.centre(s) - built_[s]));
    }
    moved_ = sqrt(furthest);
    return moved_ > 0.5*skin_;
}


void Foam::dem::verletList::build(const packedBodies& state)
{
    List<pairHistory> old(valid_ ? histories() : kept_);
    if (!std::is_sorted(old.begin(), old.end(), before))
    {
        std::sort(old.begin(), old.end(), before);
    }
    kept_.clear();

    const label n = state.nSpheres();
    scalar sum = 0;
    built_.setSize(n);
    for (label s = 0; s < n; ++s)
    {
        built_[s] = state.centre(s);
        sum += state.radius(s);
    }
    skin_ = n ? relativeSkin_*sum/n : 0;
    moved_ = 0;

    DynamicList<pairHistory> pairs, images;
    search(state, pairs, images);
    std::sort(pairs.begin(), pairs.end(), before);
    std::sort(images.begin(), images.end(), before);
    nPlain_ = pairs.size();
    nImages_ = images.size();
    nPlainBlocks_ = (nPlain_ + nLanes_ - 1)/nLanes_;
    pairs.append(images);

    // Both lists are sorted
    label o = 0;
    for (pairHistory& p : pairs)
    {
        while (o < old.size() && before(old[o], p))
        {
            ++o;
        }
        const bool same = o < old.size() && !before(p, old[o]);
        p.touches = same;
        if (same)
        {
            p = old[o++];
        }
    }

    fill(pairs, n);
    valid_ = true;
    ++nBuilds_;
}


void Foam::dem::verletList::renumber(const labelUList& newIndex)
{
    if (valid_)
    {
        drop();
    }

    label n = 0;
    for (pairHistory& h : kept_)
    {
        h.pair.i = newIndex[h.pair.i];
        h.pair.j = newIndex[h.pair.j];
        if (h.pair.i >= 0 && h.pair.j >= 0)
        {
            kept_[n++] = pairHistory(h);
        }
    }
    kept_.setSize(n);
}


void Foam::dem::verletList::turn
(
    const bodies& state,
    const UList<labelVector>& turns
)
{
    if (valid_)
    {
        drop();
    }

    label n = 0;
    for (pairHistory& h : kept_)
    {
        // What touches is nearer than a period, so the image is one of the 27
        h.image = periodicity::moved
        (
            h.image,
            turns[state.sphereBody[h.pair.i]]
          - turns[state.sphereBody[h.pair.j]]
        );
        if (h.image >= 0)
        {
            kept_[n++] = pairHistory(h);
        }
    }
    kept_.setSize(n);
}


Foam::List<Foam::dem::verletList::pairHistory>
Foam::dem::verletList::histories() const
{
    if (!valid_)
    {
        return kept_;
    }

    const label W = nLanes_;
    DynamicList<pairHistory> found;
    for (label p = 0; p < size(); ++p)
    {
        const label k = slot(p);
        if (!(now_.touched[k/W] & (1 << (k % W))))
        {
            continue;
        }

        pairHistory h{pair(p), Zero, imageOf(k)};
        for (direction d = 0; d < 3; ++d)
        {
            h.xi[d] = now_.xi[3*(k - k % W) + d*W + k % W];
        }
        for (direction d = 0; d < 4; ++d)
        {
            h.rate[d] = now_.rate[4*(k - k % W) + d*W + k % W];
        }
        found.append(h);
    }
    return List<pairHistory>(std::move(found));
}


void Foam::dem::verletList::setHistories(const UList<pairHistory>& touching)
{
    kept_ = touching;
    valid_ = false;
}


void Foam::dem::verletList::give(sweepData& data, const bool onTrial)
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
    data.shift = period_.shiftData();
    data.xiOld = now_.xi.data();
    data.xi = next.xi.data();
    data.rateOld = now_.rate.data();
    data.rate = next.rate.data();
    data.touchedOld = now_.touched.data();
    data.touched = next.touched.data();
}


void Foam::dem::verletList::accept()
{
    if (onTrial_)
    {
        std::swap(now_, trial_);
        onTrial_ = false;
    }
}


// ************************************************************************* //
