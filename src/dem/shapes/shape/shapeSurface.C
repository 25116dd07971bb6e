/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "shape.H"
#include "checkedEntry.H"
#include "OSspecific.H"
#include "StringStream.H"
#include "surfaceFile.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

// How much the mass properties of the spheres' file and those of the surface
// may differ: both have been rounded by whoever wrote them
const scalar same = 0.01;


//- The file of the surface
fileName surfaceName(const dictionary& dict, const fileName& dir)
{
    if (!dict.found("surface"))
    {
        FatalIOErrorInFunction(dict)
            << "geometry surface needs the entry 'surface', a file of triangles"
            << exit(FatalIOError);
    }
    fileName file(dict.get<fileName>("surface"));
    file.expand();
    if (!file.isAbsolute())
    {
        file = dir/file;
    }
    if (!isFile(file))
    {
        dem::badEntry
        (
            dict,
            "surface",
            "names the file " + file + ", which is missing"
        );
    }
    return file;
}


//- Stop if what was said of the body is not so of the surface
void checkSame
(
    const dictionary& dict,
    const dictionary& said,
    const dem::massProperties& is
)
{
    const scalar volume = said.get<scalar>("volume");
    const vector centre = said.get<vector>("centreOfMass");
    const scalar length = std::cbrt(is.volume);
    if
    (
        mag(volume/is.volume - 1) > same
     || mag(centre - is.centroid) > same*length
    )
    {
        OStringStream os;
        os  << "encloses " << is.volume << " m3 about " << is.centroid
            << ", but the spheres are said to stand for " << volume
            << " m3 about " << centre
            << ": were they made of another surface, or in other units"
            << " (surfaceScale)?";
        dem::badEntry(dict, "surface", os.str());
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::shape::readSurface
(
    const dictionary& dict,
    const fileName& dir,
    const dictionary& body
)
{
    const word geometry
    (
        dict.found("geometry")
      ? getChoice(dict, "geometry", {"spheres", "surface"})
      : word("spheres")
    );
    if (geometry == "spheres")
    {
        for (const word& key : {word("surface"), word("surfaceScale")})
        {
            if (dict.found(key))
            {
                badEntry(dict, key, "is of no use without geometry surface");
            }
        }
        return;
    }

    const fileName file(surfaceName(dict, dir));
    const scalar scale = getPositive(dict, "surfaceScale", 1);
    const triSurface given(dem::readSurface(file, scale));
    const massProperties is(closedSurface(file, given).properties());
    if (body.found("volume"))
    {
        checkSame(dict, body, is);
    }

    List<sphereData> spheres(centres_.size());
    forAll(spheres, i)
    {
        spheres[i] = sphereData
        (
            centreOfMass_ + (toUser_ & centres_[i]),
            radii_[i]
        );
    }
    set(spheres, &is);

    pointField points((given.points() - centreOfMass_) & toUser_);
    surface_ = std::make_shared<const surfaceDistance>
    (
        file,
        triSurface(given.surfFaces(), given.patches(), points)
    );
    isSphere_ = false;
}


// ************************************************************************* //
