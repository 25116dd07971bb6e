/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "demSolver.H"
#include "allowedKeys.H"
#include "checkedEntry.H"
#include "unitConversion.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(demSolver, 0);
    defineRunTimeSelectionTable(demSolver, input);
}
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::PtrList<Foam::dem::shape> Foam::dem::demSolver::readShapes
(
    const demInput& input
)
{
    const dictionary& dict = input.dict.subDict("shapes");

    PtrList<shape> shapes;
    for (const word& name : dict.sortedToc())
    {
        const dictionary& d = dict.subDict(name);
        shapes.append(new shape(name, d, input.directory));
        checkShape(shapes.last(), d, input);
    }
    if (shapes.empty())
    {
        FatalIOErrorInFunction(input.dict)
            << "There is no shape in the entry shapes." << nl
            << "    Give each one as  NAME { type sphere; diameter 0.01; }"
            << exit(FatalIOError);
    }
    return shapes;
}


void Foam::dem::demSolver::checkShape
(
    const shape& s,
    const dictionary& dict,
    const demInput& input
)
{
    if (input.checkShape)
    {
        input.checkShape(s, dict);
    }

    const scalar size = 2*s.boundingRadius();
    if (size >= input.period.width())
    {
        FatalIOErrorInFunction(dict)
            << "The shape " << s.name() << " measures up to " << size
            << " m, but the domain repeats itself after "
            << input.period.width() << " m." << nl
            << "    A body that meets its own image is not possible: it must be"
            << " smaller than the distance of cyclic patches."
            << exit(FatalIOError);
    }
}


void Foam::dem::demSolver::takeIn()
{
    const periodicity& period = input_.period;
    for (label b = 0; b < state_.size() && period.active(); ++b)
    {
        state_.x[b] += period.shift(period.turns(state_.x[b], 0));
        state_.updateSpheres(b);
    }
}


Foam::label Foam::dem::demSolver::share(const newBody& n)
{
    // By turns, until they go to their owners
    const label id = state_.nextId();
    if (group_.shared() && id % Pstream::nProcs() != Pstream::myProcNo())
    {
        state_.setNextId(id + 1);
        return -1;
    }
    return state_.append(n);
}


void Foam::dem::demSolver::readBodies()
{
    if (!input_.dict.found("bodies") || input_.restart)
    {
        return;
    }

    wordList names(shapes_.size());
    forAll(shapes_, i)
    {
        names[i] = shapes_[i].name();
    }

    const dictionary& dict = input_.dict.subDict("bodies");
    for (const word& name : dict.toc())
    {
        const dictionary& d = dict.subDict(name);
        checkKeys
        (
            d,
            {
                "shape", "material", "position", "velocity",
                "angularVelocity", "rotation"
            }
        );

        newBody n;
        n.shapeI = names.find(getChoice(d, "shape", names));
        n.materialI = materials_.findOfBody(d, "material");
        n.density = materials_.density(n.materialI);
        n.position = getFiniteVector(d, "position");
        if (d.found("velocity"))
        {
            n.velocity = getFiniteVector(d, "velocity");
        }
        if (d.found("angularVelocity"))
        {
            n.angularVelocity = getFiniteVector(d, "angularVelocity");
        }
        if (d.found("rotation"))
        {
            const Tuple2<vector, scalar> turn
            (
                d.get<Tuple2<vector, scalar>>("rotation")
            );
            if (!isFinite(turn.first()) || !std::isfinite(turn.second()))
            {
                badEntry(d, "rotation", "is not finite, or above 1e12");
            }
            if (mag(turn.first()) < SMALL)
            {
                badEntry(d, "rotation", "the axis has no length");
            }
            n.orientation = quaternion(turn.first(), degToRad(turn.second()));
        }
        share(n);
    }
    takeIn();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::demSolver::demSolver
(
    const demInput& input,
    const contactLaws* laws,
    const bool shared
)
:
    input_(input),
    shapes_(readShapes(input)),
    materials_(input.dict, laws),
    state_(shapes_),
    group_(shared)
{
    readBodies();
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dem::demSolver> Foam::dem::demSolver::New
(
    const demInput& input
)
{
    const word type = getChoice
    (
        input.dict,
        "demSolver",
        inputConstructorTablePtr_->sortedToc()
    );
    return (*inputConstructorTablePtr_)[type](input);
}


// ************************************************************************* //
