/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "caseCheck.H"
#include "mathematicalConstants.H"

#include <cmath>

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- An impact of a sphere on one like it, or on a plane
struct impact
{
    bool isHertz;

    //- Effective radius [m] and mass [kg], E* [Pa] or the stiffness [N/m],
    //  velocity [m/s]
    scalar rStar, mStar, elasticity, u;

    //- The deepest overlap [m]
    scalar deepest() const
    {
        return
            isHertz
          ? std::pow
            (
                15*mStar*sqr(u)/(16*elasticity*std::sqrt(rStar)),
                0.4
            )
          : u*std::sqrt(mStar/elasticity);
    }

    //- [s]
    scalar duration() const
    {
        return (isHertz ? 2.9432 : constant::mathematical::pi)*deepest()/u;
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::caseCheck::topSpeed(const kind& k) const
{
    const vector& g = dem_.g();
    if (mag(g) < SMALL)
    {
        return k.speed;
    }

    const scalar height = cmptSum
    (
        cmptMag(cmptMultiply(mesh_.bounds().span(), g/mag(g)))
    );
    const scalar ratio = around_.rho/dem_.mats().density(k.materialI);
    const scalar net = mag(g)*mag(1 - ratio);
    const scalar fall = sqrt(sqr(k.speed) + 2*net*height);
    if (ratio <= 0)
    {
        return fall;
    }

    // Weight and drag in balance, of a sphere: heavy or light
    const scalar settled =
        sqrt((4.0/3.0)*net/(ratio*0.44)*shapeOf(k).equivalentDiameter());
    return max(k.speed, min(fall, settled));
}


void Foam::caseCheck::checkRayleigh()
{
    scalar least = GREAT;
    string whose;
    for (const kind& k : kinds_)
    {
        const scalar time =
            dem_.mats().rayleighTimePerRadius(k.materialI)
           *shapeOf(k).minRadius();
        if (time < least)
        {
            least = time;
            whose = nameOf(k);
        }
    }
    addFigure("rayleighTime", least, "s", "shortest, of " + whose);

    const dem::stepControl* control = dem_.control();
    if (!control || control->type() != "fixed")
    {
        return;
    }

    const scalar dt = control->stepInContact(GREAT);
    addFigure
    (
        "stepOverRayleigh", dt/least, "-",
        "fixed step of the bodies over the Rayleigh time"
    );
    if (dt > 0.3*least)
    {
        sentence os;
        os  << "The fixed step of the bodies, " << dt << " s, is "
            << 100*dt/least << " % of the Rayleigh time of "
            << whose.c_str() << "; 10 to 30 % are usual: take "
            << 0.2*least << " s, or stepControl of type hades.";
        advice_.append(os.str());
    }
}


void Foam::caseCheck::checkImpacts()
{
    const dem::stepControl* control = dem_.control();
    if (!dem_.moves() || !control)
    {
        return;
    }

    addFigure
    (
        "overlapAtStart", 100*dem_.report().overlap, "%",
        "largest overlap over the smaller radius at the start"
    );

    scalar shortest = GREAT, damped = GREAT, worst = 0, top = 0;
    string whose;
    for (const kind& k : kinds_)
    {
        const dem::shape& s = shapeOf(k);
        const scalar u = topSpeed(k);
        const scalar m = dem_.mats().density(k.materialI)*s.volume();
        top = max(top, u);
        if (!(u > VSMALL))
        {
            continue;
        }

        forAll(dem_.mats().names(), j)
        {
            const dem::pairProperties& pair =
                dem_.mats().pair(k.materialI, j);
            for (const bool plane : {true, false})
            {
                const scalar part = plane ? 1 : 0.5;
                const impact hit
                {
                    dem_.mats().laws().normal == "hertz",
                    part*s.maxRadius(),
                    part*m,
                    pair.elasticity,
                    u
                };

                // A damped contact counts as so much shorter
                shortest = min(shortest, hit.duration());
                damped = min
                (
                    damped,
                    hit.duration()/std::pow(pair.resolution10, 0.1)
                );

                const scalar overlap = hit.deepest()/s.maxRadius();
                if (overlap > worst)
                {
                    worst = overlap;
                    whose = nameOf(k);
                }
            }
        }
    }
    addFigure("topSpeed", top, "m/s", "the fastest that a body can become");
    if (shortest >= GREAT)
    {
        return;
    }

    const scalar dt = control->stepInContact(damped);
    addFigure("contactTime", shortest, "s", "shortest impact at that speed");
    addFigure
    (
        "overlap", 100*worst, "%", "deepest impact over the largest radius"
    );
    addFigure("contactStep", dt, "s", "step of the bodies in that impact");
    addFigure
    (
        "stepsPerDeltaT", around_.deltaT/dt, "-",
        "of these in a step of the fluid or of controlDict"
    );

    if (dt > 0.5*damped)
    {
        sentence os;
        os  << "An impact at " << top << " m/s takes " << shortest
            << " s and its damping wants steps of " << 0.05*damped
            << " s: with the fixed " << dt << " s the run will stop there.";
        advice_.append(os.str());
    }
    if (worst > 0.05)
    {
        sentence os;
        os  << "At " << top << " m/s " << whose.c_str() << " goes "
            << 100*worst << " % of its largest radius into what it hits;"
            << " Hertz' law holds up to 5 %. A youngsModulus "
            << pow(worst/0.03, 2.5) << " times as large would make it 3 %.";
        advice_.append(os.str());
    }
    else if (worst < 1e-3 && around_.deltaT > 1e4*dt)
    {
        sentence os;
        os  << "While something touches, a step of " << around_.deltaT
            << " s takes " << around_.deltaT/dt << " of the bodies. Impacts"
            << " go only " << 100*worst << " % deep; with a youngsModulus "
            << pow(worst/0.01, 2.5) << " times as large they would go 1 %"
            << " and take " << 0.01/worst << " times fewer steps.";
        advice_.append(os.str());
    }
}


void Foam::caseCheck::checkFluidStep()
{
    if (!(around_.rho > 0) || !dem_.moves())
    {
        return;
    }

    scalar cells = 0, least = GREAT;
    for (const kind& k : kinds_)
    {
        const scalar now = k.speed*around_.deltaT/k.cell;
        if (now > 0.5001)
        {
            sentence os;
            os  << nameOf(k).c_str() << " starts with " << k.speed
                << " m/s and passes " << now << " cells in a step of "
                << around_.deltaT << " s; 0.5 at most are accurate: take "
                << 0.4*k.cell/k.speed << " s.";
            advice_.append(os.str());
        }
        cells = max(cells, topSpeed(k)*around_.deltaT/k.cell);

        if (around_.nu > 0)
        {
            const scalar rho = dem_.mats().density(k.materialI);
            least = min
            (
                least,
                (rho + 0.5*around_.rho)
               *sqr(shapeOf(k).equivalentDiameter())
               /(18*around_.rho*around_.nu)
            );
        }
    }
    addFigure
    (
        "cellsPerStep", cells, "-",
        "that a body can pass in a step of the fluid at its top speed"
    );

    if (least < GREAT)
    {
        addFigure
        (
            "relaxationTime", least, "s",
            "shortest in which the fluid takes a body along"
        );
        if (resolved() && around_.deltaT > 0.5*least)
        {
            sentence os;
            os  << "The fluid takes a body along in " << least
                << " s; with a step of " << around_.deltaT << " s that is"
                << " not resolved: take " << 0.2*least << " s.";
            advice_.append(os.str());
        }
    }
}


// ************************************************************************* //
