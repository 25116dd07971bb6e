/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "sceneSurvey.H"
#include "gaussGrad.H"
#include "volFields.H"

#include <cmath>
#include <unordered_map>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::sceneSurvey::lookAtBodies()
{
    const dem::bodies& state = dem_.state();
    tmp<volTensorField> grad;
    scalar largestShear = 0;
    if (fluid_.U)
    {
        grad = fv::gaussGrad<vector>::gradf
        (
            linearInterpolate(*fluid_.U),
            "gradOfScene"
        );
        largestShear = gMax
        (
            mag(2*(*skew(grad().primitiveField())))()
        );
    }

    // Where it is strongest
    const auto stir = [&](sceneNumbers& n, const label c)
    {
        if (fluid_.k[c] > n.k)
        {
            n.k = fluid_.k[c];
            n.epsilon = fluid_.epsilon[c];
        }
    };

    const label stride = 1 + state.size()/1000;
    for (label b = 0; b < state.size(); b += stride)
    {
        const label c = bins_.find(state.x[b]);
        if (c < 0)
        {
            continue;
        }
        kind& k = kindOf(state.shapeI[b], state.materialI[b]);
        sceneNumbers& n = k.numbers;
        n.cell = min(n.cell, std::cbrt(mesh_.V()[c]));

        vector u(Zero), curl(Zero);
        if (fluid_.U)
        {
            u = (*fluid_.U)[c];
            curl = 2*(*skew(grad()[c]));
        }
        n.shear = max(n.shear, mag(curl));
        n.spin = max(n.spin, mag(0.5*curl - state.omega[b]));
        if (fluid_.k.size())
        {
            stir(n, c);
        }
        k.slip += mag(u - state.v[b]);
        ++k.nSlips;
    }

    for (kind& k : kinds_)
    {
        if (!(k.nNow > 0))
        {
            k.numbers.shear = largestShear;
            k.numbers.spin = 0.5*largestShear;
            forAll(fluid_.k, c)
            {
                stir(k.numbers, c);
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::sceneSurvey::crowd
(
    const dem::bodies& state,
    const scalar edge,
    const boolList& leave
)
{
    const auto counts = [&leave](const label b)
    {
        return leave.empty() || !leave[b];
    };
    const auto blockOf = [&](const point& x)
    {
        // Three numbers of 21 bits
        const auto part = [&](const scalar v)
        {
            return uint64_t(std::llround(std::floor(v/edge))) & 0x1fffff;
        };
        return part(x.x()) | part(x.y()) << 21 | part(x.z()) << 42;
    };

    std::unordered_map<uint64_t, scalar> volume;
    volume.reserve(state.size());
    label n = 0;
    forAll(state.x, b)
    {
        if (counts(b))
        {
            volume[blockOf(state.x[b])] += state.shapeOf(b).volume();
            ++n;
        }
    }

    scalar sum = 0;
    forAll(state.x, b)
    {
        if (counts(b))
        {
            sum +=
                (volume[blockOf(state.x[b])] - state.shapeOf(b).volume())
               /pow3(edge);
        }
    }
    return n ? sum/n : 0;
}


Foam::scalar Foam::sceneSurvey::smallestGap(const dem::bodies& state)
{
    const label n = min(state.size(), label(1000));
    scalar least = GREAT;
    for (label a = 0; a < n; ++a)
    {
        for (label b = 0; b < a; ++b)
        {
            least = min
            (
                least,
                mag(state.x[a] - state.x[b])
              - state.shapeOf(a).boundingRadius()
              - state.shapeOf(b).boundingRadius()
            );
        }
    }
    return n > 1 ? max(least, scalar(0)) : GREAT;
}


// ************************************************************************* //
