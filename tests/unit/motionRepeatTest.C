/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    Aitken's relaxation of a motion that answers in proportion: what follows
    from w is c + s (w - c), with c the solution.

\*---------------------------------------------------------------------------*/

#include "figure.H"
#include "motionRepeat.H"

using namespace Foam;
using namespace styxTest;

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

const vector solution(1, -2, 0.5);

//- What is left of the distance to the solution after n steps, of a body that
//  answers by the factors s along x, y, z
scalar left(const vector& s, const label n)
{
    coupling::motionRepeat::relaxed relaxed;
    vector w(Zero);
    for (label k = 0; k < n; ++k)
    {
        const vector follows =
            solution + cmptMultiply(s, w - solution);
        w += relaxed.step(follows - w, k == 0);
    }
    return mag(w - solution)/mag(solution);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(motionRepeat, oneFactor)
{
    // By the secant through two points: exact in the second step, however the
    // body answers; without relaxation the first three would go away from it
    for (const scalar s : {-9.0, -2.0, -1.0, -0.5, 0.3, 0.9})
    {
        figure
        (
            "motionRepeat_factor" + std::to_string(s),
            left(s*vector::one, 2),
            0,
            1e-12,
            "-",
            "exact for one factor"
        );
    }
}


TEST(motionRepeat, threeFactors)
{
    figure
    (
        "motionRepeat_threeFactors",
        left(vector(-2, -0.5, 0.1), 8),
        0,
        0.02,
        "-",
        "0.5^8 of the direction that converges by itself is 0.004"
    );
}


TEST(motionRepeat, beginsAnew)
{
    coupling::motionRepeat::relaxed relaxed;
    relaxed.step(vector(1, 0, 0), true);
    relaxed.step(vector(0.5, 0, 0), false);
    figure
    (
        "motionRepeat_factorOfSecant",
        relaxed.factor(),
        2 - 1e-12,
        2 + 1e-12,
        "-",
        "-1 (1)(-0.5)/0.25"
    );
    relaxed.step(vector(3, 0, 0), true);
    figure
    (
        "motionRepeat_factorOfNewStep",
        relaxed.factor(),
        1 - 1e-12,
        1 + 1e-12,
        "-",
        "the first of a step is not relaxed"
    );
}


// ************************************************************************* //
