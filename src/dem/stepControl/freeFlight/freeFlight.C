/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "freeFlight.H"
#include "nearRanks.H"
#include "rankMail.H"
#include "sizeLevels.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::scalar;

//- First positive root t of d = c t + b t^2/2; GREAT if there is none
scalar firstRoot(const scalar d, const scalar c, const scalar b)
{
    const scalar discriminant = c*c + 2*b*d;
    if (discriminant < 0)
    {
        return Foam::GREAT;
    }
    const scalar sum = c + Foam::sqrt(discriminant);
    return 2*d < sum*Foam::GREAT ? 2*d/sum : Foam::GREAT;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

inline void Foam::dem::freeFlight::meet
(
    const label sphere,
    const scalar d,
    const scalar c,
    const scalar b,
    const scalar r,
    const bool counts
)
{
    nLooked_ += counts;

    // What touches already is no new contact
    if (d < 0)
    {
        return;
    }
    const scalar t = firstRoot(d, c, b);
    if (t >= horizon_)
    {
        return;
    }

    if (t < time_)
    {
        time_ = t;
        body_ = state_.bodyOf(sphere);
    }

    // A contact that begins deeper than a tenth of the smaller sphere is
    // none that a step could find
    const scalar speed = c + b*t;
    const scalar within =
        0.1*r < begin_*speed ? 0.1*r/max(speed, VSMALL) : begin_;
    landing_ = min(landing_, t + within);
}


Foam::scalarList Foam::dem::freeFlight::reaches
(
    const vector& v,
    const vector& a
) const
{
    scalarList reach(state_.nSpheres());
    forAll(reach, s)
    {
        const packedBodies::path& p = paths_[s];
        reach[s] =
            state_.radius(s) + reach_
          + horizon_*(mag(p.v - v) + 0.5*horizon_*(mag(p.a - a) + p.bend));
    }
    return reach;
}


void Foam::dem::freeFlight::findMean(vector& v, vector& a)
{
    const rankGroup& group = state_.group();
    label n = state_.nSpheres();
    if (group.shared())
    {
        n = 0;
        for (label s = 0; s < state_.nSpheres(); ++s)
        {
            n += state_.owns(state_.bodyOf(s));
        }
    }
    nSpheres_ = group.sum(n);

    v = a = Zero;
    for (label s = 0; s < state_.nSpheres(); ++s)
    {
        if (state_.owns(state_.bodyOf(s)))
        {
            v += paths_[s].v/nSpheres_;
            a += paths_[s].a/nSpheres_;
        }
    }
    v = group.sum(v);
    a = group.sum(a);
}


void Foam::dem::freeFlight::fetchOthers
(
    const scalarList& reach,
    const periodicity& period
)
{
    DynamicList<point> x;
    DynamicList<scalar> r;
    DynamicList<label> mine;
    forAll(reach, s)
    {
        if (state_.owns(state_.bodyOf(s)))
        {
            x.append(state_.centre(s));
            r.append(reach[s]);
            mine.append(s);
        }
    }

    List<DynamicList<visitor>> out(Pstream::nProcs());
    const List<DynamicList<label>> near(nearRanks(x, r, 0, period));
    forAll(near, rank)
    {
        for (const label k : near[rank])
        {
            const label s = mine[k];
            out[rank].append
            (
                visitor{x[k], state_.radius(s), r[k], paths_[s], bodyId(s)}
            );
        }
    }
    for (const auto& part : swapRecords(out))
    {
        for (const visitor& o : part)
        {
            others_.append(o);
            paths_.push_back(o.path);
        }
    }
}


inline void Foam::dem::freeFlight::meetPair
(
    const label i,
    const label j,
    const vector& away
)
{
    const label a = bodyId(i), b = bodyId(j);
    if (a == b || (isOther(i) && isOther(j)))
    {
        return;
    }
    const scalar distance = max(mag(away), VSMALL);
    const vector normal = away/distance;
    const packedBodies::path& p = paths_[i];
    const packedBodies::path& q = paths_[j];

    // Two ranks have a pair with a sphere of another: one counts it
    const bool counts = isOther(i) ? b < a : !isOther(j) || a < b;
    meet
    (
        isOther(i) ? j : i,
        wayTo(distance - radius(i) - radius(j)),
        normal & (q.v - p.v),
        (normal & (q.a - p.a)) + p.bend + q.bend,
        min(radius(i), radius(j)),
        counts
    );
}


void Foam::dem::freeFlight::meetSpheres(const periodicity& period)
{
    vector v, a;
    findMean(v, a);
    const scalarList reach(reaches(v, a));
    if (state_.group().shared())
    {
        fetchOthers(reach, period);
    }

    // The spheres, and behind them the images of those near a seam
    const label n = state_.nSpheres();
    DynamicList<point> x(n);
    DynamicList<label> source(n);
    DynamicList<scalar> r(n);
    for (label s = 0; s < n; ++s)
    {
        if (state_.owns(state_.bodyOf(s)))
        {
            x.append(state_.centre(s));
            source.append(s);
            r.append(reach[s]);
        }
    }
    forAll(others_, k)
    {
        x.append(others_[k].x);
        source.append(n + k);
        r.append(others_[k].reach);
    }
    const label nOriginals = x.size();
    if (period.active())
    {
        scalar overhang = 0;
        forAll(x, k)
        {
            overhang = max(overhang, period.overhang(x[k], r[k]));
        }
        for (label k = 0; k < nOriginals; ++k)
        {
            // By value: an append may move the list that a reference is into
            const point original = x[k];
            const label sourceOf = source[k];
            const scalar reachOf = r[k];
            period.forEachImage
            (
                original,
                reachOf + overhang,
                [&](const label image)
                {
                    x.append(original + period.shift(image));
                    source.append(sourceOf);
                    r.append(reachOf);
                }
            );
        }
    }

    sizeLevels(x, r, 0).forEachPair
    (
        [&](const label k, const label l)
        {
            if (k < nOriginals || l < nOriginals)
            {
                meetPair(source[k], source[l], x[k] - x[l]);
            }
        }
    );
}


void Foam::dem::freeFlight::meetWalls
(
    const wallSet& walls,
    const periodicity& period
)
{
    const scalarList reach(reaches(Zero, Zero));
    DynamicList<label> elements;
    forAll(reach, s)
    {
        if (!state_.owns(state_.bodyOf(s)))
        {
            continue;
        }
        const packedBodies::path& path = paths_[s];
        const scalar r = state_.radius(s);

        const auto meetFrom = [&](const wall& w, const point& x)
        {
            const scalar speed = w.moving() ? w.speed() : 0;
            elements.clear();
            w.candidates(x, reach[s] + speed*horizon_, elements);
            for (const label e : elements)
            {
                point p;
                vector normal;
                const scalar d = wayTo(w.nearest(x, e, p, normal) - r);
                const scalar c =
                    w.convex() ? -(normal & path.v) : mag(path.v);
                const scalar b =
                    w.convex() ? -(normal & path.a) : mag(path.a);
                meet(s, d, c + speed, b + path.bend, r);
            }
        };
        for (const wall& w : walls.walls())
        {
            meetFrom(w, state_.centre(s));
            if (!w.bounded())
            {
                continue;
            }
            period.forEachImage
            (
                state_.centre(s),
                reach[s],
                [&](const label image)
                {
                    meetFrom(w, state_.centre(s) + period.shift(image));
                }
            );
        }
    }
}


void Foam::dem::freeFlight::agree()
{
    const rankGroup& group = state_.group();
    const scalar first = group.min(time_);
    if (first < time_)
    {
        time_ = first;
        body_ = -1;
    }
    landing_ = group.min(landing_);
    nLooked_ = group.sum(nLooked_);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::freeFlight::freeFlight
(
    const packedBodies& state,
    const wallSet& walls,
    const periodicity& period,
    const scalar horizon,
    const scalar begin,
    const scalar reach
)
:
    state_(state),
    horizon_(min(min(horizon, state.paths(paths_)), walls.untilAppears())),
    begin_(begin),
    reach_(reach)
{
    if (period.active())
    {
        // No image but the next may come near
        const scalar way = 0.25*period.width();
        for (const packedBodies::path& p : paths_)
        {
            horizon_ =
                min(horizon_, firstRoot(way, mag(p.v), mag(p.a) + p.bend));
        }
    }
    horizon_ = state.group().min(horizon_);
    time_ = landing_ = horizon_;
    meetSpheres(period);
    meetWalls(walls, period);
    agree();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dem::freeFlight::step() const
{
    // The rest of a long flight is half of the step that ends in contact
    const scalar within = landing_ - time_;
    return
        time_ >= horizon_ ? horizon_
      : time_ > begin_ ? time_ - 0.5*min(within, begin_)
      : min(landing_, begin_);
}


// ************************************************************************* //
