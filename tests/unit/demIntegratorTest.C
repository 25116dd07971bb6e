/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description

Description
    The integrator alone: its order on thesis (4.46), and the torque-free
    asymmetric top.

\*---------------------------------------------------------------------------*/

#include "demCase.H"

#include "movedBodies.H"
#include "topShape.H"

#include <cmath>
#include <cstdio>

using namespace styxTest;
using namespace Foam::dem;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- The two shapes of the tests here
Foam::PtrList<shape> shapes()
{
    Foam::PtrList<shape> list(2);
    list.set(0, new shape(shape::sphere("ball", 1)));

    list.set(1, styxTest::topShape());
    return list;
}


//- A body of mass 1
newBody unitMass(const Foam::PtrList<shape>& list, const label shapeI)
{
    newBody n;
    n.shapeI = shapeI;
    n.materialI = 0;
    n.density = 1/list[shapeI].volume();
    n.position = Foam::Zero;
    return n;
}


Foam::autoPtr<integrator> stormerVerlet()
{
    return integrator::New(dictionaryOf("integrator stormerVerlet;"));
}


//- Error at t = 1 of y'' = cos(t) + y from rest, thesis (4.46), (4.47)
scalar partitionedError(const scalar tau)
{
    const Foam::PtrList<shape> list(shapes());
    bodies state(list);
    state.append(unitMass(list, 0));

    const integrator::forces force = [&](const scalar t, const scalar)
    {
        state.force[0] = vector(std::cos(t) + state.x[0].x(), 0, 0);
        state.torque[0] = Foam::Zero;
    };
    const auto method = stormerVerlet();

    force(0, 0);
    const label n = std::lround(1/tau);
    for (label i = 0; i < n; ++i)
    {
        moveBodies(*method, state, i*tau, tau, force);
    }

    const scalar y = 0.5*std::cosh(1.0) - 0.5*std::cos(1.0);
    const scalar z = 0.5*std::sinh(1.0) + 0.5*std::sin(1.0);
    return std::hypot(state.x[0].x() - y, state.v[0].x() - z);
}


//- A top of inertia 1, 2, 3 that spins about its middle axis
class top
{
    Foam::PtrList<shape> shapes_;

    bodies state_;

    Foam::autoPtr<integrator> method_;

public:

    top()
    :
        shapes_(shapes()),
        state_(shapes_),
        method_(stormerVerlet())
    {
        newBody n = unitMass(shapes_, 1);
        n.orientation = Foam::quaternion
        (
            vector(1, 2, 3)/std::sqrt(14.0),
            Foam::scalar(0.7)
        );
        state_.append(n);
        state_.setL
        (
            0, state_.q[0].transform(vector(1*0.01, 2*1, 3*0.01))
        );
        state_.update();
    }

    bodies& state()
    {
        return state_;
    }

    //- Angular velocity about its first axis [rad/s]
    scalar first() const
    {
        return state_.q[0].invTransform(state_.omega[0]).x();
    }

