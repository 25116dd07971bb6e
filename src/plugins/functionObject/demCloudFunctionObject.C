/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.


\*---------------------------------------------------------------------------*/

#include "demCloudFunctionObject.H"
#include "allowedKeys.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(demCloudFunctionObject, 0);
    addToRunTimeSelectionTable
    (
        functionObject,
        demCloudFunctionObject,
        dictionary
    );
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::demCloud& Foam::functionObjects::demCloudFunctionObject::particles()
{
    return mesh_.lookupObjectRef<demCloud>(demCloud::typeName);
}


Foam::scalar
Foam::functionObjects::demCloudFunctionObject::timeToNextWrite() const
{
    const dictionary& control = time_.controlDict();
    const word type(control.getOrDefault<word>("writeControl", "timeStep"));
    if (type != "adjustable" && type != "adjustableRunTime")
    {
        return VGREAT;
    }

    // Write times count from the start of the run; the one that is now, but
    // for round-off, has been
    const scalar interval =
        time_.userTimeToTime(control.get<scalar>("writeInterval"));
    const scalar since =
        time_.value() - time_.startTime().value();
    return (floor(since/interval + 1e-9) + 1)*interval - since;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::demCloudFunctionObject::demCloudFunctionObject
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    meshName_(mesh_.name())
{
    // OpenFOAM goes on without a function object that throws, and says so in
    // a warning: errors must stop the run here
    const bool throwing = FatalError.throwExceptions(false);
    const bool throwingIO = FatalIOError.throwExceptions(false);

    read(dict);
    if (!mesh_.foundObject<demCloud>(demCloud::typeName))
    {
        own_.reset(new demCloud(mesh_, demCloud::fluidAccess::look));

        // The fields are written before the bodies have followed: see write
        own_->writeOpt() = IOobject::NO_WRITE;
    }

    particles().passed(ledger::start);

    FatalError.throwExceptions(throwing);
    FatalIOError.throwExceptions(throwingIO);
}


Foam::functionObjects::demCloudFunctionObject::~demCloudFunctionObject()
{
    // A cloud cannot be taken down after its mesh. This happens to a run that
    // never came to its end
    if (own_.valid() && !time_.foundObject<fvMesh>(meshName_))
    {
        own_.release();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::functionObjects::demCloudFunctionObject::bringAlong
(
    const Time& runTime
)
{
    const word name("demCloud");
    if (runTime.functionObjects().findObjectID(name) >= 0)
    {
        return;
    }

    // The list is made from controlDict only, and made again whenever that is
    // read again
    dictionary& control = const_cast<dictionary&>(runTime.controlDict());
    dictionary& functions = control.subDictOrAdd("functions");
    for (const entry& e : functions)
    {
        if
        (
            e.isDict()
         && e.dict().getOrDefault<word>("type", word::null) == typeName
        )
        {
            return;
        }
    }

    dictionary own;
    own.add("type", typeName);
    functions.add(name, own);
    if (runTime.timeIndex() > runTime.startTimeIndex())
    {
        const_cast<functionObjectList&>(runTime.functionObjects()).read();
    }
}


bool Foam::functionObjects::demCloudFunctionObject::read
(
    const dictionary& dict
)
{
    dem::checkKeys
    (
        dict,
        {"type", "libs", "functionObjectLibs", "region", "enabled"}
    );
    return fvMeshFunctionObject::read(dict);
}


bool Foam::functionObjects::demCloudFunctionObject::execute()
{
    // What is written is so after the last pressure correction
    particles().passed(time_.writeTime() ? ledger::writing : ledger::fluid);
    if (own_.valid())
    {
        own_->beginStep();
    }
    particles().endStep();
    return true;
}


bool Foam::functionObjects::demCloudFunctionObject::write()
{
    if (own_.valid() && time_.writeTime())
    {
        own_->write();
    }
    particles().finishWriting();
    return true;
}


bool Foam::functionObjects::demCloudFunctionObject::end()
{
    particles().close();
    return true;
}


bool Foam::functionObjects::demCloudFunctionObject::adjustTimeStep()
{
    particles().passed(ledger::fluid);
    const scalar bound = particles().maxDeltaT();
    if (bound >= time_.deltaTValue())
    {
        return true;
    }

    const scalar left = timeToNextWrite();
    const scalar deltaT =
        left < VGREAT ? left/ceil(left/bound - 1e-9) : bound;
    Info<< "demCloud: deltaT bounded by " << particles().deltaTBound()
        << endl;
    const_cast<Time&>(time_).setDeltaT(deltaT, false);
    return true;
}


// ************************************************************************* //
