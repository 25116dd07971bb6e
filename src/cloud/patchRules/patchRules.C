/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "patchRules.H"
#include "coupledPolyPatch.H"
#include "cyclicPolyPatch.H"
#include "emptyPolyPatch.H"
#include "ListListOps.H"
#include "processorPolyPatch.H"
#include "symmetryPlanePolyPatch.H"
#include "symmetryPolyPatch.H"
#include "wallPolyPatch.H"
#include "wedgePolyPatch.H"

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

const char* const allowed =
    "    Bodies can deal with wall, symmetry and symmetryPlane (flat), cyclic"
    " (flat, a straight\n"
    "    separation), patch (inlets and outlets), empty and processor: see"
    " doc/patches.md.";

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::patchRules::judge(const polyPatch& patch)
{
    const label p = patch.index();

    if (isA<wedgePolyPatch>(patch))
    {
        refused_.append
        (
            refusal{p, "in a wedge a body would be a ring around the axis"}
        );
    }
    else if
    (
        isA<symmetryPolyPatch>(patch) || isA<symmetryPlanePolyPatch>(patch)
    )
    {
        if (flat(p))
        {
            mirrors_.append(patch.name());
        }
        else
        {
            refused_.append(refusal{p, "a mirror must be flat"});
        }
    }
    else if (patch.type() == cyclicPolyPatch::typeName)
    {
        const cyclicPolyPatch& cyclic = refCast<const cyclicPolyPatch>(patch);
        if (cyclic.owner())
        {
            addSeam(cyclic);
        }
    }
    else if (isA<coupledPolyPatch>(patch) && !isA<processorPolyPatch>(patch))
    {
        refused_.append
        (
            refusal
            {
                p,
                "a body cannot pass where the faces of both sides are not the"
                " same"
            }
        );
    }
}


bool Foam::patchRules::reached
(
    const dem::bodies& state,
    const label patch
) const
{
    point low(GREAT, GREAT, GREAT);
    point high(-low);
    for (const point& x : mesh_.boundaryMesh()[patch].localPoints())
    {
        low = min(low, x);
        high = max(high, x);
    }
    reduce(low, minOp<point>());
    reduce(high, maxOp<point>());

    forAll(state.x, b)
    {
        const point nearest = min(max(state.x[b], low), high);
        if (mag(state.x[b] - nearest) < state.shapeOf(b).boundingRadius())
        {
            return true;
        }
    }
    return false;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::patchRules::patchRules(const polyMesh& mesh)
:
    mesh_(mesh)
{
    // The patches that all ranks have come first, in the same order
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (isA<processorPolyPatch>(patch))
        {
            break;
        }
        judge(patch);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::patchRules::check(const dem::demSolver& dem, const bool wet) const
{
    for (const refusal& r : refused_)
    {
        const polyPatch& patch = mesh_.boundaryMesh()[r.patch];
        if (dem.moves() || reached(dem.state(), r.patch))
        {
            FatalErrorInFunction
                << "Patch " << patch.name() << " is of type " << patch.type()
                << ": " << r.why.c_str() << "." << nl << allowed
                << exit(FatalError);
        }
    }

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (isA<emptyPolyPatch>(patch) && wet && dem.moves())
        {
            FatalErrorInFunction
                << "Patch " << patch.name() << " is of type empty: with empty"
                << " patches a sphere would be a cylinder for the fluid but"
                << " have the mass of a sphere." << nl
                << "    In two dimensions only bodies that stay where they are"
                << " (demSolver fixed) or do not touch the fluid (coupling"
                << " none) are possible; see constant/demCloudProperties."
                << exit(FatalError);
        }
    }
}


Foam::labelList Foam::patchRules::walls
(
    const wordRes& names,
    const dictionary& dict
) const
{
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    DynamicList<label> taken;
    DynamicList<word> present;

    for (const polyPatch& patch : patches)
    {
        const bool wall = isA<wallPolyPatch>(patch);
        const bool named = names.size() && names.match(patch.name());
        if (named && !wall)
        {
            FatalIOErrorInFunction(dict)
                << "Patch " << patch.name() << " is of type " << patch.type()
                << ", not wall." << nl
                << "    Bodies touch wall patches where they are named, and"
                << " symmetry patches anyway; an inlet or an outlet lets them"
                << " out." << exit(FatalIOError);
        }
        if (wall)
        {
            present.append(patch.name());
            if (named || names.empty())
            {
                taken.append(patch.index());
            }
        }
    }

    if (taken.empty())
    {
        FatalIOErrorInFunction(dict)
            << "No patch of type wall is taken." << nl
            << "    Wall patches of the mesh: " << wordList(present) << nl
            << "    Patches of the mesh: " << patches.names()
            << exit(FatalIOError);
    }
    return labelList(std::move(taken));
}


Foam::List<Foam::dem::corners> Foam::patchRules::triangles
(
    const labelUList& patches,
    const bool old
) const
{
    const pointField& points = old ? mesh_.oldPoints() : mesh_.points();
    DynamicList<dem::corners> own;

    for (const label p : patches)
    {
        for (const face& f : mesh_.boundaryMesh()[p])
        {
            for (label k = 2; k < f.size(); ++k)
            {
                dem::corners t;
                t[0] = points[f[0]];
                t[1] = points[f[k - 1]];
                t[2] = points[f[k]];
                own.append(t);
            }
        }
    }

    List<List<dem::corners>> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = own;
    Pstream::gatherList(all);
    Pstream::scatterList(all);

    return ListListOps::combine<List<dem::corners>>
    (
        all,
        accessOp<List<dem::corners>>()
    );
}


// ************************************************************************* //
