/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Description
    Laws of drag and the other forces on bodies that are points to the fluid,
    one by one: against the form in which their sources write them, against
    values of others, and against closed forms.

\*---------------------------------------------------------------------------*/

#include "demCase.H"

#include "basset.H"
#include "bodyProfile.H"
#include "dispersion.H"
#include "dragLaw.H"
#include "mathematicalConstants.H"
#include "pointForce.H"

#include <cmath>
#include <functional>

using namespace styxTest;
using namespace Foam;
using namespace Foam::coupling;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const scalar pi = constant::mathematical::pi;

autoPtr<dragLaw> law(const std::string& name)
{
    return dragLaw::New(dictionaryOf("drag " + name + ";"));
}


autoPtr<pointForce> force(const std::string& name, const std::string& text)
{
    return pointForce::New(name, vector(0, 0, -9.81), dictionaryOf(text));
}


//- Largest relative difference of a law from the force that a source writes,
//  over Reynolds numbers and void fractions
scalar worstOff
(
    const dragLaw& l,
    const std::function<scalar(scalar u, scalar alpha)>& F,
    const std::vector<scalar>& alphas
)
{
    // A fluid and a sphere in which Re is 2e4 u
    const scalar rho = 800, nu = 1e-7, d = 2e-3;
    scalar worst = 0;
    for (const scalar u : {1e-7, 1e-5, 1e-4, 1e-3, 1e-2, 0.04, 0.2})
    {
        for (const scalar alpha : alphas)
        {
            const scalar own =
                3*pi*rho*nu*d*l.factor(u*d/nu, alpha)*u;
            worst = std::max(worst, std::abs(own/F(u, alpha) - 1));
        }
    }
    return worst;
}


const scalar rho = 800, nu = 1e-7, d = 2e-3, mu = rho*nu;
const scalar V = pi*d*d*d/6;


scalar Ergun(const scalar u, const scalar a)
{
    const scalar phi = 1 - a;
    const scalar beta =
        150*phi*phi*mu/(a*d*d) + 1.75*phi*rho*u/d;
    return beta*V*u/phi;
}


scalar WenYu(const scalar u, const scalar a)
{
    const scalar Re = a*u*d/nu;
    const scalar Cd =
        Re < 1000 ? 24/Re*(1 + 0.15*std::pow(Re, 0.687)) : 0.44;
    const scalar beta =
        0.75*Cd*a*(1 - a)*rho*u/d*std::pow(a, -2.65);
    return beta*V*u/(1 - a);
}


//- A sphere of 1 mm in a fluid that streams along x and turns about z
pointBody ball()
{
    return
        {7, 1e-3, pi*1e-9/6, vector(0.1, 0, 0), vector(0, 0, 3), 0, 1e-3};
}


fluidAtPoint stream()
{
    fluidAtPoint f;
    f.u = vector(0.15, 0, 0);
    f.rho = 1000;
    f.nu = 1e-6;
    f.curlU = vector(0, 0, -20);
    f.DuDt = vector(0, 0, 4);
    f.gradP = vector(100, -50, 0);
    f.divTau = vector(0, 30, 0);
    return f;
}


