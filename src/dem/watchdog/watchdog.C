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

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

const dictionary none;

//- The entries of the watchdog
const dictionary& entriesOf(const dictionary& properties)
{
    return
        properties.isDict("watchdog") ? properties.subDict("watchdog") : none;
}


//- The way from a to b [m], in a domain that repeats itself
vector wayFrom
(
    const point& a,
    const point& b,
    const dem::periodicity& period
)
{
    vector way = b - a;
    for (const auto& s : period.seams())
    {
        way -= std::round((way & s.normal)/s.width())*s.separation;
    }
    return way;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::dem::watchdog::sums Foam::dem::watchdog::sumsOf(const advance& a)
{
    const bodies& start = a.start;
    const bool turned = !start.fluidTorque.none();
    const bool dragged = a.now.dragged();

    // Sums alone: what each body got is in the packed bodies
    packedDrag drag;
    drag.impulse = a.earlier.impulse + a.now.given().impulse;
    drag.work = a.earlier.work + a.now.given().work;
    sums s{};
    forAll(start.v, b)
    {
        const packedEnd end(a.now.end(a.place(b), drag));
        const scalar m = start.mass[b];
        s.before +=
            0.5*m*magSqr(start.v[b]) + 0.5*(start.L(b) & start.omega[b]);
        s.now += 0.5*m*magSqr(end.v) + 0.5*(end.L & end.omega);

        const vector F = start.fluidForce[b] + m*a.g;
        if (!dragged)
        {
            s.work +=
                F & wayFrom(start.x[b], a.now.position(a.place(b)), a.period);
        }
        s.gained += m*(end.v - start.v[b]);
        s.impulse += a.dt*F;
        s.largest +=
            0.5*m*magSqr(start.v[b])
           *(dragged ? 1/start.drag->massShare(b) : 1)
          + 0.5*(start.L(b) & start.omega[b]);
        s.size += m*mag(start.v[b]) + a.dt*mag(F);
        s.mass += m;
        s.given += 0.5*sqr(a.dt)*magSqr(F)/m;

        // Held forces are constant in the advance: their work is exact, that
        // of torques is so as long as the angular velocity changes evenly
        if (turned)
        {
            const vector& T = start.fluidTorque[b];
            s.work += 0.5*a.dt*(T & (start.omega[b] + end.omega));
            s.slack += 0.5*a.dt*mag(T)*mag(end.omega - start.omega[b]);
        }
    }

    s.work += drag.work;
    s.impulse += drag.impulse;
    s.size += mag(drag.impulse);

    const rankGroup& group = a.now.group();
    for
    (
        scalar* x
      : {
            &s.before, &s.now, &s.work, &s.slack, &s.mass, &s.given, &s.size,
            &s.largest
        }
    )
    {
        *x = group.sum(*x);
    }
    s.gained = group.sum(s.gained);
    s.impulse = group.sum(s.impulse);
    return s;
}


Foam::scalar Foam::dem::watchdog::slowest(const advance& a)
{
    return 1e-6*a.now.minRadius()/a.dt;
}


bool Foam::dem::watchdog::allFine(const advance& a)
{
    const bool closed = !a.closed.empty();
    bool fine = true;
    forAll(a.start.v, b)
    {
        const point x(a.now.position(a.place(b)));
        const vector v(a.now.velocity(a.place(b)));
        fine =
            fine && std::isfinite(magSqr(x) + magSqr(v))
         && (!closed || a.closed.contains(x));
    }
    return fine;
}


Foam::string Foam::dem::watchdog::wrongBody(const advance& a)
{
    const bodies& start = a.start;
    boundBox room(a.closed);
    const bool closed = !room.empty();
    room.inflate(SMALL);
    packedDrag drag;
    forAll(start.v, b)
    {
        const label k = a.place(b);
        const point x(a.now.position(k));
        const packedEnd end(a.now.end(k, drag));
        const bool finite =
            std::isfinite(x.x() + x.y() + x.z())
         && std::isfinite(magSqr(end.v) + magSqr(end.L));
        if (finite && (!closed || room.contains(x)))
        {
            continue;
        }
        const vector R(start.shapeOf(b).boundingRadius()*vector::one);
        if (!finite || !boundBox(room.min() - R, room.max() + R).contains(x))
        {
            OStringStream os;
            os  << "body " << start.id[b] << " ("
                << start.shapeOf(b).name() << ") is at " << x
                << " with velocity " << end.v << " m/s"
                << (finite ? ", outside of a domain without a way out" : "");
            return os.str();
        }
    }
    return string();
}


Foam::string Foam::dem::watchdog::wrongEnergy(const advance& a, const sums& s)
{
    // A bed at rest trembles: energy is seen against what lifts it by a radius
    const scalar lift =
        s.mass*(mag(a.g)*a.now.minRadius() + 0.5*sqr(slowest(a)));
    scale_ = max(scale_, max(max(s.largest, mag(s.work)), max(s.given, lift)));
    gain_ = max
    (
        (s.now - s.before - s.work - s.slack - a.stored)/max(scale_, VSMALL),
        scalar(0)
    );
    if (gain_ <= energyGain_)
    {
        return string();
    }
    OStringStream os;
    os  << "the kinetic energy has grown from " << s.before << " to " << s.now
        << " J, but work of " << s.work << " J and " << a.stored
        << " J stored in contacts were there: " << 100*gain_
        << " % too much";
    return os.str();
}


Foam::string Foam::dem::watchdog::wrongMomentum
(
    const advance& a,
    const sums& s
) const
{
    const vector off = s.gained - s.impulse;
    if (mag(off) <= momentumGain_*(s.size + s.mass*slowest(a)))
    {
        return string();
    }
    OStringStream os;
    os  << "the momentum is off by " << off << " kg m/s of what the forces"
        << " explain";
    return os.str();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::watchdog::watchdog(const dictionary& properties)
:
    energyGain_(getPositive(entriesOf(properties), "energyGain", 0.01)),
    momentumGain_(getPositive(entriesOf(properties), "momentumGain", 1e-6)),
    mismatch_(getPositive(entriesOf(properties), "mismatch", 1e-6)),
    halvings_(getLabel(entriesOf(properties), "halvings", 0, 5)),
    scale_(0),
    gain_(-1)
{
    checkKeys
    (
        entriesOf(properties),
        {"energyGain", "momentumGain", "mismatch", "halvings"}
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::dem::watchdog::on(const dictionary& properties)
{
    return
        !properties.found("watchdog") || properties.isDict("watchdog")
     || getChoice(properties, "watchdog", {"on", "off"}) == "on";
}


Foam::string Foam::dem::watchdog::complaint(const advance& a)
{
    gain_ = -1;
    string wrong;
    if (a.now.group().any(!allFine(a)))
    {
        wrong = a.now.group().first(wrongBody(a));
    }
    if (wrong.empty() && a.calm)
    {
        const sums s(sumsOf(a));
        wrong = wrongEnergy(a, s);
        if (wrong.empty() && a.free)
        {
            wrong = wrongMomentum(a, s);
        }
    }
    return wrong;
}


Foam::string Foam::dem::watchdog::complaint
(
    const vector& toBodies,
    const vector& toFluid,
    const scalar magnitudes
) const
{
    const scalar off = mag(toBodies + toFluid);
    if (off <= mismatch_*max(magnitudes, VSMALL))
    {
        return string();
    }
    OStringStream os;
    os  << "the bodies got " << toBodies << " N s and the fluid " << toFluid
        << " N s, which do not cancel";
    return os.str();
}


// ************************************************************************* //
