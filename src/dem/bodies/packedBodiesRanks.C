/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "packedBodies.H"
#include "quadRecords.H"

#include <algorithm>

using Foam::dem::quadRecords::record;
using Foam::dem::quadRecords::vectorOf;

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

scalar* put(const vector& v, scalar* to)
{
    return std::copy(v.cdata(), v.cdata() + 3, to);
}


scalar* put(const quaternion& q, scalar* to)
{
    *to = q.w();
    return put(q.v(), to + 1);
}


vector vectorFrom(const scalar*& from)
{
    const vector v(from[0], from[1], from[2]);
    from += 3;
    return v;
}


quaternion quaternionFrom(const scalar*& from)
{
    const scalar w = *from++;
    return quaternion(w, vectorFrom(from));
}


//- Copy the records of n spheres
void copyRecords
(
    const dem::packedBodies::records& source,
    const label from,
    const label n,
    dem::packedBodies::records& target,
    const label to
)
{
    std::copy_n(&source.xv[from], n, &target.xv[to]);
    std::copy_n(&source.w[from], n, &target.w[to]);
    std::copy_n(&source.ft[from], n, &target.ft[to]);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::packedBodies::setGroup
(
    const rankGroup& group,
    const scalar minRadius,
    const scalar meanRadius
)
{
    group_ = group;
    minRadius_ = minRadius;
    meanRadius_ = meanRadius;
}


void Foam::dem::packedBodies::rearrange
(
    const bodies& state,
    const labelUList& source
)
{
    const packedBodies was(std::move(*this));
    sweeps_ = was.sweeps_;
    pack(state, was.g_);
    pending_ = was.pending_;
    oldPending_ = was.oldPending_;
    motion_ = was.motion_;
    singleBounds_ = was.singleBounds_;
    setGroup(was.group_, was.minRadius_, was.meanRadius_);

    const bool trial = was.old_.w.size();
    old_ = trial ? now_ : records();
    oldClumps_ = trial ? clumps_ : std::vector<clump>();
    given_.impulse = was.given_.impulse;
    given_.work = was.given_.work;
    oldGiven_ = trial ? given_ : packedDrag();
    oldGiven_.impulse = was.oldGiven_.impulse;
    oldGiven_.work = was.oldGiven_.work;

    const auto copy = [](const clump& from, clump& to)
    {
        clump c = from;
        c.body = to.body;
        c.first = to.first;
        c.last = to.last;
        c.copied = to.copied;
        to = c;
    };
    forAll(source, b)
    {
        const label former = source[b];
        if (former < 0)
        {
            continue;
        }
        const label p = place_[b], q = was.place_[former];
        const label n = p < 0 ? 1 : clumps_[p].last - clumps_[p].first;
        const label to = p < 0 ? -1 - p : clumps_[p].first;
        const label from = p < 0 ? -1 - q : was.clumps_[q].first;
        copyRecords(was.now_, from, n, now_, to);
        if (!given_.given.empty())
        {
            given_.given[b] = was.given_.given[former];
        }
        if (trial && !given_.given.empty())
        {
            oldGiven_.given[b] = was.oldGiven_.given[former];
        }
        if (trial)
        {
            copyRecords(was.old_, from, n, old_, to);
        }
        if (p >= 0)
        {
            copy(was.clumps_[q], clumps_[p]);
            if (trial)
            {
                copy(was.oldClumps_[q], oldClumps_[p]);
            }
        }
    }
}


Foam::scalar* Foam::dem::packedBodies::share
(
    const label b,
    scalar* to
) const
{
    const label p = place_[b];
    if (p < 0)
    {
        const label s = -1 - p;
        to = put(vectorOf(now_.x(s)), to);
        to = put(vectorOf(now_.v(s)), to);
        return put(vectorOf(now_.w[s]), to);
    }
    const clump& c = clumps_[p];
    to = put(c.x, to);
    to = put(c.v, to);
    to = put(c.omega, to);
    to = put(c.q, to);
    return put(c.q0, to);
}


const Foam::scalar* Foam::dem::packedBodies::receive
(
    const label b,
    const scalar* from
)
{
    const label p = place_[b];
    if (p < 0)
    {
        const label s = -1 - p;
        now_.x(s) = record(vectorFrom(from), now_.x(s).w);
        now_.v(s) = record(vectorFrom(from), now_.v(s).w);
        now_.w[s] = record(vectorFrom(from), now_.w[s].w);
        now_.f(s) = now_.t(s) = quad{0, 0, 0, 0};
        return from;
    }
    clump& c = clumps_[p];
    c.x = vectorFrom(from);
    c.v = vectorFrom(from);
    c.omega = vectorFrom(from);
    c.q = quaternionFrom(from);
    c.q0 = quaternionFrom(from);
    spreadOne(p);
    return from;
}


void Foam::dem::packedBodies::settle(const label b)
{
    if (old_.w.empty())
    {
        return;
    }
    const label p = place_[b];
    const label first = p < 0 ? -1 - p : clumps_[p].first;
    const label n = p < 0 ? 1 : clumps_[p].last - first;
    copyRecords(now_, first, n, old_, first);
    if (p >= 0)
    {
        oldClumps_[p] = clumps_[p];
    }
}


void Foam::dem::packedBodies::putBounds(UList<scalar>& to) const
{
    // Components of the spheres and not their length, so that the bounds do
    // not depend on the number of ranks
    const leapBounds& b = singleBounds_;
    for (direction d = 0; d < 3; ++d)
    {
        to[d] = b.speed[d];
        to[3 + d] = b.turning[d];
        to[6 + d] = b.acceleration[d];
    }
    to[9] = clumpMotion_.speed;
    to[10] = clumpMotion_.turning;
    to[11] = clumpMotion_.acceleration;
}


void Foam::dem::packedBodies::setBounds(const UList<scalar>& from)
{
    for (direction d = 0; d < 3; ++d)
    {
        singleBounds_.speed[d] = from[d];
        singleBounds_.turning[d] = from[3 + d];
        singleBounds_.acceleration[d] = from[6 + d];
    }
    motion_.speed = from[9];
    motion_.turning = from[10];
    motion_.acceleration = from[11];
    boundSingles();
}


// ************************************************************************* //
