/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "fluidSampler.H"
#include "cellBins.H"
#include "correctedSnGrad.H"
#include "fixedGradientFvPatchFields.H"
#include "fvcSurfaceIntegrate.H"
#include "gaussGrad.H"
#include "interpolation.H"
#include "linear.H"
#include "rankSum.H"
#include "volFields.H"

#include <cmath>

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Gauss' gradient, linear, whatever fvSchemes says
template<class Type>
auto gradient(const GeometricField<Type, fvPatchField, volMesh>& f)
{
    auto grad = fv::gaussGrad<Type>::gradf
    (
        linearInterpolate(f),
        "grad(" + f.name() + ')'
    );
    fv::gaussGrad<Type>::correctBoundaryConditions(f, grad.ref());
    return grad;
}


//- The Laplacian of the velocity
tmp<volVectorField> laplacian(const volVectorField& U)
{
    return fvc::surfaceIntegrate
    (
        U.mesh().magSf()*fv::correctedSnGrad<vector>(U.mesh()).snGrad(U)
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class FieldType>
const FieldType& Foam::coupling::fluidSampler::lookup(const word& name) const
{
    const FieldType* found = mesh_.findObject<FieldType>(name);
    if (!found)
    {
        FatalIOErrorInFunction(forces_)
            << "A force needs the field " << name << " ("
            << FieldType::typeName << "), but the solver has none." << nl
            << "    Fields of this type: "
            << mesh_.sortedNames<FieldType>() << exit(FatalIOError);
    }
    return *found;
}


template<class Type, class Setter>
void Foam::coupling::fluidSampler::interpolate
(
    const GeometricField<Type, fvPatchField, volMesh>& field,
    const UList<point>& points,
    const Setter& set
) const
{
    if (linear())
    {
        weights_.interpolate
        (
            field,
            [&](const label k, const Type& value) { set(mine_[k], value); }
        );
        return;
    }
    const auto at = Foam::interpolation<Type>::New(scheme_, field);
    forAll(mine_, k)
    {
        set(mine_[k], at->interpolate(points[mine_[k]], cells_[k]));
    }
}


void Foam::coupling::fluidSampler::sampleDerived
(
    const volVectorField& U,
    const UList<point>& points
)
{
    if (needs(fluidAtPoint::stressDivergence))
    {
        interpolate
        (
            laplacian(U)(),
            points,
            [&](const label b, const vector& value)
            {
                derived_[b].divTau = fluid_[b].rho*fluid_[b].nu*value;
            }
        );
    }
    if
    (
        !needs(fluidAtPoint::acceleration) && !needs(fluidAtPoint::vorticity)
    )
    {
        return;
    }

    const tmp<volTensorField> gradU(gradient(U));
    if (needs(fluidAtPoint::vorticity))
    {
        interpolate
        (
            gradU(),
            points,
            [&](const label b, const tensor& value)
            {
                derived_[b].curlU = 2*(*skew(value));
            }
        );
    }
    if (needs(fluidAtPoint::acceleration))
    {
        const dimensionedScalar dt
        (
            "dt",
            dimTime,
            mesh_.time().deltaT0Value()
        );
        interpolate
        (
            ((U - U.oldTime())/dt + (U & gradU()))(),
            points,
            [&](const label b, const vector& value)
            {
                derived_[b].DuDt = value;
            }
        );
    }
}


void Foam::coupling::fluidSampler::samplePressure(const UList<point>& points)
{
    const volScalarField& p = lookup<volScalarField>("p").oldTime();
    const bool kinematic = p.dimensions() != dimPressure;
    const bool weighs = mesh_.foundObject<volScalarField>("p_rgh");
    tmp<volVectorField> gradP(gradient(p));
    forAll(p.boundaryField(), patch)
    {
        // What was the old field keeps values at its patches, not gradients
        const fvPatchScalarField& side = p.boundaryField()[patch];
        if (isA<fixedGradientFvPatchScalarField>(side))
        {
            const vectorField n(side.patch().nf());
            fvPatchVectorField& g = gradP.ref().boundaryFieldRef()[patch];
            g += n*(side.fvPatchScalarField::snGrad() - (n & g));
        }
    }
    interpolate
    (
        gradP(),
        points,
        [&](const label b, const vector& value)
        {
            const scalar rho = fluid_[b].rho;
            derived_[b].gradP = kinematic ? rho*value : value;
            if (weighs)
            {
                derived_[b].gradP -= rho*g_;
            }
        }
    );
}


void Foam::coupling::fluidSampler::sampleTurbulence()
{
    const auto& k = lookup<volScalarField>("k").oldTime();
    const bool omega = !mesh_.foundObject<volScalarField>("epsilon");
    const auto& rate =
        lookup<volScalarField>(omega ? "omega" : "epsilon").oldTime();
    forAll(mine_, i)
    {
        derivedFluid& f = derived_[mine_[i]];
        f.k = k[cells_[i]];
        f.epsilon = omega ? 0.09*f.k*rate[cells_[i]] : rate[cells_[i]];
    }
}


void Foam::coupling::fluidSampler::sampleCells(const UList<point>& points)
{
    forAll(mine_, i)
    {
        derivedFluid& f = derived_[mine_[i]];
        f.cellSize = std::cbrt(mesh_.V()[cells_[i]]);
        f.toCentre = mesh_.cellCentres()[cells_[i]] - points[mine_[i]];
        f.ownShare = 1;
        if (scheme_ == "cell")
        {
            continue;
        }

        // Linear from the centre, all its own, to the surface, where it is a
        // mean
        scalar out = 0;
        for (direction d = 0; d < 3; ++d)
        {
            out = max(out, 2*mag(f.toCentre[d])/f.cellSize);
        }
        f.ownShare = 1 - min(out, scalar(1));
    }
}


void Foam::coupling::fluidSampler::findOwn
(
    const labelUList& cellOf,
    const bool hosted
)
{
    if (!Pstream::parRun() && !cellOf.found(-1))
    {
        if (mine_.size() != cellOf.size())
        {
            mine_ = identity(cellOf.size());
        }
        cells_ = cellOf;
        return;
    }

    // On faces between ranks the cell with the largest claim has a point;
    // hosts have seen to it
    List<scalar> own(Pstream::parRun() && !hosted ? cellOf.size() : 0, -GREAT);
    forAll(own, b)
    {
        if (cellOf[b] >= 0)
        {
            own[b] = cellBins::claim(mesh_.cellCentres()[cellOf[b]]);
        }
    }
    List<scalar> claim(own);
    dem::maxOverRanks(claim);

    mine_.clear();
    cells_.clear();
    forAll(cellOf, b)
    {
        if (cellOf[b] >= 0 && (own.empty() || own[b] == claim[b]))
        {
            mine_.append(b);
            cells_.append(cellOf[b]);
        }
    }
}


void Foam::coupling::fluidSampler::sampleLinear
(
    const UList<point>& points,
    const volVectorField& U,
    const volScalarField* voidFraction
)
{
    // All at once, and weights that are kept only if there are other fields
    const pointMeans& means = pointMeans::New(mesh_);
    const auto pointU(means.at(U));
    const vectorField& uOfCells = U.primitiveField();
    const vectorField& uOfPoints = pointU().primitiveField();
    tmp<pointScalarField> pointAlpha;
    if (voidFraction)
    {
        pointAlpha = means.at(*voidFraction);
    }
    const scalarField& ofCells =
        voidFraction ? voidFraction->primitiveField() : scalarField::null();
    const scalarField& ofPoints =
        voidFraction ? pointAlpha().primitiveField() : scalarField::null();

    const volScalarField* nu = nu_.field();
    weights_.find
    (
        points,
        mine_,
        cells_,
        needs_,
        [&](const label k, const pointWeights::weighted& w)
        {
            sampledFluid& f = fluid_[mine_[k]];
            f.u = w.of(uOfCells, uOfPoints);
            f.rho = rho_[w.cell];
            f.nu = nu ? (*nu)[w.cell] : nu_.uniform();
            f.voidFraction = voidFraction ? w.of(ofCells, ofPoints) : 1;
        }
    );
}


void Foam::coupling::fluidSampler::sampleKnown
(
    const UList<point>& points,
    const volVectorField& U,
    const volScalarField* voidFraction
)
{
    if (linear())
    {
        sampleLinear(points, U, voidFraction);
        return;
    }
    const volScalarField* nu = nu_.field();
    forAll(mine_, k)
    {
        sampledFluid& f = fluid_[mine_[k]];
        f.rho = rho_[cells_[k]];
        f.nu = nu ? (*nu)[cells_[k]] : nu_.uniform();
        f.voidFraction = 1;
    }
    interpolate
    (
        U,
        points,
        [&](const label b, const vector& value) { fluid_[b].u = value; }
    );
    if (voidFraction)
    {
        interpolate
        (
            *voidFraction,
            points,
            [&](const label b, const scalar value)
            {
                fluid_[b].voidFraction = value;
            }
        );
    }
}


template<class Struct>
void Foam::coupling::fluidSampler::share(List<Struct>& list)
{
    // The points of other ranks are 0 here, so that a sum is a copy
    static_assert(sizeof(Struct) % sizeof(scalar) == 0, "a list of numbers");
    const label stride = sizeof(Struct)/sizeof(scalar);
    scalar* values = reinterpret_cast<scalar*>(list.data());
    List<scalar> all(UList<scalar>(values, stride*list.size()));
    dem::sumOverRanks(all);
    std::copy(all.begin(), all.end(), values);
}


void Foam::coupling::fluidSampler::clear(const label n, const bool all)
{
    // What is found is set or added up: a sum over the ranks follows, and
    // nobody's point is in no fluid
    fluid_.setSize(n);
    if (all)
    {
        sampledFluid none;
        none.voidFraction = 0;
        fluid_ = none;
    }
    derived_.setSize(needs_ ? n : 0);
    derivedFluid none;
    none.ownShare = 0;
    derived_ = none;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::fluidSampler::fluidSampler
(
    const fvMesh& mesh,
    const fluidDensity& rho,
    const dictionary& fluid,
    const dictionary& forces,
    const vector& g,
    const word& scheme,
    const unsigned needs
)
:
    mesh_(mesh),
    rho_(rho),
    nu_(mesh, fluid),
    forces_(forces),
    g_(g),
    scheme_(scheme),
    needs_(0),
    weights_(mesh)
{
    setNeeds(needs);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::coupling::fluidSampler::setNeeds(const unsigned needed)
{
    const unsigned before = needs_;
    needs_ = needed;
    if (before && !(needed & ~before))
    {
        return;
    }

    // From here on the solver keeps the old time levels
    const volVectorField& U = lookup<volVectorField>("U").oldTime();
    if (needs(fluidAtPoint::acceleration))
    {
        U.oldTime();
    }
    if (needs(fluidAtPoint::pressureGradient))
    {
        lookup<volScalarField>("p").oldTime();
    }
    if (needs(fluidAtPoint::turbulence))
    {
        lookup<volScalarField>("k").oldTime();
        lookup<volScalarField>
        (
            mesh_.foundObject<volScalarField>("epsilon") ? "epsilon" : "omega"
        ).oldTime();
    }
}


void Foam::coupling::fluidSampler::sample
(
    const UList<point>& points,
    const labelUList& cellOf,
    const volVectorField& U,
    const volScalarField* voidFraction,
    const pointHosts* hosts
)
{
    findOwn(cellOf, hosts);
    clear(points.size(), Pstream::parRun() || mine_.size() < points.size());

    // Decomposition of cells and point values are made by all ranks
    mesh_.tetBasePtIs();
    if (linear())
    {
        const label version = pointMeans::New(mesh_).version();
        if (version != version_)
        {
            weights_.forget();
            version_ = version;
        }
    }
    sampleKnown(points, U, voidFraction);
    sampleDerived(U, points);
    if (needs(fluidAtPoint::pressureGradient))
    {
        samplePressure(points);
    }
    if (needs(fluidAtPoint::turbulence))
    {
        sampleTurbulence();
    }
    if (needs(fluidAtPoint::cell))
    {
        sampleCells(points);
    }
    if (hosts)
    {
        hosts->bringHome(fluid_);
        if (needs_)
        {
            hosts->bringHome(derived_);
        }
    }
    else if (Pstream::parRun())
    {
        share(fluid_);
        share(derived_);
    }
}


// ************************************************************************* //
