/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "faceViscosity.H"
#include "linear.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::faceViscosity::faceViscosity(const fvMesh& mesh)
:
    nu_(mesh.lookupObject<volScalarField>("nu")),
    nut_(mesh.findObject<volScalarField>("nut"))
{
    if (nut_)
    {
        both_ = linearInterpolate(nu_ + *nut_);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::coupling::faceViscosity::operator()
(
    const label face,
    const label cell
) const
{
    if (!nut_)
    {
        return nu_[cell];
    }
    const fvMesh& mesh = nu_.mesh();
    if (mesh.isInternalFace(face))
    {
        return both_()[face];
    }
    const label p = mesh.boundaryMesh().whichPatch(face);
    return both_().boundaryField()[p][face - mesh.boundary()[p].start()];
}


// ************************************************************************* //
