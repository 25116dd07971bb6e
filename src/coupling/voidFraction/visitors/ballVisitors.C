/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "ballVisitors.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::coupling::ballVisitors::find
(
    const polyMesh& mesh,
    const dem::periodicity& period,
    const List<cellBall>& balls,
    const std::function<scalar(const cellBall&)>& reach
)
{
    // The points of each rank's mesh are in a box
    List<boundBox> boxes(Pstream::nProcs());
    boxes[Pstream::myProcNo()] = boundBox(mesh.points(), false);
    Pstream::gatherList(boxes);
    Pstream::scatterList(boxes);

    const label nRanks = boxes.size();
    List<DynamicList<label>> sent(nRanks);
    List<List<point>> x(nRanks);
    List<List<scalar>> r(nRanks);
    List<DynamicList<point>> at(nRanks);
    forAll(balls, i)
    {
        const cellBall& ball = balls[i];
        const scalar far = reach(ball);
        const auto visit = [&](const point& p, const bool image)
        {
            forAll(boxes, rank)
            {
                const bool other = image || rank != Pstream::myProcNo();
                if (other && boxes[rank].overlaps(p, sqr(far)))
                {
                    sent[rank].append(i);
                    at[rank].append(p);
                }
            }
        };
        visit(ball.x, false);
        period.forEachImage
        (
            ball.x,
            far,
            [&](const label image)
            {
                visit(ball.x + period.shift(image), true);
            }
        );
    }

    sent_.setSize(nRanks);
    x_.setSize(nRanks);
    r_.setSize(nRanks);
    List<List<point>> inX(nRanks);
    List<List<scalar>> inR(nRanks);
    forAll(sent, rank)
    {
        sent_[rank] = sent[rank];
        x[rank] = at[rank];
        r[rank].setSize(sent[rank].size());
        forAll(r[rank], k)
        {
            r[rank][k] = balls[sent[rank][k]].r;
        }
    }
    swap(x, inX);
    swap(r, inR);
    forAll(x_, rank)
    {
        x_[rank] = inX[rank];
        r_[rank] = inR[rank];
    }
}


Foam::List<Foam::coupling::cellBall>
Foam::coupling::ballVisitors::visitors() const
{
    List<cellBall> all(size());
    label n = 0;
    forAll(x_, rank)
    {
        forAll(x_[rank], k)
        {
            all[n++] = {-1, x_[rank][k], r_[rank][k]};
        }
    }
    return all;
}


// ************************************************************************* //
