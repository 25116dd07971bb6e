/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "demCloud.H"
#include "bisection.H"
#include "cellOwner.H"

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

//- Why every rank must have all resolved bodies; empty if it need not
Foam::string resolvedNeedAll(const Foam::dictionary& dict)
{
    using namespace Foam;
    const dictionary& immersed = dict.subOrEmptyDict("immersed");
    const word type
    (
        immersed.getOrDefault<word>("type", "implicitForcing")
    );
    if (type == "fictitiousDomain")
    {
        return "type fictitiousDomain gives them the flow's momentum";
    }
    if (immersed.found("outerCorrectors"))
    {
        return "outerCorrectors repeat their motion";
    }
    const dictionary& fluid = dict.subOrEmptyDict("fluid");
    token rho;
    if (fluid.found("rho"))
    {
        fluid.lookup("rho").read(rho);
    }
    if (rho.isWord())
    {
        return "the density is a field";
    }
    if (dict.subOrEmptyDict("output").found("forces"))
    {
        return "the table of their forces is one of all";
    }
    return string();
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::string Foam::demCloud::needsAll(const fluidAccess access) const
{
    const dictionary& resolved = dict_.subOrEmptyDict("resolved");
    if (access != fluidAccess::none)
    {
        if (effects_.automatic && !dict_.found("coupling"))
        {
            return "effects auto chooses the coupling";
        }
        if (effects_.automatic && coupling_ != "none")
        {
            return "effects auto looks at all of them";
        }
        if (!resolved.empty())
        {
            return "some are resolved and some are points to the fluid";
        }
        if (immersedBodies())
        {
            const string why = resolvedNeedAll(dict_);
            if (!why.empty())
            {
                return why;
            }
        }
        if (coupling_ == "none" && access == fluidAccess::act)
        {
            return "the mesh may be refined around them";
        }
    }
    if (dict_.found("couplingInterval"))
    {
        return "couplingInterval looks at all of them";
    }
    if
    (
        dict_.getOrDefault<wordList>("solidFields", wordList())
       .found("solidStress")
    )
    {
        return "solidStress needs the forces of all";
    }
    return string();
}


void Foam::demCloud::setOwner
(
    const fluidAccess access,
    dem::demInput& input
) const
{
    if (!Pstream::parRun())
    {
        return;
    }
    const string why = needsAll(access);
    if (!why.empty())
    {
        Info<< "    every rank has all bodies, as " << why.c_str() << endl;
        return;
    }
    if (coupling_ == "none")
    {
        input.owner = []()
        {
            return autoPtr<dem::bodyOwner>(new dem::bisection);
        };
        return;
    }
    input.owner = [this]()
    {
        return autoPtr<dem::bodyOwner>(new coupling::cellOwner(mesh_, bins_));
    };
}


// ************************************************************************* //
