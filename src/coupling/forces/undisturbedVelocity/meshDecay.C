/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "meshDecay.H"
#include "mathematicalConstants.H"

#include <cmath>

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

//- Ages in the table and the largest of them over h^2
const Foam::label nAges = 64;
const Foam::scalar largest = 6;

//- Points along half an axis of the waves
const Foam::label nWaves = 24;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::coupling::meshDecay::age(const label i)
{
    return largest*sqr(scalar(i)/(nAges - 1));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::meshDecay::meshDecay(const bool onFaces)
:
    effective_(nAges, scalar(0))
{
    // All is even in the waves: an eighth of them, and of that the wave along
    // x is not below that along y and y not below z, as often as it stands for
    scalarList lambda(nWaves);
    forAll(lambda, i)
    {
        lambda[i] =
            2 - 2*std::cos((i + 0.5)*constant::mathematical::pi/nWaves);
    }
    for (label i = 0; i < nWaves; ++i)
    for (label j = 0; j <= i; ++j)
    for (label k = 0; k <= j; ++k)
    {
        const scalar all = lambda[i] + lambda[j] + lambda[k];
        scalar trace = onFaces ? 0 : 3;
        for (const label n : {i, j, k})
        {
            // cos^2(k h/2) = 1 - lambda/4, sin^2(k h) = lambda cos^2(k h/2)
            const scalar c = 1 - lambda[n]/4;
            trace +=
                onFaces ? c*(1 - lambda[n]/all) : -lambda[n]*c/all;
        }
        const label times = i == j && j == k ? 1 : i == j || j == k ? 3 : 6;
        forAll(effective_, a)
        {
            effective_[a] += times*trace/3*std::exp(-age(a)*all);
        }
    }
    for (scalar& e : effective_)
    {
        e = std::pow(1.5*e/pow3(scalar(nWaves)), -2.0/3.0)
           /(4*constant::mathematical::pi);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::coupling::meshDecay::effective
(
    const scalar t,
    const scalar h
) const
{
    const scalar s = t/sqr(h);
    if (s >= largest)
    {
        return t + (effective_.last() - largest)*sqr(h);
    }
    const scalar at = (nAges - 1)*std::sqrt(s/largest);
    const label i = min(label(at), nAges - 2);
    const scalar part = (s - age(i))/(age(i + 1) - age(i));
    return
        ((1 - part)*effective_[i] + part*effective_[i + 1])*sqr(h);
}


// ************************************************************************* //
