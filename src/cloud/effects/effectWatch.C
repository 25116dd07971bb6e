/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "effectWatch.H"
#include "DynamicList.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace
{

//- Far below the target, and how many samples show that it stays there
constexpr Foam::scalar farBelow = 0.2;
constexpr Foam::label patience = 10;

//- What is not switched off: the past that a force remembers would be lost; the
//  slip is small because of the drag, and a fluid that creeps through a bed at
//  rest feels nothing else
const Foam::wordList stays({"basset", "drag"});

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::effectWatch::effectWatch(const effectInput& input)
:
    target_(input.target),
    interval_(input.interval)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::effectWatch::add(const word& name, const bool on)
{
    effects_.set(name, effect{on, 0, watches(name) ? share(name) : 0});
}


Foam::wordList Foam::effectWatch::judge(const HashTable<scalar>& shares)
{
    const bool thorough = due();
    n_ = thorough ? 0 : n_ + 1;

    DynamicList<word> changed;
    for (const word& name : effects_.sortedToc())
    {
        if (!shares.found(name))
        {
            continue;
        }
        effect& e = effects_[name];
        e.share = shares[name];
        if (!e.on && e.share > target_)
        {
            e = effect{true, 0, e.share};
            changed.append(name);
        }
        else if (e.on && thorough)
        {
            e.calm = e.share < farBelow*target_ ? e.calm + 1 : 0;
            if (e.calm >= patience && !stays.found(name))
            {
                e = effect{false, 0, e.share};
                changed.append(name);
            }
        }
    }
    return wordList(std::move(changed));
}


Foam::dictionary Foam::effectWatch::state() const
{
    dictionary dict;
    dict.add("sinceSample", n_);
    for (const word& name : effects_.sortedToc())
    {
        const effect& e = effects_[name];
        dictionary d;
        d.add("on", e.on);
        d.add("calm", e.calm);
        d.add("share", e.share);
        dict.add(name, d);
    }
    return dict;
}


void Foam::effectWatch::setState(const dictionary& dict)
{
    n_ = dict.get<label>("sinceSample");
    for (const entry& e : dict)
    {
        if (e.isDict() && watches(e.keyword()))
        {
            effects_.set
            (
                e.keyword(),
                effect
                {
                    e.dict().get<bool>("on"),
                    e.dict().get<label>("calm"),
                    e.dict().get<scalar>("share")
                }
            );
        }
    }
}


// ************************************************************************* //
