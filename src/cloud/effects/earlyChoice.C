/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "earlyChoice.H"

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


//- The film, with the gap from which on the mesh resolves the flow
dictionary film(const scalar roughness, const scalar range)
{
    dictionary dict;
    dict.add("roughness", roughness);
    if (range > 0)
    {
        dict.add("range", min(range, scalar(2)));
    }
    return dict;
}


//- Add the film, in the block that bodies of the scene's kind have
void chooseFilm
(
    dictionary& properties,
    dictionary& added,
    const effectTable& table,
    const scalar roughness
)
{
    bool meet = false;
    scalar range = 0;
    for (const sceneNumbers& n : table.kinds())
    {
        meet = meet || n.nBodies > 1 || n.walls;
        range = max(range, 2*n.cell/n.d);
    }
    const bool solid = table.on("immersed");
    if (table.on("resolved") || !(table.on("lubrication") || (solid && meet)))
    {
        return;
    }
    const word block(solid ? "immersed" : "forces");
    dictionary entries;
    if (solid && !properties.found(block))
    {
        entries.add("type", word("implicitForcing"));
    }
    entries.add("lubrication", film(roughness, solid ? range : 0));
    if (!properties.found(block))
    {
        properties.add(block, dictionary(properties, dictionary()));
        properties.subDict(block).name() =
            fileName(properties.name() + '.' + block);
    }
    if (!properties.subDict(block).found("lubrication"))
    {
        properties.subDict(block).merge(entries);
        added.add(block, entries);
    }
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
    if (effects.found("roughness"))
    {
        chooseFilm
        (
            properties, added, table, effects.get<scalar>("roughness")
        );
    }
    return added;
}


// ************************************************************************* //
