/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "implicitTrapezoidal.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(implicitTrapezoidal, 0);
    addToRunTimeSelectionTable(integrator, implicitTrapezoidal, word);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using slope = dem::packedBodies::slope;

//- Half a step [s] times how much the rates of velocities differ, over the
//  largest velocity and its change [-]
scalar difference(const slope& a, const slope& b, const scalar half)
{
    scalar change = 0;
    scalar size = VSMALL;
    const auto compare = [&](const slope::rates& p, const slope::rates& q)
    {
        change = max(change, half*mag(p.v - q.v) + mag(p.x - q.x));
        size = max(size, half*mag(q.v) + mag(q.x));
    };
    for (std::size_t k = 0; k < a.singles.size(); ++k)
    {
        compare(a.singles[k], b.singles[k]);
    }
    scalar turn = 0;
    for (std::size_t k = 0; k < a.clumps.size(); ++k)
    {
        compare(a.clumps[k].of, b.clumps[k].of);
        turn = max(turn, half*mag(a.clumps[k].q - b.clumps[k].q));
    }
    return max(change/size, turn);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::implicitTrapezoidal::implicitTrapezoidal(const word&)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::implicitTrapezoidal::step
(
    packedBodies& state,
    const scalar t,
    const scalar dt,
    const bool,
    const forces& force
) const
{
    state.keep();

    const scalar half = 0.5*dt;
    const slope start = state.slopes();
    slope end = start;
    scalar before = GREAT;
    for (label n = 0; n < 100; ++n)
    {
        state.moveBy({{half, &start}, {half, &end}});
        force(t + dt, dt);
        const slope next = state.slopes();
        const scalar off = difference(end, next, half);

        // The forces of overlaps that are small beside the place do not come
        // any closer than round-off
        const bool converged = off < 1e-13 || (off < 1e-9 && off >= before);
        before = off;
        end = next;
        if (converged)
        {
            return;
        }
    }

    FatalErrorInFunction
        << "The implicit trapezoidal rule has not converged in 100 iterations"
        << " with a step of " << dt << " s at time " << t << " s." << nl
        << "    Its fixed-point iteration needs a step below 2/omega of the"
        << " stiffest contact: take a smaller one." << exit(FatalError);
}

// ************************************************************************* //
