/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "diffusionFraction.H"
#include "allowedKeys.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace coupling
{
    defineTypeNameAndDebug(diffusionFraction, 0);
    addToRunTimeSelectionTable(voidFraction, diffusionFraction, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::coupling::diffusionFraction::placed()
{
    if (!laplacian_.valid())
    {
        laplacian_.reset(new cellLaplacian(mesh_));
        decay_.expand(tau_*laplacian_->bound());
    }
}


void Foam::coupling::diffusionFraction::diffuse(scalarField& x) const
{
    decay_.apply
    (
        [this](const scalarField& from, scalarField& to)
        {
            laplacian_->apply(from, to);
            to *= tau_;
        },
        x
    );
}


void Foam::coupling::diffusionFraction::diffuse(vectorField& x) const
{
    for (direction d = 0; d < 3; ++d)
    {
        scalarField part(x.component(d));
        diffuse(part);
        x.replace(d, part);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::diffusionFraction::diffusionFraction
(
    const polyMesh& mesh,
    const cellBins& bins,
    const dem::periodicity& period,
    const dictionary& dict
)
:
    voidFraction(mesh, bins, period),
    tau_(0.25*sqr(dem::getPositive(dict, "bandwidth"))),
    decay_
    (
        dem::getChoice(dict, "scheme", decay::schemes(), "exact"),
        dem::getLabel(dict, "steps", 1, 3),
        dem::getInRange(dict, "tolerance", 1e-12, 1e-3, 1e-9)
    )
{
    dem::checkKeys
    (
        dict,
        commonKeys({"bandwidth", "scheme", "steps", "tolerance"})
    );
    if (dict.found("steps") && !dict.found("scheme"))
    {
        dem::badEntry
        (
            dict,
            "steps",
            "belongs to scheme implicitEuler or LStable; the scheme is exact"
        );
    }
}


// ************************************************************************* //
