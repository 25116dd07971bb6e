/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "hadesSolver.H"
#include "rankSum.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::string Foam::dem::hadesSolver::needsAll(const demInput& input)
{
    const dictionary& dict = input.dict;
    if (!integrator::New(dict)->leaps())
    {
        return "the integrator has stages";
    }
    if
    (
        !input.restart
     && dict.getOrDefault<word>("start", "asGiven") == "relax"
    )
    {
        return "start relax moves them together";
    }
    if (dict.found("sleeping"))
    {
        return "who sleeps must know all that it rests on";
    }
    if (dict.subOrEmptyDict("output").found("contactNetwork"))
    {
        return "the contact network is one of all";
    }
    for (const entry& e : dict.subOrEmptyDict("meters"))
    {
        if
        (
            e.isDict()
         && e.dict().getOrDefault<word>("type", word::null) == "stress"
        )
        {
            return "the meter " + e.keyword() + " needs the forces of all";
        }
    }
    const word neighbours = dict.subOrEmptyDict("neighbours")
        .getOrDefault<word>("type", "verletList");
    return
        neighbours == "verletList"
      ? string()
      : "neighbours " + neighbours + " makes its lists when it likes";
}


bool Foam::dem::hadesSolver::canShare(const demInput& input)
{
    if (!Pstream::parRun() || !input.owner)
    {
        return false;
    }
    const string why = needsAll(input);
    if (!why.empty())
    {
        Info<< "    every rank has all bodies, as " << why.c_str() << endl;
        return false;
    }
    return true;
}


void Foam::dem::hadesSolver::pack()
{
    if (!exchange_.valid())
    {
        packed_.pack(state_, g());
        return;
    }
    exchange_->take(state_);
    packed_.pack(moving(), g());
    exchange_->introduce(packed_);
    exchange_->send(packed_);
    exchange_->receive(packed_);
    due_ = group_.any(outdated());
}


void Foam::dem::hadesSolver::unpack()
{
    packed_.unpack(moving());
    if (exchange_.valid())
    {
        exchange_->giveBack(state_);
    }
}


bool Foam::dem::hadesSolver::meetOthers(const scalar t, const scalar dt)
{
    exchange_->send(packed_);

    // Meanwhile each rank tells the way of its own bodies, and hears how far
    // copies can have moved
    const packedBodies::motion& m = packed_.bounds();
    const scalar mine = (m.speed + m.turning)*dt;
    list_.moved(mine);
    walls_.moveTo(t);
    bool due = outdated();
    bool nearDue = !due && list_.nearOutdated(packed_, mine);
    bool overstepped = control_->overstepped();
    exchange_->combine(packed_, due, nearDue, overstepped);
    if (overstepped)
    {
        control_->agree(group_);
    }
    if (nearDue && !due)
    {
        list_.setNearDue();
    }
    list_.movedMore((m.speed + m.turning)*dt - mine);
    exchange_->receive(packed_);
    return due;
}


void Foam::dem::hadesSolver::shareSummary()
{
    // A step of fixed length does not ask
    if (!group_.shared() || !control_->undoes())
    {
        return;
    }
    List<scalar> largest(2);
    largest[0] = summary_.overlap;
    largest[1] = summary_.frequency10;
    maxOverRanks(largest);
    if (summary_.overlap < largest[0])
    {
        summary_.overlap = largest[0];
        summary_.overlapA = summary_.overlapB = -1;
    }
    if (summary_.frequency10 < largest[1])
    {
        summary_.frequency10 = largest[1];
        summary_.stiffA = summary_.stiffB = -1;
        summary_.duration = 1/pow(summary_.frequency10, 0.1);
    }
}


Foam::label Foam::dem::hadesSolver::nContacts() const
{
    if (!exchange_.valid())
    {
        return summary_.nPairs + summary_.nWalls + summary_.nAsleep;
    }

    // A pair with a copy is on two ranks: the owner of the first has it
    const bodies& all = moving();
    label n = summary_.nWalls;
    for (const verletList::pairHistory& h : list_.histories())
    {
        n += all.owns(all.sphereBody[h.pair.i]);
    }
    return group_.sum(n);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::hadesSolver::copy(labelUList& ofTouching) const
{
    if (exchange_.valid())
    {
        exchange_->copy(ofTouching);
    }
}


Foam::labelPair Foam::dem::hadesSolver::mostOnRank() const
{
    if (!exchange_.valid())
    {
        return demSolver::mostOnRank();
    }
    return labelPair
    (
        label(group_.max(exchange_->mostOwn())),
        label(group_.max(exchange_->mostCopies()))
    );
}


void Foam::dem::hadesSolver::shareOut()
{
    if (exchange_.valid())
    {
        exchange_->shareOut(state_, list_, walls_);
    }
}


Foam::List<Foam::DynamicList<Foam::label>>
Foam::dem::hadesSolver::moved() const
{
    return exchange_.valid() ? exchange_->moved() : demSolver::moved();
}


// ************************************************************************* //
