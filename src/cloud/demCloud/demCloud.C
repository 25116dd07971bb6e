/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "demCloud.H"
#include "cloudState.H"
#include "mapPolyMesh.H"
#include "rankBoundaries.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(demCloud, 0);
}

namespace
{

//- Under this name the ledger has what forces on points cost but for what is
//  known by another name
const char* const points = "other on points";

//- Leave nothing of what acts on bodies that are points but the buoyancy
void keepBuoyancy
(
    Foam::dem::bodies& state,
    const Foam::coupling::pointForces& points
)
{
    state.drag = nullptr;
    forAll(state.x, b)
    {
        state.fluidForce[b] -= points.lostByFluid(b);
        state.fluidTorque[b] = Foam::Zero;
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::demCloud::followMesh(const scalar t0, const scalar t1)
{
    if (meshMoved_ && !meshChanged_)
    {
        dem_->updateWalls(true, t0, t1);
        wallsMove_ = true;
    }
    else if (meshChanged_ || wallsMove_)
    {
        dem_->updateWalls(false, t0, t1);
        wallsMove_ = false;
    }
    meshMoved_ = false;
    meshChanged_ = false;
}


void Foam::demCloud::meshMoved()
{
    if (open_ && mesh_.time().timeIndex() == timeIndex_)
    {
        FatalErrorInFunction
            << "The mesh moves a second time in a step, when the bodies have"
            << " already moved with it." << nl
            << "    Set moveMeshOuterCorrectors no; in the PIMPLE dictionary of"
            << " system/fvSolution." << exit(FatalError);
    }

    passed(ledger::mesh);
    ledger::entry e(ledger_, "cells sorted after a mesh change");
    bins_.update();
    exits_.update();
    patches_.checkMotion();
    if (exchanged_.valid())
    {
        exchanged_->meshChanged();
    }
    projected_ = false;
    meshMoved_ = true;
}


void Foam::demCloud::checkFinite() const
{
    const dem::bodies& state = dem_->state();
    forAll(state.x, b)
    {
        const scalar all =
            magSqr(state.x[b]) + magSqr(state.v[b]) + magSqr(state.L(b));
        if (!(all < ROOTVGREAT))
        {
            FatalErrorInFunction
                << "Body " << state.id[b] << " ("
                << state.shapeOf(b).name() << ") at time "
                << mesh_.time().timeName() << " s is at " << state.x[b]
                << " with velocity " << state.v[b]
                << " m/s: the computation has become unstable."
                << exit(FatalError);
        }
    }
}


void Foam::demCloud::writeRanks() const
{
    if (dem_->group().shared())
    {
        const labelPair most(dem_->mostOnRank());
        Info<< "    At most " << most.first() << " bodies of its own and "
            << most.second() << " copies of others' on a rank" << nl;
    }
}


void Foam::demCloud::markInterface()
{
    if (interface_.valid())
    {
        // The mesh asks for these itself when it refines: they count as its
        passed(ledger::fluid);
        mesh_.pointCells();
        passed(ledger::mesh);

        ledger::entry e(ledger_, "refinement around the bodies");
        interface_->mark(*dem_, kinds_, 2*mesh_.time().deltaTValue());
    }
}


void Foam::demCloud::samplePoints()
{
    const dem::bodies& state = dem_->state();
    if (interval_.valid())
    {
        // Who has become a point has no forces yet
        if (!interval_->due(state, *points_) && !kindsChanged_)
        {
            return;
        }
        points_->setSteps(interval_->steps());
    }
    if (effectWatch_.valid())
    {
        typedef coupling::fluidAtPoint at;
        const bool stirs = effectWatch_->watches("dispersion");
        const unsigned also = stirs ? at::turbulence : 0;
        points_->watch(effectWatch_->due() ? at::vorticity | also : 0);
    }

    points_->sample
    (
        U().oldTime(),
        exchanged_.valid() ? &exchanged_->alpha() : nullptr,
        exchanged_.valid()
      ? exchanged_->equations()
      : coupling::averagedEquations::none
    );
    if (coupling_ == "particlesToFluid")
    {
        keepBuoyancy(dem_->state(), *points_);
    }
    for (const auto& t : points_->times().seconds())
    {
        ledger_.move(points, t.first, t.second);
    }
    ledger_.addBookings(points_->times().nLaps());
    if (interval_.valid())
    {
        interval_->exchanged(state, *points_);
    }
    if (coupling_ != "particlesToFluid")
    {
        errors_.exchanged(state, *points_);
    }
    if (effectWatch_.valid())
    {
        watchPoints();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::demCloud::beginStep()
{
    const Time& time = mesh_.time();
    if (time.timeIndex() == timeIndex_)
    {
        return;
    }
    passed(ledger::fluid);
    passed(ledger::start);
    endStep();
    finishWriting();
    if (time.writeTime())
    {
        cloudState::begin(mesh_);
    }
    timeIndex_ = time.timeIndex();
    open_ = true;
    if (interval_.valid())
    {
        interval_->beginStep(dem_->state());
    }

    const scalar t1 = time.value();
    const scalar t0 = t1 - time.deltaTValue();

    // Have bodies come or gone?
    bool changed = false;
    {
        ledger::entry e(ledger_, ledger::ofBodies);

        followMesh(t0, t1);
        kindsChanged_ = false;
        // Those that fill cells are known by their place in the list; which
        // they are may have been chosen after the bodies' solver was made
        changed = !immersed_.valid() && dem_->order();
        findKinds();
        changed = removeLeaving(t0) > 0 || changed;
        const label n = dem_->state().size();
        dem_->enter(t0);
        changed = changed || dem_->state().size() > n;
        if (kinds_.mixed() && changed)
        {
            findKinds();
        }
        startForces(n);
        changed = changed || kindsChanged_;
        dem_->shareOut();
        if (points_.valid())
        {
            points_->moveMemory();
        }
        if (immersed_.valid())
        {
            immersed_->moveMemory();
        }
    }

    if (exchanged_.valid() && changed)
    {
        ledger::entry e(ledger_, "bodies on the mesh (void fraction)");
        exchanged_->bodiesChanged();
    }

    if (points_.valid())
    {
        ledger::entry e(ledger_, points);
        samplePoints();
    }

    {
        ledger::entry e(ledger_, ledger::ofBodies);

        if (immersed_.valid())
        {
            immersed_->store();
            watchSolids();
        }
        meters_->begin(*dem_);
        cells_.setStill(false);
        advancing_ = true;
        advanceBodies(t0, t1);
        advancing_ = false;
        meters_->end(*dem_, t0, t1);
        checkFinite();
    }
    ledger_.noteBodies(*dem_);

    if (exchanged_.valid())
    {
        ledger::entry e(ledger_, "bodies on the mesh (void fraction)");
        exchanged_->project();

        // Those that fill cells may yet be moved, and others by other ranks
        cells_.setStill(!immersed_.valid() && !dem_->group().shared());
    }

    // Bodies that stay in cells that stay are found once
    if (immersed_.valid() && (dem_->moves() || !projected_))
    {
        ledger::entry e(ledger_, "bodies on the mesh (volume fraction)");
        immersed_->project(U());
        projected_ = true;
    }
}


void Foam::demCloud::addForcing(fvMatrix<vector>& eqn, const word& density)
{
    if (immersed_.valid() || exchanged_.valid())
    {
        rho_->checkEquation(density);
    }
    beginStep();
    addExchange(eqn);
    addImmersed(eqn);
}


void Foam::demCloud::addExchange(fvMatrix<vector>& eqn)
{
    if (exchanged_.valid())
    {
        ledger::entry e(ledger_, "exchange with the fluid");
        exchanged_->addTo(eqn);
    }
}


void Foam::demCloud::correct(const volVectorField& U)
{
    passed(ledger::fluid);
    if (immersed_.valid())
    {
        ledger::entry e(ledger_, "forces on the bodies");

        immersed_->sumForces(U);
        if (coupling_ == "twoWay" && dem_->moves())
        {
            immersed_->correctMotion();
        }

        const scalar dt = mesh_.time().deltaTValue();
        exchange_.active = true;
        exchange_.toBodies = dt*immersed_->forceOnBodies(exchange_.magnitudes);
        exchange_.magnitudes *= dt;
        exchange_.toFluid = dt*immersed_->forceOnFluid(U);
        exchange_.volumeError = immersed_->volumeError();
        exchange_.slip = immersed_->slip();
    }

    // The mesh asks for it once the step is over, what is written sooner
    if (mesh_.time().writeTime())
    {
        finishExchange(U);
        markInterface();
    }
}


void Foam::demCloud::finishExchange(const volVectorField& U)
{
    if (!exchanged_.valid())
    {
        return;
    }

    ledger::entry e(ledger_, "exchange with the fluid");
    exchanged_->finish(U);
    if (solids_.valid())
    {
        solids_->update();
    }
    exchange_.active = true;
    exchange_.toBodies = exchanged_->toBodies();
    exchange_.magnitudes = exchanged_->magnitudes();
    exchange_.toFluid = exchanged_->toFluid(U);
    exchange_.volumeError = exchanged_->volumeError();
    if (immersed_.valid())
    {
        const scalar dt = mesh_.time().deltaTValue();
        scalar magnitudes;
        exchange_.toBodies += dt*immersed_->forceOnBodies(magnitudes);
        exchange_.magnitudes += dt*magnitudes;
        exchange_.toFluid += dt*immersed_->forceOnFluid(U);
        exchange_.volumeError =
            max(exchange_.volumeError, immersed_->volumeError());
    }
    exchange_.leastAlpha = exchanged_->leastAlpha();
    exchange_.excess = exchanged_->excess().excess;
}


void Foam::demCloud::endStep()
{
    if (!open_)
    {
        return;
    }
    open_ = false;
    passed(ledger::fluid);
    if (exchanged_.valid())
    {
        finishExchange(U());
        errors_.averaged(exchanged_->alpha(), exchanged_->averaging());
    }
    markInterface();

    if (immersed_.valid())
    {
        if (forces_.valid())
        {
            const ledger::entry e(ledger_, "output");
            immersed_->sumFriction(U());
            forces_->write
            (
                mesh_.time().value(),
                mesh_.time().deltaTValue(),
                *dem_,
                *immersed_
            );
        }
        immersed_->finish();
    }
    if (points_.valid())
    {
        exchange_.Re = points_->largestRe();
    }
    ledger_.line(*dem_, exchange_);
    if (interval_.valid() && interval_->shows())
    {
        ledger_.limitFluid(deltaTBound());
    }
    else if (coupling_ != "none")
    {
        const bool adjusts =
            mesh_.time().controlDict().getOrDefault("adjustTimeStep", false);
        ledger_.limitFluid(adjusts ? "maxCo" : "deltaT");
    }
    if (watchdog_.valid() && exchange_.active)
    {
        checkExchange();
    }
    exchange_ = ledger::exchange();
}


void Foam::demCloud::close()
{
    endStep();
    finishWriting();
    if (!ledger_.closed())
    {
        closeErrors();
        ledger_.close
        (
            mesh_.time().rootPath()/mesh_.time().globalCaseName()
           /"postProcessing"/"demCloud"/"ledger.dat",
            dem_->group().sum(dem_->state().kineticEnergy())
        );
        if (interval_.valid() && interval_->shows())
        {
            interval_->writeSummary(Info);
        }
        if (accuracy_.valid())
        {
            accuracy_->writeSummary(Info);
        }
        writeRanks();
        writeSinks();
    }
}


void Foam::demCloud::autoMap(const mapPolyMesh&)
{
    passed(ledger::mesh);
    ledger::entry e(ledger_, "cells sorted after a mesh change");
    coupling::updateRankBoundaries(mesh_);
    bins_.update();
    exits_.update();
    projected_ = false;
    meshChanged_ = true;
    if (exchanged_.valid())
    {
        exchanged_->meshChanged();
    }
}


const Foam::coupling::momentumExchange& Foam::demCloud::exchanged() const
{
    if (!exchanged_.valid())
    {
        FatalIOErrorInFunction(dict_)
            << "This solver is for bodies that act on the fluid: coupling"
            << " twoWay with immersed, or with forces and voidFraction."
            << exit(FatalIOError);
    }
    return *exchanged_;
}


// ************************************************************************* //
