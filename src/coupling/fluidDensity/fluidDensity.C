/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "fluidDensity.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::fluidDensity::fluidDensity
(
    const objectRegistry& db,
    const dictionary& fluid
)
:
    dict_(fluid),
    value_(0),
    field_(nullptr)
{
    token first;
    if (fluid.found("rho"))
    {
        fluid.lookup("rho").read(first);
    }
    if (!first.isWord())
    {
        value_ = dem::getPositive(fluid, "rho", 1e-6, 1e9);
        return;
    }

    field_ = db.findObject<volScalarField>(first.wordToken());
    if (!field_)
    {
        const string complaint
        (
            "names no field of the solver; a number [kg/m3] is meant for"
            " solvers whose momentum equation has no density"
        );
        dem::badEntry(fluid, "rho", complaint);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::coupling::fluidDensity::checkEquation(const word& name) const
{
    if (name == (field_ ? field_->name() : word::null))
    {
        return;
    }
    dem::badEntry
    (
        dict_,
        "rho",
        name.empty()
      ? string
        (
            "names a field, but the momentum equation of the solver has no"
            " density: a number [kg/m3] is meant"
        )
      : string
        (
            "must be " + name + ", the name of the field that the momentum"
            " equation of the solver has"
        )
    );
}


// ************************************************************************* //
