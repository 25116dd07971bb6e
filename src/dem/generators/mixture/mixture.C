/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "mixture.H"
#include "allowedKeys.H"
#include "bodyRandom.H"
#include "checkedEntry.H"
#include "sizeDistribution.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::wordList Foam::dem::mixture::keys
({
    "shape", "material", "size", "mixture"
});


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::mixture::append
(
    const dictionary& dict,
    const scalar fraction,
    shapeSizes& shapes,
    const materials& m
)
{
    const label shapeI = shapes.find(dict, "shape");
    kind k;
    k.materialI = m.findOfBody(dict, "material");
    k.density = m.density(k.materialI);

    DynamicList<sizeDistribution::sizeClass> sizes;
    if (dict.found("size"))
    {
        sizes = sizeDistribution::New(dict.subDict("size"))->classes();
    }
    else
    {
        sizes.append(sizeDistribution::sizeClass{0, 1});
    }
    for (const sizeDistribution::sizeClass& c : sizes)
    {
        k.shapeI =
            c.diameter > 0
          ? shapes.ofSize(shapeI, c.diameter, dict.subDict("size"))
          : shapeI;
        k.volume = shapes.shapes()[k.shapeI].volume();
        k.share = fraction*c.share;
        kinds_.append(k);
    }
}


void Foam::dem::mixture::readComponents
(
    const dictionary& dict,
    shapeSizes& shapes,
    const materials& m
)
{
    const bool byMass =
        getChoice(dict, "by", {"number", "mass"}, "number") == "mass";

    scalar sum = 0, fractions = 0;
    for (const entry& e : dict)
    {
        if (e.keyword() == "by")
        {
            continue;
        }
        if (!e.isDict())
        {
            badEntry
            (
                dict,
                e.keyword(),
                "is none of: by, or the dictionary of a component"
            );
        }
        const dictionary& d = e.dict();
        checkKeys(d, {"fraction", "shape", "material", "size"});
        const scalar fraction = getPositive(d, "fraction", 0, 1);
        fractions += fraction;

        // Of a share of mass the number is that over the mean mass of a body
        const label first = kinds_.size();
        append(d, 1, shapes, m);
        scalar mass = 0;
        for (label i = first; i < kinds_.size(); ++i)
        {
            mass += kinds_[i].share*kinds_[i].density*kinds_[i].volume;
        }
        const scalar number = byMass ? fraction/mass : fraction;
        for (label i = first; i < kinds_.size(); ++i)
        {
            kinds_[i].share *= number;
        }
        sum += number;
    }
    if (mag(fractions - 1) > 1e-6)
    {
        FatalIOErrorInFunction(dict)
            << "The fractions of the components add up to " << fractions
            << " but must to 1" << exit(FatalIOError);
    }
    for (kind& k : kinds_)
    {
        k.share /= sum;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::mixture::mixture
(
    const dictionary& dict,
    shapeSizes& shapes,
    const materials& m
)
{
    if (!dict.found("mixture"))
    {
        append(dict, 1, shapes, m);
    }
    else
    {
        for (const word& key : {"shape", "material", "size"})
        {
            if (dict.found(key))
            {
                badEntry(dict, key, "does not go with the entry mixture");
            }
        }
        readComponents(dict.subDict("mixture"), shapes, m);
    }

    scalar sum = 0;
    for (const kind& k : kinds_)
    {
        sum += k.share;
        upTo_.append(sum);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dem::mixture::meanMass() const
{
    scalar mass = 0;
    for (const kind& k : kinds_)
    {
        mass += k.share*k.density*k.volume;
    }
    return mass;
}


const Foam::dem::mixture::kind& Foam::dem::mixture::kindOf
(
    const label seed,
    const label n
) const
{
    if (kinds_.size() == 1)
    {
        return kinds_[0];
    }
    const scalar u =
        bodyRandom(seed, n, bodyRandom::purpose::kind).uniform();
    const label i =
        std::upper_bound(upTo_.begin(), upTo_.end(), u) - upTo_.begin();
    return kinds_[min(i, kinds_.size() - 1)];
}


void Foam::dem::mixture::make
(
    const label seed,
    const label n,
    newBody& body
) const
{
    const kind& k = kindOf(seed, n);
    body.shapeI = k.shapeI;
    body.materialI = k.materialI;
    body.density = k.density;
}


// ************************************************************************* //
