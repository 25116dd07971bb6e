/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "rateGenerator.H"
#include "allowedKeys.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"

#include <random>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(rateGenerator, 0);
    addToRunTimeSelectionTable(generator, rateGenerator, dictionary);
}
}


// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Uniform in [0, 1), the same on every platform
scalar uniform(std::mt19937_64& random)
{
    return scalar(random() >> 11)*0x1.0p-53;
}


//- Uniform over all rotations (Shoemake 1992)
quaternion randomRotation(std::mt19937_64& random)
{
    const scalar twoPi = constant::mathematical::twoPi;
    const scalar u = uniform(random);
    const scalar a = twoPi*uniform(random);
    const scalar b = twoPi*uniform(random);
    const scalar r = std::sqrt(1 - u);
    return quaternion
    (
        std::sqrt(u)*std::cos(b),
        vector(r*std::sin(a), r*std::cos(a), std::sqrt(u)*std::sin(b))
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::rateGenerator::rateGenerator
(
    const word& name,
    const dictionary& dict,
    const PtrList<shape>& shapes,
    const materials& m
)
:
    generator(name)
{
    checkKeys
    (
        dict,
        {
            "type", "shape", "material", "region", "rate", "start", "total",
            "velocity", "orientation", "seed"
        }
    );

    wordList names(shapes.size());
    forAll(shapes, i)
    {
        names[i] = shapes[i].name();
    }
    shapeI_ = names.find(getChoice(dict, "shape", names));
    materialI_ = m.findOfBody(dict, "material");
    density_ = m.density(materialI_);

    const dictionary& region = dict.subDict("region");
    checkKeys(region, {"box"});
    ITstream& is = region.lookup("box");
    is >> low_ >> high_;
    if (!(cmptMin(high_ - low_) >= 0))
    {
        badEntry(region, "box", "give the smallest corner, then the largest");
    }

    rate_ = getPositive(dict, "rate");
    start_ = getFinite(dict, "start", 0);
    total_ = getLabel(dict, "total", 0);
    velocity_ =
        dict.found("velocity") ? getFiniteVector(dict, "velocity") : Zero;
    randomOrientation_ =
       !dict.found("orientation")
     || getChoice(dict, "orientation", {"random", "asGiven"}) == "random";
    seed_ = getLabel(dict, "seed", 0, 1);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dem::generatorPlan Foam::dem::rateGenerator::plan() const
{
    return generatorPlan
    {
        name(), shapeI_, materialI_, low_, high_, velocity_, rate_, total_
    };
}


Foam::label Foam::dem::rateGenerator::nDue(const scalar t) const
{
    if (t < start_)
    {
        return 0;
    }
    // Round-off of t must not decide whether a body comes now or a step later
    const scalar n = 1 + std::floor((t - start_)*rate_ + 1e-6);
    return n < total_ ? label(n) : total_;
}


bool Foam::dem::rateGenerator::make
(
    const label n,
    const hasRoom& room,
    newBody& body
) const
{
    std::seed_seq numbers{int(seed_), int(n)};
    std::mt19937_64 random(numbers);

    body.shapeI = shapeI_;
    body.materialI = materialI_;
    body.density = density_;
    body.velocity = velocity_;

    for (label trial = 0; trial < 100; ++trial)
    {
        for (direction d = 0; d < 3; ++d)
        {
            body.position[d] =
                low_[d] + uniform(random)*(high_[d] - low_[d]);
        }
        if (randomOrientation_)
        {
            body.orientation = randomRotation(random);
        }
        if (room(body))
        {
            return true;
        }
    }
    return false;
}


// ************************************************************************* //
