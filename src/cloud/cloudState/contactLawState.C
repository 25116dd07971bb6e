/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "contactLawState.H"

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using cloudState::savedBodies;

//- Angles of contacts, by the body that they are written with
struct rolledLists
{
    List<DynamicList<vector>> rolled;
    List<DynamicList<scalar>> twisted;

    explicit rolledLists(const label nBodies)
    :
        rolled(nBodies),
        twisted(nBodies)
    {}

    void append(const label b, const scalar* angle)
    {
        rolled[b].append(vector(angle[0], angle[1], angle[2]));
        twisted[b].append(angle[3]);
    }

    void write(lagrangianWriter& out, const word& name) const
    {
        out.writeLists(name + "Rolled", rolled);
        out.writeLists(name + "Twisted", twisted);
    }
};


//- The lists of all bodies one after the other; as many as there should be
template<class Type>
List<Type> joined
(
    const savedBodies& saved,
    const word& name,
    const label n
)
{
    DynamicList<Type> all;
    for (const Field<Type>& list : saved.lists<Type>(name))
    {
        all.append(list);
    }
    if (all.size() != n)
    {
        saved.bad(name)
            << "There are " << all.size() << " entries for " << n
            << " contacts." << exit(FatalIOError);
    }
    return List<Type>(std::move(all));
}


List<dem::wallRolled> readRolled
(
    const savedBodies& saved,
    const word& name,
    const label n
)
{
    List<dem::wallRolled> angles(n);
    if (saved.has(name + "Rolled"))
    {
        const List<vector> rolled(joined<vector>(saved, name + "Rolled", n));
        const List<scalar> twisted
        (
            joined<scalar>(saved, name + "Twisted", n)
        );
        forAll(angles, k)
        {
            for (direction d = 0; d < 3; ++d)
            {
                angles[k].angle[d] = rolled[k][d];
            }
            angles[k].angle[3] = twisted[k];
        }
    }
    return angles;
}


//- Stop if a body has not that sphere
void checkSphere
(
    const savedBodies& saved,
    const word& name,
    const dem::bodies& state,
    const label b,
    const label s
)
{
    if (b < 0 || s < 0 || s >= state.firstSphere[b + 1] - state.firstSphere[b])
    {
        saved.bad(name)
            << "A bridge names a body or a sphere that is not there."
            << exit(FatalIOError);
    }
}


//- So many numbers a bridge
const labelField& checkedBridges
(
    const savedBodies& saved,
    const word& name,
    const labelField& numbers,
    const label n
)
{
    if (numbers.size() % n)
    {
        saved.bad(name)
            << "There are " << numbers.size() << " numbers of bridges, each of"
            << " which has " << n << '.' << exit(FatalIOError);
    }
    return numbers;
}


//- Bridges by name
List<dem::namedPair> readPairBridges
(
    const savedBodies& saved,
    const dem::bodies& state
)
{
    const word name("bridgeSpheres");
    const List<labelField> lists(saved.lists<label>(name));
    DynamicList<dem::namedPair> pairs;
    forAll(lists, b)
    {
        const labelField& numbers = checkedBridges(saved, name, lists[b], 4);
        for (label k = 0; k < numbers.size(); k += 4)
        {
            checkSphere(saved, name, state, b, numbers[k]);
            dem::namedPair p;
            p.i = dem::sphereName{saved.id[b], numbers[k]};
            p.j = dem::sphereName{numbers[k + 1], numbers[k + 2]};
            p.memory.pair.image = numbers[k + 3];
            p.memory.bridge = true;
            const label image = numbers[k + 3];
            if (p.j.body <= p.i.body || image < 0 || image > 26)
            {
                saved.bad(name)
                    << "Body " << saved.id[b] << " has a bridge to body "
                    << numbers[k + 1] << ", image " << image
                    << ", which cannot be." << exit(FatalIOError);
            }
            pairs.append(p);
        }
    }
    return List<dem::namedPair>(std::move(pairs));
}


