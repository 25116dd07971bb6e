/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    Copies of bodies of other ranks, without ranks: a body moves where it is
    owned, and its copy is where the body is, to the last bit.

\*---------------------------------------------------------------------------*/

#include "demCase.H"

#include "packedBodies.H"

using namespace styxTest;
using namespace Foam::dem;
using Foam::mag;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

Foam::PtrList<shape> ballAndRod()
{
    Foam::PtrList<shape> list(2);
    list.set(0, new shape(shape::sphere("ball", 0.01)));
    Foam::List<shape::sphereData> rod(3);
    for (label i = 0; i < 3; ++i)
    {
        rod[i] = shape::sphereData(point(0.004*i, 0, 0), 0.003 + 0.001*i);
    }
    list.set(1, new shape("rod", rod));
    return list;
}


//- Ball, rod, ball, rod with velocities, spins and forces of the fluid
void fill(bodies& state)
{
    for (label i = 0; i < 4; ++i)
    {
        newBody b;
        b.shapeI = i % 2;
        b.materialI = 0;
        b.density = 2500;
        b.position = vector(0.03*i, 0.01, -0.02);
        b.velocity = vector(0.3, -0.1*i, 0.7);
        b.angularVelocity = vector(5, 30*i, -11);
        state.append(b);
        state.fluidForce[i] = vector(1e-3*i, 2e-3, -1e-3);
        state.fluidTorque[i] = vector(1e-6, -2e-6*i, 3e-6);
    }
}


//- A rank that has some of the bodies and owns some of these
struct rank
{
    bodies state;
    packedBodies packed;

    rank
    (
        const bodies& all,
        const Foam::labelList& own,
        const Foam::labelList& copies
    )
    :
        state(all.shapes())
    {
        take(all, own, copies);
        packed.pack(state, gravity);
    }

    void take
    (
        const bodies& all,
        const Foam::labelList& own,
        const Foam::labelList& copies
    )
    {
        state.clear();
        Foam::DynamicList<bodyRecord> records;
        Foam::DynamicList<bool> isCopy;
        for (label id = 0; id < all.size(); ++id)
        {
            if (own.found(id) || copies.found(id))
            {
                bodyRecord r = all.record(id);
                if (copies.found(id))
                {
                    r.fluidForce = r.fluidTorque = Foam::Zero;
                }
                records.append(r);
                isCopy.append(copies.found(id));
            }
        }
        state.take(Foam::identity(records.size()), records);
        state.isCopy = isCopy;
    }

    //- Send what the other has a copy of
    void send(rank& to) const
    {
        for (label b = 0; b < to.state.size(); ++b)
        {
            const label mine = state.find(to.state.id[b]);
            if (to.state.isCopy[b] && mine >= 0 && state.owns(mine))
            {
                std::vector<scalar> message(packed.nShared(mine));
                packed.share(mine, message.data());
                to.packed.receive(b, message.data());
            }
        }
    }

    //- How far its spheres are from where they are on one rank
    scalar off(const bodies& all, const packedBodies& whole) const
    {
        scalar most = 0;
        for (label b = 0; b < state.size(); ++b)
        {
            const label first = all.firstSphere[state.id[b]];
            const label begin = state.firstSphere[b];
            for (label s = begin; s < state.firstSphere[b + 1]; ++s)
            {
                const label t = first + s - begin;
                most = Foam::max
                (
                    most,
                    mag(packed.centre(s) - whole.centre(t))
                  + mag(packed.speed(s) - whole.speed(t))
                  + mag(packed.radius(s) - whole.radius(t))
                );
            }
        }
        return most;
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(demRanks, copies)
{
    const Foam::PtrList<shape> forms(ballAndRod());
    bodies all(forms);
    fill(all);
    packedBodies whole;
    whole.pack(all, gravity);

    rank a(all, {0, 3}, {1});
    rank b(all, {1, 2}, {0, 3});
    scalar off = 0;
    for (label step = 0; step < 20; ++step)
    {
        const bool trial = step % 3 != 0;
        const scalar dt = 1e-3*(1 + step % 4);
        for (packedBodies* p : {&whole, &a.packed, &b.packed})
        {
            p->leap(dt, trial);
        }
        a.send(b);
        b.send(a);

        // One copy goes and another comes, in the middle of the step
        if (step % 5 == 1)
        {
            const bool first = step % 2;
            const Foam::labelList former(a.state.id);
            rank arranged(all, {0, 3}, {first ? label(2) : label(1)});
            Foam::labelList source(arranged.state.size());
            forAll(source, k)
            {
                source[k] = former.find(arranged.state.id[k]);
            }
            a.take(all, {0, 3}, {first ? label(2) : label(1)});
            a.packed.rearrange(a.state, source);
            b.send(a);
            forAll(source, k)
            {
                if (source[k] < 0)
                {
                    a.packed.settle(k);
                }
            }
        }
        off = Foam::max(off, a.off(all, whole));
        off = Foam::max(off, b.off(all, whole));

        if (trial && step % 2)
        {
            for (packedBodies* p : {&whole, &a.packed, &b.packed})
            {
                p->undo();
            }
        }
    }
    figure("ranks_copies", off, 0, 0, "SI", "the same bodies on one rank");
}


TEST(demRanks, bounds)
{
    const Foam::PtrList<shape> forms(ballAndRod());
    bodies all(forms);
    fill(all);
    packedBodies whole;
    whole.pack(all, gravity);
    rank a(all, {0, 3}, {1});
    rank b(all, {1, 2}, {0, 3});

    Foam::List<scalar> most(packedBodies::nBounds, scalar(0)), part(most);
    for (packedBodies* p : {&whole, &a.packed, &b.packed})
    {
        p->leap(1e-3, false);
    }
    for (const packedBodies* p : {&a.packed, &b.packed})
    {
        p->putBounds(part);
        forAll(most, i)
        {
            most[i] = Foam::max(most[i], part[i]);
        }
    }
    a.packed.setBounds(most);
    const packedBodies::motion& m = a.packed.bounds();
    const packedBodies::motion& n = whole.bounds();
    figure
    (
        "ranks_bounds",
        mag(m.speed - n.speed) + mag(m.turning - n.turning)
      + mag(m.acceleration - n.acceleration),
        0,
        0,
        "SI",
        "bounds of a leap, one rank"
    );
}


TEST(demRanks, record)
{
    const Foam::PtrList<shape> forms(ballAndRod());
    bodies all(forms), part(forms);
    fill(all);
    const Foam::List<bodyRecord> records({all.record(1), all.record(3)});
    part.take(Foam::labelList({0, 1}), records);
    EXPECT_EQ(part.find(0), -1);
    EXPECT_EQ(part.find(1), 0);
    EXPECT_EQ(part.find(3), 1);
    EXPECT_EQ(part.find(4), -1);
    EXPECT_EQ(part.nSpheres(), 6);
    EXPECT_TRUE(part.owns(0));
    scalar off = 0;
    for (label s = 0; s < 3; ++s)
    {
        off = Foam::max
        (
            off,
            mag(part.sphereX()[3 + s] - all.sphereX()[all.firstSphere[3] + s])
        );
    }
    figure("ranks_record", off, 0, 0, "m", "spheres of a body that was sent");
}


// ************************************************************************* //
