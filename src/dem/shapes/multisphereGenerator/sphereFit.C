/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.
\*---------------------------------------------------------------------------*/

#include "sphereFit.H"
#include "mathematicalConstants.H"
#include "multisphereErrors.H"
#include "multisphereGenerator.H"
#include "surfaceScan.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

// Steps, how often the cluster is measured, points on a sphere, lines across
constexpr label nSteps = 160;
constexpr label measureEvery = 20;
constexpr label nPoints = 240;
constexpr label nLines = 200;


// Points spread evenly over the unit sphere by a golden spiral
std::vector<vector> spiral()
{
    const scalar goldenAngle =
        constant::mathematical::pi*(3 - std::sqrt(scalar(5)));

    std::vector<vector> points;
    for (label k = 0; k < nPoints; ++k)
    {
        const scalar z = 1 - (2*k + 1)/scalar(nPoints);
        const scalar rho = std::sqrt(1 - z*z);
        const scalar angle = k*goldenAngle;
        points.emplace_back(rho*std::cos(angle), rho*std::sin(angle), z);
    }
    return points;
}


// Spheres that overlap each one
std::vector<std::vector<label>> overlaps
(
    const pointField& centres,
    const scalarField& radii
)
{
    std::vector<std::vector<label>> lists(centres.size());
    forAll(centres, i)
    {
        forAll(centres, j)
        {
            if (i != j && mag(centres[i] - centres[j]) < radii[i] + radii[j])
            {
                lists[i].push_back(j);
            }
        }
    }
    return lists;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::sphereFit::tabulate()
{
    const surfaceScan
        scan(body_.surface(), first_.y(), first_.z(), h_, n_.y(), n_.z());

    for (label k = 0; k < n_.z(); ++k)
    {
        const auto lines = scan.row(k);

        for (label j = 0; j < n_.y(); ++j)
        {
            scalar reach = GREAT;

            for (label i = 0; i < n_.x(); ++i)
            {
                const point p(first_ + h_*vector(i, j, k));
                const pointIndexHit hit
                (
                    body_.tree().findNearest(p, sqr(reach))
                );
                const scalar distance =
                    hit.hit() ? mag(hit.hitPoint() - p) : body_.distance(p);
                reach = distance + 1.001*h_;

                bool inside = false;
                for (const auto& span : lines[j])
                {
                    inside |= (p.x() > span.first && p.x() < span.second);
                }
                table_.push_back(inside ? -distance : distance);
            }
        }
    }
}


Foam::scalar Foam::dem::sphereFit::signedDistance(const point& p) const
{
    label cell[3];
    scalar part[3];

    for (direction d = 0; d < 3; ++d)
    {
        const scalar place =
            max(scalar(0), min((p[d] - first_[d])/h_, n_[d] - 1.000001));
        cell[d] = label(place);
        part[d] = place - cell[d];
    }

    scalar sum = 0;
    for (label corner = 0; corner < 8; ++corner)
    {
        const label i = corner & 1, j = (corner >> 1) & 1, k = corner >> 2;
        const scalar weight =
            (i ? part[0] : 1 - part[0])
           *(j ? part[1] : 1 - part[1])
           *(k ? part[2] : 1 - part[2]);

        sum += weight
           *table_
            [
                cell[0] + i
              + n_.x()*(cell[1] + j + n_.y()*(cell[2] + k))
            ];
    }
    return sum;
}


void Foam::dem::sphereFit::descend
(
    const scalar length,
    pointField& centres,
    scalarField& radii
) const
{
    const std::vector<vector> normals(spiral());
    const auto neighbours = overlaps(centres, radii);
    const pointField c(centres);
    const scalarField r(radii);

    forAll(c, i)
    {
        label exposed = 0;
        scalar growth = 0;
        vector shift(Zero);

        for (const vector& n : normals)
        {
            const point p(c[i] + r[i]*n);
            bool covered = false;
            for (const label j : neighbours[i])
            {
                covered |= (magSqr(p - c[j]) < sqr(r[j]));
            }

            if (!covered)
            {
                const scalar w =
                    max(scalar(-1), min(scalar(1), signedDistance(p)/h_));
                ++exposed;
                growth += w;
                shift += w*n;
            }
        }

        if (exposed)
        {
            // The normal's components have the mean square 1/3, the radius'
            // factor is one: 3 makes both slopes of equal weight
            radii[i] = max(0.2*r[i], r[i] - length*growth/exposed);
            centres[i] -= 3*length*shift/exposed;
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::sphereFit::sphereFit(const closedSurface& body, const label cells)
:
    body_(body)
{
    const boundBox box(body.surface().points(), false);
    h_ = cmptMax(box.span())/cells;

    // Room for spheres that stick out
    const label margin = cells/8 + 2;

    for (direction d = 0; d < 3; ++d)
    {
        n_[d] = label(std::ceil(box.span()[d]/h_ - 1e-6)) + 2*margin + 1;
        first_[d] = box.centre()[d] - 0.5*(n_[d] - 1)*h_;
    }

    tabulate();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::sphereFit::improve
(
    pointField& centres,
    scalarField& radii
) const
{
    const scalar d =
        std::cbrt(6*body_.properties().volume/constant::mathematical::pi);

    pointField c(centres);
    scalarField r(radii);
    scalar least = GREAT;

    for (label step = 0; step <= nSteps; ++step)
    {
        if (step % measureEvery == 0)
        {
            pointField cNow(c);
            scalarField rNow(r);
            multisphereGenerator::correctVolume(body_, cNow, rNow);

            const scalar offset = multisphereErrors::offsetVolume
            (
                body_.surface(),
                cNow,
                rNow,
                nLines
            );
            if (offset < least)
            {
                least = offset;
                centres = cNow;
                radii = rNow;
            }
        }

        // From 2 % of the body's diameter down to 0.1 %
        const scalar done = scalar(step)/nSteps;
        descend(d*(0.02*(1 - done) + 0.001*done), c, r);
    }
}


// ************************************************************************* //
