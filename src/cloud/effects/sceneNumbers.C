/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "sceneNumbers.H"
#include "mathematicalConstants.H"

#include <cmath>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::sceneNumbers::volume() const
{
    return constant::mathematical::pi/6*pow3(d);
}


Foam::scalar Foam::sceneNumbers::Re() const
{
    return inFluid() ? slip*d/nu : 0;
}


Foam::scalar Foam::sceneNumbers::shearRe() const
{
    return inFluid() ? shear*sqr(d)/nu : 0;
}


Foam::scalar Foam::sceneNumbers::spinRe() const
{
    return inFluid() ? spin*sqr(d)/nu : 0;
}


Foam::scalar Foam::sceneNumbers::f() const
{
    const scalar alpha = max(1 - fraction, scalar(0.35));
    const scalar r = Re();
    const scalar alone = r > 1000 ? 0.44*r/24 : 1 + 0.15*std::pow(r, 0.687);
    return alone*std::pow(alpha, -2.65);
}


Foam::scalar Foam::sceneNumbers::drag() const
{
    return 3*constant::mathematical::pi*rhoF*nu*d*f()*slip;
}


Foam::scalar Foam::sceneNumbers::netWeight() const
{
    return mag(rhoP - rhoF)*volume()*g;
}


Foam::scalar Foam::sceneNumbers::dragShare() const
{
    const scalar F = drag();
    const scalar most = max(F, netWeight());
    return most > 0 ? F/most : 1;
}


Foam::scalar Foam::sceneNumbers::terminalSlip() const
{
    const scalar W = netWeight();
    if (!inFluid() || !(W > 0))
    {
        return 0;
    }

    // Between nothing and Stokes' velocity, as the drag is above Stokes'
    sceneNumbers n(*this);
    scalar low = 0;
    scalar high = W/(3*constant::mathematical::pi*rhoF*nu*d);
    for (int i = 0; i < 60; ++i)
    {
        n.slip = 0.5*(low + high);
        (n.drag() > W ? high : low) = n.slip;
    }
    return n.slip;
}


Foam::scalar Foam::sceneNumbers::relaxationTime() const
{
    return inFluid() ? (rhoP + 0.5*rhoF)*sqr(d)/(18*rhoF*nu*f()) : GREAT;
}


Foam::scalar Foam::sceneNumbers::stirred() const
{
    if (!(k > 0) || !(epsilon > 0))
    {
        return 0;
    }
    // The time as the force dispersion has it with its default
    const scalar sigma = sqrt(2*k/3);
    const scalar T = 0.15*k/epsilon/sqrt(1 + sqr(slip/sigma));
    return sigma*sqrt(T/(T + relaxationTime()));
}


Foam::scalar Foam::sceneNumbers::impactStokes() const
{
    return inFluid() ? rhoP/rhoF*Re()/9 : GREAT;
}


Foam::scalar Foam::sceneNumbers::meets() const
{
    if (!(nBodies > 1))
    {
        return 0;
    }
    const scalar part =
        until > 0
      ? (slip*until + 0.25*d)/max(gap, VSMALL)
      : fraction/often;
    return min(part, scalar(1));
}


Foam::scalar Foam::sceneNumbers::loading() const
{
    return
        inFluid()
      ? rhoP*meanFraction/(rhoF*max(1 - meanFraction, scalar(0.1)))
      : 0;
}


Foam::scalar Foam::sceneNumbers::Bagnold() const
{
    if (!inFluid() || !(fraction > 0))
    {
        return 0;
    }
    const scalar dense = 0.74;
    const scalar lambda =
        1/max(std::cbrt(dense/min(fraction, scalar(0.7))) - 1, SMALL);
    return rhoP*sqr(d)*std::sqrt(lambda)*shear/(rhoF*nu);
}


// ************************************************************************* //
