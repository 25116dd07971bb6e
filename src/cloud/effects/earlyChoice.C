/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "earlyChoice.H"
#include "fluidViscosity.H"

#include <cmath>

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- The values of a keyword in the dictionaries of a dictionary
wordList typesOf(const dictionary& dict, const word& key)
{
    DynamicList<word> found;
    for (const entry& e : dict)
    {
        if (e.isDict() && e.dict().found(key))
        {
            found.append(e.dict().getOrDefault<word>(key, ""));
        }
    }
    return wordList(std::move(found));
}


//- The largest restitution of all pairs
scalar restitution(const dictionary& properties)
{
    scalar most = -1;
    for (const entry& e : properties.subOrEmptyDict("pairs"))
    {
        if (e.isDict())
        {
            most =
                max(most, e.dict().getOrDefault<scalar>("restitution", -1));
        }
    }
    return most < 0 ? 0.9 : most;
}


scalar smallest(const effectTable& table)
{
    scalar d = GREAT;
    for (const sceneNumbers& n : table.kinds())
    {
        d = min(d, n.d);
    }
    return d;
}


//- The dictionary under a name, made if it is not there
dictionary& made(dictionary& dict, const word& name)
{
    if (!dict.found(name))
    {
        dict.add(name, dictionary(dict, dictionary()));
        dict.subDict(name).name() = fileName(dict.name() + '.' + name);
    }
    return dict.subDict(name);
}


//- Add entries to a block, and to what was added
void put
(
    dictionary& properties,
    dictionary& added,
    const word& block,
    const dictionary& entries
)
{
    made(properties, block).merge(entries);
    added.add(block, entries);
}


//- Add the film, in the block that bodies of the scene's kind have. Where some
//  fill cells and others are points there is one film: it ends at a cell, which
//  is more than a point has
void chooseFilm
(
    dictionary& properties,
    dictionary& added,
    const effectTable& table,
    const scalar roughness
)
{
    bool meet = false;
    scalar cell = 0;
    for (const sceneNumbers& n : table.kinds())
    {
        if (!n.point())
        {
            meet = meet || n.nBodies > 1 || n.walls;
            cell = max(cell, n.cell);
        }
    }
    const word coupling(properties.getOrDefault<word>("coupling", "twoWay"));
    const bool forces = properties.found("forces");
    const bool named = properties.found("immersed");
    const bool solid =
        coupling == "twoWay" && table.on("immersed") && (named || !forces);
    const bool points =
        !solid || forces || (table.on("resolved") && !named);
    const dictionary& given = properties.subOrEmptyDict("forces");
    if
    (
        coupling == "particlesToFluid" || given.found("coarseGraining")
     || !(table.on("lubrication") || (solid && meet))
     || given.found("lubrication")
     || properties.subOrEmptyDict("immersed").found("lubrication")
    )
    {
        return;
    }

    dictionary film;
    film.add("roughness", roughness);
    if (solid)
    {
        film.add("widest", cell);
    }
    dictionary entries, forcing;
    forcing.add("type", word("implicitForcing"));
    if (points && solid && !named)
    {
        put(properties, added, "immersed", forcing);
    }
    if (!points && !named)
    {
        entries = forcing;
    }
    entries.add("lubrication", film);
    put(properties, added, points ? "forces" : "immersed", entries);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

bool Foam::earlyChoice::mayRest(const dictionary& properties)
{
    const dictionary& contact = properties.subOrEmptyDict("contact");
    bool cohesive = false;
    if (contact.found("cohesion"))
    {
        for (const word& name : contact.get<wordList>("cohesion"))
        {
            cohesive = cohesive || name != "simplifiedJKR";
        }
    }
    const dictionary& walls = properties.subOrEmptyDict("walls");
    bool moves = walls.empty();
    for (const entry& e : walls)
    {
        for (const char* key : {"motion", "appears", "opens"})
        {
            moves = moves || (e.isDict() && e.dict().found(key));
        }
    }
    bool come = properties.found("sinks");
    for
    (
        const word& type
      : typesOf(properties.subOrEmptyDict("generators"), "type")
    )
    {
        come = come || (type != "fill" && type != "file");
    }
    return
        !properties.found("fluid")
     && properties.getOrDefault<word>("demSolver", "") == "hades"
     && properties.getOrDefault<word>("integrator", "stormerVerlet")
     == "stormerVerlet"
     && contact.getOrDefault<word>("damping", "restitution") != "none"
     && !cohesive && !moves && !come;
}


void Foam::earlyChoice::judgeRest
(
    effectTable& table,
    const dictionary& properties,
    const fvMesh& mesh,
    const vector& g
)
{
    const scalar e = min(restitution(properties), scalar(0.99));
    if (!(mag(g) > 0) || !mayRest(properties))
    {
        return;
    }
    const scalar height =
        cmptSum(cmptMag(cmptMultiply(mesh.bounds().span(), g/mag(g))));
    const scalar rest = std::sqrt(2*height/mag(g))*(1 + e)/(1 - e);
    const scalar left = mesh.time().endTime().value() - mesh.time().value();
    const scalar share = left > rest ? 1 - rest/left : 0;
    table.note
    ({
        "sleeping", rest, "time [s] to rest, of " + Foam::name(left),
        0.5*left, "bounces of a ball", share, share > 0.5,
        "a look at each body, 8 in " + Foam::name
        (
            0.5*std::sqrt(smallest(table)/mag(g))
        ) + " s"
    });
}


Foam::string Foam::earlyChoice::noFilm
(
    const dictionary& properties,
    const fvMesh& mesh
)
{
    string why;
    if (!properties.subOrEmptyDict("effects").found("roughness"))
    {
        why =
            "the roughness of the surfaces decides what it does: effects {"
            " type auto; roughness 1e-6; }";
    }
    else if (properties.found("sleeping"))
    {
        why =
            "a body asleep would not wake up when a film pushes it: take"
            " sleeping out";
    }
    else if
    (
        !properties.subOrEmptyDict("fluid").found("nu")
     && !(coupling::fluidViscosity::entry(mesh) > 0)
    )
    {
        why =
            "its liquid has one viscosity, which nobody has given: nu in the"
            " dictionary fluid";
    }
    return why;
}


Foam::dictionary Foam::earlyChoice::choose
(
    dictionary& properties,
    const effectTable& table
)
{
    dictionary added;
    if (table.on("sleeping") && !properties.found("sleeping"))
    {
        const scalar d = smallest(table);
        const scalar g = table.kinds()[0].g;
        dictionary sleeping;
        sleeping.add("speed", 0.01*std::sqrt(g*d));
        sleeping.add("time", 0.5*std::sqrt(d/g));
        properties.add("sleeping", sleeping);
        properties.subDict("sleeping").name() =
            fileName(properties.name() + ".sleeping");
        added.add("sleeping", sleeping);
    }
    const dictionary& effects = properties.subOrEmptyDict("effects");
    if (effects.found("roughness") && !properties.found("sleeping"))
    {
        chooseFilm
        (
            properties, added, table, effects.get<scalar>("roughness")
        );
    }
    return added;
}


// ************************************************************************* //
