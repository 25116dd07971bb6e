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
    const bodies& state = dem.state();
    const contactHistory history(dem.history());

    // Pairs of bodies, each once
    std::vector<std::pair<label, label>> pairs;
    for (const auto& h : history.pairs)
    {
        const label a = state.sphereBody[h.pair.i];
        const label b = state.sphereBody[h.pair.j];
        pairs.emplace_back(min(a, b), max(a, b));
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());

    labelList nOthers(state.size(), Zero);
    for (const auto& p : pairs)
    {
        ++nOthers[p.first];
        ++nOthers[p.second];
    }
    boolList atWall(state.size(), false);
    for (const wallTouch& t : history.walls)
    {
        atWall[state.sphereBody[t.sphere]] = true;
    }

    boolList rattles(state.size());
    nRattlers_ = 0;
    nWalls_ = 0;
    forAll(rattles, b)
    {
        rattles[b] = nOthers[b] < 2 && !atWall[b];
        nRattlers_ += rattles[b];
        nWalls_ += atWall[b];
    }

    label nBackbone = 0;
    for (const auto& p : pairs)
    {
        nBackbone += !rattles[p.first] && !rattles[p.second];
    }
    nBodies_ = state.size();
    nPairs_ = pairs.size();
    zBackbone_ =
        nBodies_ > nRattlers_ ? 2.0*nBackbone/(nBodies_ - nRattlers_) : 0;
}


// ************************************************************************* //
