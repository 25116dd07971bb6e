/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "patchRules.H"
#include "cyclicPolyPatch.H"
#include "processorCyclicPolyPatch.H"
#include "SubField.H"

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

//- A unit vector without the round-off of a sum, which depends on the ranks
Foam::vector withoutRoundOff(const Foam::vector& v)
{
    Foam::vector n = v/Foam::mag(v);
    for (Foam::direction k = 0; k < 3; ++k)
    {
        n[k] = Foam::mag(n[k]) < 1e-9 ? 0 : n[k];
    }
    return n/Foam::mag(n);
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Visitor>
void Foam::patchRules::forEachPart
(
    const label patch,
    const Visitor& visit
) const
{
    for (const polyPatch& part : mesh_.boundaryMesh())
    {
        // Where the other half is on another rank, the faces stand in a patch
        // of their own
        const bool cut =
            isA<processorCyclicPolyPatch>(part)
         && refCast<const processorCyclicPolyPatch>(part).referPatchID()
         == patch;

        if (part.index() == patch || cut)
        {
            visit(part);
        }
    }
}


Foam::patchRules::half Foam::patchRules::halfOf(const label patch) const
{
    half h;
    forEachPart
    (
        patch,
        [&h](const polyPatch& part)
        {
            const vectorField S(part.faceAreas());
            h.S += sum(S);
            h.magS += sum(mag(S));
            for (const point& x : part.localPoints())
            {
                h.corner = min(h.corner, x);
            }
        }
    );

    reduce(h.S, sumOp<vector>());
    reduce(h.magS, sumOp<scalar>());
    reduce(h.corner, minOp<point>());
    return h;
}


bool Foam::patchRules::flat(const label patch) const
{
    const half h(halfOf(patch));
    return mag(h.S) >= (1 - 1e-6)*h.magS;
}


void Foam::patchRules::addSeam(const cyclicPolyPatch& patch)
{
    const half a(halfOf(patch.index()));
    const half b(halfOf(patch.neighbPatchID()));

    const auto refuse = [&](const char* why)
    {
        refused_.append(refusal{patch.index(), why});
        refused_.append(refusal{patch.neighbPatchID(), why});
    };

    if (!(a.magS > 0))
    {
        return;
    }
    if
    (
        patch.transform() == coupledPolyPatch::ROTATIONAL
     || mag(a.S + b.S) > 1e-6*a.magS
    )
    {
        refuse("a body cannot pass through a cyclic patch with a rotation");
        return;
    }

    dem::periodicity::seam s;
    s.separation = b.corner - a.corner;
    if (mag(s.separation) < 1e-6*sqrt(a.magS))
    {
        // Both halves are in one place
        return;
    }
    if (mag(a.S) < (1 - 1e-6)*a.magS)
    {
        refuse("a cyclic patch through which bodies pass must be flat");
        return;
    }

    // All of the mesh between the two planes
    s.normal = withoutRoundOff(-a.S);
    s.low = GREAT;
    forEachPart
    (
        patch.index(),
        [&s](const polyPatch& part)
        {
            for (const point& x : part.localPoints())
            {
                s.low = min(s.low, x & s.normal);
            }
        }
    );
    reduce(s.low, minOp<scalar>());

    const scalar small = 1e-6*mag(s.width());
    scalar low = GREAT;
    scalar high = -GREAT;
    for (const point& x : mesh_.points())
    {
        low = min(low, s.height(x));
        high = max(high, s.height(x));
    }
    reduce(low, minOp<scalar>());
    reduce(high, maxOp<scalar>());
    if (!(s.width() > 0) || low < -small || high > s.width() + small)
    {
        refuse
        (
            "the mesh must lie between the two planes of a cyclic pair through"
            " which bodies pass"
        );
        return;
    }

    // Several pairs of patches may make one seam
    for (const dem::periodicity::seam& other : period_.seams())
    {
        if
        (
            mag(other.separation - s.separation) < small
         && mag(other.low - s.low) < small
        )
        {
            return;
        }
    }
    if (!period_.fits(s))
    {
        refuse
        (
            "the separation of a cyclic pair must be along the other cyclic"
            " patches"
        );
        return;
    }
    period_.append(s);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::patchRules::checkMotion() const
{
    if (!period_.active())
    {
        return;
    }

    const patchRules now(mesh_);
    bool same = now.period_.seams().size() == period_.seams().size();
    for (label k = 0; same && k < period_.seams().size(); ++k)
    {
        const dem::periodicity::seam& a = period_.seams()[k];
        const dem::periodicity::seam& b = now.period_.seams()[k];
        same =
            mag(a.separation - b.separation) + mag(a.low - b.low)
          < 1e-6*a.width();
    }
    if (!same)
    {
        FatalErrorInFunction
            << "The mesh has moved its cyclic patches: bodies can pass through"
            << " cyclic patches that stay where they are only."
            << exit(FatalError);
    }
}


// ************************************************************************* //
