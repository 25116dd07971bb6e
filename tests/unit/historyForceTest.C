/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    Forces that remember: the kernel of Basset's force and its sum of
    exponentials, its integral over steps of any lengths, a sphere that settles
    with it, and turbulent dispersion against Taylor's closed form.

\*---------------------------------------------------------------------------*/

#include "demCase.H"

#include "basset.H"
#include "dispersion.H"
#include "fluidDrag.H"
#include "mathematicalConstants.H"
#include "virtualMass.H"

#include <cmath>
#include <vector>

using namespace styxTest;
using namespace Foam;
using namespace Foam::coupling;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const scalar pi = constant::mathematical::pi;


//- Drag and added mass of one sphere of diameter 1 in a fluid of rho = nu = 1
class settlingDrag
:
    public dem::fluidDrag
{
    const vector u_ = Zero;

public:

    scalar mass = 1, inertia = 1;

    virtual const vector& fluidVelocity(const label) const
    {
        return u_;
    }

    virtual scalar rate(const label, const scalar) const
    {
        return 3*pi/inertia;
    }

    virtual scalar massShare(const label) const
    {
        return mass/inertia;
    }
};


//- Velocities of a sphere that settles from rest, over the terminal one, at
//  times s in units of tau = d^2 (ratio + 1/2)/(18 nu)
std::vector<scalar> settle
(
    const scalar ratio,
    const std::vector<scalar>& s,
    const scalar step,
    const std::string& memory
)
{
    const scalar V = pi/6;
    const scalar tau = (ratio + 0.5)/18;
    const vector g(0, 0, ratio > 1 ? -1 : 1);
    const scalar terminal = std::abs(ratio - 1)*V/(3*pi);

    virtualMass vm(g, dictionaryOf(""));
    basset history
    (
        g,
        dictionaryOf
        (
            memory == "full" ? ""
          : "memory " + memory + "; window " + text(0.2*tau) + ";"
        )
    );
    settlingDrag drag;
    drag.mass = ratio*V;

    pointBody b{1, 1, V, Zero, Zero, 0, step*tau};
    fluidAtPoint fluid;
    fluid.rho = 1;
    fluid.nu = 1;

    std::vector<scalar> found;
    label n = 0;
    for (const scalar end : s)
    {
        for (; n < label(std::lround(end/step)); ++n)
        {
            b.t = n*b.dt;
            history.note(b, fluid);
            pointSum sum;
            vm.add(b, fluid, sum);
            history.add(b, fluid, sum);
            drag.inertia = drag.mass + sum.addedMass;

            // Buoyancy and weight
            const vector a = (sum.force + (ratio - 1)*V*g)/drag.mass;
            b.v += drag.kick(0, b.v, a, b.dt);
        }
        found.push_back(mag(b.v)/terminal);
    }
    return found;
}


const std::vector<scalar> times({0.1, 0.2, 0.5, 1, 2, 5, 10});

//- References 12, v/v_inf at these times
const struct
{
    scalar ratio;
    std::vector<scalar> v;
}
table[] =
{
    {0.5, {.06303, .10645, .19620, .28989, .40023, .55299, .65856}},
    {1.5, {.07013, .12149, .23065, .34483, .47454, .63794, .73728}},
    {7.8, {.08114, .14644, .29316, .44920, .61540, .78371, .85804}},
    {1000, {.09371, .17749, .38177, .60968, .83373, .97057, .98636}}
};


