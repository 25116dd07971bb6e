/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "pointForce.H"
#include "checkedEntry.H"
#include "Switch.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace coupling
{
    defineTypeNameAndDebug(pointForce, 0);
    defineRunTimeSelectionTable(pointForce, dictionary);
}
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::wordList Foam::coupling::pointForce::names()
{
    return dictionaryConstructorTablePtr_->sortedToc();
}


bool Foam::coupling::pointForce::switchedOn
(
    const word& name,
    const dictionary& forces
)
{
    if (!forces.found(name) || forces.isDict(name))
    {
        return forces.found(name);
    }
    return Switch
    (
        dem::getChoice
        (
            forces,
            name,
            {"yes", "no", "on", "off", "true", "false"}
        )
    );
}


Foam::autoPtr<Foam::coupling::pointForce> Foam::coupling::pointForce::New
(
    const word& name,
    const vector& g,
    const dictionary& forces
)
{
    if (!switchedOn(name, forces))
    {
        return autoPtr<pointForce>();
    }

    const auto make = (*dictionaryConstructorTablePtr_)[name];
    if (forces.isDict(name))
    {
        return make(g, forces.subDict(name));
    }

    // Its options have their defaults
    dictionary none(forces, dictionary());
    none.name() = fileName(forces.name() + '.' + name);
    return make(g, none);
}


// ************************************************************************* //
