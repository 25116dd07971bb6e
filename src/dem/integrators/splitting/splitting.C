/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "splitting.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(splitting, 0);

    addNamedToRunTimeSelectionTable
        (integrator, splitting, word, symplecticEuler);
    addNamedToRunTimeSelectionTable
        (integrator, splitting, word, stormerVerletPosition);
    addNamedToRunTimeSelectionTable(integrator, splitting, word, forestRuth);
    addNamedToRunTimeSelectionTable(integrator, splitting, word, pefrl);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::splitting::splitting(const word& name)
{
    if (name == "symplecticEuler")
    {
        drifts_ = {0, 1};
        kicks_ = {1};
        order_ = 1;
    }
    else if (name == "stormerVerletPosition")
    {
        drifts_ = {0.5, 0.5};
        kicks_ = {1};
        order_ = 2;
    }
    else if (name == "forestRuth")
    {
        const scalar theta = 1/(2 - cbrt(scalar(2)));
        const scalar middle = 0.5*(1 - theta);
        drifts_ = {0.5*theta, middle, middle, 0.5*theta};
        kicks_ = {theta, 1 - 2*theta, theta};
        order_ = 4;
    }
    else
    {
        const scalar xi = 0.1786178958448091;
        const scalar lambda = -0.2123418310626054;
        const scalar chi = -0.06626458266981849;
        drifts_ = {xi, chi, 1 - 2*(chi + xi), chi, xi};
        kicks_ = {0.5 - lambda, lambda, lambda, 0.5 - lambda};
        order_ = 4;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::splitting::step
(
    packedBodies& state,
    const scalar t,
    const scalar dt,
    const bool,
    const forces& force
) const
{
    state.keep();

    // Of the step, where the positions are
    scalar part = 0;
    forAll(drifts_, i)
    {
        if (drifts_[i] != 0)
        {
            part += drifts_[i];
            state.drift(drifts_[i]*dt, order_ > 2);
            force(t + part*dt, part*dt);
        }
        if (i < kicks_.size())
        {
            state.kick(kicks_[i]*dt);
        }
    }
}

// ************************************************************************* //
