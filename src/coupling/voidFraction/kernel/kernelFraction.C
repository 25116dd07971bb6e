/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "kernelFraction.H"
#include "allowedKeys.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace coupling
{
    defineTypeNameAndDebug(kernelFraction, 0);
    addToRunTimeSelectionTable(voidFraction, kernelFraction, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::coupling::kernelFraction::reach(const cellBall&) const
{
    return 3*b_;
}


void Foam::coupling::kernelFraction::weigh
(
    const cellBall& ball,
    DynamicList<label>& cells,
    DynamicList<scalar>& weights
) const
{
    bins_.forEach
    (
        ball.x,
        3*b_,
        [&](const label c)
        {
            const scalar d2 = magSqr(mesh_.cellCentres()[c] - ball.x)/sqr(b_);
            if (d2 < 9 || c == ball.cell)
            {
                cells.append(c);
                weights.append(mesh_.cellVolumes()[c]*exp(-d2));
            }
        }
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::kernelFraction::kernelFraction
(
    const polyMesh& mesh,
    const cellBins& bins,
    const dem::periodicity& period,
    const dictionary& dict
)
:
    weightedFraction(mesh, bins, period),
    b_(dem::getPositive(dict, "bandwidth"))
{
    dem::checkKeys(dict, commonKeys({"bandwidth"}));
}


// ************************************************************************* //
