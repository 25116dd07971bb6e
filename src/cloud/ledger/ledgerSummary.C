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
#include "OFstream.H"
#include "OSspecific.H"
#include "Pstream.H"

#include <algorithm>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const char* const Foam::ledger::ofBodies = "bodies (contacts, motion)";


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::ledger::timeOfBooking()
{
    ledger trial;
    const label n = 1000;
    const clock::time_point start = clock::now();
    for (label i = 0; i < n; ++i)
    {
        const entry e(trial, "trial");
    }
    return std::chrono::duration<scalar>(clock::now() - start).count()/n;
}


std::vector<std::pair<Foam::scalar, std::string>> Foam::ledger::sorted() const
{
    std::vector<std::pair<scalar, std::string>> list;
    for (const auto* times : {&times_, &laps_})
    {
        for (const auto& t : *times)
        {
            list.emplace_back(t.second, t.first);
        }
    }
    std::sort(list.rbegin(), list.rend());
    return list;
}


std::map<std::string, Foam::scalar> Foam::ledger::partsOfBodies() const
{
    std::map<std::string, scalar> parts(parts_);
    const auto all = times_.find(ofBodies);
    if (parts.empty() || all == times_.end())
    {
        return parts;
    }
    scalar known = 0;
    for (const auto& part : parts_)
    {
        known += part.second;
    }
    parts["motion and the rest"] = max(all->second - known, scalar(0));
    return parts;
}


Foam::scalar Foam::ledger::rest(const scalar all) const
{
    scalar left = all - own();
    for (const auto& t : laps_)
    {
        left -= t.second;
    }
    return left;
}


void Foam::ledger::writeWords
(
    Ostream& os,
    const scalar all,
    const scalar kinetic
) const
{
    const int digits = os.precision(4);
    os  << nl << "demCloud: summary" << nl
        << "    " << nFluidSteps_ << " fluid steps, " << nSteps_
        << " steps of the bodies, " << nRejected_ << " more undone" << nl;
    if (nSteps_)
    {
        os  << "    Steps from " << dtMin_ << " to " << dtMax_
            << " s, limited by: " << limitsText(limits_).c_str() << nl;
    }
    if (fluidLimits_.size())
    {
        os  << "    Steps of the fluid limited by: "
            << limitsText(fluidLimits_).c_str() << nl;
    }
    os  << "    " << nEntered_ << " bodies entered, " << nLeft_
        << " left the domain" << nl
        << "    Largest overlap " << 100*maxOverlap_
        << " % of the smaller radius" << nl
        << "    Kinetic energy at the end " << kinetic << " J" << nl;
    if (energyGain_ >= 0)
    {
        os  << "    Energy without a source: " << 100*energyGain_
            << " % of what there was at most; " << nTwice_
            << " steps made twice to see it" << nl;
    }
    if (nUnknown_)
    {
        os  << "    Energy of " << nUnknown_
            << " steps not looked at, as " << energyUnknown_.c_str() << nl;
    }
    if (nBack_)
    {
        os  << "    Gone back " << nBack_ << " times over steps in which"
            << " something was wrong" << nl;
    }
    if (cells_ > 0)
    {
        os  << "    " << cells_ << " cells over the smallest diameter" << nl;
    }
    if (maxVolumeError_ > 0 || maxMismatch_ > 0)
    {
        os  << "    What the bodies received and what the momentum equation"
            << " got differ by " << maxMismatch_ << " at most" << nl
            << "    Volume of the bodies on the mesh: error "
            << 100*maxVolumeError_ << " % at most" << nl;
    }

    if (errors_.size())
    {
        os  << "    Errors behind what was chosen, where they are known" << nl;
    }
    for (const std::string& error : errors_)
    {
        os  << "        " << error.c_str() << nl;
    }

    os  << "    Bodies and coupling took " << 100*own()/all
        << " % of the time" << nl
        << "    Wall time " << all << " s, of which" << nl;
    for (const auto& t : sorted())
    {
        os  << "        " << t.second.c_str() << ": " << t.first << " s, "
            << 100*t.first/all << " %" << nl;
        if (t.second == ofBodies)
        {
            for (const auto& part : partsOfBodies())
            {
                os  << "            of which " << part.first.c_str() << ": "
                    << part.second << " s, " << 100*part.second/all << " %"
                    << nl;
            }
        }
    }
    os  << "        everything else: " << rest(all) << " s, "
        << 100*rest(all)/all << " %" << nl;

    const scalar one = timeOfBooking();
    os  << "    This ledger itself: " << nBooked_ << " bookings of "
        << 1e9*one << " ns, " << 100*nBooked_*one/all << " % of the time"
        << nl << endl;
    os.precision(digits);
}


void Foam::ledger::writeTable
(
    Ostream& os,
    const scalar all,
    const scalar kinetic
) const
{
    const scalar one = timeOfBooking();
    const auto put = [&os](const std::string& name, const scalar value)
    {
        os  << name.c_str() << tab << value << nl;
    };
    os.precision(9);
    os  << "# name" << tab << "value" << nl;
    put("fluidSteps", nFluidSteps_);
    put("bodySteps", nSteps_);
    put("undoneSteps", nRejected_);
    put("smallestStep_s", nSteps_ ? dtMin_ : 0);
    put("largestStep_s", dtMax_);
    for (const word& name : limits_.sortedToc())
    {
        put("bodyStepsLimitedBy_" + name, limits_[name]);
    }
    for (const word& name : fluidLimits_.sortedToc())
    {
        put("fluidStepsLimitedBy_" + name, fluidLimits_[name]);
    }
    put("bodiesEntered", nEntered_);
    put("bodiesLeft", nLeft_);
    put("largestOverlap", maxOverlap_);
    put("kineticEnergy_J", kinetic);
    if (energyGain_ >= 0)
    {
        put("energyWithoutSource", energyGain_);
    }
    put("stepsMadeTwice", nTwice_);
    put("stepsOfUnknownEnergy", nUnknown_);
    put("stepsGoneBackOver", nBack_);
    if (exchanged_)
    {
        put("momentumMismatch", maxMismatch_);
        put("volumeError", maxVolumeError_);
    }
    if (cells_ > 0)
    {
        put("cellsOverSmallestDiameter", cells_);
    }
    for (const auto& f : figures_)
    {
        put(f.first, f.second);
    }
    put("wallTime_s", all);
    put("bodiesAndCoupling_percent", 100*own()/all);
    put("ledgerBookings", nBooked_);
    put("ledgerShare_percent", 100*nBooked_*one/all);

    os  << nl << "# time of" << tab << "s" << tab << "percent" << nl;
    for (const auto& t : sorted())
    {
        os  << t.second.c_str() << tab << t.first << tab
            << 100*t.first/all << nl;
    }
    for (const auto& part : partsOfBodies())
    {
        os  << "of " << ofBodies << ": " << part.first.c_str() << tab
            << part.second << tab << 100*part.second/all << nl;
    }
    os  << "everything else" << tab << rest(all) << tab
        << 100*rest(all)/all << nl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::ledger::close(const fileName& file, const scalar kinetic)
{
    if (closed())
    {
        return;
    }
    closed_ = true;

    const scalar all = max(whole(), VSMALL);
    writeWords(Info, all, kinetic);
    if (Pstream::master())
    {
        mkDir(file.path());
        OFstream os(file);
        writeTable(os, all, kinetic);
    }
}


// ************************************************************************* //
