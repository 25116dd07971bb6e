/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "immersedMethod.H"
#include "allowedKeys.H"
#include "checkedEntry.H"
#include "SubList.H"
#include "readAhead.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace coupling
{
    defineTypeNameAndDebug(immersedMethod, 0);
    defineRunTimeSelectionTable(immersedMethod, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::coupling::immersedMethod::addCells
(
    const label b,
    const vector& shift
)
{
    const dem::bodies& state = present_();
    const bodyGeometry body(state, b, solved_, shift);
    const point centre = state.x[b] + shift;
    DynamicList<bodyCell>& cells = cells_[b];

    DynamicList<label> near(1024);
    bins_.forEach
    (
        centre,
        state.shapeOf(b).fluidRadius(),
        [&](const label c)
        {
            near.append(c);
        }
    );

    forAll(near, k)
    {
        readAhead::points(mesh_, near, k);
        const label c = near[k];
        const scalar beta = fraction_(body, c, bins_.radius(c));
        if (beta > 0)
        {
            bodyCell bc{c, beta, mesh_.cellCentres()[c] - centre};
            bc.tight = beta;
            bc.rho = rho_[c];
            if (beta < 1)
            {
                bc.phi = body.distance(mesh_.cellCentres()[c]);
                bc.n = body.normal(mesh_.cellCentres()[c]);
                bc.tight = tightFraction(body, bc);
            }
            cells.append(bc);
        }
    }
}


void Foam::coupling::immersedMethod::findCells(const label b)
{
    const dem::bodies& state = present_();

    cells_[b].clear();
    addCells(b, Zero);
    dem_.period().forEachImage
    (
        state.x[b],
        state.shapeOf(b).fluidRadius(),
        [&](const label image)
        {
            addCells(b, dem_.period().shift(image));
        }
    );
}


void Foam::coupling::immersedMethod::checkScheme() const
{
    const word scheme
    (
        mesh_.ddtScheme("ddt(U)")
    );
    if (dem_.moves() && scheme != "Euler")
    {
        FatalErrorInFunction
            << "Bodies that move need ddtSchemes { default Euler; } in "
            << mesh_.thisDb().time().system() << "/fvSchemes, not " << scheme
            << "." << nl
            << "    With backward and CrankNicolson the motion of a body is"
            << " not stable." << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::immersedMethod::immersedMethod
(
    const immersedScene& scene,
    const dictionary& dict
)
:
    mesh_(scene.mesh),
    bins_(scene.bins),
    dem_(scene.dem),
    kinds_(scene.kinds),
    rho_(scene.rho),
    kappa_(1000),
    viscousRate_(20),
    virtualMass_(1.5),
    solved_(vector::one),
    thickness_(0),
    // Cells that are long in an empty direction are cut deeper; bodies do not
    // move there, so it is done once
    fraction_(mesh_, mesh_.nSolutionD() < 3 ? 5 : 1),
    present_(mesh_, dem_),
    sides_(mesh_),
    open_(false),
    volumeError_(0),
    slip_(0)
{
    kappa_ = dem::getPositive(dict, "kappa", 1000);
    viscousRate_ = dem::getPositive(dict, "viscousRate", 20);
    virtualMass_ = dem::getInRange(dict, "virtualMass", 0, 10, 1.5);
    repeat_ = motionRepeat::New(mesh_, dict);

    for (direction d = 0; d < 3; ++d)
    {
        solved_[d] = mesh_.solutionD()[d] > 0 ? 1 : 0;
        if (!(solved_[d] > 0))
        {
            thickness_ = mesh_.bounds().span()[d];
        }
    }

    checkScheme();
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::coupling::immersedMethod>
Foam::coupling::immersedMethod::New
(
    const immersedScene& scene,
    const dictionary& dict,
    const bool asks
)
{
    const word type
    (
        dem::getChoice
        (
            dict,
            "type",
            dictionaryConstructorTablePtr_->sortedToc()
        )
    );
    autoPtr<immersedMethod> method
    (
        dictionaryConstructorTablePtr_->cfind(type).val()(scene, dict)
    );
    if (method->asksSolver() && !asks)
    {
        dem::badEntry
        (
            dict,
            "type",
            "is " + type + ", which acts in each pressure corrector or after"
            " the last; the solver must ask for that.\n"
            "    Run styxFoam, or take type implicitForcing, which needs no"
            " more than fvOptions"
        );
    }
    return method;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::coupling::immersedMethod::commonKeys(const wordList& more)
{
    wordList keys
    ({
        "type", "kappa", "viscousRate", "virtualMass", "outerCorrectors",
        "lubrication"
    });
    keys.append(more);
    return keys;
}


void Foam::coupling::immersedMethod::project(const volVectorField& U)
{
    findPresent();
    const dem::bodies& state = present_();
    const label n = state.size();

    cells_.setSize(n);
    imposed_.setSize(n);
    List<scalar> volume(n, scalar(0));

    sides_.update();

    links_.clear();
    for (label b = 0; b < n; ++b)
    {
        imposed_[b] = imposedMotion{state.v[b], state.omega[b]};
        cells_[b].clear();
        if (!kinds_.resolved(b))
        {
            continue;
        }
        findCells(b);
        for (const bodyCell& bc : cells_[b])
        {
            volume[b] += bc.beta*mesh_.V()[bc.cell];
        }
    }

    findFriction();

    present_.sum(volume);
    volumeError_ = 0;
    if (solved_ == vector::one)
    {
        forAll(volume, b)
        {
            const scalar exact = state.shapeOf(b).fluidVolume();
            if (kinds_.resolved(b))
            {
                volumeError_ = max(volumeError_, mag(volume[b]/exact - 1));
            }
        }
        volumeError_ = dem_.group().max(volumeError_);
    }

    startImposed(U);
    if (repeat_.valid())
    {
        repeat_->start(imposed_);
    }
    cellsFound();
    open_ = true;
}


void Foam::coupling::immersedMethod::findViscosity(const faceViscosity& nu)
{
    if (!dem_.moves())
    {
        return;
    }
    viscosity_.setSize(cells_.size());
    viscosity_ = 0;
    forAll(cells_, b)
    {
        for (const bodyCell& bc : cells_[b])
        {
            if (bc.beta < 1)
            {
                viscosity_[b] = max(viscosity_[b], nu.inCell(bc.cell));
            }
        }
    }
    present_.max(viscosity_);
}


bool Foam::coupling::immersedMethod::asksSolver() const
{
    return false;
}


Foam::label Foam::coupling::immersedMethod::imposes() const
{
    return 0;
}


Foam::scalar Foam::coupling::immersedMethod::slip() const
{
    return slip_;
}


void Foam::coupling::immersedMethod::assemble()
{
    diagonal_.setSize(mesh_.nCells());
    diagonal_ = 0;
    source_.setSize(mesh_.nCells());
    source_ = vector(Zero);

    forAll(cells_, b)
    {
        for (bodyCell& bc : cells_[b])
        {
            bc.rho = rho_[bc.cell];
            const scalar V = mesh_.V()[bc.cell]*(rho_.isField() ? bc.rho : 1);
            const scalar KV = bc.K*V;
            diagonal_[bc.cell] += KV;
            source_[bc.cell] += KV*bc.target + V*bc.push;
        }
    }
}


void Foam::coupling::immersedMethod::addTo(fvMatrix<vector>& eqn)
{
    if (repeat_.valid())
    {
        repeat_->next(dem_.state(), imposed_);
    }
    const knownFlow flow(sides_, eqn.psi());
    findViscosity(flow.nu);
    setForcing(flow);
    assemble();

    // The solver subtracts eqn from its own equation
    eqn.diag() -= diagonal_;
    eqn.source() -= source_;
}


void Foam::coupling::immersedMethod::sumForces(const volVectorField& U)
{
    force_.setSize(cells_.size());
    torque_.setSize(cells_.size());

    forAll(cells_, b)
    {
        vector F(Zero);
        vector T(Zero);
        for (const bodyCell& bc : cells_[b])
        {
            const vector f =
                (bc.rho*mesh_.V()[bc.cell])
               *(bc.K*(U[bc.cell] - bc.target) - bc.push);
            F += f;
            T += bc.r ^ f;
        }
        force_[b] = F;
        torque_[b] = T;
    }

    present_.sum(force_);
    present_.sum(torque_);
    answered(U);
}


void Foam::coupling::immersedMethod::sumFriction(const volVectorField& U)
{
    const faceViscosity nu(mesh_);

    friction_.setSize(cells_.size());
    frictionTorque_.setSize(cells_.size());
    forAll(cells_, b)
    {
        vector F(Zero);
        vector T(Zero);
        const imposedMotion& w = imposed_[b];
        for (const bodyCell& bc : cells_[b])
        {
            const vector& UP = U[bc.cell];
            for (label k = bc.link; k < bc.link + bc.nLinks; ++k)
            {
                const wallLink& l = links_[k];
                const vector f =
                    (bc.rho*mesh_.V()[bc.cell]*nu(l.face, bc.cell)*l.g)
                   *((1/l.theta - 1)*(UP - w.at(bc.r)) + UP - w.at(l.r));
                F += f;
                T += (bc.r + l.theta*(l.r - bc.r)) ^ f;
            }
        }
        friction_[b] = F;
        frictionTorque_[b] = T;
    }

    present_.sum(friction_);
    present_.sum(frictionTorque_);
}


Foam::vector Foam::coupling::immersedMethod::forceOnFluid
(
    const volVectorField& U
) const
{
    vector F(Zero);
    forAll(source_, c)
    {
        F += source_[c] - diagonal_[c]*U[c];
    }
    return
        (rho_.isField() ? 1 : rho_.uniform())
       *returnReduce(F, sumOp<vector>());
}


Foam::vector Foam::coupling::immersedMethod::forceOnBodies
(
    scalar& magnitudes
) const
{
    const label n = min(force_.size(), dem_.state().size());
    const SubList<vector> own(force_, n);
    magnitudes = dem_.group().sum(sum(mag(own)()));
    return dem_.group().sum(sum(own));
}


// ************************************************************************* //
