/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Application
    styxFoam

Description
    Dense flow: an incompressible fluid between bodies that are smaller than
    its cells and take volume from it, and bodies that are larger than cells.
    Transient, laminar or turbulent, on meshes that stay or refine. The bodies
    are those of constant/demCloudProperties with coupling twoWay.

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "averagedFluid.H"
#include "Time.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Solves the volume-averaged flow between rigid particles."
    );

    #include "setRootCase.H"
    #include "createTime.H"
    #include "createDynamicFvMesh.H"

    {
        averagedFluid fluid(mesh);

        while (runTime.run())
        {
            fluid.setDeltaT();
            ++runTime;
            Info<< "Time = " << runTime.timeName() << nl << endl;

            fluid.updateMesh();
            fluid.advanceBodies();

            while (fluid.control().loop())
            {
                fluid.predictMomentum();
                while (fluid.control().correct())
                {
                    fluid.correctPressure();
                }
                fluid.imposeBodies();
                fluid.correctTurbulence();
            }

            fluid.report();
            runTime.write();
            runTime.printExecutionTime(Info);
        }
        fluid.close();
    }

    Info<< "End" << nl << endl;
    return 0;
}


// ************************************************************************* //
