/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "bodyCells.H"
#include "Map.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::coupling::bodyCells::look
(
    const point& x,
    const label b,
    const label near
)
{
    // One that has moved a little is still in its cell as a rule
    label c = near;
    scalar depth = bins_.depth(x, c);
    if (!(depth > 0))
    {
        c = bins_.find(x, near);
        depth = c != near ? bins_.depth(x, c) : -1;
    }
    cell_[b] = c;
    if (!keepsPlaces_)
    {
        return;
    }
    const vector at(x - corner_);
    x_[b] = FixedList<float, 3>{float(at.x()), float(at.y()), float(at.z())};

    // What rounding moves it by is not safe
    depth -= 2e-7*(mag(at) + depth);
    safe_[b] = depth > 0 ? float(sqr(depth)) : -1;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::bodyCells::bodyCells
(
    const cellBins& bins,
    const bool keepsPlaces
)
:
    bins_(bins),
    keepsPlaces_(keepsPlaces),
    corner_(bins.mesh().bounds().min())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::labelList& Foam::coupling::bodyCells::find
(
    const dem::bodies& state
)
{
    const bool known = id_ == state.id && version_ == bins_.version();
    version_ = bins_.version();
    if (known && still_)
    {
        return cell_;
    }
    if (known)
    {
        forAll(state.x, b)
        {
            if (!keepsPlaces_ || mayHaveLeft(b, state.x[b]))
            {
                look(state.x[b], b, cell_[b]);
            }
        }
        return cell_;
    }

    labelList near(cell_);
    if (id_ != state.id)
    {
        // Bodies have entered or left
        Map<label> was(2*id_.size());
        forAll(id_, b)
        {
            was.insert(id_[b], cell_[b]);
        }
        id_ = state.id;
        near.setSize(id_.size());
        forAll(id_, b)
        {
            near[b] = was.lookup(id_[b], -1);
        }
    }

    cell_.setSize(id_.size());
    x_.setSize(keepsPlaces_ ? id_.size() : 0);
    safe_.setSize(x_.size());
    forAll(state.x, b)
    {
        look(state.x[b], b, near[b]);
    }
    return cell_;
}


// ************************************************************************* //
