/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.


\*---------------------------------------------------------------------------*/

#include "fluidDrag.H"

#include <cmath>

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

using Foam::scalar;

// Steps are short as a rule: series save most of the time there. The first term
// that is left out is below 1e-11 up to this z
const scalar shortStep = 0.05;


//- (1 - exp(-z))/z
scalar phi(const scalar z)
{
    if (z > shortStep)
    {
        return -std::expm1(-z)/z;
    }
    // Factors, as a division takes five times as long
    return
        1 - z*(1.0/2 - z*(1.0/6 - z*(1.0/24 - z*(1.0/120 - z*(1.0/720
      - z*(1.0/5040))))));
}


//- Share of the start in the mean velocity of a step
scalar startShare(const scalar z)
{
    return
        z > shortStep
      ? 1/z - std::exp(-z)/(-std::expm1(-z))
      : 0.5 - (1.0/12)*z*(1 - (1.0/60)*z*z);
}


//- The power p of 1 + r, to 1e-7 of r where r is small
scalar powerOf(const scalar r, const scalar p)
{
    return
        std::abs(r) < 0.02
      ? 1 + p*r*(1 - 0.5*(1 - p)*r*(1 - (1.0/3)*(2 - p)*r))
      : std::pow(1 + r, p);
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Rate>
Foam::scalar Foam::dem::fluidDrag::meanRate
(
    const Rate& rate,
    const vector& slip,
    const vector& a,
    const scalar h
)
{
    const scalar k0 = rate(mag(slip));
    if (!(k0 > 0))
    {
        return 0;
    }
    const scalar perK0 = 1/k0;
    const scalar z = k0*h;
    const scalar share = startShare(z);

    // The rate at the end over k0, if a step is made with k
    const auto endRate = [&](const scalar k)
    {
        const vector end = slip - h*phi(k*h)*(a + k*slip);
        return max(rate(mag(end))*perK0, SMALL);
    };

    // The mean over k0, to the powers of the two shares
    const scalar m1 = powerOf(endRate(k0) - 1, 1 - share);
    if (mag(m1 - 1)*z < 1e-3)
    {
        // What the next one would change is below a thousandth
        return m1*k0;
    }

    // A rate that grows with the slip makes the end's one fall: slope < 0,
    // and above -1 as drag grows with the square of the slip at most
    const scalar l1 = std::log(m1);
    const scalar l2 = (1 - share)*std::log(endRate(m1*k0));
    const scalar slope = min(max(l2/l1 - 1, scalar(-1)), scalar(0));
    return std::exp(l1/(1 - slope))*k0;
}


inline bool Foam::dem::fluidDrag::meanRateNear
(
    const dragRecord& l,
    const vector& slip,
    const vector& a,
    const scalar h,
    scalar& k
)
{
    scalar d;
    if (!holds(l, mag(slip), d))
    {
        return false;
    }
    const scalar k0 = rateAt(l, d);
    const scalar z = k0*h;
    const vector end = slip - h*(1 - 0.5*z)*(a + k0*slip);
    if (!(z < 2e-3) || !holds(l, mag(end), d))
    {
        return false;
    }

    // The share of the start is 1/2 - z/12; of rates that are this close the
    // sum of the shares is their power to (change/k0)^2/8
    const scalar change = rateAt(l, d) - k0;
    k = k0 + (0.5 + (1.0/12)*z)*change;
    return mag(change) < 5e-4*k0;
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

void Foam::dem::fluidDrag::takeExpansion
(
    const fluidDrag& from,
    const labelUList& source
)
{
    const bool expanded = from.near_.size();
    startExpansion(expanded ? source.size() : 0);
    forAll(near_, b)
    {
        near_[b] =
            source[b] >= 0
          ? from.near_[source[b]]
          : dragRecord{{0, 0, 0}, 1, -1, 0, 0, 0};
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::dem::fluidDrag::kick
(
    const label b,
    const vector& v,
    const vector& a,
    const scalar h
) const
{
    const bool known = b < near_.size();
    const vector slip = slipNear(b, v);
    const vector free = (known ? near_[b].massShare : massShare(b))*a;
    scalar k;
    if (known && meanRateNear(near_[b], slip, free, h, k))
    {
        // Four terms of phi: the next is below 1e-12
        const scalar z = k*h;
        return h*(1 - z*(0.5 - z*(1.0/6 - z*(1.0/24))))*(free + k*slip);
    }
    const auto rateOf = [&](const scalar s) { return rateNear(b, s); };
    k = meanRate(rateOf, slip, free, h);
    return h*phi(k*h)*(free + k*slip);
}


// ************************************************************************* //
