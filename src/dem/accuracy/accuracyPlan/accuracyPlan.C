/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "accuracyPlan.H"
#include "checkedEntry.H"
#include "StringStream.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::accuracyPlan::accuracyPlan
(
    const dictionary& properties,
    const label nParts
)
:
    target_(getInRange(properties, "accuracy", 1e-4, 0.2)),
    nParts_(max(nParts, label(1)))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::string Foam::dem::accuracyPlan::percent(const scalar x)
{
    OStringStream os;
    os.precision(2);
    os  << 100*x << " %";
    return os.str();
}


void Foam::dem::accuracyPlan::setSeen
(
    const string& name,
    const scalar e,
    const string& by
)
{
    for (part& p : parts_)
    {
        if (p.name == name)
        {
            p.seen = e;
            p.seenBy = by;
        }
    }
}


void Foam::dem::accuracyPlan::write(Ostream& os) const
{
    os  << "    accuracy " << percent(target_).c_str() << ", of which each of "
        << nParts_ << " parts may have " << percent(share()).c_str() << nl;
    for (const part& p : parts_)
    {
        os  << "        " << p.name.c_str() << ": " << p.chosen.c_str();
        if (p.error >= 0)
        {
            os  << ", error " << percent(p.error).c_str() << " ("
                << p.basis.c_str() << ')';
        }
        if (!p.cost.empty())
        {
            os  << "; " << p.cost.c_str();
        }
        os  << nl;
        if (p.error > share()*(1 + 1e-6))
        {
            os  << "        Warning: that is more than its share" << nl;
        }
    }
    os  << flush;
}


void Foam::dem::accuracyPlan::writeSummary(Ostream& os) const
{
    os  << "    Accuracy " << percent(target_).c_str() << ", each part "
        << percent(share()).c_str() << ": error expected; seen in this run"
        << nl;
    for (const part& p : parts_)
    {
        os  << "        " << p.name.c_str() << ": ";
        if (p.error >= 0)
        {
            os  << percent(p.error).c_str();
        }
        else
        {
            os  << "not known";
        }
        os  << "; ";
        if (p.seen >= 0)
        {
            os  << percent(p.seen).c_str() << " (" << p.seenBy.c_str() << ')';
        }
        else
        {
            os  << "not looked at";
        }
        os  << nl;
    }
}


// ************************************************************************* //
