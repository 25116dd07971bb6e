/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "progressReport.H"

#include <cmath>
#include <cstdio>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::string Foam::progressReport::duration(const scalar seconds)
{
    const long s = std::lround(seconds);
    char text[64];
    if (s < 60)
    {
        std::snprintf(text, sizeof(text), "%ld s", s);
    }
    else if (s < 3600)
    {
        std::snprintf(text, sizeof(text), "%ld min %ld s", s/60, s % 60);
    }
    else
    {
        std::snprintf
        (
            text,
            sizeof(text),
            "%ld h %ld min",
            s/3600,
            s/60 % 60
        );
    }
    return text;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::progressReport::progressReport(const Time& time)
:
    time_(time),
    last_(clock::now()),
    lastTime_(time.value())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::progressReport::add(const label nSteps, const label nBodies)
{
    steps_ += nSteps;
    bodySteps_ += scalar(nSteps)*nBodies;

    const scalar now = time_.value(), end = time_.endTime().value();
    const scalar wall =
        std::chrono::duration<scalar>(clock::now() - last_).count();
    if (wall < 10 && now < end - 0.5*time_.deltaTValue())
    {
        return;
    }

    const scalar start = time_.startTime().value();
    const scalar rate = (now - lastTime_)/max(wall, SMALL);
    Info<< "Progress: " << 100*(now - start)/max(end - start, SMALL)
        << " %, " << steps_/max(wall, SMALL) << " steps/s, "
        << bodySteps_/max(wall, SMALL) << " body-steps/s";
    if (now < end && rate > 0)
    {
        Info<< ", to the end " << duration((end - now)/rate).c_str();
    }
    Info<< endl;

    last_ = clock::now();
    lastTime_ = now;
    steps_ = 0;
    bodySteps_ = 0;
}


// ************************************************************************* //
