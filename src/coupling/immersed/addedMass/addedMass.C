/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "addedMass.H"
#include "mathematicalConstants.H"

#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::coupling::addedMass::depth
(
    const direction i,
    const scalar nuDt
) const
{
    return
        std::cbrt(torque_[i]/(8*constant::mathematical::pi))/std::sqrt(nuDt);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::addedMass::addedMass
(
    const scalar volume,
    const vector& inertiaPerDensity
)
:
    volume_(volume),
    // A rod has some about its axis
    inertiaPerDensity_
    (
        max(inertiaPerDensity, 1e-4*cmptMax(inertiaPerDensity)*vector::one)
    )
{
    // Squares of the semi-axes; a disc or a rod has some left
    const vector& I = inertiaPerDensity;
    vector a2 =
        2.5/volume
       *vector
        (
            I.y() + I.z() - I.x(),
            I.z() + I.x() - I.y(),
            I.x() + I.y() - I.z()
        );
    a2 = max(a2, 1e-4*cmptMax(a2)*vector::one);

    const scalar abc = std::sqrt(cmptProduct(a2));
    const vector alpha =
        2*abc/3
       *vector
        (
            RD(a2.y(), a2.z(), a2.x()),
            RD(a2.z(), a2.x(), a2.y()),
            RD(a2.x(), a2.y(), a2.z())
        );

    const scalar pi16 = 16*constant::mathematical::pi*abc;
    const vector chi = cmptMultiply(a2, alpha);
    for (direction i = 0; i < 3; ++i)
    {
        const direction j = (i + 1)%3;
        const direction k = (i + 2)%3;
        mass_[i] = alpha[i]/(2 - alpha[i]);
        drag_[i] = pi16/(cmptSum(chi) + chi[i]);
        torque_[i] = pi16*(a2[j] + a2[k])/(3*(chi[j] + chi[k]));

        // Both differences vanish together where the axes are equal
        const scalar d = a2[j] - a2[k];
        const scalar s = a2[j] + a2[k];
        inertia_[i] =
            mag(d) < 1e-6*s
          ? 0
          : sqr(d)*(alpha[k] - alpha[j])
           /(s*(2*d + s*(alpha[j] - alpha[k])));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::coupling::addedMass::frictionMass(const scalar nuDt) const
{
    return nuDt/volume_*drag_ + 2*passingMass(nuDt);
}


Foam::vector Foam::coupling::addedMass::passingMass(const scalar nuDt) const
{
    return
        std::sqrt(nuDt)/(12*constant::mathematical::pi*volume_)
       *cmptMultiply(drag_, drag_);
}


Foam::vector
Foam::coupling::addedMass::frictionInertia(const scalar nuDt) const
{
    vector J(Zero);
    for (direction i = 0; i < 3 && nuDt > 0; ++i)
    {
        const scalar lambda = depth(i, nuDt);
        J[i] =
            nuDt*torque_[i]/inertiaPerDensity_[i]
           *(1 + sqr(lambda)/(3*(1 + lambda)));
    }
    return J;
}


Foam::vector
Foam::coupling::addedMass::passingInertia(const scalar nuDt) const
{
    vector J(Zero);
    for (direction i = 0; i < 3 && nuDt > 0; ++i)
    {
        const scalar lambda = depth(i, nuDt);
        J[i] =
            nuDt*torque_[i]/inertiaPerDensity_[i]
           *sqr(lambda/(1 + lambda))*(2 + lambda)/6;
    }
    return J;
}


Foam::scalar Foam::coupling::addedMass::RD(scalar x, scalar y, scalar z)
{
    // Each duplication brings the arguments together by a factor of 4
    scalar sum = 0;
    scalar factor = 1;
    scalar mean = 0;
    vector d;
    do
    {
        const scalar rx = std::sqrt(x);
        const scalar ry = std::sqrt(y);
        const scalar rz = std::sqrt(z);
        const scalar lambda = rx*(ry + rz) + ry*rz;
        sum += factor/(rz*(z + lambda));
        factor /= 4;
        x = (x + lambda)/4;
        y = (y + lambda)/4;
        z = (z + lambda)/4;
        mean = (x + y + 3*z)/5;
        d = vector(mean - x, mean - y, mean - z)/mean;
    }
    while (cmptMax(cmptMag(d)) > 1e-3);

    // The series about equal arguments
    const scalar ea = d.x()*d.y();
    const scalar eb = sqr(d.z());
    const scalar ec = ea - eb;
    const scalar ed = ea - 6*eb;
    const scalar ee = ed + 2*ec;
    return
        3*sum
      + factor
       *(
            1
          + ed*(-3.0/14 + 9.0/88*ed - 4.5/26*d.z()*ee)
          + d.z()*(ee/6 + d.z()*(-9.0/22*ec + d.z()*3.0/26*ea))
        )/(mean*std::sqrt(mean));
}


// ************************************************************************* //
