/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "motionRepeat.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::coupling::motionRepeat>
Foam::coupling::motionRepeat::New
(
    const fvMesh& mesh,
    const dictionary& dict
)
{
    const word key("outerCorrectors");
    if
    (
        !dict.found(key)
     || dem::getChoice(dict, key, {"once", "repeat"}) == "once"
    )
    {
        return nullptr;
    }

    const label n =
        mesh.solutionDict().subOrEmptyDict("PIMPLE").getOrDefault<label>
        (
            "nOuterCorrectors",
            1
        );
    if (n < 2)
    {
        dem::badEntry
        (
            dict,
            key,
            "repeat needs a solver with outer correctors and"
            " nOuterCorrectors 2 or more in the dictionary PIMPLE of"
            " system/fvSolution, which has " + Foam::name(n)
        );
    }
    return autoPtr<motionRepeat>::New();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::coupling::motionRepeat::relaxed::step
(
    const vector& residual,
    const bool first
)
{
    if (first)
    {
        factor_ = 1;
    }
    else
    {
        const vector change = residual - residual_;
        const scalar factor =
            -factor_*(residual_ & change)/max(magSqr(change), VSMALL);
        if (factor > 0)
        {
            factor_ = factor;
        }
    }
    residual_ = residual;
    return factor_*residual;
}


void Foam::coupling::motionRepeat::start(const List<imposedMotion>& predicted)
{
    first_ = predicted;
    velocity_.setSize(predicted.size());
    spin_.setSize(predicted.size());
    nSolved_ = 0;
}


void Foam::coupling::motionRepeat::next
(
    const dem::bodies& state,
    List<imposedMotion>& imposed
)
{
    if (nSolved_++ == 0)
    {
        return;
    }
    const bool first = nSolved_ == 2;
    forAll(imposed, b)
    {
        imposedMotion& w = imposed[b];
        w.v += velocity_[b].step(state.v[b] - w.v, first);
        w.omega += spin_[b].step(state.omega[b] - w.omega, first);
    }
}


// ************************************************************************* //
