/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "immersedMethod.H"
#include "rankMail.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::coupling::immersedMethod::findPresent()
{
    const dem::bodies& own = dem_.state();
    const scalar cell = dem_.group().max(bins_.maxRadius());
    present_.find
    (
        [&](const label b)
        {
            // Cells beside those that it covers count, too
            return own.shapeOf(b).fluidRadius() + 4*cell;
        }
    );
    if (!dem_.group().shared())
    {
        return;
    }

    // Guests bring what was imposed, if that is known
    const dem::bodies& state = present_();
    List<imposedMotion> before(state.size(), imposedMotion());
    List<scalar> known(state.size(), scalar(0));
    forAll(own.x, b)
    {
        if (imposed0_.found(own.id[b]))
        {
            known[b] = 1;
            before[b] = imposed0_[own.id[b]];
        }
    }
    present_.tell(known);
    present_.tell(before);
    for (label b = own.size(); b < state.size(); ++b)
    {
        imposed0_.erase(state.id[b]);
        if (known[b] > 0)
        {
            imposed0_.insert(state.id[b], before[b]);
        }
    }
}


void Foam::coupling::immersedMethod::startImposed(const volVectorField& U)
{
    const dem::bodies& state = present_();

    List<vector> momentum(state.size(), vector(Zero));
    List<scalar> volume(state.size(), scalar(0));
    bool anyNew = false;
    starts_.setSize(state.size());
    starts_ = false;

    forAll(cells_, b)
    {
        if (imposed0_.found(state.id[b]) || !kinds_.resolved(b))
        {
            continue;
        }
        anyNew = true;
        starts_[b] = true;
        for (const bodyCell& bc : cells_[b])
        {
            const scalar V = bc.beta*mesh_.V()[bc.cell];
            volume[b] += V;
            momentum[b] += V*U[bc.cell];
        }
    }

    if (!dem_.group().any(anyNew))
    {
        return;
    }

    // The fluid that a body finds where it enters has its own momentum, and
    // that is not the body's to pay for
    present_.sum(momentum);
    present_.sum(volume);
    forAll(cells_, b)
    {
        if (!imposed0_.found(state.id[b]) && kinds_.resolved(b))
        {
            imposed0_.insert
            (
                state.id[b],
                imposedMotion
                {
                    momentum[b]/max(volume[b], VSMALL),
                    Zero
                }
            );
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::coupling::carriedMotion
Foam::coupling::immersedMethod::carriedOf(const label b) const
{
    const dem::bodies& state = dem_.state();
    carriedMotion c{{state.v[b], state.omega[b]}, Zero, Zero};
    c.force = state.drag == &along_ ? held_[b] : state.fluidForce[b];
    c.torque = state.fluidTorque[b];

    if (open_)
    {
        c.imposed = imposed_[b];
        if (newForce_.size() && kinds_.resolved(b))
        {
            c.force = newForce_[b];
            c.torque = newTorque_[b];
        }
    }
    else if (imposed0_.found(state.id[b]))
    {
        c.imposed = imposed0_[state.id[b]];
    }
    return c;
}


void Foam::coupling::immersedMethod::setCarried
(
    const label b,
    const carriedMotion& c
)
{
    dem::bodies& state = dem_.state();
    if (kinds_.resolved(b))
    {
        imposed0_.set(state.id[b], c.imposed);
    }
    state.fluidForce[b] = c.force;
    state.fluidTorque[b] = c.torque;
}


void Foam::coupling::immersedMethod::finish()
{
    if (!open_)
    {
        return;
    }

    // Only of the bodies that are still there
    imposed0_.clear();
    for (label b = 0; b < dem_.state().size(); ++b)
    {
        if (kinds_.resolved(b))
        {
            setCarried(b, carriedOf(b));
        }
    }
    open_ = false;
}


void Foam::coupling::immersedMethod::moveMemory()
{
    struct carried
    {
        label id;
        imposedMotion motion;
    };
    const List<DynamicList<label>> moved(dem_.moved());
    if (moved.empty())
    {
        return;
    }
    List<DynamicList<carried>> out(moved.size());
    forAll(moved, rank)
    {
        for (const label id : moved[rank])
        {
            if (imposed0_.found(id))
            {
                out[rank].append({id, imposed0_[id]});
            }
        }
    }
    for (const List<carried>& in : dem::swapRecords(out))
    {
        for (const carried& c : in)
        {
            imposed0_.set(c.id, c.motion);
        }
    }
}


// ************************************************************************* //
