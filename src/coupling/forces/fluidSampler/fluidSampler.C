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
    const labelUList& mine,
    const labelUList& cells,
    const Setter& set
) const
{
    if (linear())
    {
        weights_.interpolate
        (
            field,
            [&](const label k, const Type& value) { set(mine[k], value); }
        );
        return;
    }
    const auto at = Foam::interpolation<Type>::New(scheme_, field);
    forAll(mine, k)
    {
        set(mine[k], at->interpolate(points[mine[k]], cells[k]));
    }
}


void Foam::coupling::fluidSampler::sampleDerived
(
    const volVectorField& U,
    const UList<point>& points,
    const labelUList& mine,
    const labelUList& cells
)
{
    if (needs(fluidAtPoint::stressDivergence))
    {
        interpolate
        (
            laplacian(U)(),
            points,
            mine,
            cells,
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
            mine,
            cells,
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
            mine,
            cells,
            [&](const label b, const vector& value)
            {
                derived_[b].DuDt = value;
            }
        );
    }
}


void Foam::coupling::fluidSampler::samplePressure
(
    const UList<point>& points,
    const labelUList& mine,
    const labelUList& cells
)
{
    const volScalarField& p = lookup<volScalarField>("p").oldTime();
    const bool kinematic = p.dimensions() != dimPressure;
    const bool weighs = mesh_.foundObject<volScalarField>("p_rgh");
    interpolate
    (
        gradient(p)(),
        points,
        mine,
        cells,
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


void Foam::coupling::fluidSampler::sampleTurbulence
(
    const labelUList& mine,
    const labelUList& cells
)
{
    const auto& k = lookup<volScalarField>("k").oldTime();
    const bool omega = !mesh_.foundObject<volScalarField>("epsilon");
    const auto& rate =
        lookup<volScalarField>(omega ? "omega" : "epsilon").oldTime();
    forAll(mine, i)
    {
        derivedFluid& f = derived_[mine[i]];
        f.k = k[cells[i]];
        f.epsilon = omega ? 0.09*f.k*rate[cells[i]] : rate[cells[i]];
    }
}


void Foam::coupling::fluidSampler::sampleCells
(
    const UList<point>& points,
    const labelUList& mine,
    const labelUList& cells
)
{
    forAll(mine, i)
    {
        derivedFluid& f = derived_[mine[i]];
        f.cellSize = std::cbrt(mesh_.V()[cells[i]]);
        f.toCentre = mesh_.C()[cells[i]] - points[mine[i]];
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


Foam::labelList Foam::coupling::fluidSampler::ownPoints
(
    const labelUList& cellOf
) const
{
    // On faces between ranks the cell with the largest claim has a point
    List<scalar> claim(cellOf.size(), -GREAT);
    forAll(cellOf, b)
    {
        if (cellOf[b] >= 0)
        {
            claim[b] = cellBins::claim(mesh_.cellCentres()[cellOf[b]]);
        }
    }
    const List<scalar> own(Pstream::parRun() ? claim : List<scalar>());
    dem::maxOverRanks(claim);
    DynamicList<label> mine(cellOf.size());
    forAll(cellOf, b)
    {
        if (cellOf[b] >= 0 && (own.empty() || own[b] == claim[b]))
        {
            mine.append(b);
        }
    }
    return labelList(std::move(mine));
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
    const volScalarField* voidFraction
)
{
    const labelList mine(ownPoints(cellOf));
    clear(points.size(), Pstream::parRun() || mine.size() < points.size());
    const labelList cells(UIndirectList<label>(cellOf, mine));

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
        weights_.find(points, mine, cells);
    }
    const scalarField cellNu(nu_(cells));
    forAll(mine, k)
    {
        sampledFluid& f = fluid_[mine[k]];
        f.rho = rho_[cells[k]];
        f.nu = cellNu[k];
        f.voidFraction = 1;
    }
    interpolate
    (
        U,
        points,
        mine,
        cells,
        [&](const label b, const vector& value) { fluid_[b].u = value; }
    );
    if (voidFraction)
    {
        interpolate
        (
            *voidFraction,
            points,
            mine,
            cells,
            [&](const label b, const scalar value)
            {
                fluid_[b].voidFraction = value;
            }
        );
    }
    sampleDerived(U, points, mine, cells);
    if (needs(fluidAtPoint::pressureGradient))
    {
        samplePressure(points, mine, cells);
    }
    if (needs(fluidAtPoint::turbulence))
    {
        sampleTurbulence(mine, cells);
    }
    if (needs(fluidAtPoint::cell))
    {
        sampleCells(points, mine, cells);
    }
    if (Pstream::parRun())
    {
        share(fluid_);
        share(derived_);
    }
}


// ************************************************************************* //
