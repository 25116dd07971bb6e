/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    Kicks under drag of several spheres at once, with each set of instructions:
    against the same one by one.

\*---------------------------------------------------------------------------*/

#include "figure.H"
#include "fluidDrag.H"
#include "instructionSets.H"
#include "packedBodies.H"
#include "shape.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace styxTest;
using namespace Foam::dem;
using Foam::label;
using Foam::scalar;
using Foam::vector;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- A number between -1 and 1 for each k
scalar numberOf(const label k)
{
    const scalar x = std::sin(12.9898*(k + 1))*43758.5453;
    return 2*(x - std::floor(x)) - 1;
}


vector vectorOf(const label k)
{
    return vector(numberOf(3*k), numberOf(3*k + 1), numberOf(3*k + 2));
}


//- Drag that grows with the slip, in a fluid that moves everywhere else in
//  another way
class manyDrag
:
    public fluidDrag
{
    Foam::List<vector> u_;

public:

    explicit manyDrag(const bodies& state)
    :
        u_(state.size())
    {
        const label n = state.size();
        forAll(u_, b)
        {
            u_[b] = vectorOf(1000 + b);
        }
        startExpansion(n);

        // Around a slip that every fourth body has no more
        for (label b = 0; b < n; ++b)
        {
            const scalar s =
                (b % 4 ? 1 + 0.03*numberOf(b) : 1.3)*mag(u_[b] - state.v[b]);
            expand
            (
                b, u_[b], massShare(b), s, rate(b, s),
                rate(b, (1 - width)*s), rate(b, (1 + width)*s)
            );
        }
    }

    virtual const vector& fluidVelocity(const label b) const
    {
        return u_[b];
    }

    virtual scalar rate(const label b, const scalar slip) const
    {
        return (1 + 0.1*b)*(1 + 0.15*std::pow(300*slip, 0.687));
    }

    virtual scalar massShare(const label b) const
    {
        return 1/(1 + 0.01*b);
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(dragLanes, asOneByOne)
{
    // No number of lanes divides it, and it is more than are looked at at once
    const label n = 579;
    Foam::PtrList<shape> shapes(1);
    shapes.set(0, new shape(shape::sphere("ball", 0.01)));
    bodies state(shapes);
    for (label b = 0; b < n; ++b)
    {
        newBody body;
        body.shapeI = 0;
        body.materialI = 0;
        body.density = 1000;
        body.position = vector(0.02*b, 0, 0);
        body.velocity = vectorOf(b);
        state.append(body);
        state.fluidForce.set(b, 2*state.mass[b]*vectorOf(5000 + b));
    }
    const manyDrag drag(state);
    state.drag = &drag;
    state.recordDrag = true;
    const vector g(0.1, -0.2, -9.81);
    const scalar dt = 4e-6, h = 0.5*dt;

    label quick = 0;
    for (label b = 0; b < n; ++b)
    {
        quick += b % 4 != 0;
    }
    figure("dragLanes_quick", scalar(quick)/n, 0.7, 0.8, "of the bodies",
        "own");

    const std::pair<const char*, const sweepSet*> sets[] =
    {
        {"sse2", &sweepSse2}, {"avx2", &sweepAvx2}, {"avx512", &sweepAvx512}
    };
    for (const auto& set : sets)
    {
        if (!processorHas(set.first))
        {
            continue;
        }
        packedBodies packed;
        packed.setInstructions(*set.second);
        packed.meterDrag();
        packed.pack(state, g);
        packed.leap(dt, false);

        scalar worst = 0, worstGiven = 0, work = 0, mostWork = 0;
        vector impulse = Foam::Zero;
        scalar mostImpulse = 0;
        for (label b = 0; b < n; ++b)
        {
            const scalar m = state.mass[b];
            const vector v = state.v[b];
            const vector held = state.fluidForce[b]/m;
            const vector kick = drag.kick(b, v, g + held, h);
            const vector given = kick - h*(g + held);
            worst = Foam::max(worst, mag(packed.velocity(b) - v - kick));
            worstGiven =
                Foam::max(worstGiven, mag(packed.given().given[b] - given));
            impulse += m*given;
            mostImpulse += m*mag(given);
            const scalar done = 0.5*m*(kick & (2*v + kick));
            work += done;
            mostWork += std::abs(done);
        }
        const std::string name = std::string("dragLanes_") + set.first;
        figure(name + "_velocity", worst, -noBar, 1e-15, "m/s", "one by one");
        figure(name + "_given", worstGiven, -noBar, 1e-15, "m/s",
            "one by one");
        figure
        (
            name + "_impulse",
            mag(packed.given().impulse - impulse)/mostImpulse,
            -noBar, 1e-13, "of all", "one by one"
        );
        figure
        (
            name + "_work",
            std::abs(packed.given().work - work)/mostWork,
            -noBar, 1e-13, "of all", "change of energy"
        );
    }
}

// ************************************************************************* //
