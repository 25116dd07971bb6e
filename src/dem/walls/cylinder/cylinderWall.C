/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "cylinderWall.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(cylinderWall, 0);
    addToRunTimeSelectionTable(wall, cylinderWall, dictionary);
}
}


// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

//- Any unit vector at a right angle to a unit vector
Foam::vector perpendicular(const Foam::vector& a)
{
    const Foam::vector b =
        Foam::mag(a.x()) < 0.6
      ? Foam::vector(1, 0, 0)
      : Foam::vector(0, 1, 0);
    return (a ^ b)/Foam::mag(a ^ b);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::cylinderWall::cylinderWall
(
    const word& name,
    const label materialI,
    const dictionary& dict,
    const fileName&
)
:
    wall(name, materialI)
{
    checkEntries
    (
        dict,
        {"point", "axis", "radius", "length", "ends", "side"}
    );
    start_ = getFiniteVector(dict, "point");
    axis_ = getDirection(dict, "axis");
    radius_ = getPositive(dict, "radius", 1e-12, 1e12);
    length_ =
        dict.found("length") ? getPositive(dict, "length", 1e-12, 1e12) : GREAT;

    if (infinite() && dict.found("ends"))
    {
        badEntry(dict, "ends", "is of a cylinder with a length; this has none");
    }
    if (getChoice(dict, "ends", {"closed", "open"}, "closed") == "open")
    {
        if (dict.found("side"))
        {
            badEntry
            (
                dict,
                "side",
                "is not of a cylinder with open ends: it has bodies on both"
            );
        }
        form_ = form::tube;
        return;
    }
    form_ =
        getChoice(dict, "side", {"inside", "outside"}) == "inside"
      ? form::inside
      : form::outside;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dem::cylinderWall::farthest
(
    const point& origin,
    const vector& axis
) const
{
    const scalar near = mag((start_ - origin) ^ axis) + radius_;
    if (infinite())
    {
        return mag(axis_ ^ axis) < 1e-9 ? near : GREAT;
    }
    const point end = start_ + length_*axis_;
    return max(near, mag((end - origin) ^ axis) + radius_);
}


void Foam::dem::cylinderWall::candidates
(
    const point& c,
    const scalar reach,
    DynamicList<label>& elements
) const
{
    point p;
    vector n;
    for (label e = 0; e < (form_ == form::inside && !infinite() ? 3 : 1); ++e)
    {
        if (nearest(c, e, p, n) < reach)
        {
            elements.append(e);
        }
    }
}


Foam::scalar Foam::dem::cylinderWall::nearest
(
    const point& c,
    const label element,
    point& p,
    vector& n
) const
{
    // Along the axis and away from it
    const scalar z = (c - start_) & axis_;
    const vector radial = c - start_ - z*axis_;
    const scalar rho = mag(radial);
    const vector out =
        rho > VSMALL ? radial/rho : perpendicular(axis_);

    // The nearest of the faces, from within; the side, start and end
    scalar d = radius_ - rho;
    n = -out;
    if (form_ == form::inside)
    {
        if (element)
        {
            d = element == 1 ? z : length_ - z;
            n = element == 1 ? axis_ : -axis_;
        }
        p = c - d*n;
        return d;
    }

    const bool within = rho < radius_ && z > 0 && z < length_;
    if (form_ == form::outside && (within || (infinite() && rho < radius_)))
    {
        if (!infinite() && min(z, length_ - z) < d)
        {
            d = min(z, length_ - z);
            n = z < length_ - z ? axis_ : -axis_;
        }
        n = -n;
        p = c + d*n;
        return -d;
    }

    // The nearest point of a rod, or of a tube
    const scalar zp = infinite() ? z : min(max(z, scalar(0)), length_);
    const scalar rhoP = form_ == form::tube ? radius_ : min(rho, radius_);
    p = start_ + zp*axis_ + rhoP*out;
    const scalar away = mag(c - p);
    n = away > VSMALL ? (c - p)/away : out;
    return away;
}


// ************************************************************************* //
