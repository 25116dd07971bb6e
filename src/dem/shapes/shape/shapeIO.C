/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.
\*---------------------------------------------------------------------------*/

#include "shape.H"
#include "allowedKeys.H"
#include "checkedEntry.H"
#include "dictionaryText.H"
#include "ellipsoidSpheres.H"
#include "Fstream.H"
#include "OSspecific.H"
#include "StringStream.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

// The keywords that describe a body made of spheres
const wordList bodyKeys
{
    "spheres", "volume", "centreOfMass", "inertiaPerDensity", "report"
};


void checkSpheres
(
    const dictionary& dict,
    const List<dem::shape::sphereData>& spheres
)
{
    if (spheres.empty())
    {
        dem::badEntry
        (
            dict,
            "spheres",
            "holds no sphere: the template has zero volume"
        );
    }

    scalar least = GREAT;
    scalar extent = 0;
    forAll(spheres, i)
    {
        const scalar r = spheres[i].second();

        // Smaller than a virus to larger than a star: no power overflows
        if
        (
            !std::isfinite(r) || r < 1e-10 || r > 1e12
         || !dem::isFinite(spheres[i].first())
        )
        {
            OStringStream os;
            os  << "has in place " << i << " the sphere " << spheres[i]
                << "; the centre must be finite, the radius greater than zero"
                << " (1e-10 to 1e12 m)";
            dem::badEntry(dict, "spheres", os.str());
        }
        least = min(least, r);
        extent = max(extent, mag(spheres[i].first()) + r);
    }

    if (extent > 1e6*least)
    {
        OStringStream os;
        os  << "has spheres as small as " << least << " m that reach as far as "
            << extent << " m from the origin: round-off would swallow them";
        dem::badEntry(dict, "spheres", os.str());
    }
}


// A solid's moments are positive, and none exceeds the sum of the other two
void checkInertia(const dictionary& dict, const dem::massProperties& body)
{
    tensor axes;
    vector m;
    body.principalAxes(axes, m);

    const scalar least = cmptMin(m);
    const scalar most = cmptMax(m);
    const scalar sum = cmptSum(m);

    if (!(least > 0) || !std::isfinite(sum) || 2*most > sum*(1 + 1e-9))
    {
        OStringStream os;
        os  << "has the principal moments " << m << ", which no solid has: "
            << "each must be positive and at most the sum of the other two";
        dem::badEntry(dict, "inertiaPerDensity", os.str());
    }
}

