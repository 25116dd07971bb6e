/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "ledger.H"
#include "limitsText.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::ledger::own() const
{
    scalar sum = 0;
    for (const auto& t : times_)
    {
        sum += t.second;
    }
    return sum;
}


Foam::scalar Foam::ledger::whole() const
{
    return std::chrono::duration<scalar>(clock::now() - start_).count();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::ledger::ledger()
:
    nBooked_(0),
    energyGain_(-1),
    nBack_(0),
    cells_(0),
    start_(clock::now()),
    stepOwn_(0),
    stepWhole_(0),
    nFluidSteps_(0),
    nSteps_(0),
    nRejected_(0),
    nEntered_(0),
    nLeft_(0),
    maxOverlap_(0),
    maxMismatch_(0),
    maxVolumeError_(0),
    dtMin_(GREAT),
    dtMax_(0),
    closed_(false)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::ledger::line
(
    const dem::demSolver& dem,
    const exchange& coupled
)
{
    const dem::advanceReport& report = dem.report();
    const scalar ownNow = own();
    const scalar wholeNow = whole();
    const scalar share =
        100*(ownNow - stepOwn_)/max(wholeNow - stepWhole_, VSMALL);
    stepOwn_ = ownNow;
    stepWhole_ = wholeNow;

    ++nFluidSteps_;
    nSteps_ += report.nSteps;
    nRejected_ += report.nRejected;
    nEntered_ += report.nEntered;
    for (const word& name : report.limits.toc())
    {
        limits_(name) += report.limits[name];
    }
    maxOverlap_ = max(maxOverlap_, report.overlap);
    dtMin_ = min(dtMin_, report.dtMin);
    dtMax_ = max(dtMax_, report.dtMax);

    scalar fastest = 0;
    for (const vector& v : dem.state().v)
    {
        fastest = max(fastest, mag(v));
    }
    fastest = dem.group().max(fastest);

    Info<< "demCloud: " << dem.nBodies() << " bodies, fastest " << fastest
        << " m/s, " << report.nSteps
        << " steps (" << limitsText(report.limits).c_str() << "), "
        << report.nRejected << " undone, " << report.nContacts
        << " contacts, overlap " << 100*report.overlap << " %";
    if (report.nAsleep >= 0)
    {
        Info<< ", " << report.nAsleep << " asleep";
    }

    if (coupled.active)
    {
        const scalar mismatch =
            mag(coupled.toBodies + coupled.toFluid)
           /max(mag(coupled.toBodies), VSMALL);
        maxMismatch_ = max(maxMismatch_, mismatch);
        maxVolumeError_ = max(maxVolumeError_, coupled.volumeError);

        Info<< ", to bodies " << coupled.toBodies << " N s, to fluid "
            << coupled.toFluid << " N s (mismatch " << mismatch
            << "), volume error " << 100*coupled.volumeError << " %";
        if (coupled.leastAlpha < 0)
        {
            Info<< ", slip " << coupled.slip << " m/s";
        }
        else
        {
            Info<< ", void fraction from " << coupled.leastAlpha;
        }
        if (coupled.excess > 0)
        {
            Info<< ", " << coupled.excess
                << " m3 above closest packing spread";
        }
    }

    if (coupled.Re >= 0)
    {
        Info<< ", Re up to " << coupled.Re;
    }

    Info<< ", " << share << " % of the time" << endl;
}


// ************************************************************************* //
