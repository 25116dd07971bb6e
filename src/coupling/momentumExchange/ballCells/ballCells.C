/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "ballCells.H"
#include "rankSum.H"
#include "SubList.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::labelList& Foam::coupling::ballCells::look
(
    const dem::bodies& state
)
{
    // From where they were; a sphere that is another one now walks from there
    const label n = state.nSpheres();
    const labelList& centres = centres_.find(state);
    last_.setSize(n, -1);
    forAll(state.x, b)
    {
        const label first = state.firstSphere[b];
        const label end = state.firstSphere[b + 1];
        for (label s = first; s < end; ++s)
        {
            last_[s] =
                state.sphereX()[s] == state.x[b]
              ? centres[b]
              : bins_.find(state.sphereX()[s], last_[s]);
        }
    }
    return last_;
}


const Foam::labelList& Foam::coupling::ballCells::cells
(
    const dem::bodies& state
)
{
    const label n = state.nSpheres();
    look(state);
    if (!Pstream::parRun() && !last_.found(-1))
    {
        return last_;
    }

    // On faces between ranks several have it: all but one let go
    labelList& cell = own_;
    cell = last_;
    List<scalar> claim(n, -GREAT);
    forAll(cell, s)
    {
        if (cell[s] >= 0)
        {
            claim[s] = bins_.claim(cell[s]);
        }
    }
    const List<scalar> own(claim);
    dem::maxOverRanks(claim);

    DynamicList<label> lost;
    forAll(cell, s)
    {
        if (claim[s] == -GREAT)
        {
            lost.append(s);
        }
        else if (claim[s] != own[s])
        {
            cell[s] = -1;
        }
    }
    if (lost.empty())
    {
        return cell;
    }

    List<scalar> near(lost.size());
    forAll(lost, k)
    {
        const point& x = state.sphereX()[lost[k]];
        const label c = bins_.nearest(x, mesh_.bounds().mag());
        cell[lost[k]] = c;
        near[k] = c < 0 ? -GREAT : -mag(mesh_.cellCentres()[c] - x);
    }
    List<scalar> nearest(near);
    dem::maxOverRanks(nearest);
    List<scalar> winner(lost.size(), -GREAT);
    forAll(lost, k)
    {
        if (near[k] == nearest[k])
        {
            winner[k] = -Pstream::myProcNo();
        }
    }
    dem::maxOverRanks(winner);
    forAll(lost, k)
    {
        if (winner[k] != -Pstream::myProcNo())
        {
            cell[lost[k]] = -1;
        }
    }
    return cell;
}


bool Foam::coupling::ballCells::findWhole
(
    const dem::bodies& state,
    const bodyKinds& kinds,
    List<cellBall>& balls
)
{
    if
    (
        Pstream::parRun()
     || kinds.mixed()
     || state.nSpheres() != state.size()
     || (state.size() && kinds.resolved(0))
    )
    {
        return false;
    }
    for (const dem::shape& s : state.shapes())
    {
        if (!s.isSphere())
        {
            return false;
        }
    }
    const labelList& cell = centres_.find(state);
    if (cell.found(-1))
    {
        return false;
    }

    balls.setSize(state.size());
    forAll(balls, b)
    {
        balls[b] = {cell[b], state.x[b], state.sphereR[b]};
    }
    return true;
}


void Foam::coupling::ballCells::findShares
(
    const dem::bodies& state,
    const bodyKinds& kinds
)
{
    shareOfAll_.setSize(state.nSpheres());
    forAll(state.x, b)
    {
        const label first = state.firstSphere[b];
        const label last = state.firstSphere[b + 1];
        scalar all = 0;
        for (label s = first; s < last; ++s)
        {
            all += pow3(state.sphereR[s]);
        }
        for (label s = first; s < last; ++s)
        {
            shareOfAll_[s] =
                kinds.resolved(b) ? 0 : pow3(state.sphereR[s])/all;
        }
    }
}


void Foam::coupling::ballCells::findShared
(
    const dem::bodies& state,
    const bodyKinds& kinds,
    List<cellBall>& balls
)
{
    const label n = state.nSpheres();
    bodyOfAll_ = state.sphereBody.list();
    findShares(state, kinds);

    DynamicList<point> points(state.sphereX());
    DynamicList<label> cell(look(state));
    hosts_.find(mesh_, bins_, true, points, cell);
    const List<scalar> guests(hosts_.send(state.sphereR.list()));

    body_.clear();
    share_.clear();
    DynamicList<cellBall> found(points.size());
    for (label s = 0; s < n; ++s)
    {
        if (cell[s] >= 0)
        {
            body_.append(bodyOfAll_[s]);
            share_.append(shareOfAll_[s]);
            found.append({cell[s], points[s], state.sphereR[s]});
        }
    }
    forAll(guests, k)
    {
        found.append({cell[n + k], points[n + k], guests[k]});
    }
    balls.transfer(found);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::coupling::ballCells::find
(
    const dem::bodies& state,
    const bodyKinds& kinds,
    const bool shared,
    List<cellBall>& balls
)
{
    shared_ = shared;
    whole_ = findWhole(state, kinds, balls);
    if (whole_)
    {
        return;
    }
    if (shared_)
    {
        findShared(state, kinds, balls);
        return;
    }
    const labelList& cell = cells(state);
    findShares(state, kinds);
    body_.clear();
    share_.clear();
    DynamicList<cellBall> found(state.nSpheres());
    forAll(cell, s)
    {
        if (cell[s] >= 0 && shareOfAll_[s] > 0)
        {
            body_.append(state.sphereBody[s]);
            share_.append(shareOfAll_[s]);
            found.append({cell[s], state.sphereX()[s], state.sphereR[s]});
        }
    }
    balls.transfer(found);
}


void Foam::coupling::ballCells::average
(
    List<vector>& q,
    const label nBodies
) const
{
    if (whole_)
    {
        return;
    }
    List<vector> ofBody(nBodies, vector(Zero));
    forAll(body_, i)
    {
        ofBody[body_[i]] += share_[i]*q[i];
    }
    if (shared_)
    {
        const label n = body_.size();
        hosts_.bring
        (
            SubList<vector>(q, q.size() - n, n),
            [&](const label s, const vector& qs)
            {
                ofBody[bodyOfAll_[s]] += shareOfAll_[s]*qs;
            }
        );
    }
    else
    {
        dem::sumOverRanks(ofBody);
    }
    q.transfer(ofBody);
}


// ************************************************************************* //
