/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "fillGenerator.H"
#include "roomGrid.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"

#include <algorithm>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(fillGenerator, 0);
    addToRunTimeSelectionTable(generator, fillGenerator, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::fillGenerator::draw(const dictionary& dict)
{
    if (dict.found("number") == dict.found("fraction"))
    {
        FatalIOErrorInFunction(dict)
            << "Generator " << name() << " of type fill needs one of the"
            << " entries number and fraction; it has "
            << (dict.found("number") ? "both" : "neither")
            << exit(FatalIOError);
    }
    if (region_->volume() <= 0)
    {
        badEntry(dict, "region", "has no volume to fill");
    }

    const bool byNumber = dict.found("number");
    const label number = byNumber ? getLabel(dict, "number", 1) : labelMax;
    const scalar limit =
        byNumber
      ? GREAT
      : getPositive(dict, "fraction", 0, 0.74)*region_->volume();

    // Size and number of each
    typedef Tuple2<scalar, label> turn;
    DynamicList<turn> turns;
    scalar volume = 0;
    for (label n = 0; n < number; ++n)
    {
        // Not the body with which it is more than without it too little
        const mixture::kind& k = mixture_.kindOf(seed_, n);
        if (volume + 0.5*k.volume > limit)
        {
            break;
        }
        volume += k.volume;
        turns.append(turn(shapes_[k.shapeI].boundingRadius(), n));
    }
    std::stable_sort
    (
        turns.begin(),
        turns.end(),
        [](const turn& a, const turn& b) { return a.first() > b.first(); }
    );
    for (const turn& t : turns)
    {
        order_.append(t.second());
    }

    if (order_.empty())
    {
        badEntry(dict, "fraction", "is less than one body");
    }
    wanted_ = volume/region_->volume();
    if (wanted_ > 0.74)
    {
        badEntry
        (
            dict,
            "number",
            "of bodies has more than 0.74 of the region's volume: even the"
            " densest packing of spheres has not"
        );
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::fillGenerator::fillGenerator
(
    const word& name,
    const dictionary& dict,
    shapeSizes& shapes,
    const materials& m,
    const fileName&
)
:
    regionGenerator
    (
        name,
        dict,
        shapes,
        m,
        {"number", "fraction", "start", "tries"}
    ),
    shapes_(shapes.shapes()),
    start_(getFinite(dict, "start", 0)),
    nTries_(getLabel(dict, "tries", 1, 10000))
{
    draw(dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dem::generatorPlan Foam::dem::fillGenerator::plan() const
{
    return planOf(order_.size());
}


Foam::label Foam::dem::fillGenerator::nDue(const scalar t)
{
    return t < start_ - 1e-9*mag(start_) ? 0 : order_.size();
}


bool Foam::dem::fillGenerator::make
(
    const label n,
    const hasRoom& room,
    newBody& body
) const
{
    mixture_.make(seed_, order_[n], body);
    const shape& s = shapes_[body.shapeI];

    return place
    (
        order_[n],
        nTries_,
        [&](const newBody& b)
        {
            bool within = true;
            forEachSphere
            (
                s,
                b,
                [&](const point& x, const scalar r)
                {
                    within = within && region_->contains(x, r);
                }
            );
            return within && room(b);
        },
        body
    );
}


void Foam::dem::fillGenerator::report
(
    Ostream& os,
    const scalar volume
) const
{
    os  << "    generator " << name() << ": " << nEntered() - nLeftOut()
        << " bodies of " << order_.size() << " found room, "
        << volume/region_->volume() << " of the region's volume of "
        << wanted_ << " wanted" << nl;
}


// ************************************************************************* //
