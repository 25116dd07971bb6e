/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    The sweep over the contacts for processors with AVX2 and FMA.

\*---------------------------------------------------------------------------*/

#pragma GCC target("avx2,fma")

#define STYX_LANES 4
#define STYX_INSTRUCTIONS avx2

#include "contactSweep.H"
#include "kickSpheres.H"
#include "leapClumps.H"
#include "leapSpheres.H"
#include "wayLeft.H"

const Foam::dem::sweepSet Foam::dem::sweepAvx2
{
    STYX_LANES,
    &avx2::sweep,
    &avx2::sweepReach,
    &avx2::kick,
    &avx2::leap,
    &avx2::leapClumps,
    &avx2::spreadClumps,
    &avx2::wayLeft
};


// ************************************************************************* //
