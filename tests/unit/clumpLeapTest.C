/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    The leap of many clumps, with each set of instructions: against the same
    one by one.

\*---------------------------------------------------------------------------*/

#include "figure.H"
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

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(clumpLeap, asOneByOne)
{
    Foam::PtrList<shape> shapes(1);
    Foam::List<shape::sphereData> spheres(3);
    spheres[0] = shape::sphereData(Foam::point(0, 0, 0), 0.01);
    spheres[1] = shape::sphereData(Foam::point(0.008, 0.002, 0), 0.007);
    spheres[2] = shape::sphereData(Foam::point(-0.003, 0.006, 0.004), 0.005);
    shapes.set(0, new shape("three", spheres));

    // No number of lanes divides it, and it is more than are moved at once
    const label n = 77;
    const auto append = [&](bodies& state, const label b)
    {
        newBody body;
        body.shapeI = 0;
        body.materialI = 0;
        body.density = 1000;
        body.position = vector(0.05*b, 0, 0);
        body.velocity = vector(std::sin(b), std::cos(2*b), 0.01*b);
        body.angularVelocity = vector(0.3*b, 20 - 0.5*b, 5*std::sin(3*b));
        const vector axis(1, std::cos(b), std::sin(b));
        body.orientation = Foam::quaternion(axis/mag(axis), 0.7*b);
        state.append(body);
    };
    const vector g(0.1, -0.2, -9.81);
    const scalar dt = 1e-3;
    bodies all(shapes);
    for (label b = 0; b < n; ++b)
    {
        append(all, b);
    }
    all.update();

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
        packedBodies together;
        together.setInstructions(*set.second);
        together.pack(all, g);
        together.leap(dt, false);

        scalar worst = 0, least = 1, speed = 0;
        for (label b = 0; b < n; ++b)
        {
            bodies one(shapes);
            append(one, b);
            one.update();
            packedBodies alone;
            alone.setInstructions(*set.second);
            alone.pack(one, g);
            alone.leap(dt, false);
            worst = Foam::max
            (
                worst, mag(together.position(b) - alone.position(0))
            );
            for (label s = 0; s < 3; ++s)
            {
                worst = Foam::max
                (
                    worst, mag(together.centre(3*b + s) - alone.centre(s))
                );
            }
            least = Foam::min
            (
                least, mag(together.position(b) - all.x[b])/dt
            );
            speed = Foam::max(speed, alone.bounds().speed);
        }
        const std::string name = std::string("clumpLeap_") + set.first;
        figure(name, worst, -noBar, 1e-15, "m", "one by one");
        figure(name + "_least", least, 0.1, noBar, "m/s", "all move");
        figureNear
        (
            name + "_speed", together.bounds().speed, speed, 1e-14, "m/s",
            "the fastest of them"
        );
    }
}

// ************************************************************************* //
