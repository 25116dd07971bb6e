/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "hadesSolver.H"
#include "allowedKeys.H"
#include "checkedEntry.H"
#include "contactAccuracy.H"
#include "overlapRelaxation.H"
#include "roomGrid.H"

#include <malloc.h>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::hadesSolver::readGenerators()
{
    if (!input_.dict.found("generators"))
    {
        return;
    }

    shapeSizes sizes
    (
        shapes_,
        [this](const shape& s, const dictionary& d)
        {
            checkShape(s, d, input_);
        }
    );
    const dictionary& dict = input_.dict.subDict("generators");
    for (const word& name : dict.toc())
    {
        generators_.append
        (
            generator::New
            (
                name,
                dict.subDict(name),
                sizes,
                materials_,
                input_.directory
            ).ptr()
        );
    }
}


void Foam::dem::hadesSolver::readSinks()
{
    if (!input_.dict.found("sinks"))
    {
        return;
    }

    const dictionary& dict = input_.dict.subDict("sinks");
    for (const word& name : dict.toc())
    {
        sinks_.append
        (
            sink::New(name, dict.subDict(name), input_.outlets).ptr()
        );
    }
}


Foam::autoPtr<Foam::dem::stepControl>
Foam::dem::hadesSolver::chooseControl()
{
    impulse_.reset(new impulseError(g(), !integrator_->leaps()));
    if (!(input_.contactError > 0))
    {
        return stepControl::New(input_.dict.subDict("stepControl"));
    }

    scalar r = GREAT;
    for (const shape& s : shapes_)
    {
        r = min(r, s.minRadius());
    }
    const dictionary control
    (
        contactAccuracy(input_.dict, materials_, 2*r, mag(g())).choose
        (
            input_.contactError,
            stepAccuracy_
        )
    );
    return stepControl::New(control);
}


void Foam::dem::hadesSolver::checkIntegrator(const contactLaws& laws) const
{
    if
    (
        integrator_->goesBack()
     && (
            laws.damping != "none"
         || laws.tangential != "none"
         || laws.rolling != "none"
         || laws.torsion != "none"
        )
    )
    {
        badEntry
        (
            input_.dict,
            "integrator",
            "goes back in time within a step, where damping and friction would"
            " give energy: take damping, tangential, rolling and torsion none"
            " in contact, or stormerVerlet"
        );
    }
    if (integrator_->order() < 2 && control_->type() == "contact")
    {
        badEntry
        (
            input_.dict,
            "integrator",
            "is of first order, so that it leaves the parabolas that"
            " stepControl contact counts on in free flight: take hades or"
            " fixed, or stormerVerlet"
        );
    }
}


void Foam::dem::hadesSolver::checkShapes(const contactLaws& laws) const
{
    for (const shape& s : shapes_)
    {
        if (laws.coheres("electrostatic") && !s.isSphere())
        {
            badEntry
            (
                input_.dict.subDict("contact"),
                "cohesion",
                "electrostatic has the charge of a body in the centre of its"
                " sphere, but shape " + s.name() + " has several"
            );
        }
    }
}


void Foam::dem::hadesSolver::checkOverlaps()
{
    if (!nBodies())
    {
        return;
    }

    shareOut();
    pack();
    computeForces(input_.start, 0, true);
    report_.overlap = group_.max(summary_.overlap);

    if (report_.overlap > 1e-3)
    {
        const string who = group_.first
        (
            summary_.overlapA < 0 || summary_.overlap < report_.overlap
          ? string()
          : nameOf(summary_.overlapA) + " and " + nameOf(summary_.overlapB)
        );
        FatalIOErrorInFunction(input_.dict.subDict("bodies"))
            << who.c_str() << " overlap at the start, by "
            << 100*report_.overlap << " % of the smaller radius." << nl
            << "    Bodies may start with 0.1 % at most: move them apart, or"
            << " let the entry  start relax;  do it."
            << exit(FatalIOError);
    }
}


