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
#include "dynamicRefineFvMesh.H"

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

//- A dictionary of the folder constant; empty if there is none
Foam::IOdictionary constantDict(const Foam::fvMesh& mesh, const char* name)
{
    using namespace Foam;

    return IOdictionary
    (
        IOobject
        (
            name,
            mesh.time().constant(),
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE,
            false
        )
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::caseCheck::surroundings Foam::demCloud::surroundings() const
{
    caseCheck::surroundings s;
    s.deltaT = mesh_.time().deltaTValue();
    s.restart = cloudState::found(mesh_);

    if (coupling_ == "none")
    {
        return s;
    }
    s.points = points_.valid();
    s.felt = exchanged_.valid();
    s.mixed = kinds_.mixed();
    s.hops =
        exchanged_.valid()
     && exchanged_->equations() != coupling::averagedEquations::none
     && dict_.subOrEmptyDict("voidFraction").getOrDefault<word>("type", "")
     == "centroid";
    s.rho = rho_->isField() ? 0 : rho_->uniform();

    const IOdictionary transport(constantDict(mesh_, "transportProperties"));
    if (transport.found("nu"))
    {
        s.nu = dimensionedScalar("nu", dimViscosity, transport).value();
    }

    s.film =
        dict_.subOrEmptyDict("immersed").found("lubrication")
     || dict_.subOrEmptyDict("forces").found("lubrication");
    s.nCorrectors = coupling::frictionReach::correctorsOf(mesh_);

    const IOdictionary meshDict(constantDict(mesh_, "dynamicMeshDict"));
    if
    (
        interface_.valid()
     && meshDict.getOrDefault<word>("dynamicFvMesh", "none")
     == dynamicRefineFvMesh::typeName
    )
    {
        s.levelsToCome =
            meshDict.optionalSubDict("dynamicRefineFvMeshCoeffs")
           .get<label>("maxRefinement");

        // One that runs is refined around its bodies before this is asked
        s.levels = isA<dynamicRefineFvMesh>(mesh_) ? 0 : s.levelsToCome;
    }
    return s;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::caseCheck Foam::demCloud::check(const bool thorough) const
{
    return caseCheck(mesh_, bins_, *dem_, surroundings(), thorough);
}


// ************************************************************************* //
