/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "sphereRegion.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(sphereRegion, 0);
    addToRunTimeSelectionTable(region, sphereRegion, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::sphereRegion::sphereRegion(const dictionary& dict)
{
    List<point> centre(1);
    read(dict, typeName, centre, &radius_);
    centre_ = centre[0];
}



// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dem::sphereRegion::volume() const
{
    return 4.0/3.0*constant::mathematical::pi*pow3(radius_);
}


bool Foam::dem::sphereRegion::contains(const point& p, const scalar r) const
{
    return r <= radius_ && magSqr(p - centre_) <= sqr(radius_ - r);
}


Foam::point Foam::dem::sphereRegion::at(const vector& u) const
{
    // Equal volumes of the radius, equal areas of the height (Archimedes)
    const scalar z = 2*u.y() - 1;
    const scalar flat = std::sqrt(max(1 - sqr(z), scalar(0)));
    const scalar angle = constant::mathematical::twoPi*u.z();
    return
        centre_
      + radius_*std::cbrt(u.x())
       *vector(flat*std::cos(angle), flat*std::sin(angle), z);
}


Foam::point Foam::dem::sphereRegion::low() const
{
    return centre_ - radius_*vector::one;
}


Foam::point Foam::dem::sphereRegion::high() const
{
    return centre_ + radius_*vector::one;
}


// ************************************************************************* //
