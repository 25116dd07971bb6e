/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "demCloud.H"
#include "advancingBodies.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::demCloud::readWatchdog()
{
    if (dem::watchdog::on(dict_))
    {
        watchdog_.reset(new dem::watchdog(dict_));
    }
}


void Foam::demCloud::saveState()
{
    const_cast<Time&>(mesh_.time()).writeNow();
    if (writeOpt() != IOobject::AUTO_WRITE)
    {
        write();
    }
    finishWriting();
}


void Foam::demCloud::advanceBodies(const scalar t0, const scalar t1)
{
    const bool pushed =
        immersed_.valid() && coupling_ == "twoWay" && dem_->moves();
    const coupling::advancingBodies along
    (
        pushed ? immersed_.get() : nullptr
    );
    dem_->advance(t0, t1);
}


void Foam::demCloud::checkExchange()
{
    const string wrong
    (
        watchdog_->complaint
        (
            exchange_.toBodies, exchange_.toFluid, exchange_.magnitudes
        )
    );
    if (wrong.size())
    {
        saveState();
        FatalErrorInFunction
            << "In the step to time " << mesh_.time().value() << " s "
            << wrong.c_str() << '.' << nl
            << "    The state has been written." << nl
            << "    See the entry watchdog in " << dict_.objectPath()
            << exit(FatalError);
    }
}


// ************************************************************************* //
