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
#include "mathematicalConstants.H"
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


bool Foam::coupling::dividedFraction::isWithin(const cellBall& ball) const
{
    for (const label f : mesh_.cells()[ball.cell])
    {
        const pointHit nearest =
            mesh_.faces()[f].nearestPoint(ball.x, mesh_.points());
        if (nearest.distance() < reach(ball))
        {
            return false;
        }
    }
    return true;
}


void Foam::coupling::dividedFraction::weigh
(
    const cellBall& ball,
    DynamicList<label>& cells,
    DynamicList<scalar>& weights
) const
{
    if (ball.cell >= 0 && isWithin(ball))
    {
        cells.append(ball.cell);
        weights.append
        (
            4.0/3.0*constant::mathematical::pi*pow3(ball.r)
        );
        return;
    }
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
