/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "impactTrials.H"
#include "mathematicalConstants.H"
#include "Random.H"
#include "Tuple2.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- A rotation that is as likely as any other, as axis and angle [deg]
void drawRotation(Random& rnd, vector& axis, scalar& angle)
{
    quaternion q;
    do
    {
        q.w() = rnd.position<scalar>(-1, 1);
        q.v() = rnd.position<vector>
        (
            -vector::one, vector(vector::one)
        );
    }
    while (mag(q) > 1 || mag(q.v()) < 1e-3);

    axis = normalised(q.v());
    angle = 360/constant::mathematical::pi
       *std::atan2(mag(q.v()), q.w());
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::dictionary Foam::dem::impactTrials::caseOf
(
    const meeting& m,
    const dictionary& pair,
    const dictionary& stepControl
) const
{
    const impactSetting& s = setting_;
    dictionary dict(s.properties.name());
    dict.add("demSolver", stepControl.empty() ? word("fixed") : word("hades"));
    for (const word& key : wordList({"contact", "integrator", "neighbours"}))
    {
        if (s.properties.found(key))
        {
            dict.add(s.properties.lookupEntry(key, keyType::LITERAL));
        }
    }

    // Only what takes part; the bodies' own pairs touch nowhere
    dictionary materials(s.properties.subDict("materials").name());
    dictionary pairs(s.properties.subDict("pairs").name());
    for (const word& name : wordList({s.material, s.with}))
    {
        materials.set(name, s.properties.subDict("materials").subDict(name));
        pairs.set(word(name + '-' + name), pair);
    }
    pairs.set(s.pairKey(), pair);
    dict.add("materials", materials);
    dict.add("pairs", pairs);

    dictionary shapes(s.properties.name() + ".shapes");
    shapes.add(s.shape, s.properties.subDict("shapes").subDict(s.shape));
    dict.add("shapes", shapes);
    if (!stepControl.empty())
    {
        dict.add("stepControl", stepControl);
    }

    const auto body = [&]
    (
        const word& material,
        const scalar z,
        const scalar w,
        const vector& axis,
        const scalar angle
    )
    {
        dictionary d;
        d.add("shape", s.shape);
        d.add("material", material);
        d.add("position", vector(0, 0, z));
        d.add("velocity", vector(0, 0, w));
        d.add("rotation", Tuple2<vector, scalar>(axis, angle));
        return d;
    };

    const scalar part = s.isPlane ? 1 : 0.5;
    const scalar z = part*(m.height + m.gap);
    const scalar w = part*s.speed;
    dictionary all;
    all.add("a", body(s.material, z, -w, m.axisA, m.angleA));
    if (s.isPlane)
    {
        dictionary plane;
        plane.add("type", word("plane"));
        plane.add("point", point(Zero));
        plane.add("normal", vector(0, 0, 1));
        plane.add("material", s.with);
        dictionary walls;
        walls.add("plane", plane);
        dict.add("walls", walls);
    }
    else
    {
        all.add("b", body(s.with, -z, w, m.axisB, m.angleB));
    }
    dict.add("bodies", all);
    return dict;
}


Foam::autoPtr<Foam::dem::demSolver> Foam::dem::impactTrials::solverOf
(
    const dictionary& dict
) const
{
    demInput input(dict);
    input.directory = setting_.directory;
    input.save = [](){};
    return demSolver::New(input);
}


void Foam::dem::impactTrials::findTouch(const dictionary& pair, meeting& m)
{
    // Bodies that do not move may overlap
    const autoPtr<demSolver> still(solverOf(caseOf(m, pair, dictionary())));
    const bodies& state = still().state();

    const scalar zA = state.x[0].z();
    const scalar zB = setting_.isPlane ? 0 : state.x[1].z();
    m.height = -GREAT;
    for (label i = 0; i < state.firstSphere[1]; ++i)
    {
        const scalar up = state.sphereX()[i].z() - zA;
        if (setting_.isPlane)
        {
            if (state.sphereR[i] - up > m.height)
            {
                m.height = state.sphereR[i] - up;
                m.sphereA = i;
            }
            continue;
        }
        for (label j = state.firstSphere[1]; j < state.nSpheres(); ++j)
        {
            vector d = state.sphereX()[i] - state.sphereX()[j];
            d.z() = 0;
            const scalar both = state.sphereR[i] + state.sphereR[j];
            const scalar touch =
                sqrt(max(sqr(both) - magSqr(d), scalar(0)))
              - up + state.sphereX()[j].z() - zB;
            if (mag(d) < both && touch > m.height)
            {
                m.height = touch;
                m.sphereA = i;
                m.sphereB = j;
            }
        }
    }
    ofSpheres = ofSpheres && state.firstSphere[1] == 1;
    if (duration_ > 0)
    {
        return;
    }

    // How long the impact is that goes through the centre
    dictionary steps;
    steps.add("type", word("hades"));
    const autoPtr<demSolver> solver(solverOf(caseOf(m, pair, steps)));
    const materials& mats = solver().mats();
    const label a = mats.names().find(setting_.material);
    const label b = mats.names().find(setting_.with);
    const scalar k = mats.pair(a, b).elasticity;
    shearRatio_ = mats.pair(a, b).shearRatio;
    const scalar mStar =
        setting_.isPlane
      ? state.mass[0]
      : state.mass[0]*state.mass[1]/(state.mass[0] + state.mass[1]);
    const scalar rStar =
        (setting_.isPlane ? 1 : 0.5)*solver().shapes()[0].minRadius();
    const scalar u = setting_.speed;
    const bool isHertz = mats.laws().normal == "hertz";
    overlap_ =
        isHertz
      ? pow(15*mStar*sqr(u)/(16*k*sqrt(rStar)), 0.4)
      : u*sqrt(mStar/k);
    duration_ =
        (isHertz ? 2.9432 : constant::mathematical::pi)*overlap_/u;
}


Foam::scalar Foam::dem::impactTrials::closing
(
    const bodies& state,
    const meeting& m
) const
{
    const point& a = state.sphereX()[m.sphereA];
    if (setting_.isPlane)
    {
        const vector n(0, 0, 1);
        return -(n & state.velocityAt(0, a - state.sphereR[m.sphereA]*n));
    }

    const point& b = state.sphereX()[m.sphereB];
    const vector n = normalised(a - b);
    return
        n
      & (
            state.velocityAt(1, b + state.sphereR[m.sphereB]*n)
          - state.velocityAt(0, a - state.sphereR[m.sphereA]*n)
        );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::word Foam::dem::impactSetting::pairKey() const
{
    const word key = material + '-' + with;
    const word turned = with + '-' + material;
    return properties.subDict("pairs").found(turned) ? turned : key;
}


Foam::dem::impactTrials::impactTrials
(
    const impactSetting& setting,
    const dictionary& pair
)
:
    setting_(setting)
{
    Random rnd(setting.seed);
    for (label n = 0; n < setting.nOrientations; ++n)
    {
        meeting m;
        drawRotation(rnd, m.axisA, m.angleA);
        drawRotation(rnd, m.axisB, m.angleB);
        findTouch(pair, m);

        // Another phase of the first step in contact each time
        m.gap = setting.speed*duration_*(0.05 + 0.1*rnd.sample01<scalar>());
        meetings_.append(m);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::List<Foam::dem::impactTrials::velocities>
Foam::dem::impactTrials::impacts
(
    const dictionary& pair,
    const dictionary& stepControl,
    const scalar atOnce
) const
{
    // Bodies that still touch after so many durations stick
    const scalar longest = 300*duration_;

    DynamicList<velocities> all(meetings_.size());
    for (const meeting& m : meetings_)
    {
        autoPtr<demSolver> solver(solverOf(caseOf(m, pair, stepControl)));
        const bodies& state = solver().state();
        const scalar in = closing(state, m);

        bool touched = false, touches = true;
        scalar t = 0;
        while ((!touched || touches) && t < longest)
        {
            const scalar dt = atOnce*duration_;
            solver().advance(t, t + dt);
            t += dt;
            touches = solver().report().nContacts > 0;
            touched =
                touched || touches || solver().report().overlap > 0;
        }
        all.append
        (
            velocities{in, touches ? 0 : max(-closing(state, m), scalar(0))}
        );
    }
    return List<velocities>(std::move(all));
}


Foam::dem::impactTrials::result Foam::dem::impactTrials::restitution
(
    const dictionary& pair,
    const dictionary& stepControl,
    const scalar atOnce
) const
{
    result r;
    scalar before = 0, after = 0;
    for (const velocities& v : impacts(pair, stepControl, atOnce))
    {
        before += v.in;
        after += v.out;
        r.least = min(r.least, v.out/v.in);
        r.largest = max(r.largest, v.out/v.in);
    }
    r.mean = after/before;
    return r;
}


// ************************************************************************* //
