/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "pointMeans.H"
#include "pointConstraints.H"
#include "syncTools.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
Foam::tmp
<
    Foam::GeometricField<Type, Foam::pointPatchField, Foam::pointMesh>
>
Foam::coupling::pointMeans::at
(
    const GeometricField<Type, fvPatchField, volMesh>& field
) const
{
    const pointMesh& points = pointMesh::New(mesh_);
    auto means = tmp<GeometricField<Type, pointPatchField, pointMesh>>::New
    (
        IOobject
        (
            "pointMeans(" + field.name() + ')',
            field.instance(),
            points.thisDb()
        ),
        points,
        dimensioned<Type>(field.dimensions(), Zero)
    );
    Field<Type>& values = means.ref().primitiveFieldRef();

    for (const share& s : cells_)
    {
        values[s.point] += s.weight*field[s.of];
    }
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    for (const share& s : faces_)
    {
        const label patchi =
            patches.patchID()[s.of - mesh_.nInternalFaces()];
        values[s.point] += s.weight
           *field.boundaryField()[patchi][s.of - patches[patchi].start()];
    }
    syncTools::syncPointList
    (
        mesh_,
        values,
        plusEqOp<Type>(),
        pTraits<Type>::zero
    );

    // What symmetry planes allow
    pointConstraints::New(points).constrain(means.ref(), false);
    return means;
}


// ************************************************************************* //
