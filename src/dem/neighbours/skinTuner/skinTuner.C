/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "skinTuner.H"
#include "IOstreams.H"
#include "Pstream.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Steps of a window, at least and at most
constexpr Foam::label fewest = 50, most = 20000;

//- From rungs below this one, it looks at that
constexpr Foam::label far = 3, wide = 5;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::skinTuner::rest()
{
    rung_ = best_;
    nRest_ = 50;
    if (tells_ && told_ != best_)
    {
        Info<< "    neighbours auto: ";
        if (skin() > 0)
        {
            Info<< "verletList with skin " << skin();
        }
        else
        {
            Info<< "linkCell";
        }
        Info<< ", " << 1e6*bestTime_ << " us a step" << endl;
        told_ = best_;
    }
}


void Foam::dem::skinTuner::walk()
{
    const auto isRung = [&](const label i)
    {
        return i >= 0 && i < skins_.size();
    };
    if (!turned_ && !isRung(best_ + way_))
    {
        turned_ = true;
        way_ = -way_;
    }
    if (isRung(best_ + way_))
    {
        rung_ = best_ + way_;
    }
    else
    {
        rest();
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::skinTuner::skinTuner(const bool tells)
:
    skins_({0, 0.02, 0.035, 0.06, 0.1, 0.17, 0.3, 0.5, 0.8}),
    rung_(4),
    best_(4),
    nWanted_(fewest),
    since_(clock::now()),
    tells_(tells)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::dem::skinTuner::windowDone(scalar secondsPerStep)
{
    // A window has to hold a list or two, or it says nothing about them
    if (nBuilds_ < 3 && nSteps_ < most)
    {
        nWanted_ = min(2*max(nSteps_, fewest), most);
        return false;
    }
    if (Pstream::parRun())
    {
        Pstream::scatter(secondsPerStep);
    }
    const scalar old = skin();
    nSteps_ = 0;
    nBuilds_ = 0;
    seconds_ = 0;
    nWanted_ = fewest;

    if (nRest_ > 0)
    {
        if (--nRest_ == 0)
        {
            // The bodies are not those of then. Where lists are made at
            // nearly every step, all small skins cost the same: look far
            bestTime_ = secondsPerStep;
            turned_ = false;
            if (best_ < far)
            {
                rung_ = wide;
            }
            else
            {
                walk();
            }
        }
    }
    else if (bestTime_ < 0 || secondsPerStep < 0.98*bestTime_)
    {
        // Down the hill: the other way is up
        turned_ = bestTime_ > 0 && mag(rung_ - best_) == 1;
        bestTime_ = secondsPerStep;
        best_ = rung_;
        walk();
    }
    else if (!turned_)
    {
        turned_ = true;
        way_ = -way_;
        walk();
    }
    else
    {
        rest();
    }
    return skin() != old;
}


// ************************************************************************* //