List<dem::wallTouch> readWallBridges
(
    const savedBodies& saved,
    const wordList& savedWalls,
    const dem::demSolver& dem
)
{
    const word name("wallBridgeSpheres");
    const dem::bodies& state = dem.state();
    const wordList walls(dem.walls());
    const List<labelField> lists(saved.lists<label>(name));
    label n = 0;
    for (const labelField& numbers : lists)
    {
        n += checkedBridges(saved, name, numbers, 2).size()/2;
    }
    const List<vector> normal(joined<vector>(saved, "wallBridgeNormal", n));

    DynamicList<dem::wallTouch> touches;
    n = 0;
    forAll(lists, b)
    {
        for (label k = 0; k < lists[b].size(); k += 2, ++n)
        {
            checkSphere(saved, name, state, b, lists[b][k]);
            const label w = lists[b][k + 1];
            dem::wallTouch t = {};
            t.sphere = state.firstSphere[b] + lists[b][k];
            t.wallI =
                w >= 0 && w < savedWalls.size()
              ? walls.find(savedWalls[w])
              : -1;
            t.p = state.sphereX()[t.sphere];
            t.n = normal[n];
            if (t.wallI >= 0)
            {
                touches.append(t);
            }
        }
    }
    return List<dem::wallTouch>(std::move(touches));
}


//- Of the contacts with walls that are still there
List<dem::wallRolled> readWallsRolled
(
    const savedBodies& saved,
    const wordList& savedWalls,
    const wordList& walls
)
{
    DynamicList<bool> stays;
    for (const labelField& numbers : saved.lists<label>("wallSpheres"))
    {
        for (label k = 1; k < numbers.size(); k += 2)
        {
            stays.append(walls.found(savedWalls[numbers[k]]));
        }
    }
    const List<dem::wallRolled> all(readRolled(saved, "wall", stays.size()));
    DynamicList<dem::wallRolled> left;
    forAll(all, k)
    {
        if (stays[k])
        {
            left.append(all[k]);
        }
    }
    return List<dem::wallRolled>(std::move(left));
}


void setRolled
(
    dem::verletList::pairHistory& h,
    const dem::wallRolled& rolled
)
{
    std::copy(rolled.angle, rolled.angle + 4, h.rolled);
}


//- Number of a body of this rank, if it owns the sphere; else -1
label ownerOf
(
    const dem::bodies& state,
    const dem::bodies& all,
    const label sphere
)
{
    const label b = all.sphereBody[sphere];
    return all.owns(b) ? state.find(all.id[b]) : -1;
}


label numberOf(const dem::bodies& all, const label sphere)
{
    return sphere - all.firstSphere[all.sphereBody[sphere]];
}


void writeRolled
(
    lagrangianWriter& out,
    const dem::bodies& state,
    const dem::bodies& all,
    const dem::contactHistory& history
)
{
    rolledLists pairs(state.size()), walls(state.size());
    for (const dem::verletList::pairHistory& h : history.pairs)
    {
        const label b = ownerOf(state, all, h.pair.i);
        if (b >= 0)
        {
            pairs.append(b, h.rolled);
        }
    }
    forAll(history.walls, k)
    {
        const label b = ownerOf(state, all, history.walls[k].sphere);
        if (b >= 0)
        {
            walls.append(b, history.wallsRolled[k].angle);
        }
    }
    pairs.write(out, "contact");
    walls.write(out, "wall");
}


