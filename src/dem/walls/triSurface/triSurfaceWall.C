/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "triSurfaceWall.H"
#include "checkedEntry.H"
#include "surfaceFile.H"
#include "addToRunTimeSelectionTable.H"
#include "OSspecific.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(triSurfaceWall, 0);
    addToRunTimeSelectionTable(wall, triSurfaceWall, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::List<Foam::dem::corners> Foam::dem::triSurfaceWall::read
(
    const dictionary& dict,
    const fileName& directory
)
{
    checkEntries(dict, {"file", "scale"});
    const scalar scale =
        dict.found("scale") ? getPositive(dict, "scale", 1e-12, 1e12) : 1;

    fileName file(dict.get<fileName>("file"));
    file.expand();
    if (!file.isAbsolute())
    {
        file = directory/"triSurface"/file;
    }
    if (!isFile(file))
    {
        badEntry(dict, "file", "names the file " + file + ", which is missing");
    }

    const triSurface surface(readSurface(file, scale));
    checkTriangles(file, surface);

    List<corners> triangles(surface.size());
    forAll(triangles, t)
    {
        forAll(triangles[t], k)
        {
            triangles[t][k] = surface.points()[surface[t][k]];
        }
    }
    return triangles;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::triSurfaceWall::triSurfaceWall
(
    const word& name,
    const label materialI,
    const dictionary& dict,
    const fileName& directory
)
:
    triangleWall(name, materialI, read(dict, directory))
{}


// ************************************************************************* //
