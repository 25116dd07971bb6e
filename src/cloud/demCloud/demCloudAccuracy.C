/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "demCloud.H"
#include "couplingAccuracy.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::demCloud::planAccuracy(const fluidAccess access)
{
    if (dem::accuracyPlan::named(dict_))
    {
        accuracy_.reset
        (
            new dem::accuracyPlan
            (
                dict_,
                couplingAccuracy::nParts(dict_, access != fluidAccess::none)
            )
        );
    }
}


void Foam::demCloud::chooseCouplingAccuracy()
{
    if (accuracy_.valid())
    {
        if (dem_->stepAccuracy())
        {
            accuracy_->append(*dem_->stepAccuracy());
        }
        couplingAccuracy::choose
        (
            dict_,
            *accuracy_,
            coupling_ != "none" && pointBodies(),
            actsOnFluid()
        );
    }
}


void Foam::demCloud::writeAccuracy(const caseCheck& looked)
{
    if (!accuracy_.valid())
    {
        return;
    }
    for (const caseCheck::figure& f : looked.figures())
    {
        if (immersed_.valid() && f.name == "cellsOverDiameter" && f.value > 0)
        {
            couplingAccuracy::noteCells(*accuracy_, f.value);
        }
    }
    accuracy_->write(Info);
}


void Foam::demCloud::closeAccuracy()
{
    if (!accuracy_.valid())
    {
        return;
    }
    if (dem_->stepAccuracy())
    {
        accuracy_->setSeen
        (
            dem_->stepAccuracy()->name,
            dem_->stepError(),
            "of the impulses, by the next term of the scheme"
        );
    }
    if (interval_.valid() && interval_->shows())
    {
        accuracy_->setSeen
        (
            couplingAccuracy::interval,
            interval_->meanError(),
            "half the mean change of the forces"
        );
    }
    ledger_.setFigure("accuracy", accuracy_->target());
    for (const dem::accuracyPlan::part& p : accuracy_->parts())
    {
        if (p.error >= 0)
        {
            ledger_.setFigure("errorExpected: " + p.name, p.error);
        }
        if (p.seen >= 0)
        {
            ledger_.setFigure("errorSeen: " + p.name, p.seen);
        }
    }
}


// ************************************************************************* //
