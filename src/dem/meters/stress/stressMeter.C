/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "stressMeter.H"
#include "allowedKeys.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(stressMeter, 0);
    addToRunTimeSelectionTable(meter, stressMeter, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::stressMeter::writeRow(Ostream& os) const
{
    os  << ' ' << nBodies_ << ' ' << fraction_ << ' ' << pressure();
    for (const symmTensor& s : List<symmTensor>({stress(), motion_}))
    {
        for (direction d = 0; d < symmTensor::nComponents; ++d)
        {
            os  << ' ' << s[d];
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::stressMeter::stressMeter
(
    const word& name,
    const dictionary& dict,
    const periodicity&
)
:
    meter(name)
{
    checkKeys(dict, {"type", "region"});
    region_ = region::New(dict.subDict("region"));
    if (region_->volume() <= 0)
    {
        badEntry(dict, "region", "has no volume, over which stress is a mean");
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::stressMeter::end(const demSolver& dem, const scalar)
{
    const bodies& state = dem.state();
    boolList within(state.size(), false);
    nBodies_ = 0;
    fraction_ = 0;
    scalar mass = 0;
    vector momentum(Zero);
    forAll(within, b)
    {
        within[b] = region_->contains(state.x[b], 0);
        if (within[b])
        {
            ++nBodies_;
            fraction_ += state.shapeOf(b).volume()/region_->volume();
            mass += state.mass[b];
            momentum += state.mass[b]*state.v[b];
        }
    }

    symmTensor moving(Zero), touching(Zero);
    forAll(within, b)
    {
        if (within[b])
        {
            moving += state.mass[b]*sqr(state.v[b] - momentum/mass);
        }
    }
    for (const contactForce& c : dem.contacts())
    {
        const vector arm = state.x[c.a] - c.p;
        if (within[c.a])
        {
            touching += symm(arm*c.force);
        }
        if (c.b >= 0 && within[c.b])
        {
            // The other, or its image, has the opposite force
            touching += symm((c.branch - arm)*c.force);
        }
    }
    motion_ = moving/region_->volume();
    contacts_ = touching/region_->volume();
}


// ************************************************************************* //
