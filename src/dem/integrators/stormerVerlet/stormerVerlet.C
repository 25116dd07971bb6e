/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "stormerVerlet.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(stormerVerlet, 0);
    addToRunTimeSelectionTable(integrator, stormerVerlet, word);
}
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::stormerVerlet::step
(
    packedBodies& state,
    const scalar t,
    const scalar dt,
    const bool trial,
    const forces& force
) const
{
    state.leap(dt, trial);
    force(t + dt, dt);
}


// ************************************************************************* //
