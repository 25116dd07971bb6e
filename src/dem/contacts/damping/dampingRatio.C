/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "dampingRatio.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::scalar;

//- |ln e| where the force may not pull; grows with beta
scalar lossOfPush(const scalar beta)
{
    if (Foam::mag(beta - 1) < 1e-8)
    {
        return 2*beta;
    }
    return
        beta < 1
      ? 2*beta*std::acos(beta)/std::sqrt(1 - beta*beta)
      : 2*beta*std::acosh(beta)/std::sqrt(beta*beta - 1);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

Foam::scalar Foam::dem::restitutionOf(const scalar beta, const bool pulling)
{
    if (!pulling)
    {
        return exp(-lossOfPush(beta));
    }
    return
        beta < 1
      ? exp(-constant::mathematical::pi*beta/sqrt(1 - sqr(beta)))
      : 0;
}


Foam::scalar Foam::dem::dampingRatioOf(const scalar e, const bool pulling)
{
    const scalar loss = -log(e);
    if (pulling)
    {
        return loss/sqrt(sqr(constant::mathematical::pi) + sqr(loss));
    }

    // Halved until nothing is left between
    scalar low = 0, high = 1;
    while (lossOfPush(high) < loss)
    {
        high *= 2;
    }
    for (;;)
    {
        const scalar middle = 0.5*(low + high);
        if (!(middle > low && middle < high))
        {
            return middle;
        }
        (lossOfPush(middle) < loss ? low : high) = middle;
    }
}


Foam::scalar Foam::dem::viscousPerRatio(const bool isHertz)
{
    return isHertz ? 2*sqrt(5.0/6.0) : 2;
}


// ************************************************************************* //
