/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "touchList.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::touchList::accept()
{
    accepted.swap(trial);
    rolled.swap(trialRolled);
}


void Foam::dem::touchList::pad
(
    const label n,
    const scalar overlap
)
{
    const label end = trial.size();
    const label last = (end + n - 1)/n*n;
    trial.setSize(max(last, label(1)));

    // They have a sphere and a wall that exist
    wallTouch nothing = {};
    nothing.overlap = overlap;
    if (end)
    {
        nothing.sphere = trial[0].sphere;
        nothing.wallI = trial[0].wallI;
    }
    for (label k = end; k < last; ++k)
    {
        trial[k] = nothing;
    }
    trial.setSize(end);
    if (rolls)
    {
        trialRolled.setSize(end);
        trialRolled.setSize(max(last, label(1)), wallRolled());
        trialRolled.setSize(end);
    }
}


void Foam::dem::touchList::renumber(const labelUList& newIndex)
{
    label n = 0;
    bool sorted = true;
    forAll(accepted, k)
    {
        const label s = newIndex[accepted[k].sphere];
        if (s >= 0)
        {
            sorted = sorted && (!n || accepted[n - 1].sphere <= s);
            if (rolls)
            {
                rolled[n] = rolled[k];
            }
            accepted[n] = accepted[k];
            accepted[n++].sphere = s;
        }
    }
    accepted.setSize(n);
    rolled.setSize(rolls ? n : 0);
    if (!sorted)
    {
        sort();
    }
}


void Foam::dem::touchList::add(const touchList& others)
{
    const label n = accepted.size();
    accepted.append(others.accepted);
    if (rolls)
    {
        rolled.append(others.rolled);
    }

    if (n && n < accepted.size())
    {
        sort();
    }
}


void Foam::dem::touchList::sort()
{
    // Those of one sphere stay in their order
    labelList order(identity(accepted.size()));
    std::stable_sort
    (
        order.begin(),
        order.end(),
        [&](const label a, const label b)
        {
            return accepted[a].sphere < accepted[b].sphere;
        }
    );
    accepted = List<wallTouch>(accepted, order);
    if (rolls)
    {
        rolled = List<wallRolled>(rolled, order);
    }
}


void Foam::dem::touchList::keep
(
    const UList<bool>& asleep,
    const bool ifAsleep
)
{
    label n = 0;
    forAll(accepted, k)
    {
        const bool sleeps = asleep.size() && asleep[accepted[k].sphere];
        if (sleeps == ifAsleep)
        {
            if (rolls)
            {
                rolled[n] = rolled[k];
            }
            accepted[n++] = accepted[k];
        }
    }
    accepted.setSize(n);
    rolled.setSize(rolls ? n : 0);
}


// ************************************************************************* //
