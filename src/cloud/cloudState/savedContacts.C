/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "contactLawState.H"
#include "savedContacts.H"

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using cloudState::savedBodies;

//- Index of the sphere that a body counts as number s
label sphereOf
(
    const dem::bodies& state,
    const label b,
    const label s,
    const savedBodies& saved,
    const word& field
)
{
    if (b < 0 || s < 0 || s >= state.shapeOf(b).radii().size())
    {
        saved.bad(field)
            << "A contact names a body or a sphere that is not there."
            << exit(FatalIOError);
    }
    return state.firstSphere[b] + s;
}


//- The image of the partner in each contact; the original without a seam
List<labelField> readImages
(
    const savedBodies& saved,
    const UList<vectorField>& slip,
    const bool periodic
)
{
    List<labelField> images(slip.size());
    if (!periodic)
    {
        forAll(images, b)
        {
            images[b] =
                labelField(slip[b].size(), label(dem::periodicity::original));
        }
        return images;
    }

    const word name("contactImage");
    images = saved.lists<label>(name);
    forAll(images, b)
    {
        bool good = images[b].size() == slip[b].size();
        for (const label image : images[b])
        {
            good = good && image >= 0 && image < 27;
        }
        if (!good)
        {
            saved.bad(name)
                << "Body " << saved.id[b] << " has the images " << images[b]
                << " for " << slip[b].size() << " contacts: one each, from 0 to"
                << " 26." << exit(FatalIOError);
        }
    }
    return images;
}


//- Stop if a body has not three numbers for each contact
void checkNumbers
(
    const savedBodies& saved,
    const label b,
    const labelField& spheres,
    const vectorField& slip
)
{
    if (spheres.size() != 3*slip.size())
    {
        saved.bad("contactSpheres")
            << "Body " << saved.id[b] << " has " << spheres.size()
            << " numbers for " << slip.size() << " contacts."
            << exit(FatalIOError);
    }
}


//- Stop if a contact is not on the body of the lower id
void checkOrder(const savedBodies& saved, const label b, const label otherId)
{
    if (otherId <= saved.id[b])
    {
        saved.bad("contactSpheres")
            << "The contact of body " << saved.id[b] << " with body "
            << otherId << " is on the wrong one." << exit(FatalIOError);
    }
}


List<dem::verletList::pairHistory> readPairs
(
    const savedBodies& saved,
    const dem::bodies& state,
    const bool periodic
)
{
    const word name("contactSpheres");
    const List<labelField> spheres(saved.lists<label>(name));
    const List<vectorField> slip(saved.lists<vector>("contactSlip"));
    const List<labelField> images(readImages(saved, slip, periodic));

    Map<label> indexOf(2*state.size());
    forAll(saved.id, b)
    {
        indexOf.insert(saved.id[b], b);
    }

    DynamicList<dem::verletList::pairHistory> pairs;
    forAll(spheres, b)
    {
        checkNumbers(saved, b, spheres[b], slip[b]);
        forAll(slip[b], k)
        {
            const label* number = &spheres[b][3*k];
            const label other = indexOf.lookup(number[1], -1);
            const label i = sphereOf(state, b, number[0], saved, name);
            const label j = sphereOf(state, other, number[2], saved, name);
            checkOrder(saved, b, number[1]);
            pairs.append
            (
                dem::verletList::pairHistory{{i, j, images[b][k]}, slip[b][k]}
            );
        }
    }
    return List<dem::verletList::pairHistory>(std::move(pairs));
}


List<dem::wallTouch> readWalls
(
    const savedBodies& saved,
    const dem::bodies& state,
    const wordList& savedWalls,
    const wordList& walls
)
{
    const word name("wallSpheres");
    const List<labelField> spheres(saved.lists<label>(name));
    const List<vectorField> normal(saved.lists<vector>("wallNormal"));
    const List<vectorField> slip(saved.lists<vector>("wallSlip"));

    DynamicList<dem::wallTouch> touches;
    forAll(spheres, b)
    {
        if
        (
            spheres[b].size() != 2*slip[b].size()
         || normal[b].size() != slip[b].size()
        )
        {
            saved.bad(name)
                << "Body " << saved.id[b] << " has " << spheres[b].size()
                << " numbers and " << normal[b].size() << " normals for "
                << slip[b].size() << " contacts." << exit(FatalIOError);
        }
        forAll(slip[b], k)
        {
            const label w = spheres[b][2*k + 1];
            if (w < 0 || w >= savedWalls.size())
            {
                saved.bad(name)
                    << "Body " << saved.id[b] << " touches wall number " << w
                    << " of " << savedWalls << "." << exit(FatalIOError);
            }

            // A wall that is not in the case any more is not touched
            const label wallI = walls.find(savedWalls[w]);
            if (wallI < 0)
            {
                continue;
            }
            dem::wallTouch t;
            t.sphere = sphereOf(state, b, spheres[b][2*k], saved, name);
            t.wallI = wallI;
            t.p = state.sphereX()[t.sphere];
            t.n = normal[b][k];
            t.overlap = 0;
            t.xi = slip[b][k];
            t.likeness = 0;
            touches.append(t);
        }
    }
    return List<dem::wallTouch>(std::move(touches));
}


//- What contacts remember, by name: the partner may be on another rank
List<dem::namedPair> readNamedPairs
(
    const savedBodies& saved,
    const dem::bodies& state,
    const bool periodic
)
{
    const word name("contactSpheres");
    const List<labelField> spheres(saved.lists<label>(name));
    const List<vectorField> slip(saved.lists<vector>("contactSlip"));
    const List<labelField> images(readImages(saved, slip, periodic));

    DynamicList<dem::namedPair> pairs;
    forAll(spheres, b)
    {
        checkNumbers(saved, b, spheres[b], slip[b]);
        forAll(slip[b], k)
        {
            const label* number = &spheres[b][3*k];
            sphereOf(state, b, number[0], saved, name);
            checkOrder(saved, b, number[1]);

            dem::namedPair p;
            p.i = dem::sphereName{saved.id[b], number[0]};
            p.j = dem::sphereName{number[1], number[2]};
            p.memory.pair.image = images[b][k];
            p.memory.xi = slip[b][k];
            pairs.append(p);
        }
    }
    return List<dem::namedPair>(std::move(pairs));
}


List<dem::namedTouch> named
(
    const UList<dem::wallTouch>& touches,
    const dem::bodies& state
)
{
    DynamicList<dem::namedTouch> all;
    for (const dem::wallTouch& t : touches)
    {
        all.append(cloudState::namedOf(t, state));
    }
    return List<dem::namedTouch>(std::move(all));
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::cloudState::readContacts
(
    const savedBodies& saved,
    const wordList& savedWalls,
    dem::demSolver& dem
)
{
    const dem::bodies& state = dem.state();
    const bool periodic = dem.period().active();
    const List<dem::wallTouch> touches
    (
        readWalls(saved, state, savedWalls, dem.walls())
    );
    if (dem.group().shared())
    {
        List<dem::namedPair> pairs(readNamedPairs(saved, state, periodic));
        List<dem::namedTouch> atWalls(named(touches, state));
        readContactLaws(saved, savedWalls, dem, pairs, atWalls);
        dem.setHistory(pairs, atWalls);
    }
    else
    {
        dem::contactHistory history;
        history.pairs = readPairs(saved, state, periodic);
        history.walls = touches;
        readContactLaws(saved, savedWalls, dem, history);
        dem.setHistory(history);
    }
}


// ************************************************************************* //
