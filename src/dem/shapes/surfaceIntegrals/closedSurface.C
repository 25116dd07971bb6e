/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.
\*---------------------------------------------------------------------------*/

#include "closedSurface.H"
#include "error.H"
#include "OSspecific.H"
#include "stlCheck.H"

#include <cfenv>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::triSurface Foam::dem::closedSurface::read
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


void Foam::dem::closedSurface::refuse
(
    const label n,
    const string& what,
    const point& where
) const
{
    if (n)
    {
        FatalErrorInFunction
            << "Surface " << name_ << ' ' << what.c_str() << ": " << n
            << " found, the first at " << where << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::closedSurface::closedSurface
(
    const fileName& file,
    const scalar scale
)
:
    name_(file),
    surface_(read(file, scale)),
    search_(surface_),
    properties_(check())
{}


Foam::dem::closedSurface::closedSurface
(
    const string& name,
    const triSurface& surface
)
:
    name_(name),
    surface_(surface),
    search_(surface_),
    properties_(check())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::point Foam::dem::closedSurface::nearest(const point& p) const
{
    const pointIndexHit hit(tree().findNearest(p, sqr(GREAT)));
    return hit.rawPoint();
}


// ************************************************************************* //
