/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "historyKernel.H"
#include "checkedEntry.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::coupling::historyKernel::makeExponentials(const scalar longest)
{
    const scalar q = 1;
    const scalar lost = 1e-4;

    const scalar first = log(lost/longest);
    const scalar last = log(-log(lost)/window_);
    const label n = label(ceil((last - first)/q)) + 1;

    rates_.setSize(n);
    weights_.setSize(n);
    forAll(rates_, i)
    {
        const scalar x = first + i*q;
        rates_[i] = exp(x);
        weights_[i] = q*exp(x/2)/sqrt(constant::mathematical::pi);
    }

    // All that are slower: a geometric series
    weights_[0] /= 1 - exp(-q/2);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::historyKernel::historyKernel(const dictionary& dict)
:
    memory_(memory::full),
    window_(GREAT)
{
    const word name
    (
        dem::getChoice
        (
            dict,
            "memory",
            {"full", "window", "exponentials"},
            "full"
        )
    );
    if (name == "full")
    {
        for (const word& key : {"window", "longest"})
        {
            if (dict.found(key))
            {
                dem::badEntry
                (
                    dict,
                    key,
                    "is of no use with memory full; take it out"
                );
            }
        }
        return;
    }

    window_ = dem::getPositive(dict, "window");
    memory_ = memory::window;
    if (name == "exponentials")
    {
        memory_ = memory::exponentials;
        const scalar longest =
            dem::getPositive(dict, "longest", 1e6*window_);
        if (longest <= window_)
        {
            dem::badEntry(dict, "longest", "must be above window");
        }
        makeExponentials(longest);
    }
    else if (dict.found("longest"))
    {
        dem::badEntry(dict, "longest", "needs memory exponentials");
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::coupling::historyKernel::sum(const scalar age) const
{
    scalar s = 0;
    forAll(rates_, i)
    {
        s += weights_[i]*exp(-rates_[i]*age);
    }
    return s;
}


// ************************************************************************* //
