/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.
\*---------------------------------------------------------------------------*/

#include "sphereUnion.H"
#include "boundBox.H"
#include "error.H"
#include "mathematicalConstants.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

constexpr scalar twoPi = constant::mathematical::twoPi;

// Points and weights of the Gauss-Legendre rule of n points on (-1, 1), by
// Newton's method on the Legendre polynomial
void gaussLegendre
(
    const int n,
    std::vector<scalar>& x,
    std::vector<scalar>& w
)
{
    x.resize(n);
    w.resize(n);

    for (int i = 0; i < n; ++i)
    {
        scalar t = std::cos(constant::mathematical::pi*(i + 0.75)/(n + 0.5));
        scalar slope = 1;

        for (int iter = 0; iter < 20; ++iter)
        {
            scalar p0 = 1;
            scalar p1 = t;
            for (int k = 2; k <= n; ++k)
            {
                const scalar p2 = ((2*k - 1)*t*p1 - (k - 1)*p0)/k;
                p0 = p1;
                p1 = p2;
            }
            slope = n*(t*p1 - p0)/(t*t - 1);
            t -= p1/slope;
        }

        x[i] = t;
        w[i] = 2/((1 - t*t)*slope*slope);
    }
}


// Integrals from 0 to an angle of products of its cosine c and sine s
struct arcIntegrals
{
    scalar t;                           // 1
    scalar c, cc, ccc, cccc;
    scalar s, ss, sss, ssss;
    scalar cs, ccs, cccs;

    explicit arcIntegrals(const scalar a)
    {
        const scalar co = std::cos(a);
        const scalar si = std::sin(a);

        t = a;
        c = si;
        cc = 0.5*(a + si*co);
        ccc = si - si*si*si/3;
        cccc = 0.25*co*co*co*si + 0.75*cc;
        s = -co;
        ss = 0.5*(a - si*co);
        sss = -co + co*co*co/3;
        ssss = -0.25*si*si*si*co + 0.75*ss;
        cs = 0.5*si*si;
        ccs = -co*co*co/3;
        cccs = -0.25*co*co*co*co;
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::dem::sphereUnion::coveredArcs
(
    const std::vector<disc>& discs,
    const std::vector<label>& place,
    const disc& me,
    std::vector<std::pair<scalar, scalar>>& covered
) const
{
    for (const label other : neighbours_[me.sphere])
    {
        if (place[other] < 0)
        {
            continue;
        }

        const disc& you = discs[place[other]];
        const scalar dx = you.x - me.x;
        const scalar dy = you.y - me.y;
        const scalar distance = std::hypot(dx, dy);

        if (distance >= me.r + you.r || distance + you.r <= me.r)
        {
            // Apart, or the other one inside: nothing of me is covered.
            // Of two discs that are the same the second is covered
            if (distance > 0 || me.r != you.r || other > me.sphere)
            {
                continue;
            }
        }

        if (distance + me.r <= you.r)
        {
            return false;
        }

        const scalar cosine =
            (distance*distance + me.r*me.r - you.r*you.r)/(2*distance*me.r);

        const scalar half = std::acos(max(scalar(-1), min(scalar(1), cosine)));

        scalar start = std::atan2(dy, dx) - half;
        if (start < 0)
        {
            start += twoPi;
        }
        const scalar end = start + 2*half;

        covered.emplace_back(start, min(end, twoPi));
        if (end > twoPi)
        {
            covered.emplace_back(0, end - twoPi);
        }
    }

    std::sort(covered.begin(), covered.end());

    return true;
}


void Foam::dem::sphereUnion::addArc
(
    const disc& me,
    const scalar from,
    const scalar to,
    sliceMoments& sum
)
{
    const arcIntegrals p(from), q(to);
    const scalar a = me.x, b = me.y, r = me.r;
    const scalar c = q.c - p.c, s = q.s - p.s;
    const scalar cc = q.cc - p.cc, ss = q.ss - p.ss;
    const scalar ccc = q.ccc - p.ccc, sss = q.sss - p.sss;

    sum.a += 0.5*r*(r*(q.t - p.t) + a*c + b*s);
    sum.x += 0.5*r*(a*a*c + 2*a*r*cc + r*r*ccc);
    sum.y += 0.5*r*(b*b*s + 2*b*r*ss + r*r*sss);
    sum.xx += r/3
       *(a*a*a*c + 3*a*a*r*cc + 3*a*r*r*ccc + r*r*r*(q.cccc - p.cccc));
    sum.yy += r/3
       *(b*b*b*s + 3*b*b*r*ss + 3*b*r*r*sss + r*r*r*(q.ssss - p.ssss));
    sum.xy += 0.5*r
       *(
            b*(a*a*c + 2*a*r*cc + r*r*ccc)
          + r
           *(
                a*a*(q.cs - p.cs)
              + 2*a*r*(q.ccs - p.ccs)
              + r*r*(q.cccs - p.cccs)
            )
        );
}


Foam::dem::sphereUnion::sliceMoments Foam::dem::sphereUnion::slice
(
    const scalar z
) const
{
    const label n = centres_.size();

    std::vector<disc> discs;
    std::vector<label> place(n, -1);

    for (label i = 0; i < n; ++i)
    {
        const scalar h = z - centres_[i].z();
        const scalar square = (radii_[i] - h)*(radii_[i] + h);

        if (square > 0)
        {
            place[i] = discs.size();
            discs.push_back
            (
                {centres_[i].x(), centres_[i].y(), std::sqrt(square), i}
            );
        }
    }

    sliceMoments sum;
    for (const disc& d : discs)
    {
        std::vector<std::pair<scalar, scalar>> covered;
        if (!coveredArcs(discs, place, d, covered))
        {
            continue;
        }
        covered.emplace_back(twoPi, twoPi);

        scalar from = 0;
        for (const auto& arc : covered)
        {
            if (arc.first > from)
            {
                addArc(d, from, arc.first, sum);
            }
            from = max(from, arc.second);
        }
    }

    return sum;
}


void Foam::dem::sphereUnion::integrate()
{
    std::vector<scalar> x, w;
    gaussLegendre(16, x, w);

    scalar V = 0;
    vector first(Zero);
    symmTensor second(Zero);

    const std::vector<scalar> ends(breaks());

    for (size_t k = 1; k < ends.size(); ++k)
    {
        const scalar mid = 0.5*(ends[k] + ends[k-1]);
        const scalar half = 0.5*(ends[k] - ends[k-1]);

        for (size_t q = 0; q < x.size(); ++q)
        {
            // z = mid + half (3 t - t^3)/2: slope zero at both ends, so that
            // powers of sqrt(z - end) become smooth in t
            const scalar t = x[q];
            const scalar z = mid + half*0.5*t*(3 - t*t);
            const scalar dz = half*1.5*(1 - t*t)*w[q];

            const sliceMoments s(slice(z));

            V += dz*s.a;
            first += dz*vector(s.x, s.y, z*s.a);
            second +=
                dz*symmTensor(s.xx, s.xy, z*s.x, s.yy, z*s.y, z*z*s.a);
        }
    }

    properties_ = massProperties::fromMoments(V, first, second, origin_);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::sphereUnion::sphereUnion
(
    const pointField& centres,
    const scalarField& radii
)
:
    origin_(boundBox(centres, false).centre())
{
    if (centres.empty() || centres.size() != radii.size())
    {
        FatalErrorInFunction
            << "A union needs as many radii as centres and at least one; got "
            << radii.size() << " and " << centres.size() << exit(FatalError);
    }

    keepOuter(centres, radii);
    findNeighbours();
    integrate();
}


// ************************************************************************* //
