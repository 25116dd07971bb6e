/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "pointForces.H"
#include "rankMail.H"
#include "SubList.H"
#include "volFields.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::pointForces::pointForces
(
    const fvMesh& mesh,
    const cellBins& bins,
    bodyCells& cells,
    dem::demSolver& dem,
    const bodyKinds& kinds,
    const fluidDensity& rho,
    const dictionary& fluid,
    const dictionary& forces
)
:
    mesh_(mesh),
    bins_(bins),
    cells_(cells),
    dem_(dem),
    kinds_(kinds),
    drag_(dragLaw::New(forces)),
    sphericity_(0),
    grains_(1),
    grainWidth_(1),
    sumOfSpheres_(false),
    followsBody_(drag_.valid()),
    steps_(1),
    equations_(averagedEquations::none)
{
    checkInput(forces);
    readDrag(forces);
    readGrains(forces);
    readForces(forces);

    unsigned needs = 0;
    for (const pointForce& f : forces_)
    {
        needs |= f.needs();
        followsBody_ = followsBody_ || f.addsMass();
    }
    const word scheme(interpolationScheme(forces));
    sampler_.reset
    (
        new fluidSampler
        (
            mesh,
            rho,
            fluid,
            forces,
            dem.g(),
            scheme,
            needs
        )
    );
    report(scheme);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::coupling::pointForces::rate
(
    const label b,
    const scalar slip
) const
{
    if (!drag_.valid())
    {
        return 0;
    }

    scalar sum = 0;
    for (label i = first_[b]; i < first_[b + 1]; ++i)
    {
        const scalar stokes = elements_[i].stokes;
        sum += stokes > 0 ? stokes*factorOf(i, slip) : 0;
    }
    return sum/inertiaOf(b);
}


bool Foam::coupling::pointForces::followsExchange() const
{
    for (const pointForce& f : forces_)
    {
        if (f.followsExchange())
        {
            return true;
        }
    }
    return false;
}


void Foam::coupling::pointForces::noteExchange
(
    const label b,
    const exchangedImpulse& impulse
)
{
    for (pointForce& f : forces_)
    {
        f.noteExchange(dem_.state().id[b], impulse);
    }
}


void Foam::coupling::pointForces::moveMemory()
{
    const List<DynamicList<label>> moved(dem_.moved());
    for (pointForce& f : forces_)
    {
        if (!f.remembers() || moved.empty())
        {
            continue;
        }

        // The id of a body, how many vectors it has, and these
        List<DynamicList<vector>> out(moved.size());
        forAll(moved, rank)
        {
            for (const label id : moved[rank])
            {
                DynamicList<vector> values;
                f.save(id, values);
                out[rank].append(vector(id, values.size(), 0));
                out[rank].append(values);
            }
        }
        for (const List<vector>& in : dem::swapRecords(out))
        {
            for (label k = 0; k < in.size();)
            {
                const label id(in[k].x()), n(in[k].y());
                f.load(id, SubList<vector>(in, n, k + 1));
                k += n + 1;
            }
        }
    }
}


Foam::scalar Foam::coupling::pointForces::shortestRelaxation() const
{
    const dem::bodies& state = dem_.state();

    scalar fastest = 0;
    forAll(fluidVelocity_, b)
    {
        fastest =
            max(fastest, rate(b, mag(fluidVelocity_[b] - state.v[b])));
    }
    return fastest > 0 ? 1/fastest : GREAT;
}


// ************************************************************************* //
