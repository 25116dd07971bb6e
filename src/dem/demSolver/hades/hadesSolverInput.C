/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "hadesSolver.H"
#include "planeWall.H"
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
            walls_.append
            (
                autoPtr<wall>
                (
                    new planeWall
                    (
                        name,
                        materialI,
                        getFiniteVector(d, "point"),
                        normal
                    )
                )
            );
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
                            d
                        )
                    )
                )
            );
        }
    }
}


void Foam::dem::hadesSolver::readGenerators()
{
    if (!input_.dict.found("generators"))
    {
        return;
    }

    const dictionary& dict = input_.dict.subDict("generators");
    for (const word& name : dict.toc())
    {
        generators_.append
        (
            generator::New(name, dict.subDict(name), shapes_, materials_).ptr()
        );
    }
}


void Foam::dem::hadesSolver::checkOverlaps()
{
    if (!state_.size())
    {
        return;
    }

    computeForces(0);
    report_.overlap = summary_.overlap;

    if (summary_.overlap > 1e-3)
    {
        FatalIOErrorInFunction(input_.dict.subDict("bodies"))
            << nameOf(summary_.overlapA).c_str() << " and "
            << nameOf(summary_.overlapB).c_str() << " overlap at the start, by "
            << 100*summary_.overlap << " % of the smaller radius." << nl
            << "    Bodies may start with 0.1 % at most: move them apart."
            << exit(FatalIOError);
    }
}


bool Foam::dem::hadesSolver::hasRoom(const newBody& body) const
{
    bodies trial(shapes_);
    trial.append(body);

    // No sphere of the body may touch one that is there
    forAll(trial.sphereX, i)
    {
        forAll(state_.sphereX, j)
        {
            const scalar reach = trial.sphereR[i] + state_.sphereR[j];
            if (magSqr(trial.sphereX[i] - state_.sphereX[j]) < sqr(reach))
            {
                return false;
            }
        }

        DynamicList<label> elements;
        forAll(walls_.walls(), w)
        {
            walls_.walls()[w].candidates
            (
                trial.sphereX[i],
                trial.sphereR[i],
                elements
            );
        }
        if (elements.size())
        {
            return false;
        }
    }
    return true;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::List<Foam::dem::generatorPlan> Foam::dem::hadesSolver::plans() const
{
    List<generatorPlan> all(generators_.size());
    forAll(generators_, i)
    {
        all[i] = generators_[i].plan();
    }
    return all;
}


bool Foam::dem::hadesSolver::hasRoomFor(const label i) const
{
    newBody body;
    return generators_[i].make
    (
        generators_[i].nEntered(),
        [this](const newBody& n) { return hasRoom(n); },
        body
    );
}


// ************************************************************************* //
