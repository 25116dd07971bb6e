/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "lubrication.H"
#include "allowedKeys.H"
#include "checkedEntry.H"
#include "fluidDensity.H"
#include "fluidViscosity.H"
#include "pointForce.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const char* const Foam::coupling::lubrication::name = "lubrication";


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

bool Foam::coupling::lubrication::switchedOn(const dictionary& forces)
{
    return pointForce::switchedOn(name, forces);
}


Foam::dem::squeezedFilm Foam::coupling::lubrication::read
(
    const fvMesh& mesh,
    const dictionary& fluid,
    const dictionary& forces
)
{
    if (!forces.isDict(name))
    {
        dem::badEntry
        (
            forces,
            name,
            "needs the roughness of the surfaces, within which there is no"
            " film:  lubrication { roughness 1e-6; }"
        );
    }
    const dictionary& dict = forces.subDict(name);
    dem::checkKeys(dict, {"roughness", "range", "widest"});

    const fluidDensity rho(mesh.thisDb(), fluid);
    if (rho.isField())
    {
        dem::badEntry
        (
            fluid,
            "rho",
            "names a field, and lubrication knows one liquid only: give its"
            " density [kg/m3], or take lubrication out of forces"
        );
    }
    const scalar nu =
        fluid.found("nu")
      ? dem::getPositive(fluid, "nu")
      : fluidViscosity::entry(mesh);
    if (!(nu > 0))
    {
        FatalIOErrorInFunction(fluid)
            << "lubrication needs the viscosity nu of the liquid [m2/s], which"
            << " constant/transportProperties" << nl
            << "    does not have as a number. Give nu in the dictionary "
            << fluid.dictName() << "." << exit(FatalIOError);
    }

    dem::squeezedFilm film;
    film.viscosity = rho.uniform()*nu;
    film.roughness = dem::getPositive(dict, "roughness", 1e-12, 1);
    film.range = dem::getInRange(dict, "range", 1e-6, 2, 1);
    Info<< "    lubrication: " << film.viscosity << " Pa s, from "
        << film.range << " effective radii";
    if (dict.found("widest"))
    {
        film.widest = dem::getPositive(dict, "widest");
        if (film.widest <= film.roughness)
        {
            dem::badEntry
            (
                dict,
                "widest",
                "is " + Foam::name(film.widest) + " m, not above the roughness,"
                " within which there is no film"
            );
        }
        Info<< ", " << film.widest << " m at most";
    }
    Info<< " down to " << film.roughness << " m" << endl;
    return film;
}


Foam::dem::squeezedFilm Foam::coupling::lubrication::belowGrid
(
    const fvMesh& mesh,
    const dictionary& fluid,
    const dictionary& immersed
)
{
    const dictionary& film = immersed.subOrEmptyDict(name);
    if
    (
        immersed.isDict(name)
     && !film.found("range") && !film.found("widest")
    )
    {
        dem::badEntry
        (
            immersed,
            name,
            "needs the gap from which on the mesh resolves the flow, over the"
            " effective radius:\n    lubrication { roughness 1e-6; range 0.1; }"
            " if a cell is a tenth of the radius;\n"
            "    or in metres, the edge of a cell:  widest 0.001;"
        );
    }
    return read(mesh, fluid, immersed);
}


// ************************************************************************* //
