/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "movingWall.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::movingWall::movingWall
(
    autoPtr<wall> surface,
    const dictionary& dict
)
:
    wall(surface->name(), surface->materialI()),
    surface_(surface.ptr()),
    open_(getFinite(dict, "open", GREAT)),
    close_(getFinite(dict, "close", GREAT)),
    speed_(0)
{
    if (dict.found("motion"))
    {
        motion_ = wallMotion::New(dict.subDict("motion"));
        speed_ = motion_->speed(surface_());
        if (!(speed_ < GREAT))
        {
            badEntry
            (
                dict,
                "motion",
                "turns a wall that does not end, whose points would have any"
                " velocity: take a rectangle or a cylinder along the axis"
            );
        }
    }
    if (dict.found("open") && dict.found("close") && open_ == close_)
    {
        badEntry(dict, "close", "is the time at which the wall opens");
    }
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dem::wall> Foam::dem::movingWall::New
(
    autoPtr<wall> surface,
    const dictionary& dict
)
{
    if (dict.found("motion") || dict.found("open") || dict.found("close"))
    {
        return autoPtr<wall>(new movingWall(std::move(surface), dict));
    }
    return surface;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::movingWall::candidates
(
    const point& c,
    const scalar reach,
    DynamicList<label>& elements
) const
{
    if (present_)
    {
        surface_->candidates(atStart(c), reach, elements);
    }
}


Foam::scalar Foam::dem::movingWall::nearest
(
    const point& c,
    const label element,
    point& p,
    vector& n
) const
{
    const scalar d = surface_->nearest(atStart(c), element, p, n);
    p = (now_.R & p) + now_.d;
    n = now_.R & n;
    return d;
}


void Foam::dem::movingWall::beginAdvance(const scalar t0, const scalar t1)
{
    speed_ = motion_.valid() ? motion_->speed(surface_(), t0, t1) : 0;
}


void Foam::dem::movingWall::moveTo(const scalar t)
{
    if (motion_.valid())
    {
        now_ = motion_->at(t);
    }

    // What comes first is no end of the other
    present_ =
        open_ < close_
      ? t < open_ || t >= close_
      : t < open_ && (t >= close_ || close_ == GREAT);
}


// ************************************************************************* //
