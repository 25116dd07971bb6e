/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "bodyProfile.H"
#include "mathematicalConstants.H"
#include "sphereUnion.H"

#include <algorithm>
#include <utility>
#include <vector>

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

scalar unionVolume(const dem::shape& s, const scalar growth)
{
    scalarField radii(s.radii());
    for (scalar& r : radii)
    {
        r += growth;
    }
    return dem::sphereUnion(s.centres(), radii).properties().volume;
}


//- Surface of the union of the spheres: dV/dr by a central difference, whose
//  error is of the order of the growth's square
scalar unionSurface(const dem::shape& s)
{
    const scalar growth = 1e-4*s.minRadius();
    return (unionVolume(s, growth) - unionVolume(s, -growth))/(2*growth);
}


//- Area of the union of the spheres' shadows along an axis
scalar unionShadow(const dem::shape& s, const direction axis)
{
    const direction across = (axis + 1) % 3;
    const direction up = (axis + 2) % 3;
    const pointField& x = s.centres();
    const scalarField& r = s.radii();

    scalar low = GREAT, high = -GREAT;
    forAll(r, k)
    {
        low = min(low, x[k][up] - r[k]);
        high = max(high, x[k][up] + r[k]);
    }

    // Rows are closer where the union ends, whose edge is round
    const label nRows = 2000;
    scalar area = 0;
    std::vector<std::pair<scalar, scalar>> parts;
    for (label row = 0; row < nRows; ++row)
    {
        const scalar angle = constant::mathematical::pi*(row + 0.5)/nRows;
        const scalar y = low + 0.5*(high - low)*(1 - Foam::cos(angle));
        const scalar height =
            0.5*(high - low)*Foam::sin(angle)*constant::mathematical::pi/nRows;

        parts.clear();
        forAll(r, k)
        {
            const scalar half = sqr(r[k]) - sqr(y - x[k][up]);
            if (half > 0)
            {
                parts.emplace_back
                (
                    x[k][across] - Foam::sqrt(half),
                    x[k][across] + Foam::sqrt(half)
                );
            }
        }
        std::sort(parts.begin(), parts.end());

        scalar width = 0, end = -GREAT;
        for (const auto& part : parts)
        {
            width += max(part.second - max(part.first, end), scalar(0));
            end = max(end, part.second);
        }
        area += width*height;
    }
    return area;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::bodyProfile::bodyProfile
(
    const dem::shape& s,
    const scalar sphericity
)
:
    section_(constant::mathematical::pi*sqr(s.equivalentDiameter())/4),
    surface_(4*section_),
    shadow_(vector::one*section_)
{
    if (!s.isSphere())
    {
        surface_ = unionSurface(s);
        for (direction d = 0; d < 3; ++d)
        {
            shadow_[d] = unionShadow(s, d);
        }
    }
    if (sphericity > 0)
    {
        surface_ = 4*section_/sphericity;
    }
    else if (4*section_ > (1 + 1e-6)*surface_)
    {
        FatalErrorInFunction
            << "The shape " << s.name() << " has a volume of " << s.volume()
            << " m3, which no surface of " << surface_ << " m2 can hold, that"
            << " of its spheres." << nl
            << "    The body that it stands for is larger than they are: give"
            << " its sphericity in drag." << exit(FatalError);
    }

    // No convex body has a shadow above half its surface
    if (0.5*surface_ < (1 - 1e-3)*cmptMax(shadow_))
    {
        FatalErrorInFunction
            << "The shape " << s.name() << " with the sphericity "
            << sphericity << " would have a surface of " << surface_
            << " m2, but its largest shadow is " << cmptMax(shadow_)
            << " m2 (of one side)." << nl
            << "    Its sphericity is " << 2*section_/cmptMax(shadow_)
            << " at most." << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::coupling::dragShape Foam::coupling::bodyProfile::seenAlong
(
    const vector& n
) const
{
    // Two directions across n
    const vector other =
        mag(n.x()) < 0.7 ? vector(1, 0, 0) : vector(0, 1, 0);
    const vector e1 = normalised(n ^ other);
    const vector e2 = n ^ e1;

    // A shadow is the same from both sides: half a turn will do
    const label nSides = 16;
    scalar sides = 0;
    for (label k = 0; k < nSides; ++k)
    {
        const scalar angle = constant::mathematical::pi*k/nSides;
        sides += shadowAlong(Foam::cos(angle)*e1 + Foam::sin(angle)*e2)/nSides;
    }

    dragShape ratios;
    ratios.sphericity = 4*section_/surface_;
    ratios.crosswise = section_/shadowAlong(n);

    ratios.lengthwise = section_/(0.5*surface_ - sides);
    return ratios;
}


// ************************************************************************* //
