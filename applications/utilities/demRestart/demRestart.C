/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Application
    demRestart

Description
    Puts the times of a case aside from which a run cannot go on, so that
    startFrom latestTime goes on from the last whole one: times that a run
    which was stopped had begun to write, on all ranks or on some, or that it
    saved inside a step.

    A time is whole if it has, on all ranks, uniform/demCloudProperties, which
    Styx writes last. Those after the last whole one get names that OpenFOAM
    does not take for times; nothing is deleted but what an earlier call has
    put aside under the same name.

Usage
    \verbatim
    demRestart [-case DIR] [-dry-run]
    \endverbatim

    See doc/utilities/demRestart.md.

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "Fstream.H"
#include "HashSet.H"
#include "IOdictionary.H"
#include "OSspecific.H"
#include "Time.H"

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Is there all of a time that a run can go on from?
bool whole(const fileName& time)
{
    const fileName file(time/"uniform"/"demCloudProperties");
    if (!isFile(file))
    {
        return false;
    }
    IFstream stream(file);
    const dictionary dict(stream);
    return
        dict.lookupOrDefault<bool>("start", false)
     || dict.get<bool>("complete");
}


//- Put times aside that one of the folders has not whole; returns the last
//  that all have
word putAside(const fileNameList& folders, const bool dryRun)
{
    HashSet<word> names;
    for (const fileName& folder : folders)
    {
        for (const instant& t : Time::findTimes(folder))
        {
            if (t.name() != "constant")
            {
                names.insert(t.name());
            }
        }
    }
    instantList times;
    for (const word& name : names)
    {
        times.append(instant(name));
    }
    sort(times);

    label last = -1;
    forAll(times, i)
    {
        bool all = true;
        for (const fileName& folder : folders)
        {
            all = all && whole(folder/times[i].name());
        }
        if (all)
        {
            last = i;
        }
    }
    if (last < 0)
    {
        return word::null;
    }

    for (label i = last + 1; i < times.size(); ++i)
    {
        const word& name = times[i].name();
        Info<< "    time " << name << " is not whole: "
            << (dryRun ? "would be put" : "put") << " aside as incomplete."
            << name << endl;
        for (const fileName& folder : folders)
        {
            const fileName aside(folder/("incomplete." + name));
            if (!dryRun && isDir(folder/name))
            {
                rmDir(aside, true);
                if (!mv(folder/name, aside))
                {
                    FatalErrorInFunction
                        << "Cannot rename " << folder/name << " to " << aside
                        << exit(FatalError);
                }
            }
        }
    }
    return times[last].name();
}


// * * * * * * * * * * * * * * * * * Program * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::noParallel();
    argList::noFunctionObjects();
    argList::addNote
    (
        "Put times aside that a run which was stopped has not written to their"
        " end,\nin the case and in the folders of its ranks."
    );
    argList::addBoolOption("dry-run", "Say what would be done");

    const argList args(argc, argv);
    const bool dryRun = args.found("dry-run");
    const fileName path(args.path());

    fileNameList ranks;
    for (const fileName& folder : readDir(path, fileName::DIRECTORY))
    {
        if (folder.find("processor") == 0)
        {
            ranks.append(path/folder);
        }
    }

    const word inCase(putAside(fileNameList({path}), dryRun));
    const word onRanks
    (
        ranks.empty() ? word::null : putAside(ranks, dryRun)
    );

    // A run leaves the file in the time that it starts from before it writes
    // any other
    if (inCase.empty() && onRanks.empty())
    {
        Info<< "    no run has begun in " << path << ": all times stay"
            << endl;
    }
    if (inCase.size())
    {
        Info<< "    the case goes on from time " << inCase << endl;
    }
    if (onRanks.size())
    {
        Info<< "    the " << ranks.size() << " ranks go on from time "
            << onRanks << endl;
    }
    return 0;
}


// ************************************************************************* //
