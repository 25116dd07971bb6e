/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "ellipsoidSpheres.H"
#include "mathematicalConstants.H"
#include "sphereUnion.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::ellipsoidSpheres::makeSurface()
{
    for (direction d = 0; d < 3; ++d)
    {
        order_[d] = d;
    }
    std::sort
    (
        order_.begin(),
        order_.end(),
        [this](const direction a, const direction b)
        {
            return axes_[a] > axes_[b] || (axes_[a] == axes_[b] && a < b);
        }
    );

    const label n = 200;
    const scalar quarter = constant::mathematical::piByTwo;
    for (label i = 0; i <= n; ++i)
    {
        // From the end of the longest axis to the plane across it
        const scalar along = i < n ? std::cos(quarter*i/n) : 0;
        const scalar across = std::sqrt(1 - sqr(along));
        for (label k = 0; k <= n; ++k)
        {
            const scalar y = k < n ? std::cos(quarter*k/n) : 0;
            point p;
            p[order_[0]] = along;
            p[order_[1]] = across*y;
            p[order_[2]] = across*std::sqrt(1 - sqr(y));
            surface_.append(cmptMultiply(p, axes_));
        }
    }
    gap_.setSize(surface_.size(), GREAT);
}


void Foam::dem::ellipsoidSpheres::inscribed
(
    const point& p,
    DynamicList<point>& centres,
    scalar& radius
) const
{
    const scalar w2 = sqr(axes_[order_[2]]);
    point c;
    vector normal;
    for (direction d = 0; d < 3; ++d)
    {
        normal[d] = p[d]/sqr(axes_[d]);
        c[d] = p[d] - w2*normal[d];
    }
    c[order_[2]] = 0;
    radius = w2*mag(normal);

    centres.clear();
    centres.append(c);
    for (direction k = 0; k < 2; ++k)
    {
        const direction d = order_[k];
        if (c[d] > 1e-6*radius)
        {
            const label n = centres.size();
            for (label i = 0; i < n; ++i)
            {
                point image(centres[i]);
                image[d] = -image[d];
                centres.append(image);
            }
        }
    }
}


bool Foam::dem::ellipsoidSpheres::add(const point& p, const label most)
{
    DynamicList<point> centres;
    scalar radius;
    inscribed(p, centres, radius);
    if (centres_.size() + centres.size() > most)
    {
        return false;
    }

    for (const point& c : centres)
    {
        centres_.append(c);
        radii_.append(radius);
    }

    // An image is never nearer to the eighth than the first
    forAll(surface_, i)
    {
        gap_[i] = min(gap_[i], mag(surface_[i] - centres[0]) - radius);
    }
    return true;
}


Foam::label Foam::dem::ellipsoidSpheres::farthest() const
{
    return std::max_element(gap_.begin(), gap_.end()) - gap_.begin();
}


void Foam::dem::ellipsoidSpheres::finish()
{
    const scalar volume = properties().volume;
    const sphereUnion hull{pointField(centres_), scalarField(radii_)};
    scale_ = std::cbrt(volume/hull.properties().volume);

    error_ = 0;
    for (const point& p : surface_)
    {
        scalar nearest = GREAT;
        forAll(centres_, i)
        {
            nearest = min(nearest, mag(p - centre(i)) - radius(i));
        }
        error_ = max(error_, mag(nearest));
    }
    error_ /= std::cbrt(6*volume/constant::mathematical::pi);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::ellipsoidSpheres::ellipsoidSpheres
(
    const vector& semiAxes,
    const label n
)
:
    ellipsoidSpheres(semiAxes, 0, n)
{}


Foam::dem::ellipsoidSpheres::ellipsoidSpheres
(
    const vector& semiAxes,
    const scalar error,
    const label n
)
:
    axes_(semiAxes)
{
    makeSurface();

    // The end of the shortest axis is touched by the sphere about the centre
    point p(Zero);
    p[order_[2]] = axes_[order_[2]];
    const scalar least = 1e-9*axes_[order_[0]];
    while (add(p, n))
    {
        const label i = farthest();
        if (gap_[i] < least)
        {
            break;
        }

        // Scaling takes some of the gap away, not three quarters; the exact
        // volume costs too much to look each time
        if (error > 0 && gap_[i] < 8*error*axes_[order_[2]])
        {
            finish();
            if (error_ <= error)
            {
                return;
            }
        }
        p = surface_[i];
    }
    finish();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dem::massProperties Foam::dem::ellipsoidSpheres::properties() const
{
    const vector square = cmptMultiply(axes_, axes_);
    massProperties m;
    m.volume = 4.0/3.0*constant::mathematical::pi*cmptProduct(axes_);
    m.inertia = 0.2*m.volume*symmTensor
    (
        square.y() + square.z(), 0, 0,
        square.x() + square.z(), 0,
        square.x() + square.y()
    );
    return m;
}


// ************************************************************************* //
