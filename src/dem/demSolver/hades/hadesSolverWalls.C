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

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::hadesSolver::readWalls()
{
    if (!input_.dict.found("walls"))
    {
        return;
    }

    const dictionary& dict = input_.dict.subDict("walls");
    for (const word& name : dict.toc())
    {
        const dictionary& d = dict.subDict(name);
        const word type = getChoice(d, "type", {"patch", "plane"});
        const label materialI = materials_.find(d, "material");

        if (type == "plane")
        {
            checkKeys(d, {"type", "material", "point", "normal"});
            const vector normal = getFiniteVector(d, "normal");
            if (mag(normal) < SMALL)
            {
                badEntry(d, "normal", "it has no length");
            }
            autoPtr<planeWall> w
            (
                new planeWall
                (
                    name,
                    materialI,
                    getFiniteVector(d, "point"),
                    normal
                )
            );
            checkSeams(*w, d);
            walls_.append(autoPtr<wall>(w.ptr()));
        }
        else
        {
            checkKeys(d, {"type", "material", "patches"});
            if (!input_.patchTriangles)
            {
                badEntry(d, "type", "there is no mesh whose patches to take");
            }
            walls_.append
            (
                autoPtr<wall>
                (
                    new triangleWall
                    (
                        name,
                        materialI,
                        input_.patchTriangles
                        (
                            d.getOrDefault<wordRes>("patches", wordRes()),
                            d,
                            false
                        )
                    )
                )
            );
        }
    }
}


void Foam::dem::hadesSolver::checkSeams
(
    const planeWall& w,
    const dictionary& dict
) const
{
    for (const periodicity::seam& s : input_.period.seams())
    {
        if (mag(s.separation & w.normal()) > 1e-6*mag(s.separation))
        {
            OStringStream why;
            why << "is not across the separation " << s.separation
                << " of cyclic patches: a plane does not end, so it would cut"
                << " the seam. A wall of type patch may";
            badEntry(dict, "normal", why.str());
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


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::hadesSolver::updateWalls
(
    const bool moves,
    const scalar t0,
    const scalar t1
)
{
    for (wall& w : walls_.change())
    {
        triangleWall* patch = dynamic_cast<triangleWall*>(&w);
        if (patch && moves)
        {
            patch->setMotion(triangles(w, true), triangles(w, false), t0, t1);
        }
        else if (patch)
        {
            patch->set(triangles(w, false));
        }
    }
    walls_.renew();
}


// ************************************************************************* //
