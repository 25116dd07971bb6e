/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "generator.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(generator, 0);
    defineRunTimeSelectionTable(generator, dictionary);
}
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dem::generator> Foam::dem::generator::New
(
    const word& name,
    const dictionary& dict,
    shapeSizes& shapes,
    const materials& m,
    const fileName& directory
)
{
    const word type = getChoice
    (
        dict,
        "type",
        dictionaryConstructorTablePtr_->sortedToc()
    );
    return
        (*dictionaryConstructorTablePtr_)[type]
        (
            name,
            dict,
            shapes,
            m,
            directory
        );
}


// ************************************************************************* //
