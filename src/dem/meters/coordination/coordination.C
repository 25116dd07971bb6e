/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "coordination.H"
#include "allowedKeys.H"
#include "addToRunTimeSelectionTable.H"

#include <algorithm>
#include <utility>
#include <vector>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(coordination, 0);
    addToRunTimeSelectionTable(meter, coordination, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::coordination::writeRow(Ostream& os) const
{
    os  << ' ' << nBodies_ << ' ' << nPairs_ << ' ' << nWalls_ << ' '
        << nRattlers_ << ' ' << Z() << ' ' << zBackbone_;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::coordination::coordination
(
    const word& name,
    const dictionary& dict,
    const periodicity&
)
:
    meter(name)
{
    checkKeys(dict, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::coordination::end(const demSolver& dem, const scalar)
{
    const bodies& all = dem.touching();
    const contactHistory history(dem.history());

    // Pairs of bodies, each once; of one with a copy two ranks know
    std::vector<std::pair<label, label>> pairs;
    for (const auto& h : history.pairs)
    {
        const label a = all.sphereBody[h.pair.i];
        const label b = all.sphereBody[h.pair.j];
        pairs.emplace_back(min(a, b), max(a, b));
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());

    labelList nOthers(all.size(), Zero);
    for (const auto& p : pairs)
    {
        ++nOthers[p.first];
        ++nOthers[p.second];
    }
    boolList atWall(all.size(), false);
    for (const wallTouch& t : history.walls)
    {
        atWall[all.sphereBody[t.sphere]] = true;
    }

    labelList rattles(all.size());
    label nRattlers = 0, nWalls = 0, nBodies = 0;
    forAll(rattles, b)
    {
        rattles[b] = nOthers[b] < 2 && !atWall[b];
        nRattlers += all.owns(b) && rattles[b];
        nWalls += all.owns(b) && atWall[b];
        nBodies += all.owns(b);
    }
    dem.copy(rattles);

    // The owner of the first body counts
    label nPairs = 0, nBackbone = 0;
    for (const auto& p : pairs)
    {
        nPairs += all.owns(p.first);
        nBackbone +=
            all.owns(p.first) && !rattles[p.first] && !rattles[p.second];
    }

    const rankGroup& group = dem.group();
    nBodies_ = group.sum(nBodies);
    nRattlers_ = group.sum(nRattlers);
    nWalls_ = group.sum(nWalls);
    nPairs_ = group.sum(nPairs);
    nBackbone = group.sum(nBackbone);
    zBackbone_ =
        nBodies_ > nRattlers_ ? 2.0*nBackbone/(nBodies_ - nRattlers_) : 0;
}


// ************************************************************************* //
