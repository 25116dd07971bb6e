/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Application
    demFoam

Description
    Particles without a fluid: contacts, walls and gravity, from the same
    constant/demCloudProperties as the coupled solvers read. The time step of
    controlDict is the interval at which bodies enter and the ledger reports;
    the bodies choose their own.

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "columnFvMesh.H"
#include "Time.H"
#include "fvMesh.H"
#include "demCloud.H"
#include "progressReport.H"

#include <malloc.h>

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote("Moves rigid particles without a fluid.");

    // Lists of a large scene that are freed leave no holes, into which the
    // next ones, which are a little larger, would not fit
    mallopt(M_MMAP_THRESHOLD, 2 << 20);

    #include "setRootCase.H"
    #include "createTime.H"
    #include "createMesh.H"

    {
        demCloud cloud(mesh, demCloud::fluidAccess::none);
        progressReport progress(runTime);

        while (runTime.run())
        {
            ++runTime;
            Info<< "Time = " << runTime.timeName() << endl;

            cloud.beginStep();
            cloud.endStep();
            runTime.write();
            progress.add
            (
                cloud.dem().report().nSteps,
                cloud.dem().state().size()
            );
        }
    }

    Info<< "End" << nl << endl;
    return 0;
}


// ************************************************************************* //
