/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "sleepers.H"
#include "allowedKeys.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::sleepers::spread
(
    const packedBodies& state,
    const UList<contactBlocks::pairHistory>& contacts,
    boolList& marked
)
{
    for (label k = 0; k < nSpread_; ++k)
    {
        const boolList before(marked);
        for (const contactBlocks::pairHistory& h : contacts)
        {
            const label a = state.bodyOf(h.pair.i);
            const label b = state.bodyOf(h.pair.j);
            marked[a] = marked[a] || before[b];
            marked[b] = marked[b] || before[a];
        }
    }
}


bool Foam::dem::sleepers::disturbed(const packedBodies& state, const label b)
const
{
    return isAsleep(b) && state.unrest(b) > acceleration_;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::sleepers::sleepers(const dictionary& dict, const scalar g)
{
    checkKeys(dict, {"speed", "time", "acceleration"});
    speed_ = getPositive(dict, "speed");
    time_ = getPositive(dict, "time");
    if (!(g > 0) && !dict.found("acceleration"))
    {
        badEntry
        (
            dict,
            "acceleration",
            "must be given where there is no gravity of which to take a part"
        );
    }
    acceleration_ = getPositive(dict, "acceleration", 0.05*g);
    if (g > 0 && time_*g <= speed_)
    {
        badEntry
        (
            dict,
            "time",
            "is so short that a body that falls from rest has not come to the"
            " speed by then: it would fall asleep in the air"
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::boolList Foam::dem::sleepers::asleep() const
{
    boolList all(nAsleep_ ? rest_.size() : 0);
    forAll(all, b)
    {
        all[b] = isAsleep(b);
    }
    return all;
}


void Foam::dem::sleepers::take(const labelUList& from)
{
    rest_ = labelList(rest_, from);
    nAsleep_ = 0;
    forAll(rest_, b)
    {
        nAsleep_ += isAsleep(b);
    }
}


bool Foam::dem::sleepers::wake(const label b)
{
    const bool was = isAsleep(b);
    nAsleep_ -= was;
    rest_[b] = was ? 0 : rest_[b];
    return was;
}


void Foam::dem::sleepers::wakeAll()
{
    forAll(rest_, b)
    {
        wake(b);
    }
}


bool Foam::dem::sleepers::wakeMoving(const bodies& state)
{
    bool any = false;
    forAll(rest_, b)
    {
        const scalar turning =
            mag(state.omega[b])*state.shapeOf(b).boundingRadius();
        if (isAsleep(b) && mag(state.v[b]) + turning > speed_)
        {
            any = wake(b) || any;
        }
    }
    return any;
}


bool Foam::dem::sleepers::wake
(
    const packedBodies& state,
    const verletList& list,
    const wallSet& walls,
    const bool all
)
{
    boolList marked;
    const auto mark = [&](const label b)
    {
        marked.setSize(rest_.size(), false);
        marked[b] = true;
    };
    if (all)
    {
        forAll(rest_, b)
        {
            if (disturbed(state, b))
            {
                mark(b);
            }
        }
        if (walls.speed() > 0)
        {
            boolList moved(state.nSpheres(), false);
            walls.markMoved(moved);
            forAll(moved, s)
            {
                if (moved[s] && isAsleep(state.bodyOf(s)))
                {
                    mark(state.bodyOf(s));
                }
            }
        }
    }
    else
    {
        for (const label s : state.asleep().border())
        {
            if (disturbed(state, state.bodyOf(s)))
            {
                mark(state.bodyOf(s));
            }
        }
    }
    if (marked.empty())
    {
        return false;
    }

    credit_ -= stepsOfSort_;
    spread(state, list.histories(), marked);
    forAll(marked, b)
    {
        if (marked[b])
        {
            wake(b);
        }
    }
    return true;
}


bool Foam::dem::sleepers::looks(const scalar t, const scalar dt)
{
    credit_ = min(credit_ + 1, stepsOfSort_);
    const scalar perLook = nLooks_/time_;
    return std::floor(t*perLook) > std::floor((t - dt)*perLook);
}


bool Foam::dem::sleepers::look
(
    const packedBodies& state,
    const verletList& list,
    const wallSet& walls
)
{
    bool any = false;
    forAll(rest_, b)
    {
        if (!isAsleep(b))
        {
            const bool slow =
                mag(state.velocity(b)) + state.turning(b) < speed_;
            rest_[b] = slow ? min(rest_[b] + 1, nLooks_) : 0;
            any = any || rest_[b] == nLooks_;
        }
    }
    if (!any || credit_ < 0)
    {
        return false;
    }

    boolList restless(rest_.size());
    forAll(restless, b)
    {
        restless[b] = !isAsleep(b)
         && (rest_[b] < nLooks_ || state.unrest(b) > 0.5*acceleration_);
    }
    if (walls.speed() > 0)
    {
        boolList moved(state.nSpheres(), false);
        walls.markMoved(moved);
        forAll(moved, s)
        {
            const label b = state.bodyOf(s);
            restless[b] = restless[b] || moved[s];
        }
    }
    spread(state, list.blocks().histories(), restless);

    any = false;
    forAll(restless, b)
    {
        if (!restless[b] && !isAsleep(b))
        {
            rest_[b] = nLooks_ + 1;
            ++nAsleep_;
            any = true;
        }
    }
    credit_ -= any ? stepsOfSort_ : 0;
    return any;
}


void Foam::dem::sleepers::write
(
    dictionary& dict,
    const labelUList& order
) const
{
    dict.add("looksAtRest", labelList(rest_, order));
    dict.add("credit", credit_);
}


void Foam::dem::sleepers::read(const dictionary& dict, const label nBodies)
{
    // None of a case that did not sleep before
    labelList saved;
    dict.readIfPresent("looksAtRest", saved);
    dict.readIfPresent("credit", credit_);
    saved.setSize(nBodies, 0);
    rest_ = saved;
    take(identity(nBodies));
}


// ************************************************************************* //
