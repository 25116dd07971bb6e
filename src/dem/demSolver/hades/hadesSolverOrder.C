/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "hadesSolver.H"
#include "spatialOrder.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::hadesSolver::take(const labelUList& from)
{
    const labelList formerFirst(state_.firstSphere.list());
    state_.take(from);
    const labelList newSphere(state_.sphereMap(formerFirst, from));
    list_.renumber(newSphere);
    walls_.renumber(newSphere);
    if (sleepers_.valid())
    {
        sleepers_->setSize(formerFirst.size() - 1);
        sleepers_->take(from);
    }
    if (impulse_.valid())
    {
        impulse_->restart();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::dem::hadesSolver::order()
{
    if
    (
        !input_.mayReorder || exchange_.valid()
     || state_.nSpheres() < spatialOrder::few
    )
    {
        return false;
    }

    // To sort takes about as long as a step
    constexpr scalar most = 0.1;
    const spatialOrder space(state_.meanRadius());
    if (!saved_ && space.disorder(state_.x) < most)
    {
        return false;
    }
    if (areMany(state_.nSpheres()))
    {
        // The next advance makes these anew
        packed_.free(false);
        state_.force.forget();
        state_.torque.forget();
    }
    take(space.order(state_.x, state_.id));
    saved_ = false;
    return true;
}


void Foam::dem::hadesSolver::remove(const boolList& marked)
{
    if (exchange_.valid())
    {
        state_.remove(marked);
        exchange_->setChanged();
        return;
    }
    take(bodies::unmarked(marked));
}


// ************************************************************************* //
