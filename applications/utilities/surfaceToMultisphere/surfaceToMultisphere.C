/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Application
    surfaceToMultisphere

Description
    Approximates the body inside a closed surface by a cluster of spheres and
    writes it as a template that the entry file of a multisphere shape reads.

    The algorithm is that of Foam::dem::multisphereGenerator. Prints the
    body's mass properties and the errors of the approximation.

Usage
    \verbatim
    surfaceToMultisphere rock.stl constant/rock.spheres -spheres 5
    surfaceToMultisphere rock.obj rock.spheres -maxOffsetError 0.1 -fit
    \endverbatim

    See doc/utilities/surfaceToMultisphere.md for the options.

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "clockTime.H"
#include "closedSurface.H"
#include "Fstream.H"
#include "multisphereErrors.H"
#include "multisphereGenerator.H"
#include "OSspecific.H"
#include "StringStream.H"

using namespace Foam;
using namespace Foam::dem;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

void addOptions()
{
    argList::noParallel();
    argList::noFunctionObjects();
    argList::addNote
    (
        "Approximate the body inside a closed surface by a cluster of spheres."
        "\nGive either -spheres or -maxOffsetError."
    );
    argList::addArgument("surface", "Any kind that triSurface reads");
    argList::addArgument("output", "The template to write");
    argList::addOption("spheres", "N", "Number of spheres");
    argList::addOption
    (
        "maxOffsetError",
        "e",
        "Take as many spheres as this offset error (7.11) needs"
    );
    argList::addOption
    (
        "maxSpheres",
        "N",
        "Most spheres that -maxOffsetError may take (default: 200)"
    );
    argList::addOption
    (
        "cells",
        "n",
        "Grid cells across the longest edge (default: 40)"
    );
    argList::addOption
    (
        "removal",
        "p",
        "Grid points nearer to a new centre than p radii are removed"
        " (default: 0.9)"
    );
    argList::addBoolOption
    (
        "onGrid",
        "Keep the centres on the grid, as in the thesis"
    );
    argList::addBoolOption
    (
        "fit",
        "Move and size the spheres afterwards to lower the offset error"
    );
    argList::addOption
    (
        "scale",
        "s",
        "Multiply the surface's lengths by s, e.g. 0.001 for mm"
    );
    argList::addOption
    (
        "density",
        "rho",
        "Also print mass and moments of inertia for this density [kg/m3]"
    );
}


// A number of the command line that must lie in a range
template<class Type>
Type option
(
    const argList& args,
    const word& name,
    const Type deflt,
    const Type low,
    const Type high
)
{
    const Type value = args.getOrDefault<Type>(name, deflt);

    if (!(value >= low && value <= high))
    {
        FatalErrorInFunction
            << "Option -" << name << " is " << value << " but must be from "
            << low << " to " << high << exit(FatalError);
    }
    return value;
}


// One aligned line of the report
template<class Type>
void entryLine(const string& what, const Type& value, const string& unit)
{
    Info<< "    " << what.c_str();
    for (label i = what.size(); i < 34; ++i)
    {
        Info<< ' ';
    }
    Info<< value << "  [" << unit.c_str() << ']' << nl;
}


void printBody(const closedSurface& body, const scalar density)
{
    const massProperties& mass = body.properties();
    tensor axes;
    vector moments;
    mass.principalAxes(axes, moments);

    Info<< "Body" << nl;
    entryLine("triangles", body.surface().size(), "-");
    entryLine("volume", mass.volume, "m3");
    entryLine("centre of mass", mass.centroid, "m");
    entryLine("principal moments / density", moments, "m5");

    if (density > 0)
    {
        entryLine("mass", density*mass.volume, "kg");
        entryLine("principal moments", density*moments, "kg m2");
    }
    Info<< nl;
}


