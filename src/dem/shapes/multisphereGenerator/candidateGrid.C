/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.
\*---------------------------------------------------------------------------*/

#include "candidateGrid.H"
#include "error.H"
#include "surfaceScan.H"

#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::dem::candidateGrid::isRemoved(const point& p) const
{
    forAll(centres_, i)
    {
        if (magSqr(p - centres_[i]) < sqr(removed_[i]))
        {
            return true;
        }
    }
    return false;
}


void Foam::dem::candidateGrid::climb(point& p, scalar& distance) const
{
    // A step never leaves the body: its length is below the distance
    for (scalar step = min(h_, distance)/2; step > h_/64; step /= 2)
    {
        bool moved = true;
        for (label tries = 0; moved && tries < 8; ++tries)
        {
            moved = false;
            const point start(p);

            for (label k = 0; k < 27; ++k)
            {
                const vector way(k % 3 - 1, (k/3) % 3 - 1, k/9 - 1);
                const point q(start + step*way);

                if (isRemoved(q))
                {
                    continue;
                }

                const scalar there = body_.distance(q);
                if (there > distance + 1e-9*h_)
                {
                    distance = there;
                    p = q;
                    moved = true;
                }
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::candidateGrid::candidateGrid
(
    const closedSurface& body,
    const label cells
)
:
    body_(body)
{
    const boundBox box(body.surface().points(), false);
    h_ = cmptMax(box.span())/cells;

    Vector<label> n;
    point first;
    for (direction d = 0; d < 3; ++d)
    {
        n[d] = max(label(1), label(std::ceil(box.span()[d]/h_ - 1e-6)));
        first[d] = box.centre()[d] - 0.5*(n[d] - 1)*h_;
    }

    const surfaceScan
        scan(body.surface(), first.y(), first.z(), h_, n.y(), n.z());

    for (label k = 0; k < n.z(); ++k)
    {
        const auto lines = scan.row(k);

        for (label j = 0; j < n.y(); ++j)
        {
            for (const auto& inside : lines[j])
            {
                // The distance of the last point bounds that of the next
                scalar reach = GREAT;

                label i = std::ceil((inside.first - first.x())/h_);
                for (; first.x() + i*h_ < inside.second; ++i)
                {
                    const point p(first + h_*vector(i, j, k));
                    const pointIndexHit hit
                    (
                        body.tree().findNearest(p, sqr(reach))
                    );
                    const scalar distance =
                        hit.hit() ? mag(hit.hitPoint() - p) : body.distance(p);

                    points_.append(p);
                    distances_.append(distance);
                    reach = distance + 1.001*h_;
                }
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::Tuple2<Foam::point, Foam::scalar> Foam::dem::candidateGrid::take
(
    const scalar removal,
    const bool ascend
)
{
    if (points_.empty())
    {
        FatalErrorInFunction
            << "No grid point inside surface " << body_.name()
            << " is left for sphere " << centres_.size() + 1
            << ": more cells or a smaller removal give more candidates"
            << exit(FatalError);
    }

    const label best = findMax(distances_);
    point centre(points_[best]);
    scalar radius = distances_[best];

    if (ascend)
    {
        climb(centre, radius);
    }

    centres_.append(centre);
    removed_.append(removal*radius);

    // The chosen point goes whatever the percentage
    label n = 0;
    forAll(points_, i)
    {
        if (i != best && magSqr(points_[i] - centre) >= sqr(removal*radius))
        {
            points_[n] = points_[i];
            distances_[n] = distances_[i];
            ++n;
        }
    }
    points_.setSize(n);
    distances_.setSize(n);

    return Tuple2<point, scalar>(centre, radius);
}


// ************************************************************************* //
