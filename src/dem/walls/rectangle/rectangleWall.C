/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "rectangleWall.H"
#include "checkedEntry.H"
#include "StringStream.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(rectangleWall, 0);
    addToRunTimeSelectionTable(wall, rectangleWall, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::rectangleWall::rectangleWall
(
    const word& name,
    const label materialI,
    const dictionary& dict,
    const fileName&
)
:
    wall(name, materialI)
{
    checkEntries(dict, {"corner", "edge1", "edge2"});
    corner_ = getFiniteVector(dict, "corner");
    along1_ = getDirection(dict, "edge1");
    along2_ = getDirection(dict, "edge2");
    length1_ = mag(dict.get<vector>("edge1"));
    length2_ = mag(dict.get<vector>("edge2"));

    // Edges that are typed with six digits are at right angles
    const scalar cosine = along1_ & along2_;
    if (mag(cosine) > 1e-5)
    {
        OStringStream why;
        why << "is " << dict.get<vector>("edge2") << ", which is ";
        if (mag(cosine) > 1 - 1e-9)
        {
            why << "parallel";
        }
        else
        {
            why << "not at a right angle";
        }
        why << " to edge1 " << dict.get<vector>("edge1");
        badEntry(dict, "edge2", why.str());
    }
    along2_ -= cosine*along1_;
    along2_ /= mag(along2_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dem::rectangleWall::farthest
(
    const point& origin,
    const vector& axis
) const
{
    scalar d = 0;
    for (const scalar a : {scalar(0), length1_})
    {
        for (const scalar b : {scalar(0), length2_})
        {
            const point p = corner_ + a*along1_ + b*along2_;
            d = max(d, mag((p - origin) ^ axis));
        }
    }
    return d;
}


void Foam::dem::rectangleWall::candidates
(
    const point& c,
    const scalar reach,
    DynamicList<label>& elements
) const
{
    // Most are far from its plane
    point p;
    vector n;
    if
    (
        mag((c - corner_) & (along1_ ^ along2_)) < reach
     && nearest(c, 0, p, n) < reach
    )
    {
        elements.append(0);
    }
}


Foam::scalar Foam::dem::rectangleWall::nearest
(
    const point& c,
    const label,
    point& p,
    vector& n
) const
{
    const vector r = c - corner_;
    const scalar a = min(max(r & along1_, scalar(0)), length1_);
    const scalar b = min(max(r & along2_, scalar(0)), length2_);
    p = corner_ + a*along1_ + b*along2_;

    const scalar d = mag(c - p);
    n = d > VSMALL ? (c - p)/d : (along1_ ^ along2_);
    return d;
}


// ************************************************************************* //
