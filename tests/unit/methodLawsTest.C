/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    The force that pisoIB and fictitiousDomain give a cell, in a cell without
    neighbours: A (U - U0) = f, with A >= 1/dt the diagonal of the momentum
    equation. What implicitForcing does there is A (U - U0) = K (U_t - U) + f_w,
    in closed form.

\*---------------------------------------------------------------------------*/

#include "fictitiousDomain.H"
#include "figure.H"
#include "pisoIB.H"

#include <cmath>

using namespace Foam;
using namespace styxTest;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const scalar dt = 0.01;
const scalar alpha = 0.9;
const vector U0(0.3, -0.1, 0.02);

//- A cell whose rate is k/dt
coupling::bodyCell cellOf(const scalar k)
{
    coupling::bodyCell law{0, 0.5, Zero};
    law.K = k/dt;
    law.target = vector(1, 0.5, -0.2);
    law.push = vector(0.7, -0.4, 0.1);
    return law;
}


//- Force of implicitForcing
vector implicitForce(const coupling::bodyCell& law, const scalar A)
{
    const vector U = (A*U0 + law.K*law.target + law.push)/(A + law.K);
    return A*(U - U0);
}

} // End anonymous namespace


namespace
{

//- The motion scheme step by step for a body in a fluid without friction, the
//  fluid's answer by what the projections leave: does a first error die away?
bool diesAway
(
    const scalar ratio,
    const scalar k,
    const scalar C,
    const label projections
)
{
    const scalar q = k/(1 + k);
    scalar v = 0, vOld = 0, Ub = 1, UbOld = 0, lack = 0;
    for (label step = 0; step < 20000; ++step)
    {
        // Imposed and projected so often; the impulse on the fluid inside
        scalar impulse = 0;
        lack += Ub - UbOld;
        for (label n = 0; n < projections; ++n)
        {
            impulse += lack;
            lack *= q;
        }
        vOld = v;
        v += (-impulse + (1 + C*k)*(Ub - UbOld))/(ratio + C*k);
        UbOld = Ub;
        Ub = 2*v - vOld;
        if (mag(v) > 1e6)
        {
            return false;
        }
    }
    return mag(v - vOld) < 1e-3;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(methodLaws, pisoIBComesToImplicitForcing)
{
    scalar worst = 0;
    scalar rate = 0;
    for (const scalar k : {0.1, 1.0, 1000.0})
    {
        for (const scalar a : {1.0, 3.0, 20.0})
        {
            const scalar A = a/dt;
            const coupling::bodyCell law = cellOf(k);
            const vector right = implicitForce(law, A);

            // By which a corrector multiplies the error, and never below 0
            const scalar factor = 1 - alpha*(1 + k/a)/(1 + k);
            EXPECT_GE(factor, 1 - alpha - SMALL);

            vector f = Zero;
            for (label n = 0; n < 2000; ++n)
            {
                const scalar before = mag(f - right);
                f = coupling::pisoIB::next(law, f, U0 + f/A, alpha, dt);
                if (before > 1e-3*mag(right))
                {
                    rate = max(rate, mag(mag(f - right)/before - factor));
                }
            }
            worst = max(worst, mag(f - right)/mag(right));
        }
    }
    figure
    (
        "pisoIB_converged", worst, -noBar, 1e-10, "-",
        "force of implicitForcing in closed form"
    );
    figure
    (
        "pisoIB_rate", rate, -noBar, 1e-10, "-",
        "1 - alpha (1 + K/A)/(1 + K dt) a corrector"
    );
}


TEST(methodLaws, pisoIBInsideIsTheThesisEquation)
{
    // K dt = 1000: f + alpha/dt (U_b - U), less the thousandth
    const coupling::bodyCell law = cellOf(1000);
    const vector f(20, -3, 1);
    const vector step =
        coupling::pisoIB::next(law, f, U0, alpha, dt) - f;
    const vector thesis = alpha/dt*(law.target - U0);
    figure
    (
        "pisoIB_inside", mag(step - thesis)/mag(thesis), -noBar, 2e-3, "-",
        "thesis 3.21"
    );
}


TEST(methodLaws, fictitiousDomainWithoutDiffusion)
{
    // The step that knows nothing of the bodies has A = 1/dt
    scalar worst = 0;
    for (const scalar k : {0.1, 1.0, 1000.0})
    {
        const coupling::bodyCell law = cellOf(k);
        const vector right = implicitForce(law, 1/dt);
        worst = max
        (
            worst,
            mag(coupling::fictitiousDomain::force(law, U0, dt) - right)
           /mag(right)
        );
    }
    figure
    (
        "fictitiousDomain_force", worst, -noBar, 1e-12, "-",
        "force of implicitForcing in closed form"
    );
}


TEST(methodLaws, fictitiousDomainKnowsWhatSwings)
{
    label wrong = 0, swing = 0;
    for (const scalar ratio : {0.01, 0.1, 0.5, 0.6, 1.0, 2.0, 7.8})
    {
        for (const scalar k : {0.2, 0.5, 1.1, 3.0, 6.1, 12.7})
        {
            for (const label n : {1, 2, 3, 5, 10, 20})
            {
                const bool dies = diesAway(ratio, k, 1.5, n);
                wrong +=
                    coupling::fictitiousDomain::stable(ratio, k, 1.5, n)
                 != dies;
                swing += !dies;
            }
        }
    }
    EXPECT_GT(swing, 50);
    figure
    (
        "fictitiousDomain_stable", wrong, 0, 0, "of 252",
        "the scheme step by step"
    );
}


// ************************************************************************* //
