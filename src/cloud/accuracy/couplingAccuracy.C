/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "couplingAccuracy.H"
#include "StringStream.H"
#include "Switch.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const char* const Foam::couplingAccuracy::interval = "interval of the coupling";
const char* const Foam::couplingAccuracy::averaging = "averaging";
const char* const Foam::couplingAccuracy::cells = "cells over the diameter";
const char* const Foam::couplingAccuracy::asleep = "bodies asleep";


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Default of the tolerance of diffusionFraction
const scalar defaultTolerance = 1e-9;

//- Numbers with three digits in a text
struct sentence
:
    public OStringStream
{
    sentence()
    {
        precision(3);
    }
};


bool diffuses(const dictionary& properties)
{
    return
        properties.subOrEmptyDict("voidFraction")
       .getOrDefault<word>("type", word::null) == "diffusion";
}


//- Do the bodies feel the pressure that they make themselves? Held from one
//  exchange to the next it would not be stable
bool feelOwnPressure(const dictionary& properties)
{
    return
        properties.getOrDefault<word>("coupling", "twoWay") == "twoWay"
     && properties.subOrEmptyDict("forces")
       .getOrDefault<Switch>("pressureGradient", false);
}


void chooseInterval(dictionary& properties, dem::accuracyPlan& plan)
{
    dem::accuracyPlan::part p;
    p.name = couplingAccuracy::interval;
    p.error = -1;
    p.basis = "half the change of the forces from one exchange to the next";
    sentence os;
    if (properties.found("couplingInterval"))
    {
        const dictionary& dict = properties.subDict("couplingInterval");
        const scalar change = dict.getOrDefault<scalar>("maxChange", -2);
        p.error = 0.5*change;
        os  << "by hand";
    }
    else
    {
        dictionary dict(properties.name() + ".couplingInterval");
        dict.add("every", word("auto"));
        dict.add("maxCo", 0.5);
        dict.add("maxChange", 2*plan.share());
        properties.add("couplingInterval", dict);
        p.error = plan.share();
        p.cost = "an exchange as often as that takes, where the default is"
            " one in each step";
        os  << "every auto, maxCo 0.5, maxChange " << 2*plan.share();
    }
    p.chosen = os.str();
    plan.append(p);
}


void chooseAveraging(dictionary& properties, dem::accuracyPlan& plan)
{
    dictionary& dict = properties.subDict("voidFraction");
    dem::accuracyPlan::part p;
    p.name = couplingAccuracy::averaging;
    p.basis = "what the expansion leaves out; the bandwidth is part of the"
        " model";
    const bool byHand = dict.found("tolerance");
    if (!byHand)
    {
        dict.add("tolerance", min(0.1*plan.share(), scalar(1e-3)));
    }
    p.error = dict.get<scalar>("tolerance");

    sentence os;
    os  << "tolerance " << p.error << (byHand ? ", by hand" : "");
    p.chosen = os.str();
    if (!byHand)
    {
        sentence cost;
        cost
            << std::sqrt(std::log(p.error)/std::log(defaultTolerance))
            << " times the products of the default";
        p.cost = cost.str();
    }
    plan.append(p);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::label Foam::couplingAccuracy::nParts
(
    const dictionary& properties,
    const bool inFluid
)
{
    const word coupling
    (
        inFluid
      ? properties.getOrDefault<word>("coupling", "auto")
      : word("none")
    );
    // Bodies that stay where they are touch nothing
    label n =
        properties.getOrDefault<word>("demSolver", "hades") == "hades";
    n += properties.found("sleeping");
    if (coupling == "none")
    {
        return n;
    }
    const bool points =
        coupling == "fluidToParticles" || properties.found("forces");
    const bool solids =
        coupling != "fluidToParticles" && properties.found("immersed");
    n += points && !feelOwnPressure(properties);
    n += points && coupling != "fluidToParticles" && diffuses(properties);
    n += solids;

    // What effects auto has still to choose is one or the other
    return n + (coupling == "auto" && !points && !solids);
}


void Foam::couplingAccuracy::chooseSleeping
(
    dictionary& properties,
    dem::accuracyPlan& plan,
    const scalar g
)
{
    // Without gravity the entry must be given: see dem::sleepers
    if (!properties.found("sleeping") || !(g > 0))
    {
        return;
    }
    dictionary& dict = properties.subDict("sleeping");
    const bool byHand = dict.found("acceleration");
    if (!byHand)
    {
        dict.add("acceleration", plan.share()*g);
    }
    const scalar limit = dict.get<scalar>("acceleration");
    sentence os;
    os  << "acceleration " << limit << (byHand ? ", by hand" : "");

    dem::accuracyPlan::part p;
    p.name = asleep;
    p.chosen = os.str();
    p.error = limit/g;
    p.basis = "of its weight, the force that does not wake a body";
    p.cost = "the smaller, the fewer stay asleep";
    plan.append(p);
}


void Foam::couplingAccuracy::choose
(
    dictionary& properties,
    dem::accuracyPlan& plan,
    const bool points,
    const bool acts
)
{
    if (points && !feelOwnPressure(properties))
    {
        chooseInterval(properties, plan);
    }
    if (points && acts && diffuses(properties))
    {
        chooseAveraging(properties, plan);
    }
}


Foam::scalar Foam::couplingAccuracy::expansionError
(
    const dictionary& properties
)
{
    return
        diffuses(properties)
      ? properties.subDict("voidFraction")
       .getOrDefault<scalar>("tolerance", defaultTolerance)
      : -1;
}


Foam::scalar Foam::couplingAccuracy::errorOf(const scalar nCells)
{
    return 0.0181*pow(8/nCells, nCells < 8 ? 3.74 : 1.66);
}


Foam::scalar Foam::couplingAccuracy::cellsFor(const scalar error)
{
    return 8*max(pow(0.0181/error, 1/1.66), scalar(1));
}


Foam::scalar Foam::couplingAccuracy::costOf(const scalar nCells)
{
    return pow(nCells/8, 3.9);
}


void Foam::couplingAccuracy::noteCells
(
    dem::accuracyPlan& plan,
    const scalar nCells
)
{
    dem::accuracyPlan::part p;
    p.name = cells;
    p.error = errorOf(nCells);
    p.basis = "of the drag of a cylinder";
    const scalar wanted = std::ceil(cellsFor(plan.share()));
    sentence os;
    os  << nCells << ", where " << wanted << " are enough";
    p.chosen = os.str();
    sentence cost;
    cost
        << "about " << costOf(nCells) << " times the time of 8 cells, with "
        << wanted << " it would be " << costOf(wanted) << " times, in 3-D";
    p.cost = cost.str();
    plan.append(p);
}


// ************************************************************************* //