void Foam::dem::hadesSolver::relax()
{
    if (!relaxes_ || !state_.size())
    {
        return;
    }
    walls_.moveTo(input_.start);

    const overlapRelaxation::result r =
        overlapRelaxation(state_, walls_, input_.period).run();
    Info<< "    start relax: " << r.nPasses << " passes; largest overlap "
        << 100*r.before << " % of the smaller radius before, "
        << 100*r.after << " % now; bodies moved by " << r.mean
        << " m on average, " << r.farthest << " m at most" << endl;

    if (r.after > overlapRelaxation::tolerance)
    {
        FatalIOErrorInFunction(input_.dict)
            << "start relax: after " << r.nPasses << " passes "
            << nameOf(r.a).c_str() << " and " << nameOf(r.b).c_str()
            << " still overlap by " << 100*r.after
            << " % of the smaller radius, from " << 100*r.before
            << " % before." << nl
            << "    There is not enough room: equal spheres at random need"
            << " 1.6 times their own volume, and near that it takes long."
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::hadesSolver::enter(const scalar t)
{
    report_.nEntered = 0;
    walls_.moveTo(t);

    // Made when the first body asks for room
    autoPtr<roomGrid> grid;
    const generator::hasRoom room =
        [&](const newBody& body)
        {
            if (!grid.valid())
            {
                grid.reset(new roomGrid(state_, walls_, input_.period));
            }
            return !group_.any(!grid->hasRoom(body));
        };
    const bool relaxes = relaxes_ && !input_.restart && !hasEntered_;
    const generator::hasRoom asGiven =
        [&](const newBody& body)
        {
            if (!grid.valid() && !relaxes)
            {
                grid.reset(new roomGrid(state_, walls_, input_.period));
            }
            return relaxes || !group_.any(!grid->hasRoom(body, 1e-3));
        };
    hasEntered_ = true;
    bool overlap = false;

    const label nextId = state_.nextId();
    for (generator& g : generators_)
    {
        const label nBefore = g.nEntered();
        const label nDue = g.nDue(t);
        scalar volume = 0;
        while (g.nEntered() < nDue)
        {
            newBody body;
            const bool made = g.make
            (
                g.nEntered(),
                g.placesAsGiven() ? asGiven : room,
                body
            );
            if (!made && g.placesAsGiven())
            {
                FatalErrorInFunction
                    << "Generator " << g.name() << ": the body of "
                    << g.source(g.nEntered()).c_str() << " at "
                    << body.position << " overlaps another or a wall." << nl
                    << "    Bodies may overlap by 0.1 % of their radius at"
                    << " most: move it, or let the entry  start relax;  do it"
                    << " at the start of the run." << exit(FatalError);
            }
            overlap = overlap || g.placesAsGiven();
            if (made)
            {
                const label b = share(body);
                volume += shapes_[body.shapeI].volume();
                ++report_.nEntered;
                if (grid.valid() && b >= 0)
                {
                    grid->add(b);
                }
            }
            else if (g.waits())
            {
                Info<< "    generator " << g.name() << ": body "
                    << g.nEntered() << " waits for room" << endl;
                break;
            }
            g.setEntered(g.nEntered() + 1, g.nLeftOut() + !made);
        }
        if (g.nEntered() > nBefore)
        {
            g.report(Info, volume);
        }
        g.release();
    }
    if (exchange_.valid() && state_.nextId() > nextId)
    {
        exchange_->setChanged();
    }
    if (relaxes && overlap)
    {
        order();
        relax();
    }
    if (report_.nEntered > max(10000, state_.size()/2))
    {
        // The start of a large scene has had much that it does not need any
        // more, and the C library keeps the half of it
        malloc_trim(0);
    }
}


Foam::List<Foam::dem::generatorPlan> Foam::dem::hadesSolver::plans() const
{
    List<generatorPlan> all(generators_.size());
    forAll(generators_, i)
    {
        all[i] = generators_[i].plan();
    }
    return all;
}


bool Foam::dem::hadesSolver::hasRoomFor(const label i) const
{
    const generator& g = generators_[i];
    newBody body;
    const roomGrid grid(state_, walls_, input_.period);
    return
        g.nEntered() >= g.plan().total
     || (relaxes_ && g.placesAsGiven())
     || g.make
        (
            g.nEntered(),
            [&](const newBody& n)
            {
                const scalar part = g.placesAsGiven() ? 1e-3 : 0;
                return !group_.any(!grid.hasRoom(n, part));
            },
            body
        );
}


void Foam::dem::hadesSolver::setMeets(const bool meets, const bool restart)
{
    list_.setMeets(meets);
    if (!meets || restart || !state_.size())
    {
        return;
    }

    const overlapRelaxation::result r =
        overlapRelaxation(state_, walls_, input_.period).run();
    if (r.before > overlapRelaxation::tolerance)
    {
        Info<< "    bodies that had come to overlap, by "
            << 100*r.before << " % of the smaller radius, were moved apart, by "
            << r.farthest << " m at most" << endl;
    }
    if (r.after > overlapRelaxation::tolerance)
    {
        FatalErrorInFunction
            << "Bodies meet from now on, but " << nameOf(r.a).c_str()
            << " and " << nameOf(r.b).c_str() << " have come to overlap by "
            << 100*r.after << " % of the smaller radius and cannot be moved"
            << " apart." << nl
            << "    Take a smaller targetError in effects, so that they meet"
            << " sooner." << exit(FatalError);
    }
}


void Foam::dem::hadesSolver::setFilm(const squeezedFilm& film)
{
    // What touches and what it remembers stays, what is near is found anew
    list_.drop();
    materials_.setFilm(squeezedFilm(film));
    contacts_.setFilm(materials_.laws().film);

    const sweepLaws& laws = contacts_.laws();
    if (laws.rolls() || laws.coheres || laws.shares || laws.reaches())
    {
        walls_.deactivatePlanes();
    }
    else
    {
        walls_.activatePlanes
        (
            contacts_.nLanes(),
            materials_.laws().slips()
        );
    }
    list_.setReach(materials_.reach(), materials_.reachPerRadius());
    walls_.setReach(materials_.reach(), materials_.reachPerRadius());
}


void Foam::dem::hadesSolver::tellFilms()
{
    contacts_.tellFilms();
    films_.reset(new dem::filmImpulse);
}


Foam::Pair<Foam::vector>
Foam::dem::hadesSolver::filmImpulse(const label b) const
{
    return
        films_.valid()
      ? Pair<vector>(films_->linear(b), films_->angular(b))
      : demSolver::filmImpulse(b);
}


// ************************************************************************* //