pointSum sumOf
(
    const std::string& name,
    const std::string& text,
    const pointBody& b,
    const fluidAtPoint& f
)
{
    pointSum sum;
    force(name, text)->add(b, f, sum);
    return sum;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(dragLaws, asTheirSources)
{
    const std::vector<scalar> all({0.4, 0.6, 0.79, 0.81, 0.9, 0.99});
    const std::vector<scalar> beds({0.4, 0.6, 0.79});
    scalar worst = worstOff(*law("ergun"), Ergun, beds);
    worst = std::max(worst, worstOff(*law("wenYu"), WenYu, all));
    worst = std::max
    (
        worst,
        worstOff
        (
            *law("gidaspow"),
            [](const scalar u, const scalar a)
            {
                return a > 0.8 ? WenYu(u, a) : Ergun(u, a);
            },
            all
        )
    );
    worst = std::max
    (
        worst,
        worstOff
        (
            *law("diFelice"),
            [](const scalar u, const scalar a)
            {
                const scalar Re = a*u*d/nu;
                const scalar Cd = std::pow(0.63 + 4.8/std::sqrt(Re), 2);
                const scalar l = 1.5 - std::log10(Re);
                const scalar chi = 3.7 - 0.65*std::exp(-l*l/2);
                return
                    0.125*Cd*rho*pi*d*d*std::pow(a, 2 - chi)*u*u;
            },
            all
        )
    );
    worst = std::max
    (
        worst,
        worstOff
        (
            *law("kochHill"),
            [](const scalar u, const scalar a)
            {
                const scalar p = 1 - a, Re = a*u*d/nu;
                const scalar F0 =
                    p < 0.4
                  ? (1 + 3*std::sqrt(p/2) + 135.0/64*p*std::log(p) + 16.14*p)
                   /(1 + 0.681*p - 8.48*p*p + 8.16*p*p*p)
                  : 10*p/std::pow(a, 3);
                const scalar F3 =
                    0.0673 + 0.212*p + 0.0232/std::pow(a, 5);
                return V*18*mu/(d*d)*a*a*(F0 + 0.5*F3*Re)*u;
            },
            all
        )
    );
    worst = std::max
    (
        worst,
        worstOff
        (
            *law("beetstra"),
            [](const scalar u, const scalar a)
            {
                const scalar p = 1 - a, Re = a*u*d/nu;
                const scalar F0 =
                    10*p/(a*a) + a*a*(1 + 1.5*std::sqrt(p));
                const scalar F1 =
                    0.413*Re/(24*a*a)
                   *(1/a + 3*a*p + 8.4*std::pow(Re, -0.343))
                   /(
                        1
                      + std::pow(10, 3*p)*std::pow(Re, -(1 + 4*p)/2)
                    );
                return a*3*pi*mu*d*(F0 + F1)*u;
            },
            all
        )
    );
    worst = std::max
    (
        worst,
        worstOff
        (
            *law("tang"),
            [](const scalar u, const scalar a)
            {
                const scalar p = 1 - a, Re = a*u*d/nu;
                const scalar b =
                    0.11*p*(1 + p) - 0.00456/std::pow(a, 4)
                  + (0.169*a + 0.0644/std::pow(a, 4))
                   *std::pow(Re, -0.343);
                return
                    a*3*pi*mu*d*u
                   *(10*p/(a*a) + a*a*(1 + 1.5*std::sqrt(p)) + b*Re);
            },
            all
        )
    );
    worst = std::max
    (
        worst,
        worstOff
        (
            *law("syamlalOBrien"),
            [](const scalar u, const scalar a)
            {
                const scalar Re = u*d/nu;
                const scalar A = std::pow(a, 4.14);
                const scalar B =
                    a <= 0.85 ? 0.8*std::pow(a, 1.28) : std::pow(a, 2.65);
                const scalar c = 0.06*Re;
                const scalar Vr =
                    (A - c + std::sqrt(c*c + 2*c*(2*B - A) + A*A))/2;
                const scalar Cd = std::pow(0.63 + 4.8/std::sqrt(Re/Vr), 2);
                const scalar beta =
                    0.75*Cd*a*(1 - a)*rho*u/(Vr*Vr*d);
                return beta*V*u/(1 - a);
            },
            all
        )
    );
    figure("dragLaws_sources", worst, -noBar, 1e-12, "-",
           "references 14, force on a sphere as each source writes it");
}


// A bed of 1 mm spheres: the force of the fluid on them, drag and pressure, is
// what the fluid loses (references 10: CFDEM's Ergun case)
TEST(dragLaws, ergunBed)
{
    const scalar D = 1e-3, rhoF = 10, nuF = 1.5e-4, a = 0.451335;
    const struct
    {
        scalar U, dp;
    }
    table[] =
    {
        {0.002, 22.99}, {0.005, 57.51}, {0.01, 115.09}, {0.015, 172.76},
        {0.02, 230.51}
    };
    scalar worst = 0;
    for (const std::string name : {"ergun", "gidaspow"})
    {
        for (const auto& row : table)
        {
            const scalar u = row.U/a;
            const scalar drag =
                3*pi*rhoF*nuF*D*law(name)->factor(u*D/nuF, a)*u;
            const scalar perLength = (1 - a)/(pi*D*D*D/6)*drag/a;
            worst =
                std::max(worst, std::abs(perLength*0.0156/row.dp - 1));
        }
    }
    figure("dragLaws_ergunBed", worst, -noBar, 3e-4, "of dp",
           "references 10, digits of the table");
}


// Simulations of creeping flow through random arrays, which scatter by 3 to 4 %
TEST(dragLaws, creepingArrays)
{
    const struct
    {
        scalar phi, F;
    }
    table[] = {{0.05, 1.90}, {0.1, 2.48}, {0.2, 4.37}, {0.3, 7.53}};
    scalar worst = 0;
    for (const std::string name : {"beetstra", "tang", "kochHill"})
    {
        for (const auto& row : table)
        {
            const scalar a = 1 - row.phi;
            const scalar F = law(name)->factor(0, a)/a;
            worst = std::max(worst, std::abs(F/row.F - 1));
        }
    }
    figure("dragLaws_creepingArrays", worst, -noBar, 0.15, "of F",
           "lattice-Boltzmann, references 14");
}


// Every law at rest and far outside of its range: a finite number, above 0 but
// for Ergun's, which has no drag without a bed at rest
// Several spheres at once, as a law may have its own way for that
TEST(dragLaws, several)
{
    scalar worst = 0;
    label different = 0;
    for (const word& name : dragLaw::wordConstructorTablePtr_->toc())
    {
        const auto l = law(name);
        const scalar width = 0.05;
        DynamicList<scalar> Re, alpha;
        for (const scalar a : {0.36, 0.5, 0.79, 0.81, 0.95, 1.0})
        {
            for (scalar r = 1e-3; r < 5e3; r *= 3)
            {
                Re.append(r);
                alpha.append(a);
            }
        }
        List<dragLaw::triple> f(Re.size());
        l->factors(width, Re, alpha, f);
        forAll(f, i)
        {
            const scalar one[] = {1, 1 - width, 1 + width};
            for (label k = 0; k < 3; ++k)
            {
                const scalar expected = l->factor(one[k]*Re[i], alpha[i]);
                worst = max(worst, mag(f[i][k]/expected - 1));
            }
            different += f[i][1] != f[i][2];
        }
    }
    figure("dragLaws_several", worst, -noBar, 1e-12, "of f",
        "one after the other, 12 laws");
    figure("dragLaws_severalDiffer", different, 100, noBar, "spheres", "own");
}


TEST(dragLaws, finite)
{
    label bad = 0;
    for (const word& name : dragLaw::wordConstructorTablePtr_->toc())
    {
        const auto l = law(name);
        for (const scalar a : {0.1, 0.36, 0.8, 1.0})
        {
            for (const scalar Re : {0.0, 1e-12, 1.0, 1e3})
            {
                const scalar f = l->factor(Re, a);
                const bool none = name == "ergun" && a == 1 && Re == 0;
                bad += !(f < 1e6 && (f > 0 || none));
            }
        }
        const dragLaw::limits r(l->range());
        bad += !(r.Re > 0 && r.least < r.largest && r.largest <= 1);
    }
    figure("dragLaws_finite", bad, 0, 0, "values", "12 laws");
}


// Bodies that are no spheres
TEST(dragLaws, shapes)
{
    const dragShape disc{0.6, 0.9, 0.4};
    scalar worst = 0;
    for (const scalar Re : {0.1, 10.0, 1000.0})
    {
        const scalar logPsi = -std::log10(0.6);
        const scalar hs =
            8/(Re*std::sqrt(0.9)) + 16/(Re*std::sqrt(0.6))
          + 3/(std::sqrt(Re)*std::pow(0.6, 0.75))
          + 0.42*std::pow(10, 0.4*std::pow(logPsi, 0.2))/0.4;
        const scalar own =
            24*law("holzerSommerfeld")->factor(Re, 1, disc)/Re;
        worst = std::max(worst, std::abs(own/hs - 1));

        const scalar p = 0.6;
        const scalar A = std::exp(2.3288 - 6.4581*p + 2.4486*p*p);
        const scalar B = 0.0964 + 0.5565*p;
        const scalar C =
            std::exp(4.905 - 13.8944*p + 18.4222*p*p - 10.2599*p*p*p);
        const scalar D =
            std::exp(1.4681 + 12.2584*p - 20.7322*p*p + 15.8855*p*p*p);
        const scalar hl =
            24/Re*(1 + A*std::pow(Re, B)) + C/(1 + D/Re);
        const scalar ownHl =
            24*law("haiderLevenspiel")->factor(Re, 1, disc)/Re;
        worst = std::max(worst, std::abs(ownHl/hl - 1));
    }
    figure("dragLaws_shapes", worst, -noBar, 1e-12, "-",
           "references 14, a disc of sphericity 0.6");

    // Spheres: measured drag, within what the authors claim
    scalar sphere = 0;
    for (const std::string name : {"holzerSommerfeld", "haiderLevenspiel"})
    {
        sphere = std::max(sphere, std::abs(law(name)->Cd(100, 1)/1.08 - 1));
    }
    figure("dragLaws_shapesOfSphere", sphere, -noBar, 0.15, "of Cd",
           "sphere at Re 100, references 9");
}


// Surface and shadows of two spheres that overlap: closed forms
TEST(bodyProfiles, twoSpheres)
{
    const scalar r = 1, half = 0.6;
    const dem::shape s
    (
        "pair",
        List<dem::shape::sphereData>
        ({
            dem::shape::sphereData(point(0, 0, half), r),
            dem::shape::sphereData(point(0, 0, -half), r)
        })
    );
    const bodyProfile profile(s, 0);

    // Each sphere less the cap beyond the middle plane
    const scalar surface = 2*2*pi*r*(r + half);
    const scalar segment =
        r*r*std::acos(half/r) - half*std::sqrt(r*r - half*half);
    const scalar side = 2*(pi*r*r - segment);
    figureNear("bodyProfile_surface", profile.surface(), surface, 1e-6, "m2",
               "two caps");
    const vector sorted
    (
        Foam::cmptMin(profile.shadow()),
        0,
        Foam::cmptMax(profile.shadow())
    );
    figureNear("bodyProfile_end", sorted.x(), pi*r*r, 1e-5, "m2", "disc");
    figureNear("bodyProfile_side", sorted.z(), side, 1e-5, "m2", "two discs");

    // An ellipsoid of many spheres would be needed for slanted ones; a sphere
    // is the same from all sides
    const bodyProfile sphere(dem::shape::sphere("ball", 2), 0);
    const dragShape seen = sphere.seenAlong(normalised(vector(1, 2, 3)));
    figureNear("bodyProfile_sphere",
               seen.sphericity*seen.lengthwise*seen.crosswise, 1, 1e-12, "-",
               "three ratios of a sphere");

    // No rod of ten spheres is as round as a ball
    List<dem::shape::sphereData> row;
    for (label k = 0; k < 10; ++k)
    {
        row.append(dem::shape::sphereData(point(0, 0, 2*k), 1));
    }
    const dem::shape rod("rod", row);
    EXPECT_THROW(bodyProfile(rod, 1), Foam::error);
    EXPECT_NO_THROW(bodyProfile(rod, 0));
}


TEST(pointForces, undisturbed)
{
    const pointBody b = ball();
    const fluidAtPoint f = stream();
    const vector buoyancy =
        sumOf("buoyancy", "buoyancy yes;", b, f).undisturbed;
    const vector pressure =
        sumOf("pressureGradient", "pressureGradient on;", b, f).undisturbed;
    const vector stress =
        sumOf("viscous", "viscous true;", b, f).undisturbed;
    scalar worst = mag(buoyancy - vector(0, 0, 9810*b.volume));
    worst = max(worst, mag(pressure - b.volume*vector(-100, 50, 0)));
    worst = max(worst, mag(stress - b.volume*vector(0, 30, 0)));
    figure("forces_undisturbed", worst/(9810*b.volume), -noBar, 1e-14, "-",
           "V times rho g, grad p and div tau");
    EXPECT_FALSE(force("viscous", "viscous no;").valid());
    EXPECT_FALSE(force("viscous", "drag none;").valid());
    EXPECT_THROW(force("viscous", "viscous perhaps;"), Foam::IOerror);
    EXPECT_THROW(force("viscous", "viscous { x 1; }"), Foam::IOerror);
}


TEST(pointForces, virtualMass)
{
    const pointBody b = ball();
    const pointSum s =
        sumOf("virtualMass", "virtualMass yes;", b, stream());
    figureNear("virtualMass_mass", s.addedMass, 500*b.volume, 1e-14, "kg",
               "half the displaced fluid");
    EXPECT_NEAR(s.force.z(), 4*500*b.volume, 1e-12*b.volume);
    EXPECT_THROW
    (
        force("virtualMass", "virtualMass { coefficient -1; }"),
        Foam::IOerror
    );
}


TEST(pointForces, lift)
{
    const pointBody b = ball();
    fluidAtPoint f = stream();

    // Lags in du_x/dy = 20: towards the faster fluid, +y
    const vector saffman = sumOf("saffman", "saffman yes;", b, f).force;
    const scalar closed =
        6.46*1000*1e-6*0.25e-6*std::sqrt(20/1e-6)*0.05;
    figureNear("saffman_lift", saffman.y(), closed, 1e-3, "N",
               "6.46 mu a^2 sqrt(G/nu) (u - v)");
    EXPECT_LT(mag(saffman.x()) + mag(saffman.z()), 1e-15*closed);

    // Mei: Re 50, then 5 with the same shear
    const scalar Re = 50, beta = 0.5*20*1e-3/0.05;
    const vector mei = sumOf("mei", "mei yes;", b, f).force;
    figureNear("mei_lift", mei.y()/saffman.y(), 0.0524*std::sqrt(beta*Re),
               1e-12, "-", "over Saffman's, Re 50");
    f.u = vector(0.105, 0, 0);
    const scalar slow =
        sumOf("mei", "mei yes;", b, f).force.y()
       /sumOf("saffman", "saffman yes;", b, f).force.y();
    figureNear("mei_liftSlow", slow,
               (1 - 0.3314*std::sqrt(2.0))*std::exp(-0.5)
             + 0.3314*std::sqrt(2.0), 1e-12, "-", "over Saffman's, Re 5");
}


TEST(pointForces, magnus)
{
    pointBody b = ball();
    fluidAtPoint f = stream();
    f.curlU = Zero;

    // A ball that falls behind and turns about z: pi/8 rho d^3 (omega x v)
    const vector creeping =
        sumOf("magnus", "magnus { law rubinowKeller; }", b, f).force;
    figureNear("magnus_creeping", creeping.y(), -pi/8*1000*1e-9*3*0.05, 1e-12,
               "N", "Rubinow and Keller");

    const scalar Re = 50, ReSpin = 3;
    const scalar C =
        0.45
      + (ReSpin/Re - 0.45)
       *std::exp(-0.05684*std::pow(ReSpin, 0.4)*std::pow(Re, 0.3));
    const vector fast = sumOf("magnus", "magnus yes;", b, f).force;
    figureNear("magnus_fast", fast.y(), -pi/8*1000*1e-6*0.05*0.05*C, 1e-12,
               "N", "Oesterle and Bui Dinh");

    // The second tends to the first in slow flow
    f.u = b.v + vector(1e-7, 0, 0);
    b.omega = vector(0, 0, 1e-3);
    const scalar ratio =
        sumOf("magnus", "magnus yes;", b, f).force.y()
       /sumOf("magnus", "magnus { law rubinowKeller; }", b, f).force.y();
    figureNear("magnus_limit", ratio, 1, 0.01, "-",
               "one over the other, Re 1e-4");
    EXPECT_THROW(force("magnus", "magnus { law magnus; }"), Foam::IOerror);
}


TEST(pointForces, rotationalDrag)
{
    pointBody b = ball();
    fluidAtPoint f = stream();
    const auto coefficient = [&]()
    {
        return
            sumOf("rotationalDrag", "rotationalDrag yes;", b, f).spin;
    };
    figureNear("rotationalDrag_slow", coefficient(), 8*pi*1e-3*0.125e-9,
               1e-12, "N m s", "8 pi mu a^3");
    b.omega = vector(0, 0, 190);                // Re_r = 200
    const scalar C = 12.9/std::sqrt(200.0) + 128.4/200;
    figureNear("rotationalDrag_fast", coefficient(),
               500*std::pow(0.5e-3, 5)*C*200, 1e-12, "N m s",
               "Dennis, Singh and Ingham");
}


// ************************************************************************* //
