/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "regionGenerator.H"
#include "allowedKeys.H"
#include "bodyRandom.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- The dictionary, after a look at its keywords
const dictionary& checked(const dictionary& dict, const wordList& otherKeys)
{
    wordList keys
    (
        {"type", "region", "velocity", "orientation", "seed"}
    );
    keys.append(dem::mixture::keys);
    keys.append(otherKeys);
    dem::checkKeys(dict, keys);
    return dict;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

bool Foam::dem::regionGenerator::place
(
    const label n,
    const label nTries,
    const hasRoom& room,
    newBody& body
) const
{
    bodyRandom random(seed_, n, bodyRandom::purpose::placing);
    body.velocity = velocity_;

    for (label trial = 0; trial < nTries; ++trial)
    {
        body.position = region_->at(random.uniformVector());
        if (randomOrientation_)
        {
            body.orientation = random.rotation();
        }
        if (room(body))
        {
            return true;
        }
    }
    return false;
}


Foam::dem::generatorPlan Foam::dem::regionGenerator::planOf
(
    const label total
) const
{
    generatorPlan plan;
    plan.name = name();
    for (const mixture::kind& k : mixture_.kinds())
    {
        plan.parts.append
        (
            generatorPlan::part{k.shapeI, k.materialI, k.share*total}
        );
    }
    plan.where = &*region_;
    plan.speed = mag(velocity_);
    plan.total = total;
    return plan;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::regionGenerator::regionGenerator
(
    const word& name,
    const dictionary& dict,
    shapeSizes& shapes,
    const materials& m,
    const wordList& otherKeys
)
:
    generator(name),
    mixture_(checked(dict, otherKeys), shapes, m),
    region_(region::New(dict.subDict("region"))),
    seed_(getLabel(dict, "seed", 0, 1))
{
    velocity_ =
        dict.found("velocity") ? getFiniteVector(dict, "velocity") : Zero;
    randomOrientation_ =
        getChoice(dict, "orientation", {"random", "asGiven"}, "random")
     == "random";
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::dem::regionGenerator::make
(
    const label n,
    const hasRoom& room,
    newBody& body
) const
{
    mixture_.make(seed_, n, body);
    return place(n, 100, room, body);
}


// ************************************************************************* //
