/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "hadesSolver.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::string Foam::dem::hadesSolver::nameOf(const label i) const
{
    if (i < 0)
    {
        return "wall " + walls_.walls()[-1 - i].name();
    }
    return
        "body " + std::to_string(moving().id[i])
      + " (" + moving().shapeOf(i).name() + ')';
}


Foam::string Foam::dem::hadesSolver::shown(const vector& v)
{
    OStringStream os;
    os << v;
    return os.str();
}


Foam::string Foam::dem::hadesSolver::neighboursOf(const label b) const
{
    const bodies& state = moving();
    labelHashSet others;
    list_.pairs().forEach([&](const verletList::spherePair& p)
    {
        const label i = state.sphereBody[p.i];
        const label j = state.sphereBody[p.j];
        if (i == b || j == b)
        {
            others.insert(i == b ? j : i);
        }
    });
    forAll(walls_.walls(), w)
    {
        if (walls_.isNear(w, state.firstSphere[b], state.firstSphere[b + 1]))
        {
            others.insert(-1 - w);
        }
    }

    string names;
    for (const label i : others.sortedToc())
    {
        names += (names.empty() ? "" : ", ") + nameOf(i);
    }
    return names.empty() ? string("none") : names;
}


void Foam::dem::hadesSolver::stop(const scalar t, const string& why)
{
    if (input_.save)
    {
        input_.save();
    }

    FatalErrorInFunction
        << "The bodies cannot move on at time " << t << " s." << nl
        << why.c_str()
        << (input_.save ? "    The state has been written.\n" : "")
        << exit(FatalError);
}


Foam::string Foam::dem::hadesSolver::placeOf(const label b) const
{
    OStringStream os;
    if (b >= 0)
    {
        os  << nameOf(b).c_str() << " at " << moving().x[b]
            << " with velocity " << moving().v[b] << " m/s." << nl;
    }
    return os.str();
}


void Foam::dem::hadesSolver::giveUp(const scalar t, const stepChoice& step)
{
    unpack();

    OStringStream why;
    why << "    They need a step of " << step.dt << " s, but "
        << control_->minimum().c_str() << ' ' << control_->minDeltaT()
        << " s." << nl;

    // What the rank that has the body knows
    const string body = group_.first
    (
        step.body < 0
      ? string()
      : placeOf(step.body) + "    Its neighbours: "
      + neighboursOf(step.body) + ".\n"
    );
    if (body.size())
    {
        why << "    The reason (" << step.limit << ") is " << body.c_str();
    }

    const contactSummary& s =
        group_.any(rejected_.overlapA >= 0) ? rejected_ : summary_;
    const string pair = group_.first
    (
        s.overlapA < 0
      ? string()
      : nameOf(s.overlapA) + " and " + nameOf(s.overlapB)
    );
    if (pair.size())
    {
        why << "    Largest overlap: " << 100*s.overlap
            << " % of the smaller radius, between " << pair.c_str() << '.'
            << nl;
    }

    stop(t, why.str());
}


void Foam::dem::hadesSolver::giveUp
(
    const scalar t,
    const scalar length,
    const scalar dt,
    const stepChoice& step
)
{
    unpack();

    OStringStream why;
    why << "    An advance by " << length << " s has taken the maxSteps of "
        << control_->maxSteps() << "; they are at " << dt << " s now ("
        << step.limit << ")." << nl;
    const string body = group_.first(placeOf(step.body));
    if (body.size())
    {
        why << "    The reason is " << body.c_str();
    }
    stop(t, why.str());
}


void Foam::dem::hadesSolver::checkFinite(const scalar t)
{
    string why;
    const bodies& state = state_;
    forAll(state.x, b)
    {
        const vector sum =
            state.x[b] + state.v[b] + state.omega[b]
          + state.fluidForce[b] + state.fluidTorque[b];

        // A NaN is not below anything
        if (why.empty() && !(magSqr(sum) < VGREAT))
        {
            why =
                "    body " + std::to_string(state.id[b]) + " ("
              + state.shapeOf(b).name() + ") at " + shown(state.x[b])
              + " has velocity "
              + shown(state.v[b]) + " m/s and a force of the fluid of "
              + shown(state.fluidForce[b]) + " N.\n";
        }
    }
    if (group_.any(why.size()))
    {
        stop(t, group_.first(why));
    }
}


// ************************************************************************* //
