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

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

//- Does a wall move?
bool anyMoves(const Foam::dictionary& walls)
{
    for (const Foam::entry& e : walls)
    {
        if (e.isDict() && e.dict().found("motion"))
        {
            return true;
        }
    }
    return false;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::demCloud::readWatchdog()
{
    if (!dict_.found("watchdog"))
    {
        return;
    }

    const bool moves = mesh_.dynamic();
    const bool wayOut =
        exits_.outlets().size() || dem_->sinks().size()
     || patches_.period().active() || moves;
    watchdog_.reset
    (
        new watchdog
        (
            dict_.subDict("watchdog"),
            wayOut ? boundBox() : mesh_.bounds(),
            !moves && !anyMoves(dict_.subOrEmptyDict("walls"))
         && dem_->mats().laws().cohesion.empty()
        )
    );
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
    if (!watchdog_.valid())
    {
        dem_->advance(t0, t1);
        return;
    }

    watchdog_->store(*dem_);
    dem_->advance(t0, t1);
    string wrong(watchdog_->complaint(*dem_, t1 - t0));
    scalar pieces = max(dem_->report().nSteps, label(1));
    label n = 0;
    for (; wrong.size() && n < watchdog_->halvings(); ++n)
    {
        pieces *= 2;
        Info<< "demCloud: watchdog: " << wrong.c_str() << ';' << nl
            << "    going back to " << t0 << " s and on in " << pieces
            << " pieces" << endl;
        watchdog_->restore(*dem_);
        const scalar dt = (t1 - t0)/pieces;
        scalar t = t0;
        for (scalar i = 1; i < pieces; ++i)
        {
            dem_->advance(t, t0 + i*dt);
            t = t0 + i*dt;
        }
        dem_->advance(t, t1);
        wrong = watchdog_->complaint(*dem_, t1 - t0);
    }
    ledger_.noteEnergy(watchdog_->gain(), n);

    if (wrong.size())
    {
        // What is saved is the state before the step
        watchdog_->restore(*dem_);
        saveState();
        FatalErrorInFunction
            << "In the step to time " << t1 << " s " << wrong.c_str() << '.'
            << nl << "    It was gone back over " << n
            << " times, the last time in " << pieces << " pieces." << nl
            << "    The state before the step has been written." << nl
            << "    See the entry watchdog in " << dict_.objectPath()
            << exit(FatalError);
    }
}


void Foam::demCloud::checkExchange()
{
    const string wrong
    (
        watchdog_->complaint(exchange_.toBodies, exchange_.toFluid)
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
