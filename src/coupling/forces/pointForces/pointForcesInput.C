/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "pointForces.H"
#include "allowedKeys.H"
#include "checkedEntry.H"
#include "interpolation.H"
#include "lubrication.H"
#include "undisturbedVelocity.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::coupling::pointForces::checkInput(const dictionary& forces) const
{
    wordList keys(pointForce::names());
    keys.append("drag");
    keys.append("clumps");
    keys.append("interpolation");
    keys.append("coarseGraining");
    keys.append(lubrication::name);
    dem::checkKeys(forces, keys);

    if (forces.isDict("drag"))
    {
        dem::checkKeys(forces.subDict("drag"), {"law", "sphericity"});
    }
}


Foam::word Foam::coupling::pointForces::interpolationScheme
(
    const dictionary& forces
)
{
    return dem::getChoice
    (
        forces,
        "interpolation",
        Foam::interpolation<vector>::dictionaryConstructorTablePtr_
      ->sortedToc(),
        "cellPoint"
    );
}


void Foam::coupling::pointForces::readDrag(const dictionary& forces)
{
    sumOfSpheres_ =
        dem::getChoice
        (
            forces,
            "clumps",
            {"equivalentSphere", "sumOfSpheres"},
            "equivalentSphere"
        ) == "sumOfSpheres";
    if (!drag_.valid())
    {
        return;
    }

    if (forces.isDict("drag") && forces.subDict("drag").found("sphericity"))
    {
        const dictionary& dict = forces.subDict("drag");
        sphericity_ = dem::getInRange(dict, "sphericity", 0.01, 1);
        if (!drag_->shaped())
        {
            dem::badEntry
            (
                dict,
                "sphericity",
                "is of no use: the law " + drag_->type()
              + " is that of a sphere; take it out"
            );
        }
    }
    if (sumOfSpheres_ && drag_->shaped())
    {
        dem::badEntry
        (
            forces,
            "clumps",
            "is sumOfSpheres, but the law " + drag_->type()
          + " is that of a whole body; take equivalentSphere"
        );
    }
}


void Foam::coupling::pointForces::readGrains(const dictionary& forces)
{
    const word key("coarseGraining");
    if (!forces.found(key))
    {
        return;
    }
    grains_ = dem::getInRange(forces, key, 1, 1e12);
    grainWidth_ = 1/cbrt(grains_);
    if (sumOfSpheres_)
    {
        dem::badEntry
        (
            forces,
            key,
            "is for bodies that stand for many grains, and clumps sumOfSpheres"
            " for the spheres of one body; take equivalentSphere"
        );
    }
    if (pointForce::switchedOn(undisturbedVelocity::typeName, forces))
    {
        dem::badEntry
        (
            forces,
            key,
            "does not go with undisturbedVelocity, which is the wake of one"
            " body; take one of them out"
        );
    }
    if (lubrication::switchedOn(forces))
    {
        dem::badEntry
        (
            forces,
            key,
            "does not go with lubrication: bodies that stand for many grains"
            " meet where no two grains do; take one of them out"
        );
    }
    Info<< "    coarse graining: a body stands for " << grains_
        << " grains, " << grainWidth_ << " as wide" << endl;
}


void Foam::coupling::pointForces::readForces(const dictionary& forces)
{
    if
    (
        pointForce::switchedOn("saffman", forces)
     && pointForce::switchedOn("mei", forces)
    )
    {
        dem::badEntry
        (
            forces,
            "saffman",
            "and mei are the same lift, by two laws: take one out"
        );
    }

    // The first changes what all others see
    const word wake(undisturbedVelocity::typeName);
    wordList names(1, wake);
    for (const word& name : pointForce::names())
    {
        if (name != wake)
        {
            names.append(name);
        }
    }
    if (pointForce::switchedOn(wake, forces) && mesh_.nGeometricD() != 3)
    {
        dem::badEntry
        (
            forces,
            wake,
            "is that of a body in three dimensions, and the mesh has empty"
            " or wedge patches; take it out"
        );
    }
    for (const word& name : names)
    {
        autoPtr<pointForce> force(pointForce::New(name, dem_.g(), forces));
        if (force.valid())
        {
            forces_.append(force);
        }
    }
}


void Foam::coupling::pointForces::report(const word& scheme) const
{
    Info<< "    forces: drag "
        << (drag_.valid() ? drag_->type() : word("none"));
    for (const pointForce& f : forces_)
    {
        Info<< ", " << f.type();
    }
    Info<< ", interpolation " << scheme << endl;
}


// ************************************************************************* //
