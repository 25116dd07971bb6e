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

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::labelList& Foam::coupling::bodyCells::find
(
    const dem::bodies& state
)
{
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
    forAll(state.x, b)
    {
        cell_[b] = bins_.find(state.x[b], near[b]);
    }
    return cell_;
}


// ************************************************************************* //
