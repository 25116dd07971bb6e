/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.


Description
    Drag on bodies that are points to the fluid: the law against its table,
    and its integration against closed forms, with steps far below and far
    above the relaxation time.

\*---------------------------------------------------------------------------*/

#include "demCase.H"

#include "dragLaw.H"
#include "fluidDrag.H"
#include "movedBodies.H"

#include <cmath>
#include <functional>

using namespace styxTest;
using namespace Foam::dem;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

Foam::autoPtr<Foam::coupling::dragLaw> law(const std::string& name)
{
    return Foam::coupling::dragLaw::New(dictionaryOf("drag " + name + ";"));
}


//- Drag of one body in a fluid of uniform velocity
class oneDrag
:
    public fluidDrag
{
    std::function<scalar(scalar)> rate_;

    vector u_;

public:

    oneDrag(const std::function<scalar(scalar)>& rate, const vector& u)
    :
        rate_(rate),
        u_(u)
    {}

    virtual const vector& fluidVelocity(const label) const
    {
        return u_;
    }

    virtual scalar rate(const label, const scalar slip) const
    {
        return rate_(slip);
    }
};


//- The same, expanded at a slip velocity
class nearDrag
:
    public oneDrag
{
public:

    nearDrag(const std::function<scalar(scalar)>& rate, const vector& u)
    :
        oneDrag(rate, u)
    {}

    void expandAt(const scalar s)
    {
        startExpansion(1);
        expand
        (
            0,
            fluidVelocity(0),
            1,
            s,
            rate(0, s),
            rate(0, (1 - width)*s),
            rate(0, (1 + width)*s)
        );
    }
};


//- A sphere that falls from rest in a fluid at rest by Schiller-Naumann, in
//  units of the relaxation time and such that Re is the slip velocity
class fallingSphere
{
    Foam::PtrList<shape> shapes_;

    bodies state_;

    Foam::autoPtr<Foam::coupling::dragLaw> law_;

    oneDrag drag_;

    Foam::autoPtr<integrator> method_;

    scalar g_;

    scalar t_ = 0;


    void setForce()
    {
        state_.force[0] = vector(0, 0, -g_*state_.mass[0]);
        state_.torque[0] = Foam::Zero;
    }

public:

    explicit fallingSphere(const scalar g)
    :
        shapes_(1),
        state_(shapes_),
        law_(law("schillerNaumann")),
        drag_
        (
            [this](const scalar slip) { return law_->factor(slip, 1); },
            Foam::Zero
        ),
        method_(integrator::New(Foam::dictionary())),
        g_(g)
    {
        shapes_.set(0, new shape(shape::sphere("ball", 1)));
        newBody n;
        n.shapeI = 0;
        n.materialI = 0;
        n.density = 1;
        n.position = Foam::Zero;
        state_.append(n);
        state_.drag = &drag_;
        setForce();
    }

    fallingSphere(const fallingSphere&) = delete;

    void step(const scalar dt)
    {
        moveBodies
        (
            *method_,
            state_,
            t_,
            dt,
            [this](const scalar, const scalar) { setForce(); }
        );
        t_ += dt;
    }

    //- Downwards
    scalar velocity() const
    {
        return -state_.v[0].z();
    }

    scalar way() const
    {
        return -state_.x[0].z();
    }

    //- Where drag and weight are the same, by bisection
    scalar terminal() const
    {
        scalar low = 0, high = g_;
        for (label i = 0; i < 200; ++i)
        {
            const scalar v = 0.5*(low + high);
            (law_->factor(v, 1)*v < g_ ? low : high) = v;
        }
        return low;
    }
};


