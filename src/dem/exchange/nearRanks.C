/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "nearRanks.H"
#include "boundBox.H"
#include "ListOps.H"
#include "rankGroup.H"

#include <algorithm>

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Most halvings, and least balls that are halved: 32 boxes a rank tell the
//  others a region well and cost little
constexpr label mostHalvings = 5;
constexpr label leastBalls = 8;


boundBox boxOf
(
    const label* first,
    const label* last,
    const UList<point>& x,
    const UList<scalar>& r
)
{
    boundBox box(boundBox::invertedBox);
    for (const label* i = first; i != last; ++i)
    {
        box.min() = min(box.min(), x[*i] - r[*i]*vector::one);
        box.max() = max(box.max(), x[*i] + r[*i]*vector::one);
    }
    return box;
}


void appendBoxes
(
    label* first,
    label* last,
    const UList<point>& x,
    const UList<scalar>& r,
    const label nHalvings,
    DynamicList<boundBox>& boxes
)
{
    const boundBox box(boxOf(first, last, x, r));
    if (!nHalvings || last - first < leastBalls)
    {
        boxes.append(box);
        return;
    }

    const vector span(box.span());
    const direction d =
        span.x() >= span.y() && span.x() >= span.z() ? 0
      : span.y() >= span.z() ? 1 : 2;
    label* const middle = first + (last - first)/2;
    std::nth_element
    (
        first,
        middle,
        last,
        [&](const label a, const label b) { return x[a][d] < x[b][d]; }
    );
    appendBoxes(first, middle, x, r, nHalvings - 1, boxes);
    appendBoxes(middle, last, x, r, nHalvings - 1, boxes);
}


//- Is a ball nearer to the box than the reach?
bool isNear
(
    const boundBox& box,
    const point& x,
    const scalar reach
)
{
    const vector away =
        max(max(box.min() - x, x - box.max()), vector(Zero));
    return magSqr(away) <= sqr(reach);
}


//- The boxes of a rank and one around them
struct region
{
    List<boundBox> boxes;
    boundBox all = boundBox(boundBox::invertedBox);

    bool reaches(const point& x, const scalar reach) const
    {
        if (boxes.empty() || !isNear(all, x, reach))
        {
            return false;
        }
        for (const boundBox& b : boxes)
        {
            if (isNear(b, x, reach))
            {
                return true;
            }
        }
        return false;
    }
};


List<region> regionsOfAll(const UList<point>& x, const UList<scalar>& r)
{
    DynamicList<boundBox> mine;
    if (x.size())
    {
        labelList index(identity(x.size()));
        appendBoxes
        (
            index.begin(),
            index.end(),
            x,
            r,
            mostHalvings,
            mine
        );
    }

    List<List<boundBox>> boxes(Pstream::nProcs());
    boxes[Pstream::myProcNo()] = mine;
    Pstream::gatherList(boxes);
    Pstream::scatterList(boxes);

    List<region> regions(Pstream::nProcs());
    forAll(regions, rank)
    {
        regions[rank].boxes.transfer(boxes[rank]);
        for (const boundBox& b : regions[rank].boxes)
        {
            regions[rank].all.add(b);
        }
    }
    return regions;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::List<Foam::DynamicList<Foam::label>> Foam::dem::nearRanks
(
    const UList<point>& centres,
    const UList<scalar>& radii,
    const scalar reach,
    const periodicity& period
)
{
    const List<region> regions(regionsOfAll(centres, radii));

    // A body that touches another through a seam may be outside by so much
    scalar overhang = 0;
    if (period.active())
    {
        forAll(centres, i)
        {
            overhang =
                max(overhang, period.overhang(centres[i], radii[i]));
        }
        overhang = rankGroup(true).max(overhang);
    }

    List<DynamicList<label>> near(regions.size());
    forAll(centres, i)
    {
        const scalar within = radii[i] + reach;
        const auto tell = [&](const point& x)
        {
            forAll(regions, rank)
            {
                if
                (
                    rank != Pstream::myProcNo()
                 && (near[rank].empty() || near[rank].last() != i)
                 && regions[rank].reaches(x, within)
                )
                {
                    near[rank].append(i);
                }
            }
        };
        tell(centres[i]);
        period.forEachImage
        (
            centres[i],
            within + overhang,
            [&](const label image)
            {
                tell(centres[i] + period.shift(image));
            }
        );
    }
    return near;
}


// ************************************************************************* //
