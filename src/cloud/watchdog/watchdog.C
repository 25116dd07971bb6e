/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "watchdog.H"
#include "allowedKeys.H"
#include "checkedEntry.H"
#include "StringStream.H"

#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vector Foam::watchdog::momentumOf(const dem::bodies& state)
{
    vector sum(Zero);
    forAll(state.v, b)
    {
        sum += state.mass[b]*state.v[b];
    }
    return sum;
}


void Foam::watchdog::lookAtContacts(const dem::demSolver& dem)
{
    const dem::bodies& state = dem.state();
    scalar largest = 0;
    for (const scalar r : state.sphereR)
    {
        largest = max(largest, r);
    }
    scalar force = 0;
    atWall_ = false;
    for (const dem::contactForce& c : dem.contacts())
    {
        force += mag(c.normal());
        atWall_ = atWall_ || c.b < 0;
    }
    stored_ = force*dem.report().overlap*largest;
}


Foam::string Foam::watchdog::wrongBody(const dem::bodies& state) const
{
    OStringStream os;
    forAll(state.x, b)
    {
        const scalar all =
            magSqr(state.x[b]) + magSqr(state.v[b]) + magSqr(state.L[b]);
        const bool finite = all < GREAT;
        boundBox room(closed_);
        room.inflate(SMALL);
        room.min() -= state.shapeOf(b).boundingRadius()*vector::one;
        room.max() += state.shapeOf(b).boundingRadius()*vector::one;
        const bool lost = !closed_.empty() && !room.contains(state.x[b]);
        if (!finite || lost)
        {
            os  << "body " << state.id[b] << " ("
                << state.shapeOf(b).name() << ") is at " << state.x[b]
                << " with velocity " << state.v[b] << " m/s"
                << (finite ? ", outside of a domain without a way out" : "");
            return os.str();
        }
    }
    return string();
}


Foam::string Foam::watchdog::wrongEnergy
(
    const dem::demSolver& dem,
    const scalar dt
)
{
    const dem::bodies& state = dem.state();
    if (!calm_ || state.drag || dem.period().active())
    {
        return string();
    }

    // Held forces are constant in the step: their work is exact, that of held
    // torques nearly so
    scalar work = 0;
    forAll(state.x, b)
    {
        work +=
            (state.fluidForce[b] + state.mass[b]*dem.g())
          & (state.x[b] - x_[b]);
        work +=
            0.5*dt*(state.fluidTorque[b] & (omega_[b] + state.omega[b]));
    }
    const scalar now = state.kineticEnergy();
    scale_ = max(scale_, max(kinetic_, mag(work)));
    gain_ = max
    (
        (now - kinetic_ - work - stored_)/max(scale_, VSMALL),
        scalar(0)
    );
    if (gain_ <= energyGain_)
    {
        return string();
    }
    OStringStream os;
    os  << "the kinetic energy has grown from " << kinetic_ << " to " << now
        << " J, but work of " << work << " J and " << stored_
        << " J stored in contacts were there: " << 100*gain_
        << " % too much";
    return os.str();
}


Foam::string Foam::watchdog::wrongMomentum
(
    const dem::demSolver& dem,
    const scalar dt
) const
{
    const dem::bodies& state = dem.state();
    if (!calm_ || atWall_ || state.drag || !dem.walls().empty())
    {
        return string();
    }
    vector impulse(Zero);
    scalar size = sizes_;
    forAll(state.x, b)
    {
        const vector F = state.fluidForce[b] + state.mass[b]*dem.g();
        impulse += dt*F;
        size += dt*mag(F);
    }
    const vector off = momentumOf(state) - momentum_ - impulse;
    if (mag(off) <= momentumGain_*size)
    {
        return string();
    }
    OStringStream os;
    os  << "the momentum is off by " << off << " kg m/s of what the forces"
        << " explain";
    return os.str();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::watchdog::watchdog
(
    const dictionary& dict,
    const boundBox& closed,
    const bool calm
)
:
    energyGain_(dem::getPositive(dict, "energyGain", 0.01)),
    momentumGain_(dem::getPositive(dict, "momentumGain", 1e-6)),
    mismatch_(dem::getPositive(dict, "mismatch", 1e-6)),
    halvings_(dem::getLabel(dict, "halvings", 0, 5)),
    closed_(closed),
    calm_(calm),
    scale_(0),
    kinetic_(0),
    stored_(0),
    momentum_(Zero),
    sizes_(0),
    atWall_(false),
    gain_(0)
{
    dem::checkKeys
    (
        dict,
        {"energyGain", "momentumGain", "mismatch", "halvings"}
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::watchdog::store(const dem::demSolver& dem)
{
    const dem::bodies& state = dem.state();
    x_ = state.x;
    v_ = state.v;
    L_ = state.L;
    omega_ = state.omega;
    q_ = state.q;
    history_ = dem.history();
    kinetic_ = state.kineticEnergy();
    momentum_ = momentumOf(state);
    sizes_ = 0;
    forAll(state.v, b)
    {
        sizes_ += state.mass[b]*mag(state.v[b]);
    }
    lookAtContacts(dem);
}


Foam::string Foam::watchdog::complaint
(
    const dem::demSolver& dem,
    const scalar dt
)
{
    gain_ = 0;
    string wrong(wrongBody(dem.state()));
    wrong = wrong.empty() ? wrongEnergy(dem, dt) : wrong;
    return wrong.empty() ? wrongMomentum(dem, dt) : wrong;
}


void Foam::watchdog::restore(dem::demSolver& dem) const
{
    dem::bodies& state = dem.state();
    state.x = x_;
    state.v = v_;
    state.L = L_;
    state.omega = omega_;
    state.q = q_;
    forAll(state.x, b)
    {
        state.updateSpheres(b);
    }
    dem.setHistory(history_);
}


Foam::string Foam::watchdog::complaint
(
    const vector& toBodies,
    const vector& toFluid
) const
{
    const scalar off = mag(toBodies + toFluid);
    if (off <= mismatch_*max(mag(toBodies), VSMALL))
    {
        return string();
    }
    OStringStream os;
    os  << "the bodies got " << toBodies << " N s and the fluid " << toFluid
        << " N s, which do not cancel";
    return os.str();
}


// ************************************************************************* //
