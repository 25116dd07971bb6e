/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "verletList.H"
#include "areMany.H"
#include "allowedKeys.H"
#include "checkedEntry.H"
#include "nearPairs.H"

#include <algorithm>
#include <malloc.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// Part of the reach of the near pairs that a sphere at rest has
const Foam::scalar slowest = 0.2;


//- Give back to the system what has been freed. Lists below 32 MB leave holes
//  otherwise, into which nothing larger fits; where there are few spheres the
//  next list has them
void giveBack(const Foam::label nSpheres)
{
    if (Foam::dem::areMany(nSpheres))
    {
        malloc_trim(0);
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::verletList::setNear(const packedBodies& state)
{
    near_.start
    (
        state,
        0.5*nearSkin_,
        slowest*min(skin_/max(nearSkin_, VSMALL), scalar(1)),
        0.25
    );
    near_.setPlaces(state, far_);
    if (asleep_.due())
    {
        asleep_.sort(blocks_, state.nSpheres());
    }
    asleep_.clearBorder();
    gather(state, 0, blocks_);
    if (reaches())
    {
        gather(state, reach_, reached_);
    }
    nSweeps_ = 0;
}


void Foam::dem::verletList::gather
(
    const packedBodies& state,
    const scalar beyond,
    contactBlocks& blocks
)
{
    const quadPair* xv = state.spheres().xv.data();

    // What touched before a step on trial belongs to them: the step may be
    // undone
    const auto sooner = contactBlocks::before;
    touchedLanes lanes(blocks.touching());
    bool left = true;
    spherePair touch;
    const auto nextTouch = [&]()
    {
        left = lanes.next();
        if (left)
        {
            touch = blocks.pairInLane(lanes.lane());
        }
    };
    nextTouch();
    const float* allowed = near_.allowed.data();
    const bool sleeping = asleep_.any();
    const nearPairs found(pairs_, [&](const spherePair& p)
    {
        if (sleeping && asleep_.leavesOut(p))
        {
            return nearPairs::far;
        }

        // Each pair that touches is one of them
        if (left && !sooner(p, touch))
        {
            nextTouch();
            return nearPairs::touching;
        }
        const quad& a = xv[p.i].first;
        const quad& b = xv[p.j].first;
        vector d(a.x - b.x, a.y - b.y, a.z - b.z);
        if (p.image != periodicity::original)
        {
            d -= period_.shift(p.image);
        }
        const scalar reach =
            xv[p.i].second.w + xv[p.j].second.w
          + scalar(allowed[p.i]) + scalar(allowed[p.j]) + beyond;

        return magSqr(d) < sqr(reach) ? nearPairs::near : nearPairs::far;
    });
    blocks.setPairs(found, contactBlocks::fillerOf(state.nSpheres()));
}


void Foam::dem::verletList::keep
(
    const std::function<bool(pairHistory&)>& change
)
{
    if (valid_)
    {
        // What is made anew in any case need not be there meanwhile
        pairs_.free();
        near_.free();
        found_.free();
        const label n = label(far_.allowed.size());
        far_.free();
        giveBack(n);
        if (asleep_.blocks().nLanes())
        {
            blocks_.set(histories(), spherePair());
        }
        asleep_.clear();
        if (reachPerRadius_ <= 0)
        {
            reached_.clear();
        }
        valid_ = false;
    }
    blocks_.keepTouching(change);
    reached_.keepTouching(change);
}


void Foam::dem::verletList::adapt()
{
    // To gather the near pairs costs about as much as a sweep
    if (nSweeps_ < 20)
    {
        nearSkin_ *= 2;
    }
    else if (nSweeps_ > 200)
    {
        nearSkin_ *= 0.5;
    }

    // Beyond the skin only the fast ones reach further
    nearSkin_ = max(min(nearSkin_, min(fastSkin_, 4*skin_)), 0.1*skin_);
}


void Foam::dem::verletList::adaptFar(const label n)
{
    const scalar most = 8.0*n;
    const scalar pairs = scalar(pairs_.size());

    // To find all pairs costs a few sweeps
    if (nFarSweeps_ < 80 && pairs < 0.5*most)
    {
        fastSkin_ *= 2;
    }
    else if (nFarSweeps_ > 800 || pairs > most)
    {
        fastSkin_ *= 0.5;
    }

    // Beyond so many times that of the others it would be rare to come so far
    fastSkin_ = even_ ? skin_ : max(min(fastSkin_, 16*skin_), skin_);
    nFarSweeps_ = 0;
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
    const word type =
        getChoice(dict, "type", {"verletList", "linkCell", "auto"});
    if (type == "verletList")
    {
        checkKeys(dict, {"type", "skin"});
        relativeSkin_ = getPositive(dict, "skin", 0.1);
        return;
    }

    checkKeys(dict, {"type"});
    relativeSkin_ = 0;
    if (type == "auto")
    {
        tuner_.reset(new skinTuner());
        relativeSkin_ = tuner_->skin();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::verletList::setMeets(const bool meets)
{
    meets_ = meets;
    drop();
    if (!meets)
    {
        blocks_.clear();
        reached_.clear();
    }
}


void Foam::dem::verletList::moved(const scalar distance)
{
    // The step before was undone, perhaps after the list was made
    const scalar sum = distance + lastMove_;
    far_.moved += sum;
    near_.moved += sum;
    lastMove_ = distance;
}


bool Foam::dem::verletList::outdated(const packedBodies& state)
{
    return
        !valid_
     || renew_
     || label(far_.allowed.size()) != state.nSpheres()
     || far_.over(state);
}


void Foam::dem::verletList::build(const packedBodies& state)
{
    const label n = state.nSpheres();
    scalar largest = 0;
    for (label s = 0; s < n; ++s)
    {
        largest = max(largest, state.radius(s));
    }
    skin_ = skinOf(state.meanRadius());
    reach_ = reachOf(largest);

    adaptFar(n);
    far_.start(state, 0.5*fastSkin_, skin_/max(fastSkin_, VSMALL), 0.02);

    // While it is searched, what is made anew in any case takes no memory
    pairs_.free();
    near_.free();
    far_.freePlaces();
    giveBack(n);
    search(state);
    asleep_.setDue();
    for (contactBlocks* blocks : {&blocks_, &asleep_.blocks(), &reached_})
    {
        blocks->forEachTouching([&](const label lane)
        {
            found_.add(blocks->pairInLane(lane));
        });
    }
    pairs_.set(found_, n);
    found_.free();
    far_.setPlaces(state);

    nearSkin_ = max(min(nearSkin_, min(fastSkin_, 4*skin_)), 0.1*skin_);
    setNear(state);
    valid_ = true;
    renew_ = false;
    ++nBuilds_;
    if (tuner_)
    {
        tuner_->built();
    }
}


bool Foam::dem::verletList::refresh(const packedBodies& state)
{
    const bool outdated = near_.over(state, far_) || nearDue_ || asleep_.due();
    nearDue_ = false;
    if (outdated)
    {
        if (!asleep_.due())
        {
            adapt();
        }
        setNear(state);
    }
    ++nSweeps_;
    ++nFarSweeps_;
    if (tuner_ && tuner_->stepped())
    {
        renew_ = true;
        relativeSkin_ = tuner_->skin();
    }
    return outdated;
}


bool Foam::dem::verletList::nearOutdated
(
    const packedBodies& state,
    const scalar distance
)
{
    const bool over =
        label(near_.allowed.size()) == state.nSpheres()
     && near_.over(state, far_);

    // The copies have yet to be looked at
    near_.moved = max(near_.moved, distance);
    return over;
}


void Foam::dem::verletList::drop()
{
    if (valid_)
    {
        keep([](const pairHistory&) { return true; });
    }
}


void Foam::dem::verletList::renumber(const labelUList& newIndex)
{
    keep([&](pairHistory& h)
    {
        const label i = newIndex[h.pair.i];
        const label j = newIndex[h.pair.j];
        h.renumber(i, j);
        return i >= 0 && j >= 0;
    });
}


void Foam::dem::verletList::turn
(
    const bodies& state,
    const UList<labelVector>& turns
)
{
    keep([&](pairHistory& h)
    {
        // What touches is nearer than a period, so the image is one of the 27
        h.pair.image = periodicity::moved
        (
            h.pair.image,
            turns[state.sphereBody[h.pair.i]]
          - turns[state.sphereBody[h.pair.j]]
        );
        return h.pair.image >= 0;
    });
}


void Foam::dem::verletList::setHistories
(
    List<pairHistory> touching,
    List<pairHistory> bridged
)
{
    valid_ = false;
    asleep_.clear();
    const auto set = [](List<pairHistory>& histories, contactBlocks& blocks)
    {
        std::sort
        (
            histories.begin(),
            histories.end(),
            [](const pairHistory& a, const pairHistory& b)
            {
                return contactBlocks::before(a.pair, b.pair);
            }
        );
        blocks.set(histories, spherePair());
    };
    set(touching, blocks_);
    set(bridged, reached_);
}


// ************************************************************************* //
