/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "boxWall.H"
#include "checkedEntry.H"
#include "pointField.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(boxWall, 0);
    addToRunTimeSelectionTable(wall, boxWall, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::dem::boxWall::depth
(
    const point& c,
    const label face,
    vector& n
) const
{
    const direction d = face/2;
    n = Zero;
    n[d] = face % 2 ? -1 : 1;
    return face % 2 ? box_.max()[d] - c[d] : c[d] - box_.min()[d];
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::boxWall::boxWall
(
    const word& name,
    const label materialI,
    const dictionary& dict,
    const fileName&
)
:
    wall(name, materialI)
{
    checkEntries(dict, {"min", "max", "side"});
    box_ = boundBox(getFiniteVector(dict, "min"), getFiniteVector(dict, "max"));
    inside_ = getChoice(dict, "side", {"inside", "outside"}) == "inside";

    if (!(cmptMin(box_.span()) > 0))
    {
        badEntry(dict, "max", "is not greater than min in all components");
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dem::boxWall::farthest
(
    const point& origin,
    const vector& axis
) const
{
    scalar d = 0;
    const pointField points(box_.points());
    for (const point& p : points)
    {
        d = max(d, mag((p - origin) ^ axis));
    }
    return d;
}


void Foam::dem::boxWall::candidates
(
    const point& c,
    const scalar reach,
    DynamicList<label>& elements
) const
{
    point p;
    vector n;
    for (label e = 0; e < (inside_ ? 6 : 1); ++e)
    {
        if (nearest(c, e, p, n) < reach)
        {
            elements.append(e);
        }
    }
}


Foam::scalar Foam::dem::boxWall::nearest
(
    const point& c,
    const label element,
    point& p,
    vector& n
) const
{
    if (inside_)
    {
        const scalar d = depth(c, element, n);
        p = c - d*n;
        return d;
    }

    p = min(max(c, box_.min()), box_.max());
    scalar d = mag(c - p);
    if (d > VSMALL)
    {
        n = (c - p)/d;
        return d;
    }

    // Within the solid: to the nearest face
    d = GREAT;
    for (label face = 0; face < 6; ++face)
    {
        vector in;
        const scalar h = depth(c, face, in);
        if (h < d)
        {
            d = h;
            n = -in;
        }
    }
    p = c + d*n;
    return -d;
}


// ************************************************************************* //
