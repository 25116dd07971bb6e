/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "meter.H"
#include "checkedEntry.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "OStringStream.H"
#include "Pstream.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(meter, 0);
    defineRunTimeSelectionTable(meter, dictionary);
}
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dem::meter> Foam::dem::meter::New
(
    const word& name,
    const dictionary& dict,
    const periodicity& period
)
{
    const word type = getChoice
    (
        dict,
        "type",
        dictionaryConstructorTablePtr_->sortedToc()
    );
    return (*dictionaryConstructorTablePtr_)[type](name, dict, period);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::meter::report(const fileName& directory, const scalar t)
{
    if (!Pstream::master())
    {
        return;
    }

    // A meter that looks less often has nothing to say in between
    OStringStream row;
    row.precision(12);
    writeRow(row);
    if (row.str().empty())
    {
        return;
    }
    if (!table_.valid())
    {
        mkDir(directory);
        table_.reset(new OFstream(directory/type() + ".dat"));
        table_->precision(12);
        *table_ << "# time [s], " << columns().c_str() << nl;
    }
    *table_ << t << row.str().c_str() << endl;
}


// ************************************************************************* //
