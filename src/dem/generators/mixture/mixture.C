/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "mixture.H"
#include "bodyRandom.H"
#include "checkedEntry.H"

#include <algorithm>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::wordList Foam::dem::mixture::keys({"shape", "material"});


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::mixture::mixture
(
    const dictionary& dict,
    const PtrList<shape>& shapes,
    const materials& m
)
{
    wordList names(shapes.size());
    forAll(shapes, i)
    {
        names[i] = shapes[i].name();
    }

    kind k;
    k.shapeI = names.find(getChoice(dict, "shape", names));
    k.materialI = m.findOfBody(dict, "material");
    k.density = m.density(k.materialI);
    k.volume = shapes[k.shapeI].volume();
    k.share = 1;
    kinds_.append(k);
    upTo_.append(1);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

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
