/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "rankBoundaries.H"
#include "processorFvPatch.H"
#include "volFields.H"

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

template<class Type>
void update(const fvMesh& mesh)
{
    typedef GeometricField<Type, fvPatchField, volMesh> fieldType;

    // In the same order on all ranks
    for (const word& name : mesh.sortedNames<fieldType>())
    {
        // The values are those of the same time: nothing of it is modified
        typename fieldType::Boundary& patches =
            mesh.lookupObjectRef<fieldType>(name).boundaryFieldRef(false);

        const label first = Pstream::nRequests();
        for (fvPatchField<Type>& patch : patches)
        {
            if (isA<processorFvPatch>(patch.patch()))
            {
                patch.initEvaluate(Pstream::commsTypes::nonBlocking);
            }
        }
        Pstream::waitRequests(first);
        for (fvPatchField<Type>& patch : patches)
        {
            if (isA<processorFvPatch>(patch.patch()))
            {
                patch.evaluate(Pstream::commsTypes::nonBlocking);
            }
        }
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::coupling::updateRankBoundaries(const fvMesh& mesh)
{
    if (!Pstream::parRun())
    {
        return;
    }
    update<scalar>(mesh);
    update<vector>(mesh);
    update<sphericalTensor>(mesh);
    update<symmTensor>(mesh);
    update<tensor>(mesh);
}


// ************************************************************************* //