void printCluster
(
    const multisphereGenerator& cluster,
    const multisphereErrors& errors
)
{
    Info<< "Cluster" << nl;
    entryLine("spheres", cluster.radii().size(), "-");
    entryLine("smallest radius", min(cluster.radii()), "m");
    entryLine("largest radius", max(cluster.radii()), "m");
    entryLine("err_vol before correction", cluster.inscribedError(), "-");
    entryLine("err_vol (7.10)", errors.volume, "-");
    entryLine("err_off (7.11)", errors.offset, "-");
    entryLine("    measured along lines", errors.nLines, "-");
    entryLine("inertia error", errors.inertia, "-");
    entryLine("centroid error / diameter", errors.centroid, "-");
    entryLine("largest distance to the spheres", errors.surfaceToSpheres, "m");
    entryLine("largest distance to the surface", errors.spheresToSurface, "m");
    Info<< nl;
}


void write
(
    const fileName& file,
    const closedSurface& body,
    const multisphereGenerator& cluster,
    const multisphereErrors& errors
)
{
    if (!file.path().empty())
    {
        mkDir(file.path());
    }

    OFstream os(file);
    if (!os.good())
    {
        FatalErrorInFunction
            << "Cannot write the template " << file << exit(FatalError);
    }

    // Enough digits for the same bits on reading
    os.precision(17);

    os.beginBlock("FoamFile");
    os.writeEntry("version", word("2.0"));
    os.writeEntry("format", word("ascii"));
    os.writeEntry("class", word("dictionary"));
    os.writeEntry("object", word(file.name()));
    os.endBlock();

    os << nl << "// Written by surfaceToMultisphere. Lengths in m; the mass "
        << "properties are the body's" << nl << nl;

    cluster.writeEntries(os);

    os << nl;
    os.beginBlock("report");
    os.writeEntry("surface", fileName(body.name()));
    os.writeEntry("spheres", cluster.radii().size());
    os.writeEntry("volumeError", errors.volume);
    os.writeEntry("offsetError", errors.offset);
    os.writeEntry("inertiaError", errors.inertia);
    os.writeEntry("centroidError", errors.centroid);
    os.writeEntry("surfaceToSpheres", errors.surfaceToSpheres);
    os.writeEntry("spheresToSurface", errors.spheresToSurface);
    os.endBlock();
}


// * * * * * * * * * * * * * * * Main Program  * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    addOptions();
    const argList args(argc, argv);

    if (args.found("spheres") == args.found("maxOffsetError"))
    {
        FatalErrorInFunction
            << "Give one of the options -spheres and -maxOffsetError"
            << exit(FatalError);
    }

    multisphereGenerator::controls controls;
    controls.cells = option<label>(args, "cells", 40, 4, 1000);
    controls.removal = option<scalar>(args, "removal", 0.9, 0, 2);
    controls.ascend = !args.found("onGrid");
    controls.fit = args.found("fit");

    const label nSpheres = option<label>(args, "spheres", 1, 1, 100000);
    const label most = option<label>(args, "maxSpheres", 200, 1, 100000);
    const scalar offset =
        option<scalar>(args, "maxOffsetError", 1, SMALL, GREAT);
    const scalar scale = option<scalar>(args, "scale", 1, VSMALL, GREAT);
    const scalar density = option<scalar>(args, "density", 0, 0, GREAT);

    const clockTime clock;
    const closedSurface body(args.get<fileName>(1), scale);
    printBody(body, density);

    multisphereGenerator cluster(body, controls);
    if (args.found("spheres"))
    {
        cluster.generate(nSpheres);
    }
    else
    {
        cluster.generateToError(offset, most);
    }

    const multisphereErrors errors(body, cluster.centres(), cluster.radii());
    printCluster(cluster, errors);

    const fileName file(args.get<fileName>(2));
    write(file, body, cluster, errors);

    Info<< "Wrote " << file << " in " << clock.elapsedTime() << " s" << nl
        << endl;

    return 0;
}


// ************************************************************************* //
