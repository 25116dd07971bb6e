/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "asleepPairs.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::asleepPairs::set(const UList<bool>& asleep)
{
    asleep_ = asleep;
    due_ = true;
}


void Foam::dem::asleepPairs::sort
(
    contactBlocks& awake,
    const label nSpheres
)
{
    due_ = false;
    List<contactBlocks::pairHistory> all(with(awake.histories()));
    const auto both = [&](const contactBlocks::pairHistory& h)
    {
        return any() && asleep_[h.pair.i] && asleep_[h.pair.j];
    };
    List<contactBlocks::pairHistory> here
    (
        label(std::count_if(all.begin(), all.end(), both))
    );
    label nHere = 0, n = 0;
    for (const contactBlocks::pairHistory& h : all)
    {
        if (both(h))
        {
            // They stand still
            here[nHere] = h;
            std::fill_n(here[nHere++].rate, 4, 0);
        }
        else
        {
            all[n++] = h;
        }
    }
    const UList<contactBlocks::pairHistory> inStep(all.data(), n);
    const contactBlocks::spherePair filler(contactBlocks::fillerOf(nSpheres));
    awake.set(inStep, filler);
    blocks_.set(here, filler);
}


void Foam::dem::asleepPairs::clearBorder()
{
    border_.clear();
    atBorder_.assign(asleep_.size(), 0);
}


Foam::List<Foam::dem::contactBlocks::pairHistory>
Foam::dem::asleepPairs::with
(
    List<contactBlocks::pairHistory>&& awake
) const
{
    const List<contactBlocks::pairHistory> here(blocks_.histories());
    if (here.empty())
    {
        return std::move(awake);
    }
    List<contactBlocks::pairHistory> all(awake.size() + here.size());
    std::merge
    (
        awake.begin(),
        awake.end(),
        here.begin(),
        here.end(),
        all.begin(),
        [](const auto& a, const auto& b)
        {
            return contactBlocks::before(a.pair, b.pair);
        }
    );
    return all;
}


void Foam::dem::asleepPairs::clear()
{
    blocks_.clear();
    due_ = any();
}


// ************************************************************************* //
