/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "faceSides.H"
#include "surfaceFields.H"
#include "volFields.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::faceSides::faceSides(const fvMesh& mesh)
:
    mesh_(mesh)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::coupling::faceSides::update()
{
    // Made on demand by all ranks together: not by those alone that have faces
    // at a body
    mesh_.nonOrthDeltaCoeffs();

    delta_.setSize(mesh_.boundary().size());
    forAll(delta_, p)
    {
        delta_[p] =
            mesh_.boundary()[p].coupled()
          ? vectorField(mesh_.boundary()[p].delta())
          : vectorField();
    }
}


bool Foam::coupling::faceSides::across
(
    const label face,
    const label cell,
    vector& d
) const
{
    if (mesh_.isInternalFace(face))
    {
        const label o = mesh_.faceOwner()[face];
        const label other = o == cell ? mesh_.faceNeighbour()[face] : o;
        d = mesh_.cellCentres()[other] - mesh_.cellCentres()[cell];
        return true;
    }

    const label p = mesh_.boundaryMesh().whichPatch(face);
    if (delta_[p].empty())
    {
        return false;
    }
    d = delta_[p][face - mesh_.boundary()[p].start()];
    return true;
}


Foam::scalar Foam::coupling::faceSides::conductance
(
    const label face
) const
{
    if (mesh_.isInternalFace(face))
    {
        return mesh_.magSf()[face]*mesh_.nonOrthDeltaCoeffs()[face];
    }
    const label p = mesh_.boundaryMesh().whichPatch(face);
    const label k = face - mesh_.boundary()[p].start();
    return
        mesh_.magSf().boundaryField()[p][k]
       *mesh_.nonOrthDeltaCoeffs().boundaryField()[p][k];
}


const Foam::vector& Foam::coupling::faceSides::value
(
    const label face,
    const label cell,
    const volVectorField& U,
    const List<vectorField>& otherU
) const
{
    if (mesh_.isInternalFace(face))
    {
        const label o = mesh_.faceOwner()[face];
        return U[o == cell ? mesh_.faceNeighbour()[face] : o];
    }
    const label p = mesh_.boundaryMesh().whichPatch(face);
    return otherU[p][face - mesh_.boundary()[p].start()];
}


Foam::List<Foam::vectorField> Foam::coupling::faceSides::otherSide
(
    const volVectorField& U
) const
{
    List<vectorField> other(mesh_.boundary().size());
    forAll(other, p)
    {
        if (mesh_.boundary()[p].coupled())
        {
            other[p] = U.boundaryField()[p].patchNeighbourField();
        }
    }
    return other;
}


// ************************************************************************* //
