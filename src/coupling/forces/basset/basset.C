/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "basset.H"
#include "addToRunTimeSelectionTable.H"
#include "allowedKeys.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace coupling
{
    defineTypeNameAndDebug(basset, 0);
    addToRunTimeSelectionTable(pointForce, basset, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::basset::basset
(
    const vector&,
    const dictionary& dict
)
:
    kernel_(dict)
{
    dem::checkKeys(dict, {"memory", "window", "longest"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::coupling::basset::add
(
    const pointBody& body,
    const fluidAtPoint& fluid,
    pointSum& sum
) const
{
    const slipHistory& history = histories_[body.id];
    const scalar B =
        1.5*sqr(body.d)*fluid.rho
       *sqrt(constant::mathematical::pi*fluid.nu);
    const scalar m = B*4/3*sqrt(body.dt);

    sum.addedMass += m;
    sum.force +=
        m*history.fluidRate() + B*history.mean(body.dt, kernel_);
}


void Foam::coupling::basset::note
(
    const pointBody& body,
    fluidAtPoint& fluid
)
{
    histories_(body.id).append
    (
        body.t,
        fluid.u - body.v,
        fluid.u,
        kernel_
    );
}


void Foam::coupling::basset::save
(
    const label id,
    DynamicList<vector>& values
) const
{
    if (histories_.found(id))
    {
        histories_[id].save(values);
    }
}


bool Foam::coupling::basset::load
(
    const label id,
    const UList<vector>& values
)
{
    return values.empty() || histories_(id).load(values, kernel_);
}


void Foam::coupling::basset::keepOnly(const labelHashSet& ids)
{
    histories_.retain(ids);
}


// ************************************************************************* //
