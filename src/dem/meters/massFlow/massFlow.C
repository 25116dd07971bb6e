/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "massFlow.H"
#include "allowedKeys.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(massFlow, 0);
    addToRunTimeSelectionTable(meter, massFlow, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::dem::massFlow::crossings
(
    const scalar before,
    const scalar after
) const
{
    if (period_ <= 0)
    {
        return label(after >= 0) - label(before >= 0);
    }
    const scalar jump = period_*std::round((after - before)/period_);
    return
        label(std::floor((after - jump)/period_))
      - label(std::floor(before/period_));
}


void Foam::dem::massFlow::writeRow(Ostream& os) const
{
    os  << ' ' << number_ << ' ' << mass_ << ' ' << rate_;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::massFlow::massFlow
(
    const word& name,
    const dictionary& dict,
    const periodicity& period
)
:
    meter(name),
    period_(0)
{
    checkKeys(dict, {"type", "point", "normal"});
    point_ = getFiniteVector(dict, "point");
    normal_ = getFiniteVector(dict, "normal");
    if (mag(normal_) < SMALL)
    {
        badEntry(dict, "normal", "has no length");
    }
    normal_ /= mag(normal_);

    for (const periodicity::seam& s : period.seams())
    {
        const scalar along = mag(s.separation & normal_);
        if (along < 1e-6*mag(s.separation))
        {
            continue;
        }
        if (period_ > 0)
        {
            badEntry
            (
                dict,
                "normal",
                "must be across the separations of all cyclic patches but one"
            );
        }
        period_ = along;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::massFlow::begin(const demSolver& dem)
{
    before_.clear();
    for (const point& x : dem.state().x)
    {
        before_.append(distance(x));
    }
}


void Foam::dem::massFlow::end(const demSolver& dem, const scalar dt)
{
    const bodies& state = dem.state();
    label number = 0;
    scalar mass = 0;
    forAll(before_, b)
    {
        const label n = crossings(before_[b], distance(state.x[b]));
        number += n;
        mass += n*state.mass[b];
    }
    mass = dem.group().sum(mass);
    number_ += dem.group().sum(number);
    mass_ += mass;
    rate_ = mass/dt;
}


void Foam::dem::massFlow::write(dictionary& dict) const
{
    dict.add("number", number_);
    dict.add("mass", mass_);
}


void Foam::dem::massFlow::read(const dictionary& dict)
{
    number_ = dict.get<label>("number");
    mass_ = getFinite(dict, "mass");
}


// ************************************************************************* //
