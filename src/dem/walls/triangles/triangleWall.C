/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "triangleWall.H"

#include <algorithm>

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

//- Square of the distance of a point to a box [m2]
Foam::scalar distance2
(
    const Foam::point& p,
    const Foam::point& low,
    const Foam::point& high
)
{
    return magSqr(p - min(max(p, low), high));
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::triangleWall::grow
(
    DynamicList<node>& tree,
    const label first,
    const label last
)
{
    node n;
    n.first = first;
    n.last = last;
    n.low = triangles_[first][0];
    n.high = n.low;
    for (label t = first; t < last; ++t)
    {
        for (const point& p : triangles_[t])
        {
            n.low = min(n.low, p);
            n.high = max(n.high, p);
        }
    }

    const label self = tree.size();
    tree.append(n);

    if (last - first <= 4)
    {
        return;
    }

    // Halve along the longest side of the box
    const vector size = n.high - n.low;
    direction d = 0;
    for (direction k = 1; k < 3; ++k)
    {
        if (size[k] > size[d])
        {
            d = k;
        }
    }

    const label middle = (first + last)/2;
    std::nth_element
    (
        triangles_.begin() + first,
        triangles_.begin() + middle,
        triangles_.begin() + last,
        [d](const corners& a, const corners& b)
        {
            return a[0][d] + a[1][d] + a[2][d] < b[0][d] + b[1][d] + b[2][d];
        }
    );

    grow(tree, first, middle);
    const label right = tree.size();
    grow(tree, middle, last);
    tree[self].right = right;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::triangleWall::triangleWall
(
    const word& name,
    const label materialI,
    const List<corners>& triangles
)
:
    wall(name, materialI),
    triangles_(triangles)
{
    DynamicList<node> tree(triangles.size());
    if (triangles.size())
    {
        grow(tree, 0, triangles_.size());
    }
    tree_ = tree;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::point Foam::dem::triangleWall::nearestPoint
(
    const corners& t,
    const point& c
)
{
    const vector ab = t[1] - t[0];
    const vector ac = t[2] - t[0];
    const vector normal = ab ^ ac;
    const scalar area2 = magSqr(normal);

    // Inside, if the projection is on the inner side of the three edges
    if (area2 > VSMALL)
    {
        bool inside = true;
        for (label k = 0; k < 3 && inside; ++k)
        {
            const point& p = t[k];
            const vector edge = t[(k + 1) % 3] - p;
            inside = ((edge ^ (c - p)) & normal) >= 0;
        }
        if (inside)
        {
            return c - (((c - t[0]) & normal)/area2)*normal;
        }
    }

    // Otherwise the nearest point of the edges
    point best = t[0];
    for (label k = 0; k < 3; ++k)
    {
        const point& p = t[k];
        const vector edge = t[(k + 1) % 3] - p;
        const scalar s =
            min(max(((c - p) & edge)/max(magSqr(edge), VSMALL), scalar(0)), 1);
        const point q = p + s*edge;
        if (magSqr(c - q) < magSqr(c - best))
        {
            best = q;
        }
    }
    return best;
}


void Foam::dem::triangleWall::candidates
(
    const point& c,
    const scalar reach,
    DynamicList<label>& elements
) const
{
    if (tree_.empty())
    {
        return;
    }

    // Depth of the tree is below 2 log2(n)
    FixedList<label, 64> stack;
    label top = 0;
    stack[top++] = 0;

    while (top)
    {
        const label i = stack[--top];
        const node& n = tree_[i];

        if (distance2(c, n.low, n.high) >= sqr(reach))
        {
            continue;
        }
        if (n.right >= 0)
        {
            stack[top++] = n.right;
            stack[top++] = i + 1;
            continue;
        }
        for (label t = n.first; t < n.last; ++t)
        {
            if (magSqr(c - nearestPoint(triangles_[t], c)) < sqr(reach))
            {
                elements.append(t);
            }
        }
    }
}


Foam::scalar Foam::dem::triangleWall::nearest
(
    const point& c,
    const label element,
    point& p,
    vector& n
) const
{
    p = nearestPoint(triangles_[element], c);
    const scalar d = mag(c - p);

    if (d > VSMALL)
    {
        n = (c - p)/d;
    }
    else
    {
        // The centre lies in the triangle: its own normal will do
        const corners& t = triangles_[element];
        n = (t[1] - t[0]) ^ (t[2] - t[0]);
        n /= max(mag(n), VSMALL);
    }
    return d;
}


// ************************************************************************* //
