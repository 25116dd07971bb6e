/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "centroidFraction.H"
#include "allowedKeys.H"
#include "mathematicalConstants.H"
#include "PstreamReduceOps.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace coupling
{
    defineTypeNameAndDebug(centroidFraction, 0);
    addToRunTimeSelectionTable(voidFraction, centroidFraction, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::coupling::centroidFraction::placed()
{
    if (warned_)
    {
        return;
    }

    // Of the ball and the cell; a cell holds a ball of its own width if they
    // are 0.52
    const scalar full = constant::mathematical::pi/6;
    scalar ratio = 0;
    const bool mayBe =
        8*full*pow3(largest_) > full*min(mesh_.cellVolumes());
    for (label i = 0; mayBe && i < balls_.size(); ++i)
    {
        const cellBall& b = balls_[i];
        const scalar volume = 4*constant::mathematical::pi/3*pow3(b.r);
        ratio = max(ratio, volume/mesh_.cellVolumes()[b.cell]);
    }
    reduce(ratio, maxOp<scalar>());
    if (ratio > full)
    {
        warned_ = true;
        WarningInFunction
            << "A sphere has " << ratio << " times the volume of the cell"
            << " that holds its centre, which voidFraction centroid puts it"
            << " into as a whole." << nl
            << "    Take voidFraction diffusion, which does for cells of any"
            << " size, or cells of three diameters." << endl;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::centroidFraction::centroidFraction
(
    const polyMesh& mesh,
    const cellBins& bins,
    const dem::periodicity& period,
    const dictionary& dict
)
:
    voidFraction(mesh, bins, period),
    warned_(false)
{
    dem::checkKeys(dict, commonKeys({}));
}


// ************************************************************************* //
