/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "dispersion.H"
#include "addToRunTimeSelectionTable.H"
#include "allowedKeys.H"
#include "checkedEntry.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace coupling
{
    defineTypeNameAndDebug(dispersion, 0);
    addToRunTimeSelectionTable(pointForce, dispersion, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::dispersion::dispersion
(
    const vector&,
    const dictionary& dict
)
:
    C_(dem::getPositive(dict, "coefficient", 0.15)),
    seed_(dem::getLabel(dict, "seed", 0, 1))
{
    dem::checkKeys(dict, {"coefficient", "seed"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::coupling::dispersion::normals
(
    const label id,
    const label n
) const
{
    uint64_t state = uint64_t(seed_);
    const auto next = [&state]()
    {
        state += 0x9e3779b97f4a7c15u;
        uint64_t z = state;
        z = (z ^ (z >> 30))*0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27))*0x94d049bb133111ebu;
        return z ^ (z >> 31);
    };

    // Each in its turn stirs the state: streams that do not meet
    state = next() ^ uint64_t(id);
    state = next() ^ uint64_t(n);

    // Box and Muller; from 0 to 1, both out of reach
    const auto uniform = [&next]()
    {
        return ((next() >> 11) + 0.5)/9007199254740992.0;
    };
    vector xi;
    for (direction d = 0; d < 3; ++d)
    {
        const scalar r = sqrt(-2*log(uniform()));
        xi[d] = r*cos(constant::mathematical::twoPi*uniform());
    }
    return xi;
}


void Foam::coupling::dispersion::note
(
    const pointBody& body,
    fluidAtPoint& fluid
)
{
    const bool known = eddies_.found(body.id);
    eddy& e = eddies_(body.id);
    const vector xi = normals(body.id, e.n++);
    if (!(fluid.k > 0) || !(fluid.epsilon > 0))
    {
        // No turbulence; what comes later starts anew
        eddies_.erase(body.id);
        return;
    }

    const scalar sigma = sqrt(2*fluid.k/3);
    const scalar slip = mag(fluid.u - body.v);
    const scalar T =
        C_*fluid.k/fluid.epsilon/sqrt(1 + sqr(slip/sigma));
    const scalar keep = known ? exp(-body.dt/T) : 0;
    e.u = keep*e.u + sqrt(1 - sqr(keep))*xi;
    fluid.u += sigma*e.u;
}


void Foam::coupling::dispersion::save
(
    const label id,
    DynamicList<vector>& values
) const
{
    if (eddies_.found(id))
    {
        values.append(eddies_[id].u);
        values.append(vector(eddies_[id].n, 0, 0));
    }
}


bool Foam::coupling::dispersion::load
(
    const label id,
    const UList<vector>& values
)
{
    if (values.size() == 2)
    {
        eddies_(id) = eddy{values[0], label(values[1].x())};
    }
    return values.empty() || values.size() == 2;
}


void Foam::coupling::dispersion::keepOnly(const labelHashSet& ids)
{
    eddies_.retain(ids);
}


// ************************************************************************* //
