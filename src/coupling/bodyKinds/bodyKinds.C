/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "bodyKinds.H"
#include "allowedKeys.H"
#include "checkedEntry.H"
#include "rankSum.H"
#include "volFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::coupling::bodyKinds::rule Foam::coupling::bodyKinds::read
(
    const dictionary& dict,
    const word& key
)
{
    const word said
    (
        dem::getChoice(dict, key, {"auto", "always", "never"}, "auto")
    );
    return
        said == "auto" ? rule::bySize
      : said == "always" ? rule::always
      : rule::never;
}


bool Foam::coupling::bodyKinds::findRules(const dem::bodies& state)
{
    for (label i = ofShape_.size(); i < state.shapes().size(); ++i)
    {
        // One of a size distribution has the name of its template before a
        // colon and its size
        const word& name = state.shapes()[i].name();
        const auto given = named_.cfind(word(name.substr(0, name.find(':'))));
        ofShape_.append(given.found() ? given.val() : default_);
    }
    forAll(state.shapeI, b)
    {
        if (ofShape_[state.shapeI[b]] == rule::bySize)
        {
            return true;
        }
    }
    return false;
}


Foam::List<Foam::scalar> Foam::coupling::bodyKinds::sizes
(
    const fvMesh& mesh,
    const labelUList& cellOf,
    const dem::bodies& state
)
{
    scalar thickness = 0;
    for (direction d = 0; d < 3; ++d)
    {
        if (mesh.solutionD()[d] < 0)
        {
            thickness = mesh.bounds().span()[d];
        }
    }

    List<scalar> size(state.size(), Zero);
    forAll(size, b)
    {
        if (cellOf[b] >= 0)
        {
            const scalar V = mesh.V()[cellOf[b]];
            size[b] =
                state.shapeOf(b).equivalentDiameter()
               /(thickness > 0 ? sqrt(V/thickness) : cbrt(V));
        }
    }
    dem::maxOverRanks(size);
    return size;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::coupling::bodyKinds::read
(
    const dictionary& dict,
    const wordList& names
)
{
    mixed_ = true;
    dem::checkKeys
    (
        dict,
        {"default", "shapes", "cellsOverDiameter", "hysteresis"}
    );
    default_ = read(dict, "default");
    cells_ = dem::getPositive(dict, "cellsOverDiameter", 8);
    hysteresis_ = dem::getInRange(dict, "hysteresis", 0, 0.9, 0.2);
    if (dict.found("shapes"))
    {
        const dictionary& ofShapes = dict.subDict("shapes");
        dem::checkKeys(ofShapes, names);
        for (const word& name : ofShapes.toc())
        {
            named_.set(name, read(ofShapes, name));
        }
    }

    Info<< "    resolved";
    const char* before = ": ";
    for (const word& name : names)
    {
        const auto given = named_.cfind(name);
        const rule said = given.found() ? given.val() : default_;
        Info<< before << name;
        before = ", ";
        if (said == rule::bySize)
        {
            Info<< " from " << cells_ << " cells over the diameter on";
        }
        else
        {
            Info<< (said == rule::always ? " always" : " never");
        }
    }
    Info<< endl;
}


Foam::labelList Foam::coupling::bodyKinds::update
(
    const fvMesh& mesh,
    bodyCells& cells,
    const dem::bodies& state
)
{
    if (!mixed_)
    {
        return labelList();
    }

    const bool bySize = findRules(state);
    const List<scalar> size
    (
        bySize ? sizes(mesh, cells.find(state), state) : List<scalar>()
    );

    resolved_.setSize(state.size());
    Map<bool> now;
    DynamicList<label> changed;
    forAll(state.x, b)
    {
        const rule said = ofShape_[state.shapeI[b]];
        resolved_[b] = said == rule::always;
        if (said != rule::bySize)
        {
            continue;
        }

        // Outside of the mesh it stays what it was
        const auto was = ofId_.cfind(state.id[b]);
        const bool before = was.found() && was.val();
        const scalar least = before ? (1 - hysteresis_)*cells_ : cells_;
        resolved_[b] = size[b] > 0 ? size[b] >= least : before;
        if (was.found() && before != resolved_[b])
        {
            changed.append(b);
        }
        now.insert(state.id[b], resolved_[b]);
    }
    ofId_.transfer(now);
    return labelList(std::move(changed));
}


Foam::labelList Foam::coupling::bodyKinds::saved() const
{
    labelList kinds(resolved_.size());
    forAll(kinds, b)
    {
        kinds[b] = resolved_[b];
    }
    return kinds;
}


void Foam::coupling::bodyKinds::restore
(
    const dem::bodies& state,
    const labelUList& kinds
)
{
    resolved_.setSize(state.size());
    ofId_.clear();
    forAll(kinds, b)
    {
        resolved_[b] = kinds[b];
        ofId_.insert(state.id[b], kinds[b]);
    }
}


// ************************************************************************* //
