/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "demCloud.H"
#include "rankSum.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::labelList Foam::demCloud::takers(const boolList& inside, const scalar t)
{
    const dem::bodies& state = dem_->state();
    const PtrList<dem::sink>& sinks = dem_->sinks();

    labelList taker(state.size(), -1);
    bool askPatch = false;
    forAll(sinks, i)
    {
        askPatch = askPatch || (sinks[i].asksForPatch() && sinks[i].open(t));
        forAll(taker, b)
        {
            if (taker[b] < 0 && sinks[i].takes(state.x[b], t))
            {
                taker[b] = i;
            }
        }
    }
    if (!askPatch)
    {
        return taker;
    }

    DynamicList<label> out;
    DynamicList<point> x;
    forAll(taker, b)
    {
        if (taker[b] < 0 && !inside[b])
        {
            out.append(b);
            x.append(state.x[b]);
        }
    }
    if (out.size())
    {
        const wordList patch(exits_.nearest(x));
        forAll(out, k)
        {
            forAll(sinks, i)
            {
                if (taker[out[k]] < 0 && sinks[i].takes(patch[k], t))
                {
                    taker[out[k]] = i;
                }
            }
        }
    }
    return taker;
}


void Foam::demCloud::removeLeaving(const scalar t)
{
    const dem::bodies& state = dem_->state();
    PtrList<dem::sink>& sinks = dem_->sinks();

    const labelList& cells = cells_.find(state);
    boolList inside(state.size());
    forAll(inside, b)
    {
        inside[b] = cells[b] >= 0;
    }
    dem::anyOverRanks(inside);

    const labelList taker(takers(inside, t));
    boolList leaving(state.size());
    labelList nTaken(sinks.size(), Zero);
    label n = 0;
    forAll(leaving, b)
    {
        leaving[b] = !inside[b] || taker[b] >= 0;
        n += leaving[b];
        if (taker[b] >= 0)
        {
            sinks[taker[b]].count(state.mass[b]);
            ++nTaken[taker[b]];
        }
        else if (leaving[b])
        {
            Info<< "    body " << state.id[b] << " ("
                << state.shapeOf(b).name() << ") left the domain at "
                << state.x[b] << endl;
        }
    }
    forAll(sinks, i)
    {
        if (nTaken[i])
        {
            Info<< "    sink " << sinks[i].name() << " took " << nTaken[i]
                << " bodies, " << sinks[i].number() << " of "
                << sinks[i].mass() << " kg in all" << endl;
        }
    }

    if (n)
    {
        dem_->remove(leaving);
        ledger_.addLeft(n);
    }
}


void Foam::demCloud::writeSinks() const
{
    for (const dem::sink& s : dem().sinks())
    {
        Info<< "    Sink " << s.name() << " took " << s.number()
            << " bodies of " << s.mass() << " kg" << nl;
    }
}


// ************************************************************************* //
