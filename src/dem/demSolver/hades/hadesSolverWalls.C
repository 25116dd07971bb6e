/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "hadesSolver.H"
#include "allowedKeys.H"
#include "checkedEntry.H"
#include "movingWall.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::hadesSolver::readWalls()
{
    if (!input_.dict.found("walls"))
    {
        return;
    }

    wordList types(wall::types());
    types.append("patch");

    const dictionary& dict = input_.dict.subDict("walls");
    for (const word& name : dict.toc())
    {
        const dictionary& d = dict.subDict(name);
        const word type = getChoice(d, "type", types);
        const label materialI = materials_.find(d, "material");

        autoPtr<wall> w
        (
            type == "patch"
          ? readPatches(name, materialI, d)
          : wall::New(name, materialI, d, input_.directory)
        );
        checkSeams(*w, d);
        walls_.append(movingWall::New(std::move(w), d));
    }
}


Foam::autoPtr<Foam::dem::wall> Foam::dem::hadesSolver::readPatches
(
    const word& name,
    const label materialI,
    const dictionary& dict
) const
{
    checkKeys
    (
        dict,
        {"type", "material", "patches", "motion", "open", "close"}
    );
    if (!input_.patchTriangles)
    {
        badEntry(dict, "type", "there is no mesh whose patches to take");
    }
    return autoPtr<wall>
    (
        new triangleWall
        (
            name,
            materialI,
            input_.patchTriangles
            (
                dict.getOrDefault<wordRes>("patches", wordRes()),
                dict,
                false
            )
        )
    );
}


void Foam::dem::hadesSolver::checkSeams
(
    const wall& w,
    const dictionary& dict
) const
{
    for (const periodicity::seam& s : input_.period.seams())
    {
        if (!w.bounded() && !w.repeats(s.separation))
        {
            OStringStream why;
            why << "is " << w.type() << ", which does not end, but the normal"
                << " of a plane must be across the separation " << s.separation
                << " of cyclic patches, the axis of a cylinder along it, and"
                << " the inside of a box or can has no place there: it would"
                << " cut the seam. A rectangle, triSurface or patch may";
            badEntry(dict, "type", why.str());
        }
    }
}


void Foam::dem::hadesSolver::readMirrors()
{
    for (const word& name : input_.mirrors)
    {
        // A name that no wall of the dictionary has
        walls_.append
        (
            autoPtr<wall>
            (
                new triangleWall
                (
                    "mirror:" + name,
                    -1,
                    input_.mirrorTriangles(name, false)
                )
            )
        );
    }
}


bool Foam::dem::hadesSolver::ofMesh(const wall& w) const
{
    return
        w.mirror()
     || input_.dict.subDict("walls").subDict(w.name()).get<word>("type")
     == "patch";
}


Foam::List<Foam::dem::corners> Foam::dem::hadesSolver::triangles
(
    const wall& w,
    const bool old
) const
{
    if (w.mirror())
    {
        const word patch(w.name().substr(w.name().find(':') + 1));
        return input_.mirrorTriangles(patch, old);
    }
    const dictionary& d = input_.dict.subDict("walls").subDict(w.name());
    return input_.patchTriangles
    (
        d.getOrDefault<wordRes>("patches", wordRes()),
        d,
        old
    );
}


void Foam::dem::hadesSolver::checkClosing(const scalar t)
{
    if (!walls_.anyAppeared())
    {
        return;
    }

    // As much as bodies may overlap at the start
    const bodies& state = moving();
    const wallTouch* touch = walls_.inTheWay(state.sphereR.list(), 1e-3);
    if (!group_.any(touch))
    {
        return;
    }
    if (control_->undoes())
    {
        packed_.undo();
    }
    unpack();
    string why;
    if (touch)
    {
        const label b = state.sphereBody[touch->sphere];
        why =
            "    " + nameOf(-1 - touch->wallI) + " appears where "
          + nameOf(b) + " is, at " + shown(state.x[b]) + ".\n"
            "    Let it close when nothing is in its way, or let it move there"
            " with a motion.\n";
    }
    stop(t, group_.first(why));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::hadesSolver::updateWalls
(
    const bool moves,
    const scalar t0,
    const scalar t1
)
{
    input_.meshMoves = input_.meshMoves || moves;
    for (wall& w : walls_.change())
    {
        if (!ofMesh(w))
        {
            continue;
        }
        movingWall* timed = dynamic_cast<movingWall*>(&w);
        triangleWall& patch =
            refCast<triangleWall>(timed ? timed->surface() : w);
        if (moves)
        {
            if (timed)
            {
                badEntry
                (
                    input_.dict.subDict("walls"),
                    w.name(),
                    "has patches of a mesh that moves, and a motion or a time"
                    " of its own: only one of them can be"
                );
            }
            patch.setMotion(triangles(w, true), triangles(w, false), t0, t1);
        }
        else
        {
            patch.set(triangles(w, false));
        }
    }
    walls_.renew();
}


// ************************************************************************* //
