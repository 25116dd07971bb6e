/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "shapeSizes.H"
#include "checkedEntry.H"

#include <cstdio>

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

Foam::wordList namesOf(const Foam::PtrList<Foam::dem::shape>& shapes)
{
    Foam::wordList names(shapes.size());
    forAll(shapes, i)
    {
        names[i] = shapes[i].name();
    }
    return names;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::shapeSizes::shapeSizes(PtrList<shape>& shapes, const check& c)
:
    shapes_(shapes),
    given_(namesOf(shapes)),
    check_(c)
{
    forAll(given_, i)
    {
        indexOf_.insert(given_[i], i);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::dem::shapeSizes::find
(
    const dictionary& dict,
    const word& key
) const
{
    return given_.find(getChoice(dict, key, given_));
}


Foam::label Foam::dem::shapeSizes::ofSize
(
    const label i,
    const scalar diameter,
    const dictionary& dict
)
{
    // As many digits as tell the sizes of bodies apart
    char digits[32];
    std::snprintf(digits, sizeof(digits), ":%.12g", diameter);
    const word name(shapes_[i].name() + digits);

    const auto found = indexOf_.cfind(name);
    if (found.found())
    {
        return *found;
    }

    const label index = shapes_.size();
    shapes_.append
    (
        new shape
        (
            shapes_[i].scaled(name, diameter/shapes_[i].equivalentDiameter())
        )
    );
    indexOf_.insert(name, index);
    check_(shapes_[index], dict);
    return index;
}


// ************************************************************************* //
