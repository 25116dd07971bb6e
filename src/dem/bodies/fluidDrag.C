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

//- (1 - exp(-z))/z
scalar phi(const scalar z)
{
    return z > 0 ? -std::expm1(-z)/z : 1;
}


//- Share of the start in the mean velocity of a step
scalar startShare(const scalar z)
{
    // The first terms of the series, where the quotient loses its digits
    return
        z < 1e-2
      ? 0.5 - z/12
      : 1/z - std::exp(-z)/(-std::expm1(-z));
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
    const scalar share = startShare(k0*h);

    // Logarithm of the mean rate over k0, if a step is made with exp(l) k0
    const auto next = [&](const scalar l)
    {
        const scalar k = std::exp(l)*k0;
        const vector end = slip - h*phi(k*h)*(a + k*slip);
        return (1 - share)*std::log(rate(b, mag(end))/k0);
    };

    const scalar l1 = next(0);
    if (mag(l1)*k0*h < 1e-3)
    {
        // What the next one would change is below a thousandth
        return std::exp(l1)*k0;
    }

    // A rate that grows with the slip makes the end's one fall: slope < 0,
    // and above -1 as drag grows with the square of the slip at most
    const scalar slope = min(max(next(l1)/l1 - 1, scalar(-1)), scalar(0));
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