//- Way after 2 relaxation times in n steps
scalar wayAfter(const scalar g, const label n)
{
    fallingSphere ball(g);
    for (label i = 0; i < n; ++i)
    {
        ball.step(2.0/n);
    }
    return ball.way();
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

// The table has four digits, three above Re = 100
TEST(dragLaws, schillerNaumann)
{
    const auto sn = law("schillerNaumann");
    const struct
    {
        scalar Re, Cd, tolerance;
    }
    table[] =
    {
        {0.1, 247.40, 1e-4}, {1, 27.60, 1e-4}, {10, 4.151, 2e-4},
        {20, 2.610, 3e-4}, {50, 1.538, 5e-4}, {100, 1.092, 5e-4},
        {300, 0.684, 1e-3}, {1000, 0.438, 1.2e-3}, {1e5, 0.44, 1e-12}
    };

    scalar worst = 0;
    for (const auto& row : table)
    {
        const scalar off = std::abs(sn->Cd(row.Re, 1)/row.Cd - 1);
        EXPECT_LT(off, row.tolerance) << "Re " << row.Re;
        worst = std::max(worst, off);
    }
    figure("schillerNaumann_table", worst, -noBar, 1.2e-3, "of Cd",
           "references 9, Re 0.1 to 1e5");
    EXPECT_DOUBLE_EQ(sn->factor(0, 1), 1);
}


// A law that is not there
TEST(dragLaws, unknown)
{
    EXPECT_THROW(law("schilerNaumann"), Foam::IOerror);
    EXPECT_FALSE(law("none").valid());
    EXPECT_FALSE
    (
        Foam::coupling::dragLaw::New(Foam::dictionary()).valid()
    );
}


// An added mass: a body without weight of its own in a fluid falls up with 2 g
// and holds at any step what the closed form says
TEST(fluidDrags, addedMass)
{
    class light
    :
        public oneDrag
    {
    public:

        light()
        :
            oneDrag([](const scalar) { return 3.0; }, Foam::Zero)
        {}

        virtual scalar massShare(const label) const
        {
            return 0.01/(0.01 + 0.5);
        }
    };

    // Density ratio 0.01: weight less buoyancy over its own mass is 99 g
    const light drag;
    const vector up(0, 0, 99*9.81);
    const vector start = drag.kick(0, Foam::Zero, up, 1e-6);
    figureNear("fluidDrag_addedMass", start.z()/1e-6, 0.99*9.81/0.51, 1e-5,
               "m/s2", "(rho_f - rho_p) g/(rho_p + rho_f/2)");
    const vector end = drag.kick(0, Foam::Zero, up, 1e6);
    figureNear("fluidDrag_addedMassEnd", end.z(), 0.99*9.81/0.51/3, 1e-12,
               "m/s", "balance with the drag");
}


// With a rate that does not change a kick is exact, whatever its length
TEST(fluidDrags, linear)
{
    const vector u(1, -2, 0.5), v(-3, 0, 1), a(0, 0.3, -9.81);
    scalar worst = 0;
    for (const scalar k : {1e-12, 1e-3, 1.0, 1e3, 1e9})
    {
        const oneDrag drag([k](const scalar) { return k; }, u);
        const vector end = v + drag.kick(0, v, a, 1);
        const scalar rest = std::exp(-k);
        const vector exact =
            u + rest*(v - u) - std::expm1(-k)/k*a;
        worst = std::max(worst, Foam::mag(end - exact)/Foam::mag(exact));
    }
    figure("fluidDrag_linear", worst, -noBar, 1e-12, "-",
           "closed form, steps of 1e-12 to 1e9 relaxation times");
}


// The scheme keeps its second order with a drag that is not linear
// Short kicks of bodies that are expanded take a shorter way: against the long
// one, across where that begins
TEST(fluidDrags, near)
{
    const auto sn = law("schillerNaumann");
    const auto rate = [&](const scalar slip)
    {
        return sn->factor(300*slip, 1);
    };
    const vector u(0.3, -0.2, 1), v(0.1, 0.4, -0.5);
    const oneDrag drag(rate, u);
    nearDrag near(rate, u);
    const scalar k = rate(Foam::mag(u - v));

    scalar worst = 0, compared = 0;
    for (const scalar off : {0.0, 0.03, -0.04, 0.2})
    {
        near.expandAt((1 + off)*Foam::mag(u - v));
        for (scalar z = 1e-8; z < 10; z *= 1.7)
        {
            for (const scalar g : {0.0, 0.3, -2.0})
            {
                const vector a(0, 0, k*g);
                const vector kick = drag.kick(0, v, a, z/k);
                worst = std::max
                (
                    worst,
                    Foam::mag(near.kick(0, v, a, z/k) - kick)/Foam::mag(kick)
                );
                ++compared;
            }
        }
    }
    figure("fluidDrag_near", worst, -noBar, 2e-5, "of the change",
        "kicks without the expansion");
    figure("fluidDrag_nearCompared", compared, 100, noBar, "kicks", "own");
}


TEST(fluidDrags, order)
{
    const scalar g = 1000;
    const scalar fine = wayAfter(g, 20480);
    const scalar coarse = std::abs(wayAfter(g, 160) - fine);
    const scalar half = std::abs(wayAfter(g, 320) - fine);
    figure("fluidDrag_order", std::log2(coarse/half), 1.9, 2.1, "-",
           "Schiller-Naumann from rest, way after 2 relaxation times");
}


// Steps far above the relaxation time: no oscillation, no growth, and the
// terminal velocity, from creeping flow to a constant drag coefficient
TEST(fluidDrags, stiff)
{
    scalar overshoot = 0, fall = 0, after = 0;
    for (const scalar g : {1e-2, 2.0, 1e2, 1e4, 1e6})
    {
        for (const scalar dt : {1.0, 10.0, 1e3, 1e8})
        {
            fallingSphere ball(g);
            const scalar terminal = ball.terminal();
            scalar last = 0;
            for (label i = 0; i < 40; ++i)
            {
                ball.step(dt);
                const scalar v = ball.velocity();
                overshoot = std::max(overshoot, v/terminal - 1);
                fall = std::max(fall, (last - v)/terminal);
                last = v;
            }
            after = std::max(after, std::abs(last/terminal - 1));
        }
    }
    figure("fluidDrag_overshoot", overshoot, -noBar, 1e-3, "terminal velocity",
           "largest in 40 steps of 1 to 1e8 relaxation times, Re 0.01 to 1e4");
    figure("fluidDrag_fall", fall, -noBar, 1e-3, "terminal velocity",
           "largest decrease in one of these steps");
    figure("fluidDrag_terminal", after, -noBar, 1e-6, "-",
           "after these steps, closed form");
}


// What is taken down of the drag is the change of the velocity without weight
TEST(fluidDrags, recorded)
{
    for (const char* name : {"stormerVerlet", "symplecticEuler",
        "explicitEuler", "rk4", "implicitTrapezoidal"})
    {
        Foam::PtrList<shape> shapes(1);
        shapes.set(0, new shape(shape::sphere("ball", 1)));
        bodies state(shapes);
        newBody n;
        n.shapeI = 0;
        n.materialI = 0;
        n.density = 1;
        n.position = Foam::Zero;
        n.velocity = vector(0.3, 0, -1);
        state.append(n);
        const auto sn = law("schillerNaumann");
        const oneDrag drag
        (
            [&](const scalar slip) { return sn->factor(slip, 1); },
            vector(1, -2, 0.5)
        );
        state.drag = &drag;
        state.recordDrag = true;

        const auto method = integrator::New
        (
            dictionaryOf("integrator " + std::string(name) + ";")
        );
        const vector a(0, 0.2, -3);
        const scalar dt = 0.1;
        const auto force = [&](const scalar, const scalar)
        {
            state.force[0] = state.mass[0]*a;
            state.torque[0] = Foam::Zero;
        };
        scalar worst = 0;
        for (label step = 0; step < 20; ++step)
        {
            const vector before = state.v[0];
            force(0, 0);
            moveBodies(*method, state, step*dt, dt, force);
            worst = std::max
            (
                worst,
                Foam::mag(state.v[0] - before - dt*a - state.dragGiven[0])
            );
        }
        figure("fluidDrag_recorded_" + std::string(name), worst, -noBar,
               1e-12, "m/s", "change of velocity less that by weight");
    }
}

// ************************************************************************* //
