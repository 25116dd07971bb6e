/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "integrator.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(integrator, 0);
    defineRunTimeSelectionTable(integrator, word);
}
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dem::integrator> Foam::dem::integrator::New
(
    const dictionary& dict
)
{
    word name("stormerVerlet");
    if (dict.found("integrator"))
    {
        name = getChoice
        (
            dict,
            "integrator",
            wordConstructorTablePtr_->sortedToc()
        );
    }
    return (*wordConstructorTablePtr_)[name](name);
}


// ************************************************************************* //
