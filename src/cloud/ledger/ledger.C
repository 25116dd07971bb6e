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
#include "StringStream.H"

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

Foam::ledger::ledger(const solver fluid)
:
    solver_(fluid),
    lapEnd_(clock::now()),
    lapOwn_(0),
    started_(false),
    exchangeTime_(0),
    nTimed_(0),
    nBooked_(0),
    energyGain_(-1),
    nBack_(0),
    nTwice_(0),
    nUnknown_(0),
    cells_(0),
    exchanged_(false),
    slips_(0),
    speeds_(0),
    start_(lapEnd_),
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

void Foam::ledger::lap(const char* name)
{
    if (started_)
    {
        if (solver_ == solver::none || name == start)
        {
            return;
        }
        if (solver_ == solver::whole && name != mesh)
        {
            name = looked;
        }
    }
    const clock::time_point now = clock::now();
    const scalar booked = own();
    laps_[started_ ? name : start] +=
        std::chrono::duration<scalar>(now - lapEnd_).count()
      - (booked - lapOwn_);
    lapEnd_ = now;
    lapOwn_ = booked;
    started_ = started_ || name == start;
    ++nBooked_;
}


void Foam::ledger::noteBodies(const dem::demSolver& dem)
{
    const scalar all = dem.exchangeTime();
    if (all > exchangeTime_)
    {
        move(ofBodies, "exchange between ranks", all - exchangeTime_);
        exchangeTime_ = all;
    }
    if (dem.nTimed())
    {
        parts_["neighbours"] = dem.neighbourTime();
        parts_["contacts"] = dem.contactTime(dem::sweepTimes::pairs);
        if (dem.walls().size())
        {
            parts_["walls"] = dem.contactTime(dem::sweepTimes::walls);
        }
        nBooked_ += dem.nTimed() - nTimed_;
        nTimed_ = dem.nTimed();
    }
}


void Foam::ledger::setError
(
    const std::string& kind,
    const std::string& name,
    const scalar value,
    const std::string& what
)
{
    if (value < 0)
    {
        return;
    }
    figures_[kind + ": " + name] = value;

    OStringStream os;
    os.precision(3);
    os  << name.c_str() << ": " << 100*value << " % (" << what.c_str() << ')';
    errors_.push_back(os.str());
}


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
    energyGain_ = max(energyGain_, report.energyGain);
    nBack_ += report.nBack;
    nTwice_ += report.nTwice;
    if (report.energyUnknown)
    {
        energyUnknown_ = report.energyUnknown;
        ++nUnknown_;
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
        exchanged_ = true;
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
            slips_ += coupled.slip;
            speeds_ += fastest;
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
