/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "patchExits.H"
#include "emptyPolyPatch.H"
#include "symmetryPlanePolyPatch.H"
#include "symmetryPolyPatch.H"
#include "wallPolyPatch.H"
#include "wedgePolyPatch.H"

#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::patchExits::makeTree()
{
    DynamicList<label> faces;
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (!patch.coupled())
        {
            forAll(patch, i)
            {
                faces.append(patch.start() + i);
            }
        }
    }
    faces_.transfer(faces);

    // A little larger, so that no face is on its side
    treeBoundBox box(mesh_.points());
    const vector margin(1e-3*max(box.mag(), ROOTVSMALL)*vector::one);
    box.min() -= margin;
    box.max() += margin;
    tree_.reset
    (
        new indexedOctree<treeDataFace>
        (
            treeDataFace(false, mesh_, faces_),
            box,
            12,     // levels
            10,     // faces a leaf
            3       // leaves a face
        )
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::patchExits::outlets() const
{
    wordList names;
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if
        (
           !patch.coupled()
         && !isA<wallPolyPatch>(patch)
         && !isA<symmetryPolyPatch>(patch)
         && !isA<symmetryPlanePolyPatch>(patch)
         && !isA<emptyPolyPatch>(patch)
         && !isA<wedgePolyPatch>(patch)
        )
        {
            names.append(patch.name());
        }
    }
    return names;
}


Foam::wordList Foam::patchExits::nearest(const UList<point>& points)
{
    if (!tree_.valid())
    {
        makeTree();
    }

    // Of each point the distance to this rank's nearest face, and its patch
    scalarList distance(points.size(), GREAT);
    labelList patch(points.size(), -1);
    if (faces_.size())
    {
        forAll(points, i)
        {
            const pointIndexHit hit =
                tree_->findNearest(points[i], GREAT);
            if (hit.hit())
            {
                distance[i] = mag(hit.hitPoint() - points[i]);
                patch[i] =
                    mesh_.boundaryMesh().whichPatch(faces_[hit.index()]);
            }
        }
    }

    wordList names(points.size());
    forAll(points, i)
    {
        // The patches that are not coupled have the same numbers on all ranks;
        // where two are as near, the first counts
        const scalar least = returnReduce(distance[i], minOp<scalar>());
        label p = distance[i] <= least && patch[i] >= 0 ? patch[i] : labelMax;
        reduce(p, minOp<label>());
        names[i] = p < labelMax ? mesh_.boundaryMesh()[p].name() : word::null;
    }
    return names;
}


// ************************************************************************* //
