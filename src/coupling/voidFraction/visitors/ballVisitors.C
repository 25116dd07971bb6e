/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "ballVisitors.H"
#include "ListListOps.H"
#include "ranksOf.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::coupling::ballVisitors::find
(
    const polyMesh& mesh,
    const dem::periodicity& period,
    const List<cellBall>& balls,
    const std::function<scalar(const cellBall&)>& reach
)
{
    const List<boundBox> boxes(rankBoxes(mesh));
    List<DynamicList<label>> toRanks(boxes.size());
    List<DynamicList<point>> at(boxes.size());
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
                    toRanks[rank].append(i);
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

    set(toRanks);
    x_ = ListListOps::combine<List<point>>
    (
        dem::swapRecords(at),
        accessOp<List<point>>()
    );
    List<scalar> r(balls.size());
    forAll(r, i)
    {
        r[i] = balls[i].r;
    }
    r_ = send(r);
}


Foam::List<Foam::coupling::cellBall>
Foam::coupling::ballVisitors::visitors() const
{
    List<cellBall> all(size());
    forAll(all, n)
    {
        all[n] = {-1, x_[n], r_[n]};
    }
    return all;
}


// ************************************************************************* //
