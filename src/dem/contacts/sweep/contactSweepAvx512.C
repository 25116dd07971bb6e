/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    The sweep over the contacts for processors with AVX-512.

\*---------------------------------------------------------------------------*/

#pragma GCC target("avx512f,avx512dq,avx512vl,avx512bw,avx2,fma")

#define STYX_LANES 8
#define STYX_INSTRUCTIONS avx512

#include "contactSweep.H"
#include "kickSpheres.H"
#include "leapClumps.H"
#include "leapSpheres.H"
#include "wayLeft.H"

const Foam::dem::sweepSet Foam::dem::sweepAvx512
{
    STYX_LANES,
    &avx512::sweep,
    &avx512::sweepReach,
    &avx512::kick,
    &avx512::leap,
    &avx512::leapClumps,
    &avx512::spreadClumps,
    &avx512::wayLeft
};


// ************************************************************************* //
