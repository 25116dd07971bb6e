/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "demCloud.H"
#include "earlyChoice.H"
#include "effectLaws.H"
#include "lubrication.H"
#include "sceneSurvey.H"

#include <cmath>

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

//- A body that meets another, at the larger one of its slip and that of its
//  fall: one that rests may be hit. The last one, whose fall is known, is kept
Foam::sceneNumbers impact
(
    const Foam::sceneNumbers& n,
    Foam::sceneNumbers& last
)
{
    const bool same =
        n.d == last.d && n.rhoP == last.rhoP && n.rhoF == last.rhoF
     && n.nu == last.nu;
    if (!same)
    {
        last = n;
        last.slip = n.terminalSlip();
    }
    Foam::sceneNumbers meets(n);
    meets.slip = Foam::max(n.slip, last.slip);
    return meets;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::HashTable<Foam::scalar> Foam::demCloud::pointShares
(
    const bool thorough
)
{
    const effectWatch& watch = *effectWatch_;
    const dem::bodies& state = dem_->state();
    HashTable<scalar> shares;
    scalar largest = 0, volume = 0;
    boolList solid(kinds_.mixed() ? state.size() : 0);
    forAll(state.x, b)
    {
        if (kinds_.mixed())
        {
            solid[b] = kinds_.resolved(b);
            if (solid[b])
            {
                continue;
            }
        }
        largest = max(largest, state.shapeOf(b).equivalentDiameter());
        volume += state.shapeOf(b).volume();
    }
    if (!(largest > 0))
    {
        return shares;
    }

    // All ranks know all bodies, and what was sampled at them
    if (thorough || !(domain_ > 0))
    {
        domain_ = gSum(mesh_.V().field());
        meanCell_ =
            std::cbrt(domain_/returnReduce(mesh_.nCells(), sumOp<label>()));
    }
    const bool crowd =
        thorough || state.size() <= 2000
     || (watch.watches("contacts") && watch.near("contacts"));
    sceneNumbers n;
    n.nBodies = state.size();
    n.g = mag(dem_->g());
    n.meanFraction = volume/domain_;
    n.fraction =
        crowd
      ? sceneSurvey::crowd(state, max(3*largest, meanCell_), solid)
      : n.meanFraction;

    // A film that is off is looked at as long as it may be near its bar
    const word film(coupling::lubrication::name);
    const bool squeezes =
        watch.watches(film)
     && (thorough || (watch.near(film) && !watch.on(film)));
    const bool few = state.size() <= 200;
    const bool meet = few && thorough && watch.watches("contacts");
    const scalar until =
        mesh_.time().deltaTValue()*effects_.interval
       *(interval_.valid() ? interval_->steps() : 1);
    if (few && (squeezes || meet))
    {
        n.gap = sceneSurvey::smallestGap(state);
        n.until = squeezes ? until : 0;
    }
    n.turbulent = watch.watches("dispersion");
    sceneNumbers falls;
    const List<coupling::fluidAtPoint>& fluid = points_->sampled();
    const label stride = 1 + state.size()/1000;
    for (label b = 0; b < state.size(); b += stride)
    {
        if (kinds_.resolved(b))
        {
            continue;
        }
        const coupling::fluidAtPoint& f = fluid[b];
        n.d = state.shapeOf(b).equivalentDiameter();
        n.rhoP = state.mass[b]/state.shapeOf(b).volume();
        n.rhoF = f.rho;
        n.nu = f.nu;
        n.slip = mag(f.u - state.v[b]);
        n.shear = mag(f.curlU);
        n.spin = mag(0.5*f.curlU - state.omega[b]);
        n.k = f.k;
        n.epsilon = f.epsilon;
        for (const effectLaw& law : effectLaws::all())
        {
            const bool squeeze = law.name == film;
            const bool crowded =
                squeeze || law.name == word("contacts")
             || law.name == word("denseDrag");

            // What is not sampled, or takes long; without gravity nothing is
            // known of how fast bodies meet that have no slip
            const bool curled =
                (
                    !thorough
                 && (
                        law.name == word("saffman")
                     || law.name == word("dispersion")
                    )
                )
             || (squeeze && !(squeezes && n.g > 0));
            if
            (
                watch.watches(law.name) && law.asked(n) && !curled
             && (crowd || !crowded)
            )
            {
                scalar& share = shares(law.name, 0);
                share = max
                (
                    share,
                    law.share(squeeze ? impact(n, falls) : n, effects_.target)
                );
            }
        }
    }
    if (meet)
    {
        // Few may meet where the blocks of a crowd do not have both
        scalar fastest = 0;
        for (const vector& v : state.v)
        {
            fastest = max(fastest, mag(v));
        }
        scalar& share = shares("contacts", 0);
        share = max
        (
            share, effects_.target*4*fastest*until/max(n.gap, VSMALL)
        );
    }
    return shares;
}


void Foam::demCloud::watchPoints()
{
    const auto start = ledger::clock::now();
    switchEffects(pointShares(effectWatch_->due()));
    ledger_.move
    (
        "other on points",
        "watching the effects left out",
        std::chrono::duration<scalar>(ledger::clock::now() - start).count()
    );
    ledger_.addBookings(1);
}


void Foam::demCloud::watchSolids()
{
    const dem::bodies& state = dem_->state();
    if
    (
        !effectWatch_.valid() || !state.size()
     || !effectWatch_->watches("contacts") || kinds_.mixed()
    )
    {
        return;
    }

    ledger::entry e(ledger_, "watching the effects left out");
    scalar cell = GREAT;
    for (const label c : cells_.find(state))
    {
        if (c >= 0)
        {
            cell = min(cell, std::cbrt(mesh_.V()[c]));
        }
    }
    reduce(cell, minOp<scalar>());

    // Bodies that come close meet; a crowd is one of them
    HashTable<scalar> shares;
    const scalar gap = max(sceneSurvey::smallestGap(state), VSMALL);
    shares.set("contacts", effects_.target*cell/(0.5*gap));
    switchEffects(shares);
}


void Foam::demCloud::switchEffects(const HashTable<scalar>& shares)
{
    for (const word& name : effectWatch_->judge(shares))
    {
        const bool on = effectWatch_->on(name);
        const string why
        (
            name == coupling::lubrication::name
          ? earlyChoice::noFilm(dict_, mesh_)
          : string()
        );
        Info<< "demCloud: effect " << name
            << (
                   why.size()
                 ? (on ? " called for" : " no longer called for")
                 : (on ? " switched on" : " switched off")
               )
            << " at time " << mesh_.time().value()
            << " s: its share is " << 100*effectWatch_->share(name)
            << " %, the target " << 100*effects_.target << " %" << endl;
        if (why.empty())
        {
            switchEffect(name, on);
        }
        else if (on)
        {
            Info<< "    Advice: it is left out, as " << why.c_str()
                << ", and go on from a time that is written" << endl;
        }
    }
}


void Foam::demCloud::switchForce(const word& name, const bool on)
{
    // A dictionary has the options of a force
    dictionary& forces = dict_.subDict("forces");
    dictionary& chosen = chosen_.subDict("forces");
    forces.remove(name);
    chosen.remove(name);
    if (on && name == "basset")
    {
        dictionary memory(forces, dictionary());
        memory.name() = fileName(forces.name() + '.' + name);
        memory.add("memory", word("exponentials"));
        memory.add("window", 10*mesh_.time().deltaTValue());
        forces.add(name, memory);
        chosen.add(name, memory);
    }
    else if (on && name == coupling::lubrication::name)
    {
        dictionary film(forces, dictionary());
        film.name() = fileName(forces.name() + '.' + name);
        film.add
        (
            "roughness",
            dict_.subDict("effects").get<scalar>("roughness")
        );
        forces.add(name, film);
        chosen.add(name, film);
    }
    else if (on)
    {
        forces.add(name, word("yes"));
        chosen.add(name, word("yes"));
    }
    if (name == coupling::lubrication::name)
    {
        dem_->setFilm
        (
            on
          ? coupling::lubrication::read(mesh_, dict_.subDict("fluid"), forces)
          : dem::squeezedFilm()
        );
        return;
    }
    points_->setForce(name, forces);
}


void Foam::demCloud::switchExchange(const bool on)
{
    coupling_ = on ? "twoWay" : "fluidToParticles";
    dict_.set("coupling", coupling_);
    chosen_.set("coupling", coupling_);
    if (!on)
    {
        exchanged_.clear();
        dem_->state().recordDrag = false;
        return;
    }
    if (!dict_.found("voidFraction"))
    {
        dictionary model;
        model.add("type", word("centroid"));
        dict_.add("voidFraction", model);
        chosen_.add("voidFraction", model);
    }
    makeExchange(false);
    exchanged_->start();
}


void Foam::demCloud::switchEffect(const word& name, const bool on)
{
    if (name == "contacts")
    {
        // Those that have come to overlap are moved apart
        dem_->setMeets(on, false);
        cells_.setStill(false);
    }
    else if (name == "exchange")
    {
        switchExchange(on);
    }
    else if (name == "drag" || name == "denseDrag")
    {
        const word law
        (
            !effectWatch_->on("drag") ? "none"
          : effectWatch_->on("denseDrag") ? "gidaspow" : "schillerNaumann"
        );
        dict_.subDict("forces").set("drag", law);
        chosen_.subDict("forces").set("drag", law);
        points_->setDrag(dict_.subDict("forces"));
    }
    else
    {
        switchForce(name, on);
    }
}


// ************************************************************************* //
