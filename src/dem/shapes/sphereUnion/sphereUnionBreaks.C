/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.
\*---------------------------------------------------------------------------*/

#include "sphereUnion.H"

#include <algorithm>
#include <cmath>
#include <numeric>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::sphereUnion::keepOuter
(
    const pointField& centres,
    const scalarField& radii
)
{
    // Largest first: a sphere can only be inside one that came before
    std::vector<label> order(radii.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort
    (
        order.begin(),
        order.end(),
        [&](const label a, const label b) { return radii[a] > radii[b]; }
    );

    for (const label i : order)
    {
        const vector c(centres[i] - origin_);
        const scalar r = radii[i];
        bool inside = false;

        for (size_t k = 0; k < centres_.size() && !inside; ++k)
        {
            inside = (mag(c - centres_[k]) + r <= radii_[k]*(1 + 1e-14));
        }

        if (!inside)
        {
            centres_.push_back(c);
            radii_.push_back(r);
        }
    }
}


void Foam::dem::sphereUnion::findNeighbours()
{
    const label n = centres_.size();
    neighbours_.resize(n);

    for (label i = 0; i < n; ++i)
    {
        for (label j = 0; j < i; ++j)
        {
            const scalar reach = radii_[i] + radii_[j];
            if (magSqr(centres_[i] - centres_[j]) < reach*reach)
            {
                neighbours_[i].push_back(j);
                neighbours_[j].push_back(i);
            }
        }
    }
}


bool Foam::dem::sphereUnion::exposed
(
    const vector& p,
    const label i,
    const label j,
    const label k
) const
{
    for (const label other : neighbours_[i])
    {
        const scalar r = radii_[other]*(1 - 1e-10);

        if
        (
            other != j
         && other != k
         && magSqr(p - centres_[other]) < r*r
        )
        {
            return false;
        }
    }

    return true;
}


void Foam::dem::sphereUnion::addCircleEnds
(
    const label i,
    const label j,
    std::vector<scalar>& z
) const
{
    // Circle about m with radius rho, across the unit vector u
    const vector arm(centres_[j] - centres_[i]);
    const scalar d = mag(arm);
    const vector u(arm/d);

    const scalar along =
        (d*d + radii_[i]*radii_[i] - radii_[j]*radii_[j])/(2*d);
    const scalar rhoSqr = radii_[i]*radii_[i] - along*along;

    if (rhoSqr <= 0)
    {
        return;
    }

    const vector m(centres_[i] + along*u);
    const vector up(vector(0, 0, 1) - u.z()*u);
    const scalar steep = mag(up);

    if (steep < 1e-12)
    {
        z.push_back(m.z());
        return;
    }

    const vector rise(up*(std::sqrt(rhoSqr)/steep));

    for (const vector& p : {vector(m + rise), vector(m - rise)})
    {
        // With a flat circle the exposed part decides little: keep both
        if (steep < 1e-6 || exposed(p, i, j, j))
        {
            z.push_back(p.z());
        }
    }
}


void Foam::dem::sphereUnion::addTriplePoints
(
    const label i,
    const label j,
    const label k,
    std::vector<scalar>& z
) const
{
    // |p - ci| = ri etc. Differences give two planes: p = ci + a e1 + b e2
    // in their plane, and p leaves it by h along the normal n
    const vector a(centres_[j] - centres_[i]);
    const vector b(centres_[k] - centres_[i]);
    const vector n(a ^ b);
    const scalar nn = magSqr(n);

    if (nn < 1e-20*magSqr(a)*magSqr(b))
    {
        return;
    }

    const scalar ri2 = radii_[i]*radii_[i];
    const scalar sa = 0.5*(magSqr(a) + ri2 - radii_[j]*radii_[j]);
    const scalar sb = 0.5*(magSqr(b) + ri2 - radii_[k]*radii_[k]);

    // In-plane vector q with q.a = sa and q.b = sb
    const vector q((sa*(b ^ n) + sb*(n ^ a))/nn);
    const scalar hSqr = ri2 - magSqr(q);

    if (hSqr < 0)
    {
        return;
    }

    const vector h(n*std::sqrt(hSqr/nn));

    for (const vector& p : {vector(q + h), vector(q - h)})
    {
        const vector x(centres_[i] + p);
        if (exposed(x, i, j, k))
        {
            z.push_back(x.z());
        }
    }
}


std::vector<Foam::scalar> Foam::dem::sphereUnion::breaks() const
{
    const label n = centres_.size();
    std::vector<scalar> z;

    for (label i = 0; i < n; ++i)
    {
        for (const scalar end : {-radii_[i], radii_[i]})
        {
            const vector p(centres_[i] + vector(0, 0, end));
            if (exposed(p, i, i, i))
            {
                z.push_back(p.z());
            }
        }

        for (const label j : neighbours_[i])
        {
            if (j > i)
            {
                continue;
            }
            addCircleEnds(i, j, z);

            for (const label k : neighbours_[j])
            {
                if (k < j && magSqr(centres_[k] - centres_[i])
                  < sqr(radii_[k] + radii_[i]))
                {
                    addTriplePoints(i, j, k, z);
                }
            }
        }
    }

    std::sort(z.begin(), z.end());

    // Merge what round-off has parted
    const scalar least = 1e-10*(z.back() - z.front());
    std::vector<scalar> merged(1, z.front());
    for (const scalar value : z)
    {
        if (value - merged.back() > least)
        {
            merged.push_back(value);
        }
    }

    return merged;
}


// ************************************************************************* //
