/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "slipHistory.H"

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

//- (1 - exp(-z))/z
Foam::scalar phi(const Foam::scalar z)
{
    return z > 0 ? -std::expm1(-z)/z : 1;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::coupling::slipHistory::retire(const historyKernel& kernel)
{
    const scalar old = age(0);
    const scalar young = age(1);
    const vector change = recent_[1].w - recent_[0].w;
    forAll(sums_, i)
    {
        const scalar rate = kernel.rates()[i];
        sums_[i] += exp(-rate*young)*phi(rate*(old - young))*change;
        if (fromStart_)
        {
            sums_[i] += exp(-rate*old)*recent_[0].w;
        }
    }
    fromStart_ = false;

    for (label j = 1; j < recent_.size(); ++j)
    {
        recent_[j - 1] = recent_[j];
    }
    recent_.remove();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::coupling::slipHistory::append
(
    const scalar t,
    const vector& w,
    const vector& u,
    const historyKernel& kernel
)
{
    if (recent_.empty())
    {
        sums_.setSize(kernel.rates().size(), Zero);
    }
    else
    {
        const scalar h = t - recent_.last().t;
        rate_ = (u - u_)/h;
        forAll(sums_, i)
        {
            sums_[i] *= exp(-kernel.rates()[i]*h);
        }
    }
    u_ = u;
    recent_.append(record{t, w});

    while
    (
        kernel.bounded()
     && recent_.size() > 1
     && age(1) >= kernel.window()
    )
    {
        retire(kernel);
    }
}


Foam::vector Foam::coupling::slipHistory::mean
(
    const scalar h,
    const historyKernel& kernel
) const
{
    const auto G = [h](const scalar a)
    {
        return (a + h)*sqrt(a + h) - a*sqrt(a);
    };

    vector sum = Zero;
    if (fromStart_)
    {
        const scalar a = age(0);
        sum += 2/(sqrt(a + h) + sqrt(a))*recent_[0].w;
    }

    scalar older = G(age(0));
    for (label j = 1; j < recent_.size(); ++j)
    {
        const scalar younger = G(age(j));
        sum +=
            4/(3*h)*(older - younger)/(recent_[j].t - recent_[j - 1].t)
           *(recent_[j].w - recent_[j - 1].w);
        older = younger;
    }

    forAll(sums_, i)
    {
        sum += kernel.weights()[i]*phi(kernel.rates()[i]*h)*sums_[i];
    }
    return sum;
}


void Foam::coupling::slipHistory::save(DynamicList<vector>& values) const
{
    values.append(vector(recent_.size(), sums_.size(), fromStart_));
    values.append(u_);
    values.append(rate_);
    for (const record& r : recent_)
    {
        values.append(vector(r.t, 0, 0));
        values.append(r.w);
    }
    values.append(sums_);
}


bool Foam::coupling::slipHistory::load
(
    const UList<vector>& values,
    const historyKernel& kernel
)
{
    if (values.size() < 3)
    {
        return false;
    }
    const label nRecent = label(values[0].x());
    const label nSums = label(values[0].y());
    if
    (
        nRecent < 1
     || nSums != kernel.rates().size()
     || values.size() != 3 + 2*nRecent + nSums
    )
    {
        return false;
    }

    fromStart_ = values[0].z() > 0.5;
    u_ = values[1];
    rate_ = values[2];
    recent_.clear();
    for (label j = 0; j < nRecent; ++j)
    {
        recent_.append(record{values[3 + 2*j].x(), values[4 + 2*j]});
    }
    sums_.setSize(nSums);
    forAll(sums_, i)
    {
        sums_[i] = values[3 + 2*nRecent + i];
    }
    return true;
}


// ************************************************************************* //