//- The spheres of a template of type ellipsoid, and what they stand for
List<dem::shape::sphereData> readEllipsoid
(
    const word& name,
    const dictionary& dict,
    dem::massProperties& body,
    scalar& error
)
{
    const vector axes = dem::getFiniteVector(dict, "semiAxes");
    const scalar least = cmptMin(axes);
    if (least < 1e-10 || cmptMax(axes) > 20*least)
    {
        dem::badEntry
        (
            dict,
            "semiAxes",
            "must be greater than zero (1e-10 m), the longest up to 20 times"
            " the shortest"
        );
    }
    if (dict.found("spheres") == dict.found("surfaceError"))
    {
        FatalIOErrorInFunction(dict)
            << "An ellipsoid needs one of the entries spheres and"
            << " surfaceError; " << dict.name() << " has "
            << (dict.found("spheres") ? "both" : "neither")
            << exit(FatalIOError);
    }

    const label most = 100;
    const bool byNumber = dict.found("spheres");
    const label n = byNumber ? dem::getLabel(dict, "spheres", 1) : most;
    const scalar wanted =
        byNumber ? 0 : dem::getPositive(dict, "surfaceError", 0, 1);
    if (n > most)
    {
        dem::badEntry(dict, "spheres", "must be 100 at most");
    }

    const dem::ellipsoidSpheres cluster(axes, wanted, n);
    if (wanted > 0 && cluster.error() > wanted)
    {
        OStringStream os;
        os  << "takes more than 100 spheres: with " << cluster.size()
            << " it is " << cluster.error();
        dem::badEntry(dict, "surfaceError", os.str());
    }
    Info<< "    shape " << name << ": an ellipsoid of " << cluster.size()
        << " spheres, largest distance of the surfaces "
        << 100*cluster.error()
        << " % of the diameter of the sphere of the same volume" << endl;

    List<dem::shape::sphereData> spheres(cluster.size());
    forAll(spheres, i)
    {
        spheres[i] =
            dem::shape::sphereData(cluster.centre(i), cluster.radius(i));
    }
    body = cluster.properties();
    error = cluster.error();
    return spheres;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::dictionary Foam::dem::shape::readFile
(
    const dictionary& dict,
    const fileName& dir
)
{
    fileName file(dict.get<fileName>("file"));
    file.expand();

    if (!file.isAbsolute())
    {
        file = dir/file;
    }

    if (!isFile(file))
    {
        badEntry(dict, "file", "names the file " + file + ", which is missing");
    }

    checkText(file);
    IFstream is(file);
    dictionary content(is);
    checkKeys(content, bodyKeys);

    return content;
}


void Foam::dem::shape::readMultisphere(const dictionary& dict)
{
    const List<sphereData> spheres(dict.get<List<sphereData>>("spheres"));
    checkSpheres(dict, spheres);

    if
    (
        !dict.found("volume")
     && !dict.found("centreOfMass")
     && !dict.found("inertiaPerDensity")
    )
    {
        set(spheres, nullptr);
        return;
    }

    massProperties body;
    body.volume = getPositive(dict, "volume");
    body.centroid = getFiniteVector(dict, "centreOfMass");
    body.inertia = dict.get<symmTensor>("inertiaPerDensity");
    checkInertia(dict, body);

    set(spheres, &body);

    // What standing for that body costs in exactness
    Info<< "    shape " << name_ << ": " << spheres.size()
        << " spheres, volume error " << 100*volumeError() << " %";
    surfaceError_ =
        dict.subOrEmptyDict("report").getOrDefault<scalar>("offsetError", -1);
    if (surfaceError_ >= 0)
    {
        Info<< ", offset error " << 100*surfaceError_
            << " %, as surfaceToMultisphere found";
    }
    Info<< endl;
}


void Foam::dem::shape::readSphere(const dictionary& dict)
{
    const scalar d = getPositive(dict, "diameter", 2e-10, 1e12);
    set(List<sphereData>(1, sphereData(Zero, 0.5*d)), nullptr);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::shape::shape
(
    const word& name,
    const dictionary& dict,
    const fileName& dir,
    const wordList& otherKeys
)
:
    name_(name)
{
    const word type
    (
        getChoice(dict, "type", {"ellipsoid", "multisphere", "sphere"})
    );

    wordList keys(otherKeys);
    keys.append("type");

    if (type == "sphere")
    {
        keys.append("diameter");
        checkKeys(dict, keys);
        readSphere(dict);
        return;
    }

    if (type == "ellipsoid")
    {
        keys.append(wordList({"semiAxes", "spheres", "surfaceError"}));
        checkKeys(dict, keys);
        massProperties body;
        const List<sphereData> spheres
        (
            readEllipsoid(name, dict, body, surfaceError_)
        );
        set(spheres, &body);
        return;
    }

    // The same entries stand here or in a file
    keys.append(wordList({"file", "geometry", "surface", "surfaceScale"}));
    if (!dict.found("file"))
    {
        keys.append(bodyKeys);
    }
    checkKeys(dict, keys);

    if (!dict.found("file") && !dict.found("spheres"))
    {
        FatalIOErrorInFunction(dict)
            << "A multisphere needs one of the entries 'file' and 'spheres'; "
            << dict.name() << " has neither" << exit(FatalIOError);
    }

    const dictionary body(dict.found("file") ? readFile(dict, dir) : dict);
    readMultisphere(body);
    readSurface(dict, dir, body);
}


// ************************************************************************* //
