/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.
\*---------------------------------------------------------------------------*/

#include "shape.H"
#include "error.H"
#include "mathematicalConstants.H"
#include "sphereUnion.H"

#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::shape::set
(
    const List<sphereData>& spheres,
    const massProperties* body
)
{
    const label n = spheres.size();
    centres_.setSize(n);
    radii_.setSize(n);

    forAll(spheres, i)
    {
        centres_[i] = spheres[i].first();
        radii_[i] = spheres[i].second();
    }

    const massProperties hull(sphereUnion(centres_, radii_).properties());
    const massProperties& mass = body ? *body : hull;

    unionVolume_ = hull.volume;
    volume_ = mass.volume;
    equivalentDiameter_ = std::cbrt(6*volume_/constant::mathematical::pi);
    centreOfMass_ = mass.centroid;
    mass.principalAxes(toUser_, inertiaPerDensity_);

    boundingRadius_ = 0;
    forAll(centres_, i)
    {
        // v & T = T^T & v turns the user's vector into the principal frame
        centres_[i] = (centres_[i] - centreOfMass_) & toUser_;
        boundingRadius_ =
            max(boundingRadius_, mag(centres_[i]) + radii_[i]);
    }

    // All three moments of a sphere are 2/5 V r^2
    const scalar own = 0.4*unionVolume_*sqr(radii_[0]);

    isSphere_ =
        n == 1
     && mag(centres_[0]) <= 1e-9*radii_[0]
     && cmptMax(cmptMag(inertiaPerDensity_ - own*vector::one)) <= 1e-9*own;

    if (isSphere_)
    {
        centres_[0] = Zero;
        boundingRadius_ = radii_[0];
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::shape::shape(const word& name, const List<sphereData>& spheres)
:
    name_(name)
{
    set(spheres, nullptr);
}


Foam::dem::shape::shape
(
    const word& name,
    const List<sphereData>& spheres,
    const massProperties& body
)
:
    name_(name)
{
    set(spheres, &body);
}


Foam::dem::shape Foam::dem::shape::sphere(const word& name, scalar diameter)
{
    if (!(diameter > 0) || !std::isfinite(diameter))
    {
        FatalErrorInFunction
            << "Sphere " << name << " has the diameter " << diameter
            << " [m]; it must be greater than zero" << exit(FatalError);
    }

    return shape(name, List<sphereData>(1, sphereData(Zero, 0.5*diameter)));
}


Foam::dem::shape Foam::dem::shape::scaled
(
    const word& name,
    const scalar factor
) const
{
    shape s(*this);
    s.name_ = name;
    s.centres_ *= factor;
    s.radii_ *= factor;
    s.centreOfMass_ *= factor;
    s.boundingRadius_ *= factor;
    s.volume_ *= pow3(factor);
    s.equivalentDiameter_ *= factor;
    s.unionVolume_ *= pow3(factor);
    s.inertiaPerDensity_ *= pow5(factor);
    s.surfaceScale_ *= factor;
    return s;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dem::shape::minRadius() const
{
    return min(radii_);
}


Foam::scalar Foam::dem::shape::maxRadius() const
{
    return max(radii_);
}


// ************************************************************************* //
