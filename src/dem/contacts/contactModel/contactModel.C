/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "contactModel.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::dem;

// Spheres from which on it pays to fetch those of later contacts: with 10,000
// a sweep loses 4 %, with 50,000 it gains 5 %
const label fetchedFrom = 20000;

struct namedSet
{
    const char* name;
    const sweepSet* sweeps;
    bool runs;
};


//- The sets of instructions, the best first
const namedSet& find(const word& name)
{
    static const namedSet sets[] =
    {
        {
            "avx512",
            &sweepAvx512,
            __builtin_cpu_supports("avx512f")
         && __builtin_cpu_supports("avx512dq")
         && __builtin_cpu_supports("avx512vl")
         && __builtin_cpu_supports("avx512bw")
        },
        {
            "avx2",
            &sweepAvx2,
            __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")
        },
        {"sse2", &sweepSse2, true}
    };

    for (const namedSet& s : sets)
    {
        if (name == "auto" ? s.runs : name == s.name)
        {
            if (s.runs)
            {
                return s;
            }
            break;
        }
    }
    FatalErrorInFunction
        << "This processor has no instructions " << name << "." << nl
        << "    Take auto for the entry instructions of contact."
        << exit(FatalError);
    return sets[2];
}


sweepLaws::resistance numbered(const word& resistance)
{
    return
        resistance == "elasticPlastic" ? sweepLaws::elasticPlastic
      : resistance == "constant" ? sweepLaws::constant
      : sweepLaws::free;
}


sweepLaws numbered(const contactLaws& laws)
{
    sweepLaws n;
    n.normal =
        laws.normal == "hooke" ? sweepLaws::hooke : sweepLaws::hertz;
    n.tangential =
        laws.tangential == "mindlin" ? sweepLaws::mindlin
      : laws.tangential == "coulomb" ? sweepLaws::coulomb
      : sweepLaws::noTangential;
    n.damping =
        laws.damping == "hades" ? sweepLaws::hades
      : laws.damping == "none" ? sweepLaws::noDamping
      : sweepLaws::viscous;
    n.pulling = laws.pulling;
    n.rolling = numbered(laws.rolling);
    n.torsion = numbered(laws.torsion);
    n.coheres = laws.coheres("simplifiedJKR");
    n.bridges = laws.coheres("capillary");
    n.vanDerWaals = laws.coheres("vanDerWaals");
    n.charges = laws.coheres("electrostatic");
    n.film = laws.film;
    n.shares = laws.multiContact == "share";
    return n;
}

} // End anonymous namespace