void writeBridges
(
    lagrangianWriter& out,
    const dem::bodies& state,
    const dem::bodies& all,
    const dem::contactHistory& history
)
{
    List<DynamicList<label>> pairs(state.size()), walls(state.size());
    List<DynamicList<vector>> normal(state.size());
    for (const dem::verletList::pairHistory& h : history.pairsBridged)
    {
        const label b = ownerOf(state, all, h.pair.i);
        if (b >= 0)
        {
            pairs[b].append(numberOf(all, h.pair.i));
            pairs[b].append(all.id[all.sphereBody[h.pair.j]]);
            pairs[b].append(numberOf(all, h.pair.j));
            pairs[b].append(h.pair.image);
        }
    }
    for (const dem::wallTouch& t : history.wallsBridged)
    {
        const label b = ownerOf(state, all, t.sphere);
        if (b >= 0)
        {
            walls[b].append(numberOf(all, t.sphere));
            walls[b].append(t.wallI);
            normal[b].append(t.n);
        }
    }
    out.writeLists("bridgeSpheres", pairs);
    out.writeLists("wallBridgeSpheres", walls);
    out.writeLists("wallBridgeNormal", normal);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::dem::namedTouch Foam::cloudState::namedOf
(
    const dem::wallTouch& t,
    const dem::bodies& state
)
{
    const label b = state.sphereBody[t.sphere];
    dem::namedTouch n;
    n.i = dem::sphereName{state.id[b], t.sphere - state.firstSphere[b]};
    n.memory = t;
    return n;
}


void Foam::cloudState::writeContactLaws
(
    lagrangianWriter& out,
    const dem::bodies& state,
    const dem::bodies& all,
    const dem::contactHistory& history
)
{
    if (history.rolls)
    {
        writeRolled(out, state, all, history);
    }
    if (history.bridges)
    {
        writeBridges(out, state, all, history);
    }
}


void Foam::cloudState::readContactLaws
(
    const savedBodies& saved,
    const wordList& savedWalls,
    const dem::demSolver& dem,
    dem::contactHistory& history
)
{
    const dem::contactHistory laws(dem.history());
    if (laws.rolls)
    {
        const List<dem::wallRolled> pairs
        (
            readRolled(saved, "contact", history.pairs.size())
        );
        forAll(pairs, k)
        {
            setRolled(history.pairs[k], pairs[k]);
        }
        history.wallsRolled = readWallsRolled(saved, savedWalls, dem.walls());
    }
    if (laws.bridges && saved.has("bridgeSpheres"))
    {
        const dem::bodies& state = dem.state();
        Map<label> indexOf(2*state.size());
        forAll(saved.id, b)
        {
            indexOf.insert(saved.id[b], b);
        }
        DynamicList<dem::verletList::pairHistory> bridges;
        for (const dem::namedPair& p : readPairBridges(saved, state))
        {
            const label a = indexOf.lookup(p.i.body, -1);
            const label b = indexOf.lookup(p.j.body, -1);
            checkSphere(saved, "bridgeSpheres", state, b, p.j.sphere);
            dem::verletList::pairHistory h;
            h.pair.i = state.firstSphere[a] + p.i.sphere;
            h.pair.j = state.firstSphere[b] + p.j.sphere;
            h.pair.image = p.memory.pair.image;
            bridges.append(h);
        }
        history.pairsBridged = bridges;
        history.wallsBridged = readWallBridges(saved, savedWalls, dem);
    }
}


void Foam::cloudState::readContactLaws
(
    const savedBodies& saved,
    const wordList& savedWalls,
    const dem::demSolver& dem,
    List<dem::namedPair>& pairs,
    List<dem::namedTouch>& touches
)
{
    const dem::contactHistory laws(dem.history());
    if (laws.rolls)
    {
        const List<dem::wallRolled> rolled
        (
            readRolled(saved, "contact", pairs.size())
        );
        forAll(rolled, k)
        {
            setRolled(pairs[k].memory, rolled[k]);
        }
        const List<dem::wallRolled> atWalls
        (
            readWallsRolled(saved, savedWalls, dem.walls())
        );
        forAll(atWalls, k)
        {
            touches[k].rolled = atWalls[k];
        }
    }
    if (laws.bridges && saved.has("bridgeSpheres"))
    {
        pairs.append(readPairBridges(saved, dem.state()));
        for (const auto& t : readWallBridges(saved, savedWalls, dem))
        {
            touches.append(namedOf(t, dem.state()));
            touches.last().bridge = true;
        }
    }
}


// ************************************************************************* //
