/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "demCloud.H"
#include "ranksOf.H"
#include "rankSum.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::boolList Foam::demCloud::areInside()
{
    const labelList& cells = cells_.find(dem_->state());
    return coupling::areInMesh(mesh_, bins_, *dem_, cells);
}


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
    const dem::rankGroup& group = dem_->group();
    if (group.any(out.size()))
    {
        const wordList patch(nearestPatches(x));
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


Foam::wordList Foam::demCloud::nearestPatches(const UList<point>& x)
{
    if (!dem_->group().shared())
    {
        return exits_.nearest(x);
    }

    // Those few bodies that are on their way out
    List<List<point>> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = x;
    Pstream::gatherList(all);
    Pstream::scatterList(all);
    DynamicList<point> joined;
    label first = 0;
    forAll(all, rank)
    {
        first = rank == Pstream::myProcNo() ? joined.size() : first;
        joined.append(all[rank]);
    }
    return wordList(SubList<word>(exits_.nearest(joined), x.size(), first));
}


Foam::label Foam::demCloud::removeLeaving(const scalar t)
{
    const dem::bodies& state = dem_->state();
    PtrList<dem::sink>& sinks = dem_->sinks();

    const boolList inside(areInside());
    const labelList taker(takers(inside, t));
    boolList leaving(state.size());
    labelList nTaken(sinks.size(), Zero);
    scalarList massTaken(sinks.size(), Zero);
    label n = 0;
    OStringStream left;
    forAll(leaving, b)
    {
        leaving[b] = !inside[b] || taker[b] >= 0;
        n += leaving[b];
        if (taker[b] >= 0)
        {
            massTaken[taker[b]] += state.mass[b];
            ++nTaken[taker[b]];
        }
        else if (leaving[b])
        {
            left<< "    body " << state.id[b] << " ("
                << state.shapeOf(b).name() << ") left the domain at "
                << state.x[b] << nl;
        }
    }
    const dem::rankGroup& group = dem_->group();
    n = group.sum(n);
    if (n)
    {
        Info<< group.joined(left.str()).c_str() << flush;
    }
    forAll(sinks, i)
    {
        const label number = n ? group.sum(nTaken[i]) : 0;
        if (number)
        {
            sinks[i].count(number, group.sum(massTaken[i]));
            Info<< "    sink " << sinks[i].name() << " took " << number
                << " bodies, " << sinks[i].number() << " of "
                << sinks[i].mass() << " kg in all" << endl;
        }
    }

    if (n)
    {
        dem_->remove(leaving);
        ledger_.addLeft(n);
    }
    return n;
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