    void step(const scalar dt)
    {
        moveBodies
        (
            *method_,
            state_,
            0,
            dt,
            [&](const scalar, const scalar)
            {
                state_.torque[0] = Foam::Zero;
                state_.force[0] = Foam::Zero;
            }
        );
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(demIntegrator, order)
{
    std::printf("Tau           error          eoc_stormerVerlet\n");

    scalar tau = 0.1;
    scalar error = partitionedError(tau);
    for (int row = 0; row < 6; ++row)
    {
        const scalar half = partitionedError(0.5*tau);
        const scalar eoc = std::log2(error/half);
        std::printf("%-12.7g  %-13.6e  %.4f\n", tau, error, eoc);

        if (row >= 4)
        {
            figure
            (
                row == 4 ? "verletOrder_tau0.00625" : "verletOrder_tau0.003125",
                eoc,
                1.98,
                2.02,
                "-",
                "thesis 4.4"
            );
        }
        tau *= 0.5;
        error = half;
    }
}


TEST(demIntegrator, asymmetricTop)
{
    const scalar period = 39.10573420;
    const scalar dt = 0.002;

    top t;
    const scalar e0 = t.state().kineticEnergy();
    const vector L0 = t.state().L(0);

    // The first component starts at its positive crest w0 cn(0) and passes
    // zero upwards once a period
    label n = 0;
    scalar firstPass = 0;
    scalar lastPass = 0;
    label nPasses = 0;
    scalar energy = 0;
    scalar momentum = 0;

    for (; n*dt < 100.5*period; ++n)
    {
        const scalar old = t.first();
        t.step(dt);
        const scalar now = t.first();

        if (old < 0 && now >= 0)
        {
            lastPass = (n + old/(old - now))*dt;
            firstPass = nPasses++ ? firstPass : lastPass;
        }
        energy =
            std::max(energy, std::abs(t.state().kineticEnergy()/e0 - 1));
        momentum = std::max(momentum, mag(t.state().L(0) - L0)/mag(L0));
    }

    EXPECT_GE(nPasses, 100);
    figureNear
    (
        "asymmetricTop_period",
        (lastPass - firstPass)/(nPasses - 1),
        period,
        1e-3,
        "s",
        "Jacobi's elliptic functions"
    );
    figure
    (
        "asymmetricTop_energy",
        energy,
        0,
        1e-6,
        "-",
        "100 periods, exact 0"
    );
    figure
    (
        "asymmetricTop_angularMomentum",
        momentum,
        0,
        1e-10,
        "-",
        "100 periods, exact 0"
    );
    figure
    (
        "asymmetricTop_quaternion",
        std::abs(mag(t.state().q[0]) - 1),
        0,
        1e-12,
        "-",
        "exact 0"
    );
}


TEST(demIntegrator, orderOfRotation)
{
    // The top under a torque that depends on where it points
    const auto end = [](const scalar dt)
    {
        top t;
        const auto method = stormerVerlet();
        bodies& s = t.state();
        s.setL(0, 0.5*s.L(0));
        s.update();

        const integrator::forces force = [&](const scalar time, const scalar)
        {
            s.force[0] = Foam::Zero;
            s.torque[0] =
                vector(0, 0, 1) ^ s.q[0].transform(vector(1, 0.5, 0.2));
            s.torque[0] *= 1 + 0.3*std::sin(time);
        };
        force(0, 0);
        const label n = std::lround(4/dt);
        for (label i = 0; i < n; ++i)
        {
            moveBodies(*method, s, i*dt, dt, force);
        }
        return s.q[0].transform(vector(1, 1, 1)) + s.L(0);
    };

    const vector a = end(0.02);
    const vector b = end(0.01);
    const vector c = end(0.005);
    figure
    (
        "rotationOrder",
        std::log2(mag(a - b)/mag(b - c)),
        1.95,
        2.05,
        "-",
        "Richardson"
    );
}


TEST(demIntegrator, orientationOfTheUser)
{
    // What is turned by the user is where he expects it
    Foam::PtrList<shape> list(1);
    Foam::List<shape::sphereData> spheres(3);
    spheres[0] = shape::sphereData(point(1, 0.2, 0), 0.5);
    spheres[1] = shape::sphereData(point(-1, 0, 0.3), 0.4);
    spheres[2] = shape::sphereData(point(0, 0.8, -0.1), 0.45);
    list.set(0, new shape("three", spheres));

    newBody n = unitMass(list, 0);
    n.position = point(3, 4, 5);
    n.orientation = Foam::quaternion(vector(0, 0, 1), M_PI/2);

    bodies state(list);
    state.append(n);

    for (label i = 0; i < 3; ++i)
    {
        const vector d = spheres[i].first() - list[0].centreOfMass();
        const point expected = n.position + vector(-d.y(), d.x(), d.z());
        EXPECT_LT(mag(state.sphereX()[i] - expected), 1e-14);
    }
    EXPECT_LT
    (
        std::abs
        (
            std::abs(state.userOrientation(0).w())
          - std::abs(n.orientation.w())
        ),
        1e-14
    );
}


// ************************************************************************* //
