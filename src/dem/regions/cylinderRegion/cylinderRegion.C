/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "cylinderRegion.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"
#include "mathematicalConstants.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(cylinderRegion, 0);
    addToRunTimeSelectionTable(region, cylinderRegion, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::cylinderRegion::cylinderRegion(const dictionary& dict)
{
    List<point> ends(2);
    read(dict, typeName, ends, &radius_);
    end_ = ends[0];
    length_ = mag(ends[1] - end_);
    if (length_ <= 1e-12*(mag(end_) + radius_))
    {
        badEntry(dict, typeName, "has an axis without length");
    }
    axis_ = (ends[1] - end_)/length_;

    // Across the axis, from the direction that is farthest from it
    direction least = 0;
    for (direction d = 1; d < 3; ++d)
    {
        least = mag(axis_[d]) < mag(axis_[least]) ? d : least;
    }
    vector e(Zero);
    e[least] = 1;
    e1_ = e - (e & axis_)*axis_;
    e1_ /= mag(e1_);
    e2_ = axis_ ^ e1_;

    for (direction d = 0; d < 3; ++d)
    {
        reach_[d] = radius_*std::sqrt(sqr(e1_[d]) + sqr(e2_[d]));
    }
}



// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dem::cylinderRegion::volume() const
{
    return constant::mathematical::pi*sqr(radius_)*length_;
}


bool Foam::dem::cylinderRegion::contains(const point& p, const scalar r) const
{
    const scalar along = (p - end_) & axis_;
    return
        r <= radius_ && along >= r && along <= length_ - r
     && magSqr(p - end_ - along*axis_) <= sqr(radius_ - r);
}


Foam::point Foam::dem::cylinderRegion::at(const vector& u) const
{
    const scalar angle = constant::mathematical::twoPi*u.z();
    return
        end_ + u.x()*length_*axis_
      + radius_*std::sqrt(u.y())
       *(std::cos(angle)*e1_ + std::sin(angle)*e2_);
}


Foam::point Foam::dem::cylinderRegion::low() const
{
    return min(end_, end_ + length_*axis_) - reach_;
}


Foam::point Foam::dem::cylinderRegion::high() const
{
    return max(end_, end_ + length_*axis_) + reach_;
}


// ************************************************************************* //
