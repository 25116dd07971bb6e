/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "presentBodies.H"
#include "ranksOf.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::coupling::presentBodies::find
(
    const std::function<scalar(const label)>& reach
)
{
    if (!shared())
    {
        return;
    }
    const dem::bodies& state = dem_.state();
    const List<boundBox> boxes(rankBoxes(mesh_));
    List<DynamicList<label>> toRanks(boxes.size());
    List<DynamicList<dem::bodyRecord>> records(boxes.size());
    forAll(state.x, b)
    {
        const scalar far = reach(b);
        forAll(boxes, rank)
        {
            bool near = boxes[rank].overlaps(state.x[b], sqr(far));
            dem_.period().forEachImage
            (
                state.x[b],
                far,
                [&](const label image)
                {
                    const point p = state.x[b] + dem_.period().shift(image);
                    near = near || boxes[rank].overlaps(p, sqr(far));
                }
            );
            if (near && rank != Pstream::myProcNo())
            {
                toRanks[rank].append(b);
                records[rank].append(state.record(b));
            }
        }
    }
    set(toRanks);

    DynamicList<dem::bodyRecord> others;
    for (const auto& part : dem::swapRecords(records))
    {
        others.append(part);
    }
    all_.reset(new dem::bodies(state));
    all_->drag = nullptr;
    all_->take(identity(state.size() + others.size()), others);
}


void Foam::coupling::presentBodies::max(List<scalar>& q) const
{
    if (!shared())
    {
        dem::maxOverRanks(q);
        return;
    }
    const List<scalar> found(SubList<scalar>(q, size(), q.size() - size()));
    bring
    (
        found,
        [&](const label b, const scalar x) { q[b] = Foam::max(q[b], x); }
    );
    tell(q);
}


// ************************************************************************* //
