/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "contactForces.H"
#include "quadRecords.H"

using Foam::dem::quadRecords::record;
using Foam::dem::quadRecords::vectorOf;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::dem;

//- Copies of spheres, two more than are asked for, which touch nothing
struct copiedSpheres
{
    packedBodies::records r;

    std::vector<int> material;

    explicit copiedSpheres(const label n)
    {
        r.xv.assign(n + 2, quadPair{{0, 0, 0, 1}, {0, 0, 0, 0.1}});
        r.x(n + 1).x = 1;
        r.w.assign(n + 2, quad{0, 0, 0, 0.1});
        r.ft.assign(n + 2, quadPair{{0, 0, 0, 0}, {0, 0, 0, 0}});
        material.assign(n + 2, 0);
    }

    //- Sphere s of the bodies, moved by so much [m]
    void copy
    (
        const label to,
        const bodies& state,
        const label s,
        const vector& shift
    )
    {
        const label b = state.sphereBody[s];
        const scalar radius = state.sphereR[s];
        r.x(to) = record(state.sphereX()[s] + shift, 1/state.mass[b]);
        r.v(to) = record(state.velocityAt(b, state.sphereX()[s]), radius);
        r.w[to] = record(radius*state.omega[b], radius);
        material[to] = state.materialI[b];
    }

    void give(sweepData& data, const materials& m)
    {
        data.xv = &r.xv[0].first.x;
        data.w = &r.w[0].x;
        data.ft = &r.ft[0].first.x;
        data.material = material.data();
        data.pairs = m.pairs().cdata();
        data.nMaterials = m.names().size();
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::List<Foam::dem::contactForce> Foam::dem::contactForces
(
    const contactModel& model,
    const materials& m,
    const bodies& state,
    const UList<verletList::pairHistory>& pairs,
    const periodicity& period,
    const UList<wallTouch>& touches,
    const PtrList<wall>& walls
)
{
    const label nPairs = pairs.size(), nTouches = touches.size();
    const label nLanes = model.nLanes();
    List<contactForce> all(nPairs + nTouches);
    if (all.empty())
    {
        return all;
    }
    copiedSpheres spheres(2*nPairs + nTouches);

    List<verletList::pairHistory> histories(pairs);
    for (label k = 0; k < nPairs; ++k)
    {
        const verletList::spherePair& p = pairs[k].pair;
        const vector shift =
            p.image == periodicity::original
          ? vector(Zero)
          : period.shift(p.image);
        spheres.copy(2*k, state, p.i, Zero);
        spheres.copy(2*k + 1, state, p.j, shift);
        histories[k].pair = verletList::spherePair(2*k, 2*k + 1);

        contactForce& c = all[k];
        c.a = state.sphereBody[p.i];
        c.b = state.sphereBody[p.j];
        const vector d = state.sphereX()[p.i] - state.sphereX()[p.j] - shift;
        c.n = d/max(mag(d), VSMALL);
        const scalar rSum = state.sphereR[p.i] + state.sphereR[p.j];
        c.p = state.sphereX()[p.i] - state.sphereR[p.i]/rSum*d;
        c.overlap = rSum - mag(d);
        c.branch = state.x[c.a] - state.x[c.b] - shift;
    }

    // The sweep reads as many walls as fill up the last block
    std::vector<wallTouch> atWalls((nTouches/nLanes + 2)*nLanes, wallTouch{});
    std::vector<int> wallMaterial(walls.size(), 0);
    sweepData data;
    data.mirrors = false;
    forAll(walls, w)
    {
        wallMaterial[w] = walls[w].materialI();
        data.mirrors = data.mirrors || wallMaterial[w] < 0;
    }
    for (label k = 0; k < nTouches; ++k)
    {
        const label s = touches[k].sphere;
        spheres.copy(2*nPairs + k, state, s, Zero);
        atWalls[k] = touches[k];
        atWalls[k].sphere = 2*nPairs + k;
        atWalls[k].likeness = 1;

        contactForce& c = all[nPairs + k];
        c.a = state.sphereBody[s];
        c.b = -1 - touches[k].wallI;
        c.n = touches[k].n;
        c.overlap = touches[k].overlap;
        c.p = state.sphereX()[s]
            - (state.sphereR[s] - touches[k].overlap)*touches[k].n;
        c.branch = state.x[c.a] - c.p;
    }

    // The sweep writes how contacts have rolled, which is not asked for here
    const bool rolls = model.laws().rollsBack();
    std::vector<scalar> wallRolled(rolls ? 4*atWalls.size() : 0, 0);
    contactBlocks blocks;
    blocks.setLanes(nLanes);
    blocks.setMemory(true, true, rolls);
    blocks.set(histories, contactBlocks::fillerOf(2*nPairs + nTouches));

    spheres.give(data, m);
    data.laws = &model.laws();
    data.fetches = false;
    data.dt = 0;
    data.ahead = 0;
    blocks.give(data, false);
    data.shift = nullptr;
    data.nWallBlocks = (nTouches + nLanes - 1)/nLanes;
    data.wallSphere = &atWalls[0].sphere;
    data.wallSphereStep = sizeof(wallTouch)/sizeof(int);
    data.wallRecords = atWalls[0].n.v_;
    data.wallRecordsStep = sizeof(wallTouch)/sizeof(scalar);
    data.wallMaterial = wallMaterial.data();
    data.wallRolled = rolls ? wallRolled.data() : nullptr;

    contactShares shares;
    if (model.laws().shares)
    {
        // As a sweep over all of them does
        std::vector<contactShares::contact> ofPairs, ofWalls;
        const auto isClump = [&](const label b)
        {
            return b >= 0 && !state.shapeOf(b).isSphere();
        };
        forAll(all, k)
        {
            const contactForce& c = all[k];
            if (c.overlap <= 0 || (!isClump(c.a) && !isClump(c.b)))
            {
                continue;
            }
            k < nPairs
          ? ofPairs.push_back
            ({c.a, c.b, pairs[k].pair.image, k, c.overlap, c.n})
          : ofWalls.push_back({c.a, -1, 0, k - nPairs, c.overlap, c.n});
        }
        const label nWallLanes = (nTouches/nLanes + 1)*nLanes;
        shares.find(ofPairs, blocks.nLanes(), ofWalls, nWallLanes);
        data.pairShare = shares.ofPairs();
        data.wallShare = shares.ofWalls();
    }

    sweepFound found;
    model.instructions().sweep(model.laws(), data, found);
    for (label k = 0; k < nPairs; ++k)
    {
        all[k].force = vectorOf(spheres.r.f(2*k));
    }
    for (label k = 0; k < nTouches; ++k)
    {
        all[nPairs + k].force = vectorOf(spheres.r.f(2*nPairs + k));
    }
    return all;
}


// ************************************************************************* //
