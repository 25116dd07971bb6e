/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.
\*---------------------------------------------------------------------------*/

#include "surfaceFile.H"
#include "checkedEntry.H"
#include "error.H"
#include "OSspecific.H"
#include "stlCheck.H"

#include <cfenv>

// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

Foam::triSurface Foam::dem::readSurface
(
    const fileName& file,
    const scalar scale
)
{
    if (!isFile(file))
    {
        FatalErrorInFunction
            << "Surface " << file << " is missing" << exit(FatalError);
    }

    if (!triSurface::canRead(file))
    {
        FatalErrorInFunction
            << "Surface " << file << " is of a kind that triSurface cannot "
            << "read" << exit(FatalError);
    }

    // OpenFOAM's reader crashes on what is no STL file
    if ((file.ext() == "stl" || file.ext() == "stlb") && isFile(file, false))
    {
        const string wrong(checkSTL(file));
        if (!wrong.empty())
        {
            FatalErrorInFunction
                << "Surface " << file << " is unreadable: " << wrong.c_str()
                << exit(FatalError);
        }
    }

    // A reader that meets NaN must not end in a floating-point trap: the
    // checks find it afterwards
    std::fenv_t traps;
    std::feholdexcept(&traps);

    // The readers' own errors do not name the file: add its name
    const bool oldError = FatalError.throwExceptions();
    const bool oldIOError = FatalIOError.throwExceptions();
    triSurface surface;
    string complaint;

    try
    {
        surface = triSurface(file, scale);
    }
    catch (const Foam::error& e)
    {
        complaint = e.message();
    }

    FatalError.throwExceptions(oldError);
    FatalIOError.throwExceptions(oldIOError);
    std::fesetenv(&traps);

    if (!complaint.empty())
    {
        FatalErrorInFunction
            << "Surface " << file << " is unreadable: " << complaint.c_str()
            << exit(FatalError);
    }

    // Nor do all readers look whether the corners of a triangle are there
    for (const labelledTri& f : surface)
    {
        for (const label corner : f)
        {
            if (corner < 0 || corner >= surface.points().size())
            {
                FatalErrorInFunction
                    << "Surface " << file << " is unreadable: a triangle has"
                    << " corner number " << corner << ", but there are "
                    << surface.points().size() << " points"
                    << exit(FatalError);
            }
        }
    }

    return surface;
}


void Foam::dem::refuseSurface
(
    const string& name,
    const label n,
    const string& what,
    const point& where
)
{
    if (n)
    {
        FatalErrorInFunction
            << "Surface " << name << ' ' << what.c_str() << ": " << n
            << " found, the first at " << where << exit(FatalError);
    }
}


void Foam::dem::checkTriangles
(
    const string& name,
    const triSurface& surface
)
{
    const pointField& points = surface.points();

    if (surface.empty())
    {
        FatalErrorInFunction
            << "Surface " << name << " holds no triangle" << exit(FatalError);
    }

    surfaceFinding bad, degenerate;

    for (const point& p : points)
    {
        if (!isFinite(p))
        {
            bad.add(p);
        }
    }
    refuseSurface
    (
        name,
        bad.n,
        "has corners that are not finite (NaN), or 1e12 m away",
        bad.where
    );

    for (const labelledTri& f : surface)
    {
        const vector ab(points[f[1]] - points[f[0]]);
        const vector bc(points[f[2]] - points[f[1]]);
        const vector ca(points[f[0]] - points[f[2]]);
        const scalar longest =
            max(max(magSqr(ab), magSqr(bc)), magSqr(ca));

        if (mag(ab ^ bc) <= 1e-10*longest)
        {
            degenerate.add(points[f[0]]);
        }
    }
    refuseSurface
    (
        name,
        degenerate.n,
        "has degenerate triangles, without area or with a corner used twice"
        " (surfaceClean may repair it)",
        degenerate.where
    );
}


// ************************************************************************* //
