/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "decay.H"
#include "error.H"
#include "mathematicalConstants.H"
#include "wordList.H"

#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::decay::decay
(
    const word& scheme,
    const label nSteps,
    const scalar tolerance
)
:
    scheme_(scheme),
    nSteps_(nSteps),
    tolerance_(tolerance),
    series_(1, scalar(1)),
    range_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::coupling::decay::schemes()
{
    return wordList({"exact", "implicitEuler", "LStable"});
}


Foam::scalar Foam::coupling::decay::operator()(const scalar z) const
{
    if (scheme_ == "exact")
    {
        return std::exp(-z);
    }
    if (scheme_ == "implicitEuler")
    {
        return std::pow(1 + z/nSteps_, -nSteps_);
    }

    scalar sum = 1;
    scalar term = 1;
    for (label n = 1; n <= 2*nSteps_; ++n)
    {
        term *= z/n;
        sum += term;
    }
    return 1/sum;
}


void Foam::coupling::decay::expand(const scalar range)
{
    using constant::mathematical::pi;

    range_ = range;
    // Twice as many points until the coefficients have come down to the rest
    for (label n = 32; ; n *= 2)
    {
        scalarList value(n);
        forAll(value, j)
        {
            const scalar x = std::cos(pi*(j + 0.5)/n);
            value[j] = operator()(0.5*range*(x + 1));
        }

        scalarList c(n, scalar(0));
        forAll(c, k)
        {
            forAll(value, j)
            {
                c[k] += 2*value[j]*std::cos(pi*k*(j + 0.5)/n)/n;
            }
        }
        c[0] *= 0.5;

        scalar tail = 0;
        label last = n - 1;
        while (last > 0 && tail + mag(c[last]) < tolerance_)
        {
            tail += mag(c[last--]);
        }
        if (last > n/2 && n < 4096)
        {
            continue;
        }

        // The value 1 at z = 0, where the polynomials are 1 and -1 in turn
        c.setSize(last + 1);
        scalar atZero = 0;
        forAll(c, k)
        {
            atZero += k % 2 ? -c[k] : c[k];
        }
        forAll(c, k)
        {
            c[k] /= atZero;
        }
        series_ = c;
        return;
    }
}


void Foam::coupling::decay::apply(const product& z, scalarField& x) const
{
    if (nProducts() == 0)
    {
        return;
    }

    // T_k+1 = 2 X T_k - T_k-1 with X = 2 z/range - 1
    scalarField before(x);
    scalarField now(x.size()), next(x.size());
    z(before, now);
    forAll(now, c)
    {
        now[c] = 2/range_*now[c] - before[c];
        x[c] = series_[0]*before[c] + series_[1]*now[c];
    }
    for (label k = 2; k < series_.size(); ++k)
    {
        z(now, next);
        const scalar ck = series_[k];
        forAll(now, c)
        {
            const scalar t = 4/range_*next[c] - 2*now[c] - before[c];
            x[c] += ck*t;
            before[c] = now[c];
            now[c] = t;
        }
    }
}


// ************************************************************************* //
