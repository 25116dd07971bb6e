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
#include <unordered_map>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

uint64_t Foam::dem::verletList::keyOf(const label p) const
{
    return
        ((uint64_t(pairs_[p].i)*27 + imageOf(p)) << 31) | uint32_t(pairs_[p].j);
}


void Foam::dem::verletList::search(const bodies& state)
{
    pairs_.clear();
    image_.clear();

    if (state.nSpheres() < 2)
    {
        return;
    }
    if (periodic())
    {
        searchImages(state);
        return;
    }

    const UList<label>& body = state.sphereBody;

    sizeLevels(state.sphereX, state.sphereR, skin_).forEachPair
    (
        [&](const label i, const label j)
        {
            if (body[i] != body[j])
            {
                pairs_.append(spherePair{min(i, j), max(i, j)});
            }
        }
    );

    // So that the order in which forces are added, and with it their
    // round-off, does not depend on when the list was made
    std::sort
    (
        pairs_.begin(),
        pairs_.end(),
        [](const spherePair& a, const spherePair& b)
        {
            return a.i < b.i || (a.i == b.i && a.j < b.j);
        }
    );
}


void Foam::dem::verletList::searchImages(const bodies& state)
{
    const UList<label>& body = state.sphereBody;
    const label n = state.nSpheres();

    // The spheres, and behind them the images of those near a seam
    DynamicList<point> x(state.sphereX);
    DynamicList<scalar> r(state.sphereR);
    DynamicList<label> source(identity(n));
    DynamicList<label> image(labelList(n, label(periodicity::original)));

    scalar overhang = 0;
    for (label s = 0; s < n; ++s)
    {
        overhang = max(overhang, period_.overhang(x[s], r[s]));
    }
    for (label s = 0; s < n; ++s)
    {
        period_.forEachImage
        (
            state.sphereX[s],
            state.sphereR[s] + skin_ + overhang,
            [&](const label m)
            {
                x.append(state.sphereX[s] + period_.shift(m));
                r.append(state.sphereR[s]);
                source.append(s);
                image.append(m);
            }
        );
    }

    struct imagePair
    {
        spherePair pair;
        label image;
    };
    DynamicList<imagePair> found;

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
             && body[source[i]] != body[source[j]]
            )
            {
                found.append(imagePair{{source[i], source[j]}, image[j]});
            }
        }
    );

    std::sort
    (
        found.begin(),
        found.end(),
        [](const imagePair& a, const imagePair& b)
        {
            return
                std::tie(a.pair.i, a.pair.j, a.image)
              < std::tie(b.pair.i, b.pair.j, b.image);
        }
    );
    for (const imagePair& p : found)
    {
        pairs_.append(p.pair);
        image_.append(p.image);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::verletList::verletList(const scalar relativeSkin)
:
    relativeSkin_(relativeSkin),
    skin_(0),
    nBuilds_(0)
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

bool Foam::dem::verletList::outdated(const bodies& state) const
{
    if (built_.size() != state.nSpheres())
    {
        return true;
    }

    const scalar limit = sqr(0.5*skin_);
    forAll(built_, s)
    {
        if (magSqr(state.sphereX[s] - built_[s]) > limit)
        {
            return true;
        }
    }
    return false;
}


void Foam::dem::verletList::build(const bodies& state)
{
    std::unordered_map<uint64_t, vector> history;
    forAll(pairs_, p)
    {
        if (touching_[p])
        {
            history.emplace(keyOf(p), xi_[p]);
        }
    }

    skin_ =
        state.nSpheres()
      ? relativeSkin_*sum(state.sphereR)/state.nSpheres()
      : 0;

    search(state);

    xi_ = DynamicList<vector>(pairs_.size());
    xi_.setSize(pairs_.size(), vector(Zero));
    touching_ = DynamicList<bool>(pairs_.size());
    touching_.setSize(pairs_.size(), false);

    if (!history.empty())
    {
        forAll(pairs_, p)
        {
            const auto old = history.find(keyOf(p));
            if (old != history.end())
            {
                xi_[p] = old->second;
                touching_[p] = true;
            }
        }
    }

    xiNew_ = xi_;
    touchingNew_ = touching_;
    built_ = pointField(state.sphereX);
    ++nBuilds_;
}


void Foam::dem::verletList::renumber(const labelUList& newIndex)
{
    label n = 0;
    forAll(pairs_, p)
    {
        const label i = newIndex[pairs_[p].i];
        const label j = newIndex[pairs_[p].j];

        if (touching_[p] && i >= 0 && j >= 0)
        {
            if (periodic())
            {
                image_[n] = image_[p];
            }
            pairs_[n] = spherePair{i, j};
            xi_[n] = xi_[p];
            touching_[n] = true;
            ++n;
        }
    }
    pairs_.setSize(n);
    image_.setSize(min(n, image_.size()));
    xi_.setSize(n);
    touching_.setSize(n);
    built_.clear();
}


void Foam::dem::verletList::turn
(
    const bodies& state,
    const UList<labelVector>& turns
)
{
    forAll(pairs_, p)
    {
        if (!touching_[p])
        {
            continue;
        }

        // What touches is nearer than a period, so the image is one of the 27
        image_[p] = periodicity::moved
        (
            image_[p],
            turns[state.sphereBody[pairs_[p].i]]
          - turns[state.sphereBody[pairs_[p].j]]
        );
        touching_[p] = image_[p] >= 0;
    }
    built_.clear();
}


Foam::List<Foam::dem::verletList::pairHistory>
Foam::dem::verletList::histories() const
{
    DynamicList<pairHistory> found;
    forAll(pairs_, p)
    {
        if (touching_[p])
        {
            found.append(pairHistory{pairs_[p], xi_[p], imageOf(p)});
        }
    }
    return List<pairHistory>(std::move(found));
}


void Foam::dem::verletList::setHistories(const UList<pairHistory>& touching)
{
    pairs_.clear();
    image_.clear();
    xi_.clear();
    touching_.clear();
    for (const pairHistory& h : touching)
    {
        pairs_.append(h.pair);
        xi_.append(h.xi);
        touching_.append(true);
        if (periodic())
        {
            image_.append(h.image);
        }
    }
    built_.clear();
}


// ************************************************************************* //
