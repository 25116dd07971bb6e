/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "boxRegion.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(boxRegion, 0);
    addToRunTimeSelectionTable(region, boxRegion, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::boxRegion::boxRegion(const dictionary& dict)
{
    List<point> corner(2);
    read(dict, typeName, corner);
    low_ = corner[0];
    high_ = corner[1];
    if (cmptMin(high_ - low_) < 0)
    {
        badEntry(dict, typeName, "give the smallest corner, then the largest");
    }
}



// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dem::boxRegion::volume() const
{
    return cmptProduct(high_ - low_);
}


bool Foam::dem::boxRegion::contains(const point& p, const scalar r) const
{
    return cmptMin(p - low_) >= r && cmptMin(high_ - p) >= r;
}


Foam::point Foam::dem::boxRegion::at(const vector& u) const
{
    return low_ + cmptMultiply(u, high_ - low_);
}


Foam::point Foam::dem::boxRegion::low() const
{
    return low_;
}


Foam::point Foam::dem::boxRegion::high() const
{
    return high_;
}


// ************************************************************************* //
