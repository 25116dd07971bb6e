/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "effectChoice.H"

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- What an effect of the contacts has in the pairs, the materials and contact
struct contactKeys
{
    word effect;
    wordList ofPairs;
    wordList ofMaterials;
    wordList ofContact;
};


const List<contactKeys> contactEffects
({
    {
        "capillary", {"surfaceTension", "contactAngle", "bridgeVolume"}, {}, {}
    },
    {
        "vanDerWaals",
        {"hamakerConstant", "minSeparation", "maxSeparation"}, {}, {}
    },
    {"simplifiedJKR", {"cohesionEnergyDensity"}, {}, {}},
    {
        "electrostatic", {}, {"surfaceCharge"},
        {"chargeCutOff", "relativePermittivity"}
    },
    {"rolling", {"rollingFriction", "rollingDampingRatio"}, {}, {}}
});


//- Has one of the dictionaries of a dictionary the keyword?
bool anyHas(const dictionary& dict, const wordList& keys)
{
    for (const entry& e : dict)
    {
        if (e.isDict() && keys.size() && e.dict().found(keys[0]))
        {
            return true;
        }
    }
    return false;
}


//- Take keywords out of all dictionaries of a dictionary
void strip(dictionary& dict, const wordList& keys)
{
    for (entry& e : dict)
    {
        for (const word& key : keys)
        {
            if (e.isDict())
            {
                e.dict().remove(key);
            }
        }
    }
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


//- Add an entry to a dictionary and to the list of what was added
template<class Type>
void put
(
    dictionary& dict,
    dictionary& added,
    const word& key,
    const Type& value
)
{
    dict.add(key, value);
    added.add(key, value);
}


void chooseForces
(
    dictionary& forces,
    dictionary& added,
    const effectTable& table,
    const bool modelB,
    const scalar deltaT
)
{
    if (!forces.found("drag"))
    {
        put
        (
            forces,
            added,
            "drag",
            word
            (
                !table.on("drag") ? "none"
              : table.on("denseDrag") ? "gidaspow" : "schillerNaumann"
            )
        );
    }
    for (const word& name : effectChoice::forces())
    {
        // In model B the drag holds what acts on the volume
        const bool counted =
            modelB && (name == "pressureGradient" || name == "viscous");
        const bool other = name == "saffman" && forces.found("mei");
        if (forces.found(name) || counted || other || !table.on(name))
        {
            continue;
        }
        if (name == "basset")
        {
            dictionary memory;
            memory.add("memory", word("exponentials"));
            memory.add("window", 10*deltaT);
            put(forces, added, name, memory);
        }
        else
        {
            put(forces, added, name, word("yes"));
        }
    }
}


dictionary fractionModel(const effectTable& table, const bool averaged)
{
    // Of those that are points, if there are others
    scalar d = 0, cell = GREAT;
    for (const sceneNumbers& n : table.kinds())
    {
        if (!table.on("resolved") || n.point())
        {
            d = max(d, n.d);
            cell = min(cell, n.cell > 0 ? n.cell : GREAT);
        }
    }
    dictionary model;
    const bool wide = cell >= 3*d;
    model.add
    (
        "type",
        word(!wide ? "diffusion" : averaged ? "divided" : "centroid")
    );
    if (!wide)
    {
        model.add("bandwidth", 6*d);
    }
    return model;
}


//- Which bodies fill cells
dictionary whichFill(const effectTable& table)
{
    dictionary kinds, shapes;
    bool refines = false;
    for (const sceneNumbers& n : table.kinds())
    {
        refines = refines || n.refines;
        shapes.set(n.shape, word(n.point() ? "never" : "always"));
    }
    if (refines)
    {
        // The cells are those of the bodies that fill them
        kinds.add("shapes", shapes);
    }
    else
    {
        kinds.add("default", word("auto"));
        kinds.add("cellsOverDiameter", sceneNumbers::fills);
    }
    return kinds;
}


//- The coupling of the scene, or of the blocks that are there by hand
word couplingOf
(
    const dictionary& properties,
    const effectTable& table,
    const bool acts
)
{
    bool fluid = false;
    for (const sceneNumbers& n : table.kinds())
    {
        fluid = fluid || n.inFluid();
    }
    const bool byHand =
        properties.found("immersed") || properties.found("voidFraction")
     || properties.found("momentumExchange");
    return
        !fluid ? "none"
      : byHand || table.on("immersed") ? "twoWay"
      : acts && table.on("exchange") ? "twoWay" : "fluidToParticles";
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::effectChoice::forces()
{
    return
    {
        "buoyancy", "pressureGradient", "viscous", "virtualMass", "basset",
        "saffman", "magnus", "rotationalDrag", "dispersion"
    };
}


Foam::wordList Foam::effectChoice::nameContacts(dictionary& properties)
{
    DynamicList<word> named, cohesion;
    if (!properties.found("pairs") || !properties.found("materials"))
    {
        return wordList();
    }
    const bool free = !properties.subOrEmptyDict("contact").found("cohesion");
    const bool rolls = !properties.subOrEmptyDict("contact").found("rolling");
    for (const contactKeys& c : contactEffects)
    {
        const bool given =
            anyHas(properties.subDict("pairs"), c.ofPairs)
         || anyHas(properties.subDict("materials"), c.ofMaterials);
        if (given && (c.effect == "rolling" ? rolls : free))
        {
            named.append(c.effect);
            if (c.effect != "rolling")
            {
                cohesion.append(c.effect);
            }
        }
    }
    if (cohesion.size())
    {
        made(properties, "contact").add("cohesion", wordList(cohesion));
    }
    if (named.found("rolling"))
    {
        made(properties, "contact").add("rolling", word("elasticPlastic"));
    }
    return wordList(named);
}


void Foam::effectChoice::dropContacts
(
    dictionary& properties,
    const wordList& named,
    const effectTable& table
)
{
    DynamicList<word> kept;
    for (const contactKeys& c : contactEffects)
    {
        if (!named.found(c.effect))
        {
            continue;
        }
        if (table.on(c.effect))
        {
            kept.append(c.effect);
            continue;
        }
        strip(properties.subDict("pairs"), c.ofPairs);
        strip(properties.subDict("materials"), c.ofMaterials);
        for (const word& key : c.ofContact)
        {
            properties.subDict("contact").remove(key);
        }
    }

    wordList cohesion(kept);
    inplaceSubsetList
    (
        cohesion, [](const word& name) { return name != "rolling"; }
    );
    if (named.size() && properties.found("contact"))
    {
        dictionary& contact = properties.subDict("contact");
        if (cohesion.size())
        {
            contact.set("cohesion", cohesion);
        }
        else if (named.size() > label(named.found("rolling")))
        {
            contact.remove("cohesion");
        }
        if (named.found("rolling") && !kept.found("rolling"))
        {
            contact.remove("rolling");
        }
    }
}


Foam::dictionary Foam::effectChoice::chooseCoupling
(
    dictionary& properties,
    const effectTable& table,
    const bool acts,
    const bool averaged,
    const scalar deltaT
)
{
    dictionary added;
    if (!properties.found("coupling"))
    {
        put
        (
            properties, added, "coupling",
            couplingOf(properties, table, acts)
        );
    }
    const word coupling(properties.get<word>("coupling"));
    if (coupling == "none")
    {
        return added;
    }

    const bool solid =
        !properties.found("forces")
     && (
            coupling == "particlesToFluid"
         || (
                coupling == "twoWay"
             && (properties.found("immersed") || table.on("immersed"))
            )
        );
    const bool both =
        coupling == "twoWay" && table.on("resolved")
     && properties.found("forces") == properties.found("immersed");
    if (solid || both)
    {
        if (!properties.found("immersed"))
        {
            dictionary immersed;
            immersed.add("type", word("implicitForcing"));
            put(properties, added, "immersed", immersed);
        }
        if (!both)
        {
            return added;
        }
        put(properties, added, "resolved", whichFill(table));
    }

    const bool modelB =
        properties.subOrEmptyDict("momentumExchange")
       .getOrDefault<word>("equations", "A") == "B";
    dictionary chosen;
    chooseForces
    (
        made(properties, "forces"), chosen, table, modelB, deltaT
    );
    added.add("forces", chosen);
    if (coupling == "twoWay" && !properties.found("voidFraction"))
    {
        put(properties, added, "voidFraction", fractionModel(table, averaged));
    }
    return added;
}


// ************************************************************************* //