scalar worstSettling(const scalar step, const std::string& memory)
{
    scalar worst = 0;
    for (const auto& row : table)
    {
        const auto v = settle(row.ratio, times, step, memory);
        for (size_t k = 0; k < v.size(); ++k)
        {
            worst = std::max(worst, std::abs(v[k]/row.v[k] - 1));
        }
    }
    return worst;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(historyForces, kernel)
{
    const historyKernel kernel
    (
        dictionaryOf("memory exponentials; window 1e-3; longest 10;")
    );
    scalar worst = 0;
    for (scalar a = 1e-3; a <= 10; a *= 1.01)
    {
        worst = std::max(worst, std::abs(kernel.sum(a)*std::sqrt(a) - 1));
    }
    figure("basset_kernel", worst, -noBar, 3e-4, "-",
           "sum of exponentials against 1/sqrt(age), four decades");
    figure("basset_terms", kernel.rates().size(), 1, 30, "-",
           "exponentials for them");

    EXPECT_THROW
    (
        historyKernel(dictionaryOf("memory exponentials;")),
        Foam::IOerror
    );
    EXPECT_THROW(historyKernel(dictionaryOf("window 1;")), Foam::IOerror);
    EXPECT_THROW
    (
        historyKernel
        (
            dictionaryOf("memory exponentials; window 1; longest 0.1;")
        ),
        Foam::IOerror
    );
}


// A slip that starts at 2 and grows as 3 t: H = 2/sqrt(t) + 6 sqrt(t), in steps
// of any lengths
TEST(historyForces, integral)
{
    const historyKernel full(dictionaryOf(""));
    const historyKernel sums
    (
        dictionaryOf("memory exponentials; window 0.05;")
    );
    slipHistory exact, summed;
    scalar t = 0;
    for (label n = 0; n < 400; ++n)
    {
        const vector w(2 + 3*t, 0, 0);
        exact.append(t, w, Zero, full);
        summed.append(t, w, Zero, sums);
        t += n % 3 ? 0.002 : 0.007;
    }

    // The mean over the step that begins at the last record, T
    const scalar T = t - 0.007, h = 0.01;
    const auto primitive = [](const scalar x)
    {
        return 4*std::sqrt(x) + 4*std::pow(x, 1.5);
    };
    const scalar own = 4*std::sqrt(h);          // what the step itself adds
    const scalar H = (primitive(T + h) - primitive(T))/h - own;
    figureNear("basset_integral", exact.mean(h, full).x(), H, 1e-10,
               "m/s/sqrt(s)", "closed form, 400 steps of two lengths");
    figureNear("basset_integralSums", summed.mean(h, sums).x(), H, 3e-4,
               "m/s/sqrt(s)", "closed form, bounded memory");
    EXPECT_LT(summed.nRecords(), 20);
    EXPECT_EQ(exact.nRecords(), 400);

    // Saved, read again, gone on with
    DynamicList<vector> saved;
    summed.save(saved);
    slipHistory again;
    ASSERT_TRUE(again.load(saved, sums));
    for (slipHistory* s : {&summed, &again})
    {
        s->append(t, vector(1, 2, 3), vector(1, 0, 0), sums);
    }
    EXPECT_EQ(summed.mean(h, sums), again.mean(h, sums));
    EXPECT_EQ(summed.fluidRate(), again.fluidRate());
    EXPECT_FALSE(again.load(saved, full));
    saved.remove();
    EXPECT_FALSE(again.load(saved, sums));
}


TEST(historyForces, settling)
{
    figure("basset_settling", worstSettling(0.01, "full"), -noBar, 0.01, "-",
           "references 12, s 0.1 to 10, ratios 0.5 to 1000, steps of 0.01 tau");
    figure("basset_settlingSums", worstSettling(0.01, "exponentials"), -noBar,
           0.01, "-", "the same with bounded memory");
    const scalar coarse = worstSettling(0.1, "full");
    figure("basset_settlingCoarse", coarse, -noBar, 0.05, "-",
           "the same in steps of 0.1 tau");

    // What the bounded memories change, by itself
    scalar sums = 0, window = 0;
    for (const auto& row : table)
    {
        const auto full = settle(row.ratio, times, 0.02, "full");
        const auto bounded = settle(row.ratio, times, 0.02, "exponentials");
        const auto cut = settle(row.ratio, times, 0.02, "window");
        for (size_t k = 0; k < full.size(); ++k)
        {
            sums = std::max(sums, std::abs(bounded[k]/full[k] - 1));
            window = std::max(window, std::abs(cut[k]/full[k] - 1));
        }
    }
    figure("basset_sumsError", sums, -noBar, 1e-4, "-",
           "exponentials against full memory");
    figure("basset_windowError", window, 0.01, noBar, "-",
           "a window of 0.2 tau against full memory");
}


// The spread of fluid points in steady turbulence (Taylor):
// <x^2> = 2 sigma^2 T^2 (t/T - 1 + exp(-t/T))
TEST(historyForces, taylor)
{
    dispersion walk(Zero, dictionaryOf("coefficient 0.3;"));
    fluidAtPoint still;
    still.rho = 1;
    still.nu = 1;
    still.k = 1.5;
    still.epsilon = 4.5;

    // sigma = 1; the slip of a body that follows is u' itself
    const scalar T = 0.1, dt = 0.005;
    const label nBodies = 4000;
    scalar sum = 0, variance = 0;
    vector mean = Zero;
    for (label id = 0; id < nBodies; ++id)
    {
        pointBody b{id, 1, 1, Zero, Zero, 0, dt};
        vector x = Zero;
        for (label n = 0; n < 60; ++n)
        {
            fluidAtPoint f(still);
            walk.note(b, f);
            x += dt*f.u;
            if (n == 40)
            {
                variance += magSqr(f.u)/(3*nBodies);
                mean += f.u/nBodies;
            }
        }
        sum += magSqr(x)/(3*nBodies);
    }
    const scalar t = 60*dt;
    const scalar taylor = 2*T*T*(t/T - 1 + std::exp(-t/T));
    figureNear("dispersion_taylor", sum, taylor, 0.05, "m2",
               "Taylor 1921; 12,000 walks: standard error 1.3 %");
    figureNear("dispersion_variance", variance, 1, 0.05, "m2/s2", "2 k/3");
    EXPECT_LT(mag(mean), 0.06);

    // One that falls fast through the eddies
    pointBody fast{0, 1, 1, vector(0, 0, -std::sqrt(99.0)), Zero, 0, 0.01};
    scalar both = 0, square = 0;
    for (label id = 0; id < nBodies; ++id)
    {
        fast.id = nBodies + id;
        fluidAtPoint first(still), second(still);
        walk.note(fast, first);
        walk.note(fast, second);
        both += first.u.x()*second.u.x();
        square += sqr(first.u.x());
    }
    figure("dispersion_crossing", both/square, 0.32, 0.42, "-",
           "correlation after T = T_L/10: exp(-1) = 0.368");
}


// ************************************************************************* //
