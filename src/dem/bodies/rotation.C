/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "rotation.H"
#include "bodies.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Sine and cosine; for the small angles of most steps by their series, whose
//  next terms are below round-off
inline void sineCosine
(
    const Foam::scalar a,
    Foam::scalar& sine,
    Foam::scalar& cosine
)
{
    const Foam::scalar s = a*a;
    if (s < 1e-2)
    {
        sine = a*(1 - s/6*(1 - s/20*(1 - s/42*(1 - s/72*(1 - s/110)))));
        cosine = 1 - s/2*(1 - s/12*(1 - s/30*(1 - s/56*(1 - s/90))));
    }
    else
    {
        sine = Foam::sin(a);
        cosine = Foam::cos(a);
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::vector Foam::dem::angularVelocity
(
    const quaternion& q,
    const vector& L,
    const vector& inertia
)
{
    const vector Lb = q.invTransform(L);
    return q.transform(cmptDivide(Lb, inertia));
}


Foam::scalar Foam::dem::largestSpin
(
    const vector& L,
    const vector& omega,
    const vector& inertia
)
{
    const scalar least = cmptMin(inertia);
    const scalar most = cmptMax(inertia);
    const scalar square =
        ((least + most)*(L & omega) - magSqr(L))/(least*most);
    return max(sqrt(max(square, scalar(0))), mag(omega));
}


void Foam::dem::turn
(
    quaternion& q,
    const vector& L,
    const vector& inertia,
    const scalar dt
)
{
    // Angular momentum in the principal frame, which the turns change
    vector Lb = q.invTransform(L);

    const auto about = [&](const direction k, const scalar time)
    {
        const scalar angle = time*Lb[k]/inertia[k];
        scalar halfSine, halfCosine;
        sineCosine(0.5*angle, halfSine, halfCosine);
        const scalar c = halfCosine*halfCosine - halfSine*halfSine;
        const scalar s = 2*halfSine*halfCosine;
        const direction m = (k + 1) % 3;
        const direction n = (k + 2) % 3;

        const scalar Lm = Lb[m];
        Lb[m] = c*Lm + s*Lb[n];
        Lb[n] = c*Lb[n] - s*Lm;

        // q times the turn about an axis
        const scalar w = q.w();
        const vector v = q.v();
        q.w() = halfCosine*w - halfSine*v[k];
        q.v()[k] = halfCosine*v[k] + halfSine*w;
        q.v()[m] = halfCosine*v[m] + halfSine*v[n];
        q.v()[n] = halfCosine*v[n] - halfSine*v[m];
    };

    about(2, 0.5*dt);
    about(1, 0.5*dt);
    about(0, dt);
    about(1, 0.5*dt);
    about(2, 0.5*dt);

    q = unit(q);
}


// ************************************************************************* //
