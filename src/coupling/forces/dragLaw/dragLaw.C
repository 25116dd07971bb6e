/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.


\*---------------------------------------------------------------------------*/

#include "dragLaw.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace coupling
{
    defineTypeNameAndDebug(dragLaw, 0);
    defineRunTimeSelectionTable(dragLaw, word);
}
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::coupling::dragLaw> Foam::coupling::dragLaw::New
(
    const dictionary& dict
)
{
    if (!dict.found("drag"))
    {
        return autoPtr<dragLaw>();
    }

    wordList laws(wordConstructorTablePtr_->sortedToc());
    laws.append("none");

    const word name =
        dict.isDict("drag")
      ? dem::getChoice(dict.subDict("drag"), "law", laws)
      : dem::getChoice(dict, "drag", laws);
    if (name == "none")
    {
        return autoPtr<dragLaw>();
    }
    return (*wordConstructorTablePtr_)[name]();
}


// ************************************************************************* //
