/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "bisection.H"
#include "boundBox.H"
#include "rankSum.H"
#include "PstreamReduceOps.H"

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

scalar weight(const dem::bodies& own, const label b)
{
    return own.firstSphere[b + 1] - own.firstSphere[b];
}


direction longest(const vector& span)
{
    return
        span.x() >= span.y() && span.x() >= span.z() ? 0
      : span.y() >= span.z() ? 1 : 2;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::dem::bisection::rankOf(const point& x) const
{
    // A part's cut stands behind that of the whole
    label first = 0, last = Pstream::nProcs();
    for (const cut& c : cuts_)
    {
        if (c.first == first && c.last == last)
        {
            (x[c.axis] < c.at ? last : first) = c.middle;
        }
    }
    return first;
}


void Foam::dem::bisection::place(List<cut>& level, const bodies& own) const
{
    const label n = level.size();

    // The part of each body
    labelList part(own.size(), -1);
    List<scalar> low(3*n, GREAT), high(3*n, GREAT), all(n, scalar(0));
    forAll(own.x, b)
    {
        const label rank = rankOf(own.x[b]);
        forAll(level, k)
        {
            if (level[k].first == rank)
            {
                part[b] = k;
                all[k] += weight(own, b);
                for (direction d = 0; d < 3; ++d)
                {
                    low[3*k + d] = min(low[3*k + d], own.x[b][d]);
                    high[3*k + d] = min(high[3*k + d], -own.x[b][d]);
                }
            }
        }
    }
    sumOverRanks(all);
    for (List<scalar>* ends : {&low, &high})
    {
        for (scalar& x : *ends)
        {
            x = -x;
        }
        maxOverRanks(*ends);
    }

    List<scalar> from(n), to(n);
    forAll(level, k)
    {
        const vector a(-low[3*k], -low[3*k + 1], -low[3*k + 2]);
        const vector b(high[3*k], high[3*k + 1], high[3*k + 2]);
        level[k].axis = longest(b - a);
        from[k] = a[level[k].axis];
        to[k] = b[level[k].axis];
    }

    // To the last digits
    for (label i = 0; i < 50; ++i)
    {
        List<scalar> below(n, scalar(0));
        forAll(level, k)
        {
            level[k].at = 0.5*(from[k] + to[k]);
        }
        forAll(part, b)
        {
            const label k = part[b];
            if (k >= 0 && own.x[b][level[k].axis] < level[k].at)
            {
                below[k] += weight(own, b);
            }
        }
        sumOverRanks(below);
        forAll(level, k)
        {
            const cut& c = level[k];
            const scalar wanted =
                all[k]*(c.middle - c.first)/(c.last - c.first);
            (below[k] < wanted ? from[k] : to[k]) = c.at;
        }
    }

    // Behind the body that makes the share whole
    forAll(level, k)
    {
        level[k].at = to[k];
    }
}


void Foam::dem::bisection::bisect(const bodies& own)
{
    cuts_.clear();
    DynamicList<cut> parts;
    parts.append(cut{0, Pstream::nProcs(), 0, 0, 0});
    while (parts.size())
    {
        DynamicList<cut> level;
        for (cut c : parts)
        {
            if (c.last - c.first > 1)
            {
                c.middle = (c.first + c.last)/2;
                level.append(c);
            }
        }
        place(level, own);
        cuts_.append(level);

        parts.clear();
        for (const cut& c : level)
        {
            parts.append(cut{c.first, c.middle, 0, 0, 0});
            parts.append(cut{c.middle, c.last, 0, 0, 0});
        }
    }
}


Foam::scalar Foam::dem::bisection::imbalance
(
    const bodies& own,
    const labelUList& to
)
{
    List<scalar> share(Pstream::nProcs(), scalar(0));
    forAll(to, b)
    {
        share[to[b]] += weight(own, b);
    }
    sumOverRanks(share);
    return max(share)*share.size()/max(sum(share), VSMALL);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::labelList Foam::dem::bisection::owners(const bodies& own)
{
    labelList to(own.size());
    const auto ask = [&]()
    {
        forAll(to, b)
        {
            to[b] = rankOf(own.x[b]);
        }
    };

    ask();
    if (cuts_.empty() || imbalance(own, to) > 1.1)
    {
        bisect(own);
        ask();
    }
    return to;
}


// ************************************************************************* //
