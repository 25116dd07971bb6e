/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "hadesSolver.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::dem::hadesSolver::walls() const
{
    wordList names(walls_.walls().size());
    forAll(names, w)
    {
        names[w] = walls_.walls()[w].name();
    }
    return names;
}


Foam::dem::contactHistory Foam::dem::hadesSolver::history() const
{
    contactHistory history;
    history.pairs = list_.histories();
    const touchList touches(walls_.together());
    history.walls = touches.accepted;
    history.rolls = materials_.laws().rollsBack();
    history.wallsRolled = touches.rolled;
    history.bridges = materials_.laws().coheres("capillary");
    history.pairsBridged = list_.bridges();
    history.wallsBridged = walls_.bridges();

    const bodies& all = moving();
    const auto id = [&](const label s) { return all.id[all.sphereBody[s]]; };
    for (auto* pairs : {&history.pairs, &history.pairsBridged})
    {
        for (verletList::pairHistory& h : *pairs)
        {
            if (id(h.pair.j) < id(h.pair.i))
            {
                h.turnRound();
            }
        }
    }
    return history;
}


void Foam::dem::hadesSolver::setHistory(const contactHistory& history)
{
    contactHistory h(history);
    for (auto* pairs : {&h.pairs, &h.pairsBridged})
    {
        for (verletList::pairHistory& p : *pairs)
        {
            p.renumber(p.pair.i, p.pair.j);
        }
    }
    list_.setHistories(h.pairs, h.pairsBridged);
    walls_.setTouches
    (
        history.walls,
        history.wallsRolled,
        history.wallsBridged
    );
}


void Foam::dem::hadesSolver::setHistory
(
    const UList<namedPair>& pairs,
    const UList<namedTouch>& touches
)
{
    exchange_->setSaved(pairs, touches);
}


void Foam::dem::hadesSolver::writeCounters(dictionary& dict) const
{
    dictionary entered, leftOut;
    for (const generator& g : generators_)
    {
        entered.add(g.name(), g.nEntered());
        leftOut.add(g.name(), g.nLeftOut());
    }
    dict.add("entered", entered);
    dict.add("leftOut", leftOut);

    dictionary taken;
    for (const sink& s : sinks_)
    {
        dictionary counters;
        s.write(counters);
        taken.add(s.name(), counters);
    }
    dict.add("sinks", taken);

    dictionary step;
    control_->writeState(step);
    dict.add("stepControl", step);

    if (watchdog_.valid())
    {
        dict.add("watchdogScale", watchdog_->scale());
    }

    saved_ = true;
    if (sleepers_.valid())
    {
        dictionary asleep;
        sleepers_->write(asleep, state_.byId());
        dict.add("sleeping", asleep);
    }
}


void Foam::dem::hadesSolver::readCounters(const dictionary& dict)
{
    // A sink that is new in the case has taken nothing
    const dictionary& taken = dict.subOrEmptyDict("sinks");
    for (sink& s : sinks_)
    {
        if (taken.found(s.name()))
        {
            s.read(taken.subDict(s.name()));
        }
    }

    // A generator that is new in the case starts with its first body
    const dictionary& entered = dict.subDict("entered");
    const dictionary& leftOut = dict.subOrEmptyDict("leftOut");
    for (generator& g : generators_)
    {
        if (entered.found(g.name()))
        {
            g.setEntered
            (
                entered.get<label>(g.name()),
                leftOut.getOrDefault<label>(g.name(), 0)
            );
        }
    }
    control_->readState(dict.subDict("stepControl"));
    if (watchdog_.valid())
    {
        watchdog_->setScale(dict.getOrDefault<scalar>("watchdogScale", 0));
    }
    saved_ = true;
    if (sleepers_.valid())
    {
        sleepers_->read(dict.subOrEmptyDict("sleeping"), state_.size());
    }
}


// ************************************************************************* //
