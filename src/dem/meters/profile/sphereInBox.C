/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "sphereInBox.H"
#include "mathematicalConstants.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using constant::mathematical::pi;

//- Of a disc of radius s the area where x < a, for a from -s to s [m2]
scalar segment(const scalar s, const scalar a)
{
    return
        s*s*(0.5*pi + std::asin(a/s))
      + a*std::sqrt(std::max(s*s - a*a, scalar(0)));
}


//- Of a disc of radius s the area where x < a and y < b [m2]
scalar corner(const scalar s, const scalar a0, const scalar b0)
{
    const scalar a = std::min(std::max(a0, -s), s);
    const scalar b = std::min(std::max(b0, -s), s);
    const scalar left = segment(s, a);
    const scalar below = segment(s, b);
    if (a*a + b*b < s*s)
    {
        return 0.5*(left + below) + a*b - 0.25*pi*s*s;
    }
    if (a < 0)
    {
        return b < 0 ? 0 : left;
    }
    return b < 0 ? below : left + below - pi*s*s;
}


//- Half of the points of Gauss on (-1, 1), and their weights
const scalar gaussAt[] =
{
    0.1834346424956498, 0.5255324099163290,
    0.7966664774136267, 0.9602898564975363
};
const scalar gaussWeight[] =
{
    0.3626837833783620, 0.3137066458778873,
    0.2223810344533745, 0.1012285362903763
};

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::scalar Foam::dem::sphereInBox
(
    const point& c,
    const scalar r,
    const point& low,
    const point& high
)
{
    const vector a(low - c), b(high - c);
    if (cmptMax(a) >= r || cmptMin(b) <= -r)
    {
        return 0;
    }
    if (cmptMax(a) <= -r && cmptMin(b) >= r)
    {
        return 4.0/3.0*pi*r*r*r;
    }

    // Where in z the disc begins to reach a side or an edge
    const scalar first = std::max(a.z(), -r);
    const scalar last = std::min(b.z(), r);
    scalar cuts[18] = {first, last};
    label n = 2;
    const auto cutAt = [&](const scalar square)
    {
        if (square < r*r)
        {
            const scalar z = std::sqrt(r*r - square);
            for (const scalar cut : {-z, z})
            {
                if (cut > first && cut < last)
                {
                    cuts[n++] = cut;
                }
            }
        }
    };
    for (const scalar x : {a.x(), b.x()})
    {
        cutAt(x*x);
        for (const scalar y : {a.y(), b.y()})
        {
            cutAt(x*x + y*y);
        }
    }
    cutAt(a.y()*a.y());
    cutAt(b.y()*b.y());
    std::sort(cuts, cuts + n);

    scalar volume = 0;
    for (label k = 1; k < n; ++k)
    {
        const scalar from = std::asin(cuts[k - 1]/r);
        const scalar half = 0.5*(std::asin(cuts[k]/r) - from);
        for (label i = 0; i < 8; ++i)
        {
            const scalar side = i < 4 ? 1 : -1;
            const scalar at = from + half*(1 + side*gaussAt[i%4]);
            const scalar s = r*std::cos(at);
            volume += half*gaussWeight[i%4]*s
               *(
                    corner(s, b.x(), b.y()) - corner(s, a.x(), b.y())
                  - corner(s, b.x(), a.y()) + corner(s, a.x(), a.y())
                );
        }
    }
    return volume;
}


// ************************************************************************* //
