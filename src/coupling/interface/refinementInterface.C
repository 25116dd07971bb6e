/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "refinementInterface.H"
#include "bodyGeometry.H"
#include "allowedKeys.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::refinementInterface::refinementInterface
(
    const fvMesh& mesh,
    const cellBins& bins,
    const dictionary& dict
)
:
    mesh_(mesh),
    bins_(bins),
    layer_(0.3),
    field_
    (
        IOobject
        (
            "interface",
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        ),
        mesh,
        dimensionedScalar(dimless, Zero)
    )
{
    dem::checkKeys(dict, {"layer"});
    layer_ = dem::getNonNegative(dict, "layer", 0.3);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::coupling::refinementInterface::mark
(
    const dem::bodies& state,
    const scalar ahead
)
{
    scalarField& value = field_.primitiveFieldRef();
    value = 0;

    vector solved(vector::one);
    for (direction d = 0; d < 3; ++d)
    {
        solved[d] = mesh_.solutionD()[d] > 0 ? 1 : 0;
    }

    forAll(state.x, b)
    {
        const bodyGeometry body(state, b, solved);
        const dem::shape& s = state.shapeOf(b);
        const scalar motion =
            ahead
           *(mag(state.v[b]) + mag(state.omega[b])*s.boundingRadius());
        const scalar inner = layer_*s.equivalentDiameter() + motion;
        const scalar outer = 1.5*inner;

        bins_.forEach
        (
            state.x[b],
            s.boundingRadius() + outer,
            [&](const label c)
            {
                // The cell's edge over its diagonal is 0.58 for a cube
                const scalar nearest =
                    body.distance(mesh_.C()[c]) - 0.6*bins_.radius(c);
                if (nearest < inner)
                {
                    value[c] = 1;
                }
                else if (nearest < outer)
                {
                    value[c] = max(value[c], 0.7);
                }
            }
        );
    }

    field_.correctBoundaryConditions();
}


// ************************************************************************* //
