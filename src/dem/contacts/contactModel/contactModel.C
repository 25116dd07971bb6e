/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "contactKernel.H"
#include "hertz.H"
#include "tangentialLaws.H"
#include "dampingLaws.H"

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::dem;

//- The kernel once the normal and the tangential law are known
template<class Normal, class Tangential>
autoPtr<contactModel> withDamping(const word& damping, const materials& m)
{
    if (damping == "restitution")
    {
        return autoPtr<contactModel>
        (
            new contactKernel<Normal, Tangential, dampingLaws::restitution>(m)
        );
    }
    if (damping == "hades")
    {
        return autoPtr<contactModel>
        (
            new contactKernel<Normal, Tangential, dampingLaws::hades>(m)
        );
    }
    return autoPtr<contactModel>
    (
        new contactKernel<Normal, Tangential, dampingLaws::none>(m)
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dem::contactModel> Foam::dem::contactModel::New
(
    const contactLaws& laws,
    const materials& m
)
{
    using normalLaws::hertz;

    return
        laws.tangential == "mindlin"
      ? withDamping<hertz, tangentialLaws::mindlin>(laws.damping, m)
      : withDamping<hertz, tangentialLaws::none>(laws.damping, m);
}


// ************************************************************************* //
