/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "triangleWall.H"
#include "ListOps.H"
#include "UIndirectList.H"

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
    point low = triangles_[order_[first]][0];
    point high = low;
    for (label k = first; k < last; ++k)
    {
        for (const point& p : triangles_[order_[k]])
        {
            low = min(low, p);
            high = max(high, p);
        }
    }

    node n;
    n.first = first;
    n.last = last;
    const label self = tree.size();
    tree.append(n);

    if (last - first <= 4)
    {
        return;
    }

    // Halve along the longest side of the box
    const vector size = high - low;
    direction d = 0;
    for (direction k = 1; k < 3; ++k)
    {
        if (size[k] > size[d])
        {
            d = k;
        }
    }

    const auto middle = [this, d](const label t)
    {
        const corners& c = triangles_[t];
        return c[0][d] + c[1][d] + c[2][d];
    };
    const label half = (first + last)/2;
    std::nth_element
    (
        order_.begin() + first,
        order_.begin() + half,
        order_.begin() + last,
        [&middle](const label a, const label b)
        {
            return middle(a) < middle(b);
        }
    );

    grow(tree, first, half);
    const label right = tree.size();
    grow(tree, half, last);
    tree[self].right = right;
}


void Foam::dem::triangleWall::fitBoxes()
{
    // The children of a node stand behind it
    for (label i = tree_.size() - 1; i >= 0; --i)
    {
        node& n = tree_[i];
        if (n.right >= 0)
        {
            n.low = min(tree_[i + 1].low, tree_[n.right].low);
            n.high = max(tree_[i + 1].high, tree_[n.right].high);
            continue;
        }

        n.low = triangles_[n.first][0];
        n.high = n.low;
        const auto hold = [&n](const corners& t)
        {
            for (const point& p : t)
            {
                n.low = min(n.low, p);
                n.high = max(n.high, p);
            }
        };
        for (label t = n.first; t < n.last; ++t)
        {
            hold(triangles_[t]);
            if (moving())
            {
                hold(end_[t]);
            }
        }
    }
}


Foam::dem::corners Foam::dem::triangleWall::now(const label t) const
{
    corners c(triangles_[t]);
    if (moving())
    {
        forAll(c, k)
        {
            c[k] += part_*(end_[t][k] - triangles_[t][k]);
        }
    }
    return c;
}


Foam::dem::corners Foam::dem::triangleWall::velocities(const label t) const
{
    corners v;
    forAll(v, k)
    {
        v[k] = (end_[t][k] - triangles_[t][k])/dt_;
    }
    return v;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::triangleWall::triangleWall
(
    const word& name,
    const label materialI,
    const List<corners>& triangles
)
:
    wall(name, materialI)
{
    set(triangles);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::triangleWall::set(const List<corners>& triangles)
{
    triangles_ = triangles;
    end_.clear();
    t0_ = 0;
    dt_ = 1;
    part_ = 0;
    speed_ = 0;

    order_ = identity(triangles.size());
    DynamicList<node> tree(triangles.size());
    if (triangles.size())
    {
        grow(tree, 0, triangles.size());
    }
    tree_ = tree;

    triangles_ = List<corners>(UIndirectList<corners>(triangles, order_));
    fitBoxes();
}


void Foam::dem::triangleWall::setMotion
(
    const List<corners>& start,
    const List<corners>& end,
    const scalar t0,
    const scalar t1
)
{
    triangles_ = List<corners>(UIndirectList<corners>(start, order_));
    end_ = List<corners>(UIndirectList<corners>(end, order_));
    t0_ = t0;
    dt_ = t1 - t0;
    part_ = 0;

    speed_ = 0;
    forAll(end_, t)
    {
        for (const vector& v : velocities(t))
        {
            speed_ = max(speed_, mag(v));
        }
    }

    // A patch of a moving mesh that rests is a wall like any other
    if (!(speed_ > 0))
    {
        end_.clear();
    }
    fitBoxes();
}


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
            const point p =
                nearestPoint(moving() ? now(t) : triangles_[t], c);
            if (magSqr(c - p) < sqr(reach))
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
    const corners& rest = triangles_[element];
    p = nearestPoint(moving() ? now(element) : rest, c);
    const scalar d = mag(c - p);

    if (d > VSMALL)
    {
        n = (c - p)/d;
    }
    else
    {
        // The centre lies in the triangle: its own normal will do
        const corners t = now(element);
        n = (t[1] - t[0]) ^ (t[2] - t[0]);
        n /= max(mag(n), VSMALL);
    }
    return d;
}


Foam::scalar Foam::dem::triangleWall::farthest
(
    const point& origin,
    const vector& axis
) const
{
    scalar d = 0;
    for (const corners& t : triangles_)
    {
        for (const point& p : t)
        {
            d = max(d, mag((p - origin) ^ axis));
        }
    }
    return d;
}


Foam::vector Foam::dem::triangleWall::velocity
(
    const label element,
    const point& p
) const
{
    if (!moving())
    {
        return Zero;
    }

    // Linear between the corners
    const corners c = now(element);
    const corners v = velocities(element);
    const vector normal = (c[1] - c[0]) ^ (c[2] - c[0]);
    const scalar area2 = max(magSqr(normal), VSMALL);
    const scalar a = (((p - c[0]) ^ (c[2] - c[0])) & normal)/area2;
    const scalar b = (((c[1] - c[0]) ^ (p - c[0])) & normal)/area2;
    return v[0] + a*(v[1] - v[0]) + b*(v[2] - v[0]);
}


Foam::scalar Foam::dem::triangleWall::spin
(
    const label element,
    const vector& n
) const
{
    if (!moving())
    {
        return 0;
    }

    const corners c = now(element);
    const corners v = velocities(element);
    const vector edge = c[1] - c[0];
    return (n & (edge ^ (v[1] - v[0])))/max(magSqr(edge), VSMALL);
}


// ************************************************************************* //
