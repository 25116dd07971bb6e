/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "filmImpulse.H"
#include "quadRecords.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::filmImpulse::collect
(
    const packedBodies& state,
    const std::vector<quad>& onSpheres
)
{
    F_ = vector(Zero);
    T_ = vector(Zero);
    // There are none before the first film
    const label n = min(label(onSpheres.size()), state.nSpheres());
    for (label s = 0; s < n; ++s)
    {
        const label b = state.bodyOf(s);
        const vector f = quadRecords::vectorOf(onSpheres[s]);
        F_[b] += f;
        if (!state.isSingle(b))
        {
            T_[b] += (state.centre(s) - state.position(b)) ^ f;
        }
    }
}


void Foam::dem::filmImpulse::kick(const scalar h)
{
    forAll(F_, b)
    {
        J_[b] += h*F_[b];
        JL_[b] += h*T_[b];
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::filmImpulse::begin
(
    const packedBodies& state,
    const std::vector<quad>& onSpheres
)
{
    const label n = state.size();
    F_.resize(n);
    T_.resize(n);
    J_.resize(n);
    JL_.resize(n);
    J_ = vector(Zero);
    JL_ = vector(Zero);
    collect(state, onSpheres);
}


void Foam::dem::filmImpulse::step
(
    const packedBodies& state,
    const std::vector<quad>& onSpheres,
    const scalar h
)
{
    kick(0.5*h);
    collect(state, onSpheres);
    kick(0.5*h);
}


// ************************************************************************* //
