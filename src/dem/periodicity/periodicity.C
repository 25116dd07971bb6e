/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "periodicity.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::periodicity::append(const seam& s)
{
    seams_.append(s);

    shifts_.setSize(27);
    for (label image = 0; image < 27; ++image)
    {
        shifts_[image] = shift
        (
            labelVector(image % 3 - 1, image/3 % 3 - 1, image/9 - 1)
        );
    }
}


bool Foam::dem::periodicity::fits(const seam& s) const
{
    const scalar small = 1e-6*s.width();
    for (const seam& other : seams_)
    {
        if
        (
            mag(s.separation & other.normal) > small
         || mag(other.separation & s.normal) > small
        )
        {
            return false;
        }
    }
    return seams_.size() < 3 && small > 0;
}


Foam::scalar Foam::dem::periodicity::width() const
{
    scalar w = GREAT;
    for (const seam& s : seams_)
    {
        w = min(w, s.width());
    }
    return w;
}


Foam::label Foam::dem::periodicity::moved
(
    const label image,
    const labelVector& m
)
{
    const labelVector sum
    (
        image % 3 - 1 + m.x(),
        image/3 % 3 - 1 + m.y(),
        image/9 - 1 + m.z()
    );
    for (direction k = 0; k < 3; ++k)
    {
        if (sum[k] < -1 || sum[k] > 1)
        {
            return -1;
        }
    }
    return (sum.x() + 1) + 3*(sum.y() + 1) + 9*(sum.z() + 1);
}


Foam::labelVector Foam::dem::periodicity::turns
(
    const point& p,
    const scalar slack
) const
{
    labelVector m(Zero);
    forAll(seams_, k)
    {
        const scalar h = seams_[k].height(p);
        const scalar w = seams_[k].width();
        if (h < -slack || h >= w + slack)
        {
            m[k] = -label(std::floor(h/w));
        }
    }
    return m;
}


Foam::vector Foam::dem::periodicity::shift(const labelVector& m) const
{
    vector way(Zero);
    forAll(seams_, k)
    {
        way += scalar(m[k])*seams_[k].separation;
    }
    return way;
}


Foam::scalar Foam::dem::periodicity::overhang
(
    const point& centre,
    const scalar radius
) const
{
    scalar out = 0;
    for (const seam& s : seams_)
    {
        const scalar h = s.height(centre);
        out = max(out, radius - min(h, s.width() - h));
    }
    return out;
}


// ************************************************************************* //
