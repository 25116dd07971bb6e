/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "momentumExchange.H"
#include "allowedKeys.H"
#include "bodyWake.H"
#include "checkedEntry.H"
#include "zeroGradientFvPatchFields.H"

#include <cmath>

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

//- The dictionary of a name, or an error that it is missing
const Foam::dictionary& exchangeDict(const Foam::dictionary& dict)
{
    const Foam::word name("momentumExchange");
    return
        dict.found(name) ? dict.subDict(name) : Foam::dictionary::null;
}


//- 1 - exp(-z), z not below 0; as a series where it is short
Foam::scalar fallen(const Foam::scalar z)
{
    // Factors, as a division takes five times as long
    return
        z > 0.01
      ? -std::expm1(-z)
      : z*(1 - z*(1.0/2 - z*(1.0/6 - z*(1.0/24 - z*(1.0/120)))));
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::coupling::momentumExchange::place()
{
    const dem::bodies& state = dem_.state();
    ballCells_.find(state, kinds_, dem_.group().shared(), balls_);
    spread_->place(std::move(balls_));

    List<scalar> volume(state.size());
    forAll(volume, b)
    {
        volume[b] = kinds_.resolved(b) ? 0 : state.shapeOf(b).volume();
    }
    List<scalar> room;
    const UList<scalar>& ofBalls = ballCells_.share(volume, room);
    scalarField solids(spread_->spread(ofBalls));
    if (keepMoved_)
    {
        moved_ = solids;
    }
    excess_ = packing_.apply(mesh_, solids);
    if (keepMoved_)
    {
        moved_ = solids - moved_;
    }
    alpha_.primitiveFieldRef() = 1 - solids;
    alpha_.correctBoundaryConditions();

    // What there is, and what a sum over the field finds
    const scalar there = returnReduce(sum(ofBalls), sumOp<scalar>());
    const scalar found =
        gSum((1 - alpha_.primitiveField())*mesh_.V().field());
    volumeError_ = there > 0 ? mag(found/there - 1) : 0;
}


void Foam::coupling::momentumExchange::findImpulses()
{
    const dem::bodies& state = dem_.state();
    const scalar dt = mesh_.time().deltaTValue();
    const label n = state.size();
    const bool loses = forces_.loses();
    J_.setSize(n);
    response_.setSize(n);
    v_.setSize(n);
    if (!responds())
    {
        rest_ = List<vector>(n, vector(Zero));
    }

    for (label b = 0; b < n; ++b)
    {
        v_[b] = state.v[b];
        const vector slip = forces_.slipNear(b, v_[b]);
        const scalar k =
            state.drag || !feels_ ? forces_.rateNear(b, mag(slip)) : 0;
        const scalar m = state.mass[b];
        J_[b] = Zero;
        response_[b] = 0;
        if (kinds_.resolved(b))
        {
            continue;
        }
        J_[b] = loses ? dt*forces_.lostByFluid(b) : vector(Zero);
        if (responds())
        {
            response_[b] = theta_*m*fallen(k*dt);
            J_[b] += b < state.dragGiven.size()
              ? m*state.dragGiven[b]
              : vector(Zero);
        }
        else
        {
            const scalar K = m/forces_.massShare(b)*k;
            response_[b] = theta_*K*dt;
            J_[b] += K*dt*slip;
        }
    }
}


inline Foam::vector Foam::coupling::momentumExchange::impulse
(
    const label b
) const
{
    const dem::bodies& state = dem_.state();
    if (kinds_.resolved(b))
    {
        return Zero;
    }
    return
        J_[b]
      + (responds() ? state.mass[b]*(state.v[b] - v_[b]) : rest_[b]);
}


void Foam::coupling::momentumExchange::respond(const volVectorField& U)
{
    const vectorField change
    (
        U.primitiveField() - U.oldTime().primitiveField()
    );
    spread_->gather(change, seen_);

    dem::bodies& state = dem_.state();
    ballCells_.average(seen_, state.size());
    forAll(J_, b)
    {
        if (kinds_.resolved(b))
        {
            continue;
        }
        if (responds())
        {
            state.v[b] = v_[b] + response_[b]/state.mass[b]*seen_[b];
        }
        else
        {
            rest_[b] = response_[b]*seen_[b];
        }
        addToBodies(b);
    }
}


void Foam::coupling::momentumExchange::addToBodies(const label b)
{
    const vector J = impulse(b);
    toBodies_ += J;
    magnitudes_ += mag(J);
}


void Foam::coupling::momentumExchange::noteImpulses()
{
    if (!forces_.followsExchange())
    {
        return;
    }

    const dem::bodies& state = dem_.state();
    exchangedImpulse got;
    got.dt = mesh_.time().deltaTValue();
    got.step = mesh_.time().timeIndex();
    got.tau = spread_->spreadTime();
    got.onFaces = equations_ != averagedEquations::none;

    List<vector> offset(spread_->balls().size());
    forAll(offset, i)
    {
        offset[i] = spread_->offset(i);
    }
    ballCells_.average(offset, state.size());
    forAll(J_, b)
    {
        got.J = impulse(b);
        got.offset = offset[b];
        got.moved = dem_.moves() ? got.dt*state.v[b] : vector(Zero);
        forces_.noteExchange(b, got);
    }
}


void Foam::coupling::momentumExchange::checkDilute()
{
    const scalar least = leastAlpha();
    if (equations_ != averagedEquations::none || warned_ || least > 0.99)
    {
        return;
    }
    warned_ = true;
    WarningInFunction
        << "The void fraction has come down to " << least
        << ", but the equations of this solver have none: they are right for"
        << " bodies of up to 1 % of the volume." << nl
        << "    styxFoam solves the averaged equations." << endl;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::momentumExchange::momentumExchange
(
    const fvMesh& mesh,
    const cellBins& bins,
    bodyCells& centres,
    dem::demSolver& dem,
    const bodyKinds& kinds,
    const fluidDensity& rho,
    exchangedForces& forces,
    const dictionary& dict,
    const bool averaged,
    const bool feels
)
:
    mesh_(mesh),
    dem_(dem),
    kinds_(kinds),
    rho_(rho),
    forces_(forces),
    feels_(feels),
    spread_
    (
        voidFraction::New
        (
            mesh,
            bins,
            dem.period(),
            dict.subDict("voidFraction")
        )
    ),
    packing_(dict.subDict("voidFraction")),
    ballCells_(mesh, bins, centres),
    equations_(averagedEquations::none),
    theta_(1),
    alpha_
    (
        IOobject
        (
            "voidFraction",
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        ),
        mesh,
        dimensionedScalar("one", dimless, 1),
        zeroGradientFvPatchScalarField::typeName
    ),
    toBodies_(Zero),
    volumeError_(0),
    warned_(false)
{
    const dictionary& own = exchangeDict(dict);
    dem::checkKeys(own, {"equations", "drag"});
    const word set(dem::getChoice(own, "equations", {"A", "B"}, "A"));
    if (averaged)
    {
        equations_ = set == "A" ? averagedEquations::A : averagedEquations::B;
    }
    const word drag
    (
        dem::getChoice
        (
            own,
            "drag",
            {"implicit", "split", "explicit"},
            "implicit"
        )
    );
    theta_ = drag == "implicit" ? 1 : drag == "split" ? 0.5 : 0;
    Info<< "    void fraction " << spread_->type() << ", drag " << drag
        << " in the fluid, equations "
        << (averaged ? set : word("without a void fraction")) << endl;

    dem_.state().recordDrag = feels_;

    if (forces_.followsExchange() && spread_->spreadTime() < 0)
    {
        dem::badEntry
        (
            dict.subDict("voidFraction"),
            "type",
            "is " + spread_->type() + ", and undisturbedVelocity among the"
            " forces knows the wake of a Gaussian or of a cell only: take"
            " diffusion, kernel or centroid"
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::coupling::momentumExchange::start()
{
    place();
    alpha_.oldTime();
}


void Foam::coupling::momentumExchange::bodiesChanged()
{
    volScalarField& before = alpha_.oldTime();
    place();
    before == alpha_;
}


void Foam::coupling::momentumExchange::project()
{
    // The void fraction of before is the old one of the fluid's equations
    alpha_.oldTime();
    place();
    findImpulses();
    const scalar perTime = 1/mesh_.time().deltaTValue();
    F_ = perTime*spread(J_);
    K_ = perTime*spread(response_);
    checkDilute();
}


void Foam::coupling::momentumExchange::addTo(fvMatrix<vector>& eqn) const
{
    const vectorField& old = eqn.psi().oldTime().primitiveField();
    const scalarField& V = mesh_.V();
    const scalar density = rho_.isField() ? 1 : rho_.uniform();

    // The solver subtracts eqn from its own equation
    forAll(K_, c)
    {
        const scalar KV = K_[c]*V[c]/density;
        eqn.diag()[c] -= KV;
        eqn.source()[c] -= KV*old[c] - F_[c]*V[c]/density;
    }
}


void Foam::coupling::momentumExchange::finish(const volVectorField& U)
{
    toBodies_ = Zero;
    magnitudes_ = 0;
    if (dem_.group().any(J_.size() != dem_.state().size()))
    {
        return;
    }
    if (theta_ > 0)
    {
        respond(U);
    }
    else
    {
        forAll(J_, b)
        {
            addToBodies(b);
        }
    }
    toBodies_ = dem_.group().sum(toBodies_);
    magnitudes_ = dem_.group().sum(magnitudes_);
    noteImpulses();
}


void Foam::coupling::momentumExchange::meshChanged()
{
    spread_->meshChanged();
    ballCells_.meshChanged();
}


Foam::vector Foam::coupling::momentumExchange::toFluid
(
    const volVectorField& U
) const
{
    const vectorField& now = U.primitiveField();
    const vectorField& old = U.oldTime().primitiveField();
    return
       -mesh_.time().deltaTValue()
       *gSum((F_ + K_*(now - old))*mesh_.V().field());
}


Foam::scalar Foam::coupling::momentumExchange::leastAlpha() const
{
    return gMin(alpha_.primitiveField());
}


// ************************************************************************* //
