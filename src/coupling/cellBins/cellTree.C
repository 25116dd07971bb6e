/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "cellTree.H"

#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::List<Foam::boundBox> Foam::coupling::cellTree::cellBoxes() const
{
    const pointField& points = mesh_.points();
    const labelList& owner = mesh_.faceOwner();
    const labelList& neighbour = mesh_.faceNeighbour();

    List<boundBox> boxes(mesh_.nCells(), boundBox(boundBox::invertedBox));
    forAll(mesh_.faces(), f)
    {
        for (const label p : mesh_.faces()[f])
        {
            boxes[owner[f]].add(points[p]);
            if (f < neighbour.size())
            {
                boxes[neighbour[f]].add(points[p]);
            }
        }
    }
    return boxes;
}


void Foam::coupling::cellTree::grow
(
    const UList<boundBox>& boxes,
    const label first,
    const label last
)
{
    const label at = label(nodes_.size());
    nodes_.push_back(node{boundBox(boundBox::invertedBox), first, last, 0});
    boundBox box(boundBox::invertedBox);
    for (label k = first; k < last; ++k)
    {
        box.add(boxes[cells_[k]]);
    }

    // A point on a face must not be lost by round-off
    box.inflate(1e-6);
    nodes_[at].box = box;
    if (last - first <= 4)
    {
        return;
    }

    const vector span(box.span());
    direction axis = 0;
    for (direction d = 1; d < 3; ++d)
    {
        axis = span[d] > span[axis] ? d : axis;
    }
    const label half = first + (last - first)/2;
    std::nth_element
    (
        cells_.begin() + first,
        cells_.begin() + half,
        cells_.begin() + last,
        [&](const label a, const label b)
        {
            const scalar xa = boxes[a].min()[axis] + boxes[a].max()[axis];
            const scalar xb = boxes[b].min()[axis] + boxes[b].max()[axis];
            return xa < xb || (xa == xb && a < b);
        }
    );
    grow(boxes, first, half);
    nodes_[at].upper = label(nodes_.size());
    grow(boxes, half, last);
}


void Foam::coupling::cellTree::make()
{
    cells_ = identity(mesh_.nCells());
    nodes_.reserve(mesh_.nCells() + 1);
    grow(cellBoxes(), 0, cells_.size());
}


// ************************************************************************* //
