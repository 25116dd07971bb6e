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
#include <unordered_map>

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

uint64_t keyOf(const Foam::label i, const Foam::label j)
{
    return (uint64_t(Foam::min(i, j)) << 32) | uint32_t(Foam::max(i, j));
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::verletList::search(const bodies& state)
{
    pairs_.clear();

    if (state.nSpheres() < 2)
    {
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
            history.emplace(keyOf(pairs_[p].i, pairs_[p].j), xi_[p]);
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
            const auto old = history.find(keyOf(pairs_[p].i, pairs_[p].j));
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
            pairs_[n] = spherePair{min(i, j), max(i, j)};
            xi_[n] = xi_[p];
            touching_[n] = true;
            ++n;
        }
    }
    pairs_.setSize(n);
    xi_.setSize(n);
    touching_.setSize(n);
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
            found.append(pairHistory{pairs_[p], xi_[p]});
        }
    }
    return List<pairHistory>(std::move(found));
}


void Foam::dem::verletList::setHistories(const UList<pairHistory>& touching)
{
    pairs_.clear();
    xi_.clear();
    touching_.clear();
    for (const pairHistory& h : touching)
    {
        pairs_.append(h.pair);
        xi_.append(h.xi);
        touching_.append(true);
    }
    built_.clear();
}


// ************************************************************************* //
