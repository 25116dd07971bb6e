/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "meterSet.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::meterSet::meterSet
(
    const dictionary& dict,
    const periodicity& period,
    const fileName& directory,
    const word& start
)
:
    directory_(directory),
    start_(start)
{
    if (!dict.found("meters"))
    {
        return;
    }
    const dictionary& all = dict.subDict("meters");
    for (const word& name : all.toc())
    {
        meters_.append(meter::New(name, all.subDict(name), period).ptr());
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::meterSet::begin(const demSolver& dem)
{
    for (meter& m : meters_)
    {
        m.begin(dem);
    }
}


void Foam::dem::meterSet::end
(
    const demSolver& dem,
    const scalar t0,
    const scalar t1
)
{
    for (meter& m : meters_)
    {
        m.end(dem, t1 - t0);
        m.report(directory_/m.name()/start_, t1);
    }
}


Foam::dictionary Foam::dem::meterSet::counters() const
{
    dictionary all;
    for (const meter& m : meters_)
    {
        dictionary one;
        m.write(one);
        all.add(m.name(), one);
    }
    return all;
}


void Foam::dem::meterSet::setCounters(const dictionary& dict)
{
    for (meter& m : meters_)
    {
        if (dict.found(m.name()))
        {
            m.read(dict.subDict(m.name()));
        }
    }
}


// ************************************************************************* //