namespace
{

//- Take note of the stiffest and the deepest contact of a kind; who is in a
//  lane of it?
template<class Who>
void note(const sweepExtremes& found, contactSummary& sum, const Who& who)
{
    if (found.overlapAt >= 0 && found.overlap > sum.overlap)
    {
        const labelPair p = who(found.overlapAt);
        sum.overlap = found.overlap;
        sum.overlapA = p.first();
        sum.overlapB = p.second();
    }
    if (found.stiffAt >= 0 && found.frequency10 > sum.frequency10)
    {
        const labelPair p = who(found.stiffAt);
        sum.frequency10 = found.frequency10;
        sum.stiffA = p.first();
        sum.stiffB = p.second();
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::contactModel::giveWalls
(
    const wallSet& walls,
    UList<wallTouch>& touches,
    sweepData& data
)
{
    static_assert
    (
        offsetof(wallTouch, wallI) == offsetof(wallTouch, sphere) + sizeof(int)
     && offsetof(wallTouch, xi) == offsetof(wallTouch, n) + sizeof(quad)
     && offsetof(wallTouch, u) == offsetof(wallTouch, n) + 2*sizeof(quad)
     && offsetof(wallTouch, rate) == offsetof(wallTouch, n) + 3*sizeof(quad),
        "the sweep reads the contacts with walls as records of four numbers"
    );

    wallMaterial_.resize(walls.walls().size());
    data.mirrors = false;
    forAll(walls.walls(), w)
    {
        wallMaterial_[w] = walls.walls()[w].materialI();
        data.mirrors = data.mirrors || wallMaterial_[w] < 0;
    }

    wallTouch* first = touches.data();
    data.nWallBlocks = (touches.size() + nLanes() - 1)/nLanes();
    data.wallSphere = &first->sphere;
    data.wallSphereStep = sizeof(wallTouch)/sizeof(int);
    data.wallRecords = first->n.v_;
    data.wallRecordsStep = sizeof(wallTouch)/sizeof(scalar);
    data.wallMaterial = wallMaterial_.data();
}


void Foam::dem::contactModel::giveBodies
(
    packedBodies& state,
    sweepData& data
) const
{
    packedBodies::records& r = state.spheres();
    data.xv = &r.xv[0].first.x;
    data.w = &r.w[0].x;
    data.ft = &r.ft[0].first.x;
    data.material = state.material();
    data.fetches = state.nSpheres() > fetchedFrom;
    data.pairs = materials_.pairs().cdata();
    data.nMaterials = materials_.names().size();
    data.laws = &laws_;
}


void Foam::dem::contactModel::hold
(
    packedBodies& state,
    verletList& list,
    wallSet& walls
)
{
    state.asleep().clear(state.spheres());
    walls.findAsleep(state);

    // Nothing moves, so that nothing slips and no dashpot acts. What the
    // contacts remember stays to the last bit, however often this is done
    sweepData data;
    giveBodies(state, data);
    data.dt = 0;
    data.ahead = 0;
    contactBlocks& pairsAsleep = list.asleep().blocks();
    pairsAsleep.give(data, true);
    data.shift = list.shiftData();
    touchList& asleep = walls.asleep();
    const DynamicList<wallTouch> memory(asleep.trial);
    const DynamicList<wallRolled> rolled(asleep.trialRolled);
    giveWalls(walls, asleep.padded(nLanes()), data);
    data.wallRolled = asleep.trialAngles();
    if (laws_.shares)
    {
        shares_.find(state, list, pairsAsleep, asleep.trial, nLanes());
        data.pairShare = shares_.ofPairs();
        data.wallShare = shares_.ofWalls();
    }

    sweepFound found;
    set_->sweep(laws_, data, found);
    asleep.trial = memory;
    asleep.trialRolled = rolled;
    asleep.accept();
    nHeld_ = found.pairs.nTouching + found.walls.nTouching;
    heldFrequency10_ = max(found.pairs.frequency10, found.walls.frequency10);
    state.asleep().hold(state.spheres());
}


void Foam::dem::contactModel::attract
(
    sweepData& data,
    const packedBodies& state,
    verletList& list,
    wallSet& walls,
    const bool onTrial,
    contactSummary& sum,
    sweepTimes* times
)
{
    UList<wallTouch>& reached = walls.paddedReached(nLanes());
    list.giveReached(data, onTrial);
    giveWalls(walls, reached, data);
    if (tellsFilms_)
    {
        films_.assign(state.spheres().xv.size(), quad{0, 0, 0, 0});
        data.films = &films_[0].x;
    }

    sweepFound found;
    set_->attract(laws_, data, found);
    if (times)
    {
        times->passed(sweepTimes::pairs, found.pairsDone);
        times->passed(sweepTimes::walls);
    }

    if (found.pairs.frequency10 > sum.frequency10)
    {
        const verletList::spherePair p =
            list.reachedInLane(found.pairs.stiffAt);
        sum.frequency10 = found.pairs.frequency10;
        sum.stiffA = state.bodyOf(p.i);
        sum.stiffB = state.bodyOf(p.j);
    }
    if (found.walls.frequency10 > sum.frequency10)
    {
        const wallTouch& t = reached[found.walls.stiffAt];
        sum.frequency10 = found.walls.frequency10;
        sum.stiffA = state.bodyOf(t.sphere);
        sum.stiffB = -1 - t.wallI;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::contactModel::contactModel
(
    const contactLaws& laws,
    const materials& m
)
:
    materials_(m),
    set_(find(laws.instructions).sweeps),
    laws_(numbered(laws))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dem::contactSummary Foam::dem::contactModel::addForces
(
    packedBodies& state,
    verletList& list,
    wallSet& walls,
    const scalar dt,
    const scalar between,
    const bool onTrial,
    sweepTimes* times
)
{
    const auto passed = [=](const sweepTimes::of what)
    {
        if (times)
        {
            times->passed(what);
        }
    };
    if (times)
    {
        times->start();
    }
    const bool refreshed = list.refresh(state);
    passed(sweepTimes::pairs);
    if (refreshed || !walls.narrowed())
    {
        walls.narrow(state, list.allowedNear());
    }
    passed(sweepTimes::walls);
    if (state.asleep().any())
    {
        if (state.asleep().due())
        {
            hold(state, list, walls);
        }
        state.asleep().meet(list.asleep().border(), state.spheres());
    }
    passed(sweepTimes::pairs);
    walls.findTouches(state);
    passed(sweepTimes::walls);

    sweepData data;
    data.clock = times ? &sweepTimes::now : nullptr;
    giveBodies(state, data);
    data.dt = dt;
    data.ahead = between > 0 ? 0.5*dt/between : 0;
    list.give(data, onTrial);
    giveWalls(walls, walls.padded(nLanes()), data);
    walls.planes().give(data, onTrial);
    data.wallRolled = walls.rolled();
    if (laws_.shares)
    {
        shares_.find(state, list, list.blocks(), walls.trial(), nLanes());
        data.pairShare = shares_.ofPairs();
        data.wallShare = shares_.ofWalls();
    }

    sweepFound found;
    set_->sweep(laws_, data, found);
    if (times)
    {
        times->passed(sweepTimes::pairs, found.pairsDone);
        times->passed(sweepTimes::walls);
    }

    contactSummary sum;
    sum.nPairs = found.pairs.nTouching;
    sum.nWalls = found.walls.nTouching + found.planes.nTouching;
    if (state.asleep().any())
    {
        sum.nAsleep = nHeld_;
        sum.asleepFrequency10 = heldFrequency10_;
    }
    sum.wallSpeed = walls.speed();
    note(found.pairs, sum, [&](const label lane)
    {
        const verletList::spherePair p = list.pairInLane(lane);
        return labelPair(state.bodyOf(p.i), state.bodyOf(p.j));
    });
    note(found.walls, sum, [&](const label lane)
    {
        const wallTouch& t = walls.trial()[lane];
        return labelPair(state.bodyOf(t.sphere), -1 - t.wallI);
    });
    note(found.planes, sum, [&](const label lane)
    {
        return labelPair
        (
            state.bodyOf(walls.planes().sphereInLane(lane)),
            -1 - walls.planes().wallInLane(lane)
        );
    });
    if (laws_.reaches())
    {
        attract(data, state, list, walls, onTrial, sum, times);
    }
    if (sum.frequency10 > 0)
    {
        sum.duration = 1/pow(sum.frequency10, 0.1);
    }
    return sum;
}


// ************************************************************************* //
