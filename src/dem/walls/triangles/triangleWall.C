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


//- Point of a segment that is nearest to c [m]
inline Foam::point nearestOf
(
    const Foam::point& a,
    const Foam::point& b,
    const Foam::point& c
)
{
    using namespace Foam;

    const vector ab = b - a;
    const scalar along = ((c - a) & ab)/max(magSqr(ab), VSMALL);
    return a + min(max(along, scalar(0)), scalar(1))*ab;
}


//- The same of a triangle without an area, as where a corner of a finer face
//  stands on the edge of a coarser one
Foam::point nearestOfSliver
(
    const Foam::dem::corners& t,
    const Foam::point& c
)
{
    Foam::point best = nearestOf(t[0], t[1], c);
    for (int k = 1; k < 3; ++k)
    {
        const Foam::point p = nearestOf(t[k], t[(k + 1) % 3], c);
        if (Foam::magSqr(c - p) < Foam::magSqr(c - best))
        {
            best = p;
        }
    }
    return best;
}


//- Point of a triangle that is nearest to c [m]
inline Foam::point nearestOf
(
    const Foam::dem::corners& t,
    const Foam::point& c
)
{
    using namespace Foam;

    // The projections of c from each corner on the edges ab and ac tell whether
    // it is nearest to a corner, to an edge or to the face: the regions are
    // told apart by the sides of the edges, whose normals are not needed
    const vector ab = t[1] - t[0];
    const vector ac = t[2] - t[0];
    const scalar abab = ab & ab;
    const scalar abac = ab & ac;
    const scalar acac = ac & ac;

    const scalar ab0 = ab & (c - t[0]);
    const scalar ac0 = ac & (c - t[0]);
    if (ab0 <= 0 && ac0 <= 0)
    {
        return t[0];
    }
    const scalar ab1 = ab0 - abab;
    const scalar ac1 = ac0 - abac;
    if (ab1 >= 0 && ac1 <= ab1)
    {
        return t[1];
    }
    const scalar ab2 = ab0 - abac;
    const scalar ac2 = ac0 - acac;
    if (ac2 >= 0 && ab2 <= ac2)
    {
        return t[2];
    }

    if (ab0*ac1 <= ab1*ac0 && ab0 >= 0 && ab1 <= 0)
    {
        return t[0] + ab0/(ab0 - ab1)*ab;
    }
    if (ab2*ac0 <= ab0*ac2 && ac0 >= 0 && ac2 <= 0)
    {
        return t[0] + ac0/(ac0 - ac2)*ac;
    }
    const scalar bc1 = ac1 - ab1;
    const scalar bc2 = ab2 - ac2;
    if (ab1*ac2 <= ab2*ac1 && bc1 >= 0 && bc2 >= 0)
    {
        return t[1] + bc1/max(bc1 + bc2, VSMALL)*(t[2] - t[1]);
    }

    // What is left of the normal of a sliver is round-off, its direction any
    const vector normal = ab ^ ac;
    const scalar area2 = magSqr(normal);
    return
        area2 > 1e-20*abab*acac
      ? c - ((c - t[0]) & normal)/area2*normal
      : nearestOfSliver(t, c);
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
    return nearestOf(t, c);
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
                end_.empty()
              ? nearestOf(triangles_[t], c)
              : nearestOf(now(t), c);
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
    p =
        end_.empty()
      ? nearestOf(triangles_[element], c)
      : nearestOf(now(element), c);
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
