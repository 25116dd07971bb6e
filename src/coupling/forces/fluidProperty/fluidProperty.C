/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.


\*---------------------------------------------------------------------------*/

#include "fluidProperty.H"
#include "checkedEntry.H"
#include "IOdictionary.H"
#include "dimensionedScalar.H"
#include "volFields.H"

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

//- The entry in constant/transportProperties, or 0 if it is not there
Foam::scalar transportEntry(const Foam::fvMesh& mesh, const Foam::word& name)
{
    using namespace Foam;

    IOobject io
    (
        "transportProperties",
        mesh.time().constant(),
        mesh,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );
    if (!io.typeHeaderOk<IOdictionary>(true))
    {
        return 0;
    }

    const IOdictionary dict(io);
    return
        dict.found(name)
      ? dimensionedScalar(name, dimless, dict).value()
      : 0;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::fluidProperty::fluidProperty
(
    const fvMesh& mesh,
    const dictionary& dict,
    const word& name,
    const string& unit
)
:
    mesh_(mesh),
    name_(name),
    value_(0)
{
    string source("the field of that name");
    if (dict.found(name))
    {
        value_ = dem::getPositive(dict, name);
        source = "given";
    }
    else if (!mesh.foundObject<volScalarField>(name))
    {
        value_ = transportEntry(mesh, name);
        source = "of constant/transportProperties";
    }

    if (source != "the field of that name" && !(value_ > 0))
    {
        FatalIOErrorInFunction(dict)
            << "The " << name << " of the fluid " << unit.c_str()
            << " is not known: this solver has no field " << name
            << ", and constant/transportProperties has no entry " << name
            << " above 0." << nl
            << "    Give it in the dictionary " << dict.dictName() << "."
            << exit(FatalIOError);
    }

    Info<< "    fluid: " << name << ' ';
    if (value_ > 0)
    {
        Info<< value_ << ' ' << unit.c_str() << ", ";
    }
    Info<< source.c_str() << endl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalarField Foam::coupling::fluidProperty::operator()
(
    const labelUList& cells
) const
{
    if (value_ > 0)
    {
        return scalarField(cells.size(), value_);
    }
    return scalarField
    (
        mesh_.lookupObject<volScalarField>(name_).primitiveField(),
        cells
    );
}


// ************************************************************************* //
