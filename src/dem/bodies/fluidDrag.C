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
    return
        z > shortStep
      ? -std::expm1(-z)/z
      : 1 - z/2*(1 - z/3*(1 - z/4*(1 - z/5*(1 - z/6*(1 - z/7)))));
}


//- Share of the start in the mean velocity of a step
scalar startShare(const scalar z)
{
    return
        z > shortStep
      ? 1/z - std::exp(-z)/(-std::expm1(-z))
      : 0.5 - z/12*(1 - z*z/60);
}


//- The power p of 1 + r, to 1e-7 of r where r is small
scalar powerOf(const scalar r, const scalar p)
{
    return
        std::abs(r) < 0.02
      ? 1 + p*r*(1 - (1 - p)*r/2*(1 - (2 - p)*r/3))
      : std::pow(1 + r, p);
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::dem::fluidDrag::meanRate
(
    const label b,
    const vector& slip,
    const vector& a,
    const scalar h
) const
{
    const scalar k0 = rate(b, mag(slip));
    if (!(k0 > 0))
    {
        return 0;
    }
    const scalar z = k0*h;
    const scalar share = startShare(z);

    // The rate at the end over k0, if a step is made with k
    const auto endRate = [&](const scalar k)
    {
        const vector end = slip - h*phi(k*h)*(a + k*slip);
        return max(rate(b, mag(end))/k0, SMALL);
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


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::dem::fluidDrag::kick
(
    const label b,
    const vector& v,
    const vector& a,
    const scalar h
) const
{
    const vector slip = fluidVelocity(b) - v;
    const vector free = massShare(b)*a;
    const scalar k = meanRate(b, slip, free, h);
    return h*phi(k*h)*(free + k*slip);
}


// ************************************************************************* //
