/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "hadesSolver.H"

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

//- Does a wall move?
bool anyMoves(const Foam::dictionary& walls)
{
    for (const Foam::entry& e : walls)
    {
        if (e.isDict() && e.dict().found("motion"))
        {
            return true;
        }
    }
    return false;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::hadesSolver::readWatchdog()
{
    if (!watchdog::on(input_.dict))
    {
        return;
    }
    watchdog_.reset(new watchdog(input_.dict));
    packed_.meterDrag();
    energyUnknown_ =
        anyMoves(input_.dict.subOrEmptyDict("walls")) ? "a wall moves"
      : materials_.laws().cohesion.size() ? "attraction acts"
      : nullptr;
    if (sinks_.size() || input_.outlets.size() || input_.period.active())
    {
        input_.closed = boundBox();
    }
}


Foam::scalar Foam::dem::hadesSolver::storedInContacts() const
{
    // At rest there are no dashpots
    bodies still(moving());
    still.v = Zero;
    still.omega = Zero;
    scalar stored = 0;
    DynamicList<verletList::pairHistory> some;
    const auto add = [&](const UList<wallTouch>& touches)
    {
        for
        (
            const contactForce& c
          : contactForces
            (
                contacts_,
                materials_,
                still,
                some,
                input_.period,
                touches,
                walls_.walls()
            )
        )
        {
            stored += max(c.normal()*c.overlap, scalar(0));
        }
        some.clear();
    };

    // A part of them at a time, unless they have shares of each other's
    const label most =
        materials_.laws().multiContact == "share" ? labelMax : 10000;
    list_.forEachTouching
    (
        [&](const verletList::spherePair& p, const vector& xi)
        {
            verletList::pairHistory h;
            h.pair = p;
            h.xi = xi;
            some.append(h);
            if (some.size() == most)
            {
                add(UList<wallTouch>());
            }
        }
    );
    add(walls_.together().accepted);
    return group_.sum(stored);
}


void Foam::dem::hadesSolver::keepStart()
{
    const contactLaws& laws = materials_.laws();
    const bool whole = laws.rollsBack() || laws.coheres("capillary");
    advanceStart& s = start_;
    s.startSlip(areMany(state_.nSpheres()), summary_.nPairs);
    s.state.clear();
    if (whole && exchange_.valid())
    {
        s.pairs = exchange_->pairsOf(list_);
    }
    else if (whole)
    {
        s.whole = history();
    }
    else if (laws.slips())
    {
        list_.forEachTouching
        (
            [&](const verletList::spherePair& p, const vector& xi)
            {
                if (exchange_.valid())
                {
                    for (const label sphere : {p.i, p.j})
                    {
                        const sphereName name(exchange_->nameOf(sphere));
                        s.names.append(name.body);
                        s.names.append(name.sphere);
                    }
                    s.names.append(p.image);
                }
                else
                {
                    s.touching.add(p);
                }
                s.addSlip(xi);
            }
        );
    }
    if (exchange_.valid())
    {
        s.touches = exchange_->touchesOf(walls_);
    }
    else if (!whole)
    {
        s.whole.walls = walls_.together().accepted;
    }

    s.control.clear();
    control_->writeState(s.control);
    if (sleepers_.valid())
    {
        s.asleep.reset(new sleepers(*sleepers_));
    }
}


void Foam::dem::hadesSolver::goBack()
{
    advanceStart& s = start_;
    if (s.state.valid())
    {
        state_.x = s.state->x;
        state_.v = s.state->v;
        state_.q = s.state->q;
        forAll(state_.x, b)
        {
            state_.setL(b, s.state->L(b));
            state_.omega[b] = s.state->omega[b];
            state_.updateSpheres(b);
        }
    }
    control_->readState(s.control);
    if (sleepers_.valid())
    {
        *sleepers_ = *s.asleep;
    }

    List<verletList::pairHistory> pairs
    (
        s.touching.nPlain() + s.touching.nImages()
    );
    DynamicList<namedPair> named(s.pairs);
    label n = 0;
    const auto historyOf = [&](const verletList::spherePair& p)
    {
        verletList::pairHistory h;
        h.pair = p;
        h.xi = s.slipOf(n++);
        return h;
    };
    s.touching.forEach([&](const verletList::spherePair& p)
    {
        const label k = n;
        pairs[k] = historyOf(p);
    });
    for (label k = 0; k < s.names.size(); k += 5)
    {
        const label* of = &s.names[k];
        named.append
        (
            namedPair
            {
                sphereName{of[0], of[1]},
                sphereName{of[2], of[3]},
                historyOf(verletList::spherePair(-1, -1, of[4]))
            }
        );
    }
    if (exchange_.valid())
    {
        list_.setHistories
        (
            List<verletList::pairHistory>(), List<verletList::pairHistory>()
        );
        walls_.setTouches
        (
            List<wallTouch>(), List<wallRolled>(), List<wallTouch>()
        );
        exchange_->setSaved(named, s.touches);
        exchange_->shareOut(state_, list_, walls_, true);
    }
    else if (pairs.empty())
    {
        setHistory(s.whole);
    }
    else
    {
        // They are as the list has them, which makes room for them
        list_.drop();
        list_.setHistories
        (
            std::move(pairs), List<verletList::pairHistory>()
        );
        walls_.setTouches
        (
            s.whole.walls,
            s.whole.wallsRolled,
            s.whole.wallsBridged
        );
    }
    s.state.reset(new bodies(state_));
}


Foam::string Foam::dem::hadesSolver::wrongIn(const scalar length)
{
    static const labelUList asTheyAre;
    const bodies& start = start_.state.valid() ? *start_.state : state_;
    report_.energyUnknown =
        input_.meshMoves ? "the mesh moves"
      : state_.drag && !integrator_->leaps()
      ? "a drag follows the bodies between stages"
      : energyUnknown_;
    return watchdog_->complaint
    (
        watchdog::advance
        {
            start,
            packed_,
            exchange_.valid() ? exchange_->own() : asTheyAre,
            g(),
            length,
            input_.period,
            input_.closed,
            !report_.energyUnknown,
            walls_.walls().empty(),
            stored_,
            start_.drag
        }
    );
}


void Foam::dem::hadesSolver::endPiece()
{
    if (packed_.dragged())
    {
        packedDrag piece;
        piece.impulse = packed_.given().impulse;
        piece.work = packed_.given().work;
        for (label b = 0; b < state_.size(); ++b)
        {
            packed_.end(exchange_.valid() ? exchange_->own()[b] : b, piece);
        }
        start_.drag.impulse += piece.impulse;
        start_.drag.work += piece.work;
    }
    unpack();
    start_.drag.given.resize(state_.dragGiven.size(), Zero);
    forAll(state_.dragGiven, b)
    {
        start_.drag.given[b] += state_.dragGiven[b];
    }
}


void Foam::dem::hadesSolver::watch(const scalar t0, const scalar t1)
{
    stored_ = 0;
    start_.drag = packedDrag();
    string wrong(wrongIn(t1 - t0));
    const label nEntered = report_.nEntered;
    const auto startAgain = [&]()
    {
        goBack();
        start_.drag = packedDrag();
        report_ = advanceReport();
        report_.nEntered = nEntered;
        notesStored_ = true;
    };
    scalar pieces = max(report_.nSteps, label(1));
    label n = 0;
    const label nTwice = wrong.size() ? 1 : 0;
    if (nTwice)
    {
        // Perhaps it is what contacts gave back
        startAgain();
        move(t0, t1);
        wrong = wrongIn(t1 - t0);
    }
    for (; wrong.size() && n < watchdog_->halvings(); ++n)
    {
        pieces *= 2;
        Info<< "demCloud: watchdog: " << wrong.c_str() << ';' << nl
            << "    going back to " << t0 << " s and on in " << pieces
            << " pieces" << endl;
        startAgain();
        scalar t = t0;
        for (scalar i = 1; i < pieces; ++i)
        {
            move(t, t0 + i*(t1 - t0)/pieces);
            t = t0 + i*(t1 - t0)/pieces;
            endPiece();
        }
        move(t, t1);
        wrong = wrongIn(t1 - t0);
    }
    report_.energyGain = watchdog_->gain();
    report_.nBack = n;
    report_.nTwice = nTwice;

    if (wrong.size())
    {
        goBack();
        if (input_.save)
        {
            input_.save();
        }
        FatalErrorInFunction
            << "In the step to time " << t1 << " s " << wrong.c_str() << '.'
            << nl << "    It was gone back over " << n
            << " times, the last time in " << pieces << " pieces." << nl
            << "    The state before the step has been written." << nl
            << "    See the entry watchdog in " << input_.dict.name()
            << exit(FatalError);
    }
}


// ************************************************************************* //
