/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    The sweep over the contacts for processors with any x86-64.

\*---------------------------------------------------------------------------*/

#define STYX_LANES 2
#define STYX_INSTRUCTIONS sse2

#include "contactSweep.H"
#include "kickSpheres.H"
#include "leapClumps.H"
#include "leapSpheres.H"
#include "wayLeft.H"

const Foam::dem::sweepSet Foam::dem::sweepSse2
{
    STYX_LANES,
    &sse2::sweep,
    &sse2::sweepReach,
    &sse2::kick,
    &sse2::leap,
    &sse2::leapClumps,
    &sse2::spreadClumps,
    &sse2::wayLeft
};


// ************************************************************************* //
