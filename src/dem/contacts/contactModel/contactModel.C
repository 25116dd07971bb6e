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
    n.rolls = laws.rolling != "none";
    n.twists = laws.torsion != "none";
    n.coheres = laws.cohesion != "none";
    return n;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::contactModel::giveWalls
(
    const packedBodies& state,
    wallSet& walls,
    sweepData& data
)
{
    const UList<wallTouch>& touches = walls.trial();
    const label W = nLanes();
    const label n = (touches.size() + W - 1)/W*W;

    wallBlocks& b = blocks_;
    b.sphere.assign(n, 4*state.nSpheres());
    b.material.assign(n, 0);
    b.normal.assign(3*n, 0);
    b.overlap.assign(n, 0);
    b.velocity.assign(3*n, 0);
    b.spin.assign(n, 0);
    b.xi.assign(3*n, 0);
    b.rate.assign(4*n, 0);
    b.touched.assign(n/W, 0);

    data.mirrors = false;
    forAll(touches, k)
    {
        const wallTouch& t = touches[k];
        b.sphere[k] = 4*t.sphere;
        b.material[k] = walls.walls()[t.wallI].materialI();
        b.overlap[k] = t.overlap;
        b.spin[k] = t.spin;
        data.mirrors = data.mirrors || b.material[k] < 0;

        const label first = 3*(k - k % W) + k % W;
        for (direction d = 0; d < 3; ++d)
        {
            b.normal[first + d*W] = t.n[d];
            b.velocity[first + d*W] = t.u[d];
            b.xi[first + d*W] = t.xi[d];
        }
        for (direction d = 0; d < 4; ++d)
        {
            b.rate[4*(k - k % W) + d*W + k % W] = t.rate[d];
        }
        b.touched[k/W] |= (t.likeness > 0) << (k % W);
    }

    data.nWallBlocks = n/W;
    data.sphere = b.sphere.data();
    data.wallMaterial = b.material.data();
    data.wallNormal = b.normal.data();
    data.wallOverlap = b.overlap.data();
    data.wallSpin = b.spin.data();
    data.ofWalls.xiOld = data.ofWalls.xi = b.xi.data();
    data.ofWalls.rateOld = data.ofWalls.rate = b.rate.data();
    data.ofWalls.touchedOld = data.ofWalls.touched = b.touched.data();
    data.ofWalls.velocity = b.velocity.data();
}


void Foam::dem::contactModel::takeWalls(wallSet& walls) const
{
    UList<wallTouch>& touches = walls.trial();
    const label W = nLanes();

    forAll(touches, k)
    {
        wallTouch& t = touches[k];
        for (direction d = 0; d < 3; ++d)
        {
            t.xi[d] = blocks_.xi[3*(k - k % W) + d*W + k % W];
        }
        for (direction d = 0; d < 4; ++d)
        {
            t.rate[d] = blocks_.rate[4*(k - k % W) + d*W + k % W];
        }
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
    const bool onTrial
)
{
    walls.findTouches(state);

    sweepData data;
    packedBodies::records& r = state.spheres();
    data.x = &r.x[0].x;
    data.v = &r.v[0].x;
    data.w = &r.w[0].x;
    data.f = &r.f[0].x;
    data.t = &r.t[0].x;
    data.material = state.material();
    data.pairs = materials_.pairs().cdata();
    data.nMaterials = materials_.names().size();
    data.dt = dt;
    data.ahead = between > 0 ? 0.5*dt/between : 0;
    list.refresh(state);
    list.give(data, onTrial);
    giveWalls(state, walls, data);

    sweepExtremes pairs, atWalls;
    set_->sweep(laws_, data, pairs, atWalls);
    takeWalls(walls);

    contactSummary sum;
    sum.nPairs = pairs.nTouching;
    sum.nWalls = atWalls.nTouching;
    sum.wallSpeed = walls.speed();

    const auto bodyAt = [&](const label sphere)
    {
        return state.bodyOf(sphere);
    };
    const auto wallAt = [&](const label lane)
    {
        return -1 - walls.trial()[lane].wallI;
    };
    if (atWalls.overlap > pairs.overlap)
    {
        sum.overlap = atWalls.overlap;
        sum.overlapA = bodyAt(blocks_.sphere[atWalls.overlapAt]/4);
        sum.overlapB = wallAt(atWalls.overlapAt);
    }
    else if (pairs.overlapAt >= 0)
    {
        const verletList::spherePair p = list.pairInLane(pairs.overlapAt);
        sum.overlap = pairs.overlap;
        sum.overlapA = bodyAt(p.i);
        sum.overlapB = bodyAt(p.j);
    }
    if (atWalls.frequency10 > pairs.frequency10)
    {
        sum.frequency10 = atWalls.frequency10;
        sum.stiffA = bodyAt(blocks_.sphere[atWalls.stiffAt]/4);
        sum.stiffB = wallAt(atWalls.stiffAt);
    }
    else if (pairs.stiffAt >= 0)
    {
        const verletList::spherePair p = list.pairInLane(pairs.stiffAt);
        sum.frequency10 = pairs.frequency10;
        sum.stiffA = bodyAt(p.i);
        sum.stiffB = bodyAt(p.j);
    }
    if (sum.frequency10 > 0)
    {
        sum.duration = 1/pow(sum.frequency10, 0.1);
    }
    return sum;
}


// ************************************************************************* //
