/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.
\*---------------------------------------------------------------------------*/

#include "multisphereGenerator.H"
#include "error.H"
#include "multisphereErrors.H"
#include "sphereUnion.H"

#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::dem::multisphereGenerator::tryOut(const label n)
{
    // Lines across when the number of spheres is being chosen
    constexpr label nLines = 300;

    generate(n);

    return
        multisphereErrors::offsetVolume
        (
            body_.surface(),
            centres_,
            radii_,
            nLines
        )/body_.properties().volume;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::multisphereGenerator::multisphereGenerator
(
    const closedSurface& body,
    const controls& parameters
)
:
    body_(body),
    controls_(parameters),
    grid_(body, parameters.cells),
    inscribedError_(0)
{
    if (controls_.fit)
    {
        fit_.reset(new sphereFit(body, controls_.cells));
    }
}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

Foam::scalar Foam::dem::multisphereGenerator::correctVolume
(
    const closedSurface& body,
    pointField& centres,
    scalarField& radii
)
{
    const massProperties& mass = body.properties();
    const scalar factor =
        std::cbrt(mass.volume/sphereUnion(centres, radii).volume());

    centres = mass.centroid + factor*(centres - mass.centroid);
    radii *= factor;

    return factor;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::multisphereGenerator::generate(const label n)
{
    while (inscribed_.size() < n)
    {
        inscribed_.append(grid_.take(controls_.removal, controls_.ascend));
    }

    centres_.setSize(n);
    radii_.setSize(n);
    for (label i = 0; i < n; ++i)
    {
        centres_[i] = inscribed_[i].first();
        radii_[i] = inscribed_[i].second();
    }

    const scalar factor = correctVolume(body_, centres_, radii_);
    inscribedError_ = mag(1 - 1/pow3(factor));

    if (fit_.valid())
    {
        fit_->improve(centres_, radii_);
    }
}


void Foam::dem::multisphereGenerator::generateToError
(
    const scalar offset,
    const label maxSpheres
)
{
    label n = 1;
    label failed = 0;
    scalar best = GREAT;

    // Numbers that grow by a tenth until one is good enough ...
    for (scalar error = tryOut(n); error > offset; error = tryOut(n))
    {
        best = min(best, error);

        if (n == maxSpheres || !grid_.size())
        {
            FatalErrorInFunction
                << "The offset error " << offset << " is out of reach for "
                << "surface " << body_.name() << ": the best of up to " << n
                << " spheres has " << best << ". Allow more spheres, or more "
                << "grid cells" << exit(FatalError);
        }

        failed = n;
        n = min(min(n + max(label(1), n/10), maxSpheres), n + grid_.size());
    }

    // ... then the first between the last failure and that one
    const label good = n;
    for (n = failed + 1; n < good && tryOut(n) > offset; ++n)
    {}

    generate(n);
}


void Foam::dem::multisphereGenerator::writeEntries(Ostream& os) const
{
    const massProperties& mass = body_.properties();

    os.writeEntry("volume", mass.volume);
    os.writeEntry("centreOfMass", mass.centroid);
    os.writeEntry("inertiaPerDensity", mass.inertia);

    os << nl << "spheres" << nl << '(' << nl;
    forAll(centres_, i)
    {
        os << "    (" << centres_[i] << ' ' << radii_[i] << ')' << nl;
    }
    os << ");" << nl;
}


// ************************************************************************* //
