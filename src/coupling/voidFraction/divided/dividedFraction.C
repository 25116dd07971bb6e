/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "dividedFraction.H"
#include "allowedKeys.H"
#include "bodyGeometry.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace coupling
{
    defineTypeNameAndDebug(dividedFraction, 0);
    addToRunTimeSelectionTable(voidFraction, dividedFraction, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::coupling::dividedFraction::reach
(
    const cellBall& ball
) const
{
    // The share of a cell that a ball nearly touches is about zero, not zero:
    // such a cell has it on another rank, too
    return 1.1*ball.r;
}


void Foam::coupling::dividedFraction::weigh
(
    const cellBall& ball,
    DynamicList<label>& cells,
    DynamicList<scalar>& weights
) const
{
    const bodyGeometry sphere(bodyGeometry::sphere(ball.x, ball.r));
    bins_.forEach
    (
        ball.x,
        ball.r,
        [&](const label c)
        {
            const scalar inside = fraction_(sphere, c, bins_.radius(c));
            if (inside > 0 || c == ball.cell)
            {
                // Its own cell has a weight, be the rest of it in a wall
                cells.append(c);
                weights.append
                (
                    mesh_.cellVolumes()[c]*max(inside, scalar(1e-12))
                );
            }
        }
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::dividedFraction::dividedFraction
(
    const polyMesh& mesh,
    const cellBins& bins,
    const dem::periodicity& period,
    const dictionary& dict
)
:
    weightedFraction(mesh, bins, period),
    fraction_(mesh)
{
    dem::checkKeys(dict, commonKeys({}));
}


// ************************************************************************* //
