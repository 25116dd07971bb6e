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


void Foam::demCloud::closeErrors()
{
    const scalar ofSteps = dem_->stepError();
    const scalar ofInterval =
        interval_.valid() && interval_->shows() ? interval_->meanError() : -1;
    const char* const bySteps =
        "of the impulses, by the forces at three times in a row";
    const char* const byInterval = "half the mean change of the forces";
    const std::string seen = "errorSeen", expected = "errorExpected";

    ledger_.setError(seen, dem::accuracyPlan::steps, ofSteps, bySteps);
    ledger_.setError(seen, couplingAccuracy::interval, ofInterval, byInterval);
    errors_.note(ledger_);
    ledger_.setError
    (
        seen,
        "slip of resolved bodies",
        ledger_.slip(),
        "the largest against the velocity imposed on the fluid, of the fastest"
    );
    ledger_.setError
    (
        expected,
        couplingAccuracy::averaging,
        exchanged_.valid() ? couplingAccuracy::expansionError(dict_) : -1,
        "what the expansion of the diffusion leaves out"
    );
    ledger_.setError
    (
        expected,
        couplingAccuracy::cells,
        immersed_.valid() && ledger_.cells() > 0
      ? couplingAccuracy::errorOf(ledger_.cells())
      : -1,
        "drag of a cylinder with as many as the smallest body"
    );
    scalar volume = -1, surface = -1;
    for (const dem::shape& s : dem_->shapes())
    {
        if (!s.isSphere())
        {
            volume = max(volume, s.volumeError());
            surface = max(surface, s.surfaceError());
        }
    }
    ledger_.setError
    (
        expected,
        "volume of clumps",
        volume,
        "spheres against the body that they stand for, the worst shape"
    );
    ledger_.setError
    (
        expected,
        "surface of clumps",
        surface,
        "offset volume, or the distance of an ellipsoid; the worst shape"
    );

    if (!accuracy_.valid())
    {
        return;
    }
    accuracy_->setSeen(dem::accuracyPlan::steps, ofSteps, bySteps);
    accuracy_->setSeen(couplingAccuracy::interval, ofInterval, byInterval);
    ledger_.setFigure("accuracy", accuracy_->target());
    for (const dem::accuracyPlan::part& p : accuracy_->parts())
    {
        if (p.error >= 0)
        {
            ledger_.setFigure(expected + ": " + p.name, p.error);
        }
    }
}


// ************************************************************************* //
