/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "forceMemory.H"

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

Foam::word fieldOf(const Foam::coupling::pointForce& f)
{
    return "memory_" + f.type();
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::cloudState::writeForceMemory
(
    lagrangianWriter& out,
    const dem::bodies& state,
    const coupling::pointForces& points
)
{
    DynamicList<word> names;
    for (const coupling::pointForce& f : points.forces())
    {
        if (!f.remembers())
        {
            continue;
        }

        List<DynamicList<vector>> values(state.size());
        forAll(values, b)
        {
            f.save(state.id[b], values[b]);
        }
        out.writeLists(fieldOf(f), values);
        names.append(f.type());
    }
    return wordList(std::move(names));
}


void Foam::cloudState::readForceMemory
(
    const savedBodies& saved,
    const wordList& written,
    coupling::pointForces& points
)
{
    for (coupling::pointForce& f : points.forces())
    {
        if (!f.remembers())
        {
            continue;
        }
        if (!written.found(f.type()))
        {
            Info<< "    force " << f.type() << " starts without memory: this"
                << " time was written without it" << endl;
            continue;
        }

        const List<vectorField> values(saved.lists<vector>(fieldOf(f)));
        forAll(values, b)
        {
            if (!f.load(saved.id[b], values[b]))
            {
                saved.bad(fieldOf(f))
                    << "The " << values[b].size() << " vectors of body "
                    << saved.id[b] << " are no memory of the force "
                    << f.type() << " with the options that it has now."
                    << exit(FatalIOError);
            }
        }
    }
}


// ************************************************************************* //
