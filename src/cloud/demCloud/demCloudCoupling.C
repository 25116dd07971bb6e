/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.


\*---------------------------------------------------------------------------*/

#include "demCloud.H"
#include "allowedKeys.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

//- Stop at forces that need bodies that feel the fluid
void checkPushed(const Foam::dictionary& forces)
{
    for
    (
        const char* name
      : {"virtualMass", "basset", "lubrication", "pressureGradient", "viscous"}
    )
    {
        if (Foam::coupling::pointForce::switchedOn(name, forces))
        {
            Foam::dem::badEntry
            (
                forces,
                name,
                "belongs to bodies that feel the fluid, and with coupling"
                " particlesToFluid they do not; take it out, or coupling twoWay"
            );
        }
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::volVectorField& Foam::demCloud::U() const
{
    return mesh_.lookupObject<volVectorField>("U");
}


bool Foam::demCloud::actsOnFluid() const
{
    return coupling_ == "twoWay" || coupling_ == "particlesToFluid";
}


bool Foam::demCloud::pointBodies() const
{
    return
        coupling_ == "fluidToParticles"
     || (coupling_ != "none" && dict_.found("forces"));
}


bool Foam::demCloud::immersedBodies() const
{
    return coupling_ != "none" && (!pointBodies() || dict_.found("resolved"));
}


void Foam::demCloud::checkCoupling(const fluidAccess access) const
{
    const auto refuse = [this](const word& block, const string& why)
    {
        if (dict_.found(block))
        {
            dem::badEntry(dict_, block, why);
        }
    };

    checkKinds();
    const bool points = pointBodies();
    if (actsOnFluid() && !points && !dict_.found("immersed"))
    {
        dem::badEntry
        (
            dict_,
            "coupling",
            "is " + coupling_ + ", which needs the block immersed, if bodies"
            " fill cells of the fluid, or forces, if they are points to it"
        );
    }
    if (access == fluidAccess::look)
    {
        if (coupling_ != "none" && coupling_ != "fluidToParticles")
        {
            refuse
            (
                "coupling",
                "is " + coupling_ + ", but a function object cannot act on"
                " the fluid.\n"
                "    Move  particles { type demCloud; }  from functions in"
                " system/controlDict to\n    constant/fvOptions (in a solver"
                " that has fvOptions, as pimpleFoam), or take\n"
                "    coupling none or fluidToParticles"
            );
        }
        refuse("interface", "needs the fvOption demCloud; take it out");
    }

    if (points && !immersedBodies())
    {
        const string why
        (
            "does not go with coupling fluidToParticles, or another with"
            " forces, in which bodies are points to the fluid; take it out"
        );
        refuse("immersed", why);
        refuse("interface", why);
    }
    if (coupling_ != "none" && !(points && actsOnFluid()))
    {
        const string why
        (
            "belongs to coupling twoWay or particlesToFluid with forces, in"
            " which the fluid feels bodies that are points to it; take it out"
        );
        refuse("voidFraction", why);
        refuse("momentumExchange", why);
        refuse("solidFields", why);
    }
    if
    (
        points
     && !actsOnFluid()
     && coupling::pointForce::switchedOn
        (
            "undisturbedVelocity",
            dict_.subDict("forces")
        )
    )
    {
        dem::badEntry
        (
            dict_.subDict("forces"),
            "undisturbedVelocity",
            "is of no use with coupling " + coupling_ + ": the fluid does not"
            " feel the bodies, so that they have no wake; take it out"
        );
    }
}


void Foam::demCloud::makeExchange(const bool averaged)
{
    exchanged_.reset
    (
        new coupling::momentumExchange
        (
            mesh_,
            bins_,
            cells_,
            *dem_,
            kinds_,
            *rho_,
            *points_,
            dict_,
            averaged,
            coupling_ != "particlesToFluid"
        )
    );
    if (dict_.found("solidFields"))
    {
        solids_.reset
        (
            new coupling::solidFields(mesh_, *dem_, *exchanged_, dict_)
        );
    }
}


void Foam::demCloud::readCoupling(const fluidAccess access)
{
    checkCoupling(access);
    readKinds();

    if (coupling_ != "none")
    {
        const dictionary& fluid = dict_.subDict("fluid");
        dem::checkKeys
        (
            fluid,
            pointBodies()
          ? wordList({"rho", "nu"})
          : wordList({"rho"})
        );
        rho_.reset(new coupling::fluidDensity(mesh_.thisDb(), fluid));
    }

    if (pointBodies())
    {
        if (coupling_ == "particlesToFluid")
        {
            checkPushed(dict_.subDict("forces"));
        }
        points_.reset
        (
            new coupling::pointForces
            (
                mesh_,
                bins_,
                cells_,
                *dem_,
                kinds_,
                *rho_,
                dict_.subDict("fluid"),
                dict_.subDict("forces")
            )
        );

        // From here on the solver keeps the old time level
        U().oldTime();
        if (actsOnFluid())
        {
            makeExchange(access == fluidAccess::share);
        }
    }
    if (immersedBodies())
    {
        const dictionary& immersed = dict_.subDict("immersed");
        immersed_ = coupling::immersedMethod::New
        (
            coupling::immersedScene{mesh_, bins_, *dem_, kinds_, *rho_},
            immersed,
            access == fluidAccess::share
        );
        if (immersed_->asksSolver() && points_.valid())
        {
            dem::badEntry
            (
                immersed,
                "type",
                "takes all of a cell for fluid, but with forces the bodies"
                " that are points leave\n    the fluid a part of it only; take"
                " type implicitForcing"
            );
        }
    }
    readInterval(access);
}


Foam::scalar Foam::demCloud::maxDeltaT()
{
    return
        interval_.valid()
      ? interval_->maxDeltaT
        (
            dem_->state(),
            points_.valid() ? points_.get() : nullptr
        )
      : GREAT;
}


void Foam::demCloud::readInterval(const fluidAccess access)
{
    autoPtr<coupling::frictionReach> friction;
    if (immersed_.valid() && coupling_ == "twoWay")
    {
        friction = coupling::frictionReach::New
        (
            mesh_,
            bins_,
            kinds_,
            surroundings().nu,
            *dem_
        );
    }
    const dictionary* entries = dict_.findDict("couplingInterval");
    if (access != fluidAccess::none && (entries || friction.valid()))
    {
        interval_.reset
        (
            new coupling::couplingInterval
            (
                mesh_,
                bins_,
                entries,
                points_.valid(),
                std::move(friction)
            )
        );
        if
        (
            access == fluidAccess::share
         && interval_->skips()
         && coupling::pointForce::switchedOn
            (
                "pressureGradient",
                dict_.subOrEmptyDict("forces")
            )
        )
        {
            dem::badEntry
            (
                dict_.subDict("couplingInterval"),
                "every",
                "leaves out exchanges, in which bodies with pressureGradient"
                " feel the pressure that they make themselves: held over steps"
                " it is not stable. Take every 1, or equations B without"
                " pressureGradient"
            );
        }
    }
}


// ************************************************************************* //
