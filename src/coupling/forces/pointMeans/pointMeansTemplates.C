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

    // Point by point: a sum in memory would wait for itself
    for (label i = 0; i < cells_.size();)
    {
        const label pointi = cells_[i].point;
        Type sum = pTraits<Type>::zero;
        for (; i < cells_.size() && cells_[i].point == pointi; ++i)
        {
            sum += cells_[i].weight*field[cells_[i].of];
        }
        values[pointi] = sum;
    }
    label i = 0;
    forAll(end_, patchi)
    {
        const Field<Type>& onPatch = field.boundaryField()[patchi];
        for (; i < end_[patchi]; ++i)
        {
            const share& s = faces_[i];
            values[s.point] += s.weight*onPatch[s.of];
        }
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
