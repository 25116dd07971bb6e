/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "ledger.H"

#include <algorithm>
#include <vector>

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

//- The limits of the steps, most frequent first: "contact 12, end 1"
std::string listed(const Foam::HashTable<Foam::label>& limits)
{
    std::string text;
    for (const Foam::word& name : limits.sortedToc())
    {
        text += (text.empty() ? "" : ", ") + name + ' '
          + std::to_string(limits[name]);
    }
    return text.empty() ? "none" : text;
}

} // End anonymous namespace


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
        << " steps (" << listed(report.limits).c_str() << "), "
        << report.nRejected << " undone, " << report.nContacts
        << " contacts, overlap " << 100*report.overlap << " %";

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


void Foam::ledger::close()
{
    if (closed())
    {
        return;
    }
    closed_ = true;

    const scalar all = max(whole(), VSMALL);
    const auto percent = [all](const scalar t) { return 100*t/all; };

    Info<< nl << "demCloud: summary" << nl
        << "    " << nFluidSteps_ << " fluid steps, " << nSteps_
        << " steps of the bodies, " << nRejected_ << " more undone" << nl;
    if (nSteps_)
    {
        Info<< "    Steps from " << dtMin_ << " to " << dtMax_
            << " s, limited by: " << listed(limits_).c_str() << nl;
    }
    Info<< "    " << nEntered_ << " bodies entered, " << nLeft_
        << " left the domain" << nl
        << "    Largest overlap " << 100*maxOverlap_
        << " % of the smaller radius" << nl;
    if (maxVolumeError_ > 0 || maxMismatch_ > 0)
    {
        Info<< "    What the bodies received and what the momentum equation"
            << " got differ by " << maxMismatch_ << " at most" << nl
            << "    Volume of the bodies on the mesh: error "
            << 100*maxVolumeError_ << " % at most" << nl;
    }

    Info<< "    Wall time " << all << " s, of which" << nl;
    std::vector<std::pair<scalar, std::string>> sorted;
    for (const auto& t : times_)
    {
        sorted.emplace_back(t.second, t.first);
    }
    std::sort(sorted.rbegin(), sorted.rend());
    for (const auto& t : sorted)
    {
        Info<< "        " << t.second.c_str() << ": " << t.first << " s, "
            << percent(t.first) << " %" << nl;
    }
    Info<< "        everything else (fluid, mesh): " << all - own() << " s, "
        << percent(all - own()) << " %" << nl << endl;
}


// ************************************************************************* //
