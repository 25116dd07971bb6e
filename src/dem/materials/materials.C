/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "materials.H"
#include "allowedKeys.H"
#include "checkedEntry.H"
#include "dampingRatio.H"
#include "DynamicList.H"
#include "ListOps.H"
#include "mathematicalConstants.H"
#include "unitConversion.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::materials::readMaterials(const dictionary& dict)
{
    const bool charged = laws_.coheres("electrostatic");
    DynamicList<word> keys;
    keys.append(wordList({"density", "youngsModulus", "poissonsRatio"}));
    if (charged)
    {
        keys.append("surfaceCharge");
    }

    names_ = dict.sortedToc();
    if (names_.empty())
    {
        FatalIOErrorInFunction(dict)
            << "There is no material." << nl
            << "    Give each one as  NAME { density 2650; youngsModulus 1e8;"
            << " poissonsRatio 0.3; }" << exit(FatalIOError);
    }

    for (const word& name : names_)
    {
        const dictionary& d = dict.subDict(name);
        checkKeys(d, wordList(keys));

        density_.append
        (
            d.found("density") ? getPositive(d, "density", 1e-6, 1e9) : 0
        );
        E_.append(getPositive(d, "youngsModulus", 1e-6, 1e30));
        nu_.append(getInRange(d, "poissonsRatio", 0, 0.5));

        // Walls are not charged
        charge_.append
        (
            charged && (d.found("density") || d.found("surfaceCharge"))
          ? getFinite(d, "surfaceCharge")
          : 0
        );
    }
}


void Foam::dem::materials::readAttraction
(
    const dictionary& dict,
    const label i,
    const label j,
    pairProperties& p
) const
{
    using namespace constant;

    if (laws_.coheres("capillary"))
    {
        const scalar angle =
            degToRad(getInRange(dict, "contactAngle", 0, 90));
        const scalar v = getPositive(dict, "bridgeVolume", 1e-9, 0.1);
        p.bridgeForce =
            mathematical::twoPi*cos(angle)
           *getPositive(dict, "surfaceTension", 1e-12, 1e6);
        p.bridgeVolume = v;
        p.bridgeReach = (1 + 0.5*angle)*(cbrt(v) + 0.1*pow(v, 2.0/3.0));
    }
    if (laws_.coheres("vanDerWaals"))
    {
        p.hamakerConstant = getNonNegative(dict, "hamakerConstant");
        p.minSeparation = getPositive(dict, "minSeparation", 1e-12, 1);
        p.maxSeparation =
            getPositive(dict, "maxSeparation", 10*p.minSeparation);
        if (p.maxSeparation <= p.minSeparation)
        {
            badEntry
            (
                dict,
                "maxSeparation",
                "must be above the minSeparation of "
              + std::to_string(p.minSeparation) + " m"
            );
        }
    }
    if (laws_.coheres("electrostatic"))
    {
        // F = q_i q_j/(4 pi eps l^2) with q = 4 pi r^2 sigma. The constant of
        // nature stands here, as OpenFOAM's own needs a database
        const scalar eps0 = 8.8541878128e-12;
        p.chargePressure =
            4*mathematical::pi*charge_[i]*charge_[j]
           /(eps0*laws_.permittivity);
        p.chargeCutOff = laws_.chargeCutOff;
    }
}


Foam::dem::pairProperties Foam::dem::materials::readPair
(
    const dictionary& dict,
    const label i,
    const label j,
    const contactLaws& laws
) const
{
    wordList keys(laws.pairKeys());
    keys.append(laws.freePairKeys());
    checkKeys(dict, keys);

    pairProperties p;

    const bool isHertz = laws.normal == "hertz";
    const scalar EStar =
        1/((1 - sqr(nu_[i]))/E_[i] + (1 - sqr(nu_[j]))/E_[j]);
    const scalar GStar =
        1
       /(
            (2 - nu_[i])*2*(1 + nu_[i])/E_[i]
          + (2 - nu_[j])*2*(1 + nu_[j])/E_[j]
        );
    p.shearRatio = 4*GStar/EStar;
    p.elasticity =
        isHertz ? EStar : getPositive(dict, "normalStiffness", 1e-12, 1e30);

    const auto damp = [&](const scalar beta)
    {
        p.normalDamping = viscousPerRatio(isHertz)*beta;
        p.tangentialDamping = p.normalDamping*sqrt(p.shearRatio);
        p.resolution10 = pow(1 + (isHertz ? 5 : 20)*beta, 10);
    };

    if (keys.found("friction"))
    {
        p.friction = getNonNegative(dict, "friction");
    }
    if (keys.found("rollingFriction"))
    {
        p.rollingFriction = getNonNegative(dict, "rollingFriction");
    }
    if (keys.found("torsionalFriction"))
    {
        p.torsionalFriction = getNonNegative(dict, "torsionalFriction");
    }
    if (keys.found("cohesionEnergyDensity"))
    {
        p.cohesionEnergyDensity =
            getNonNegative(dict, "cohesionEnergyDensity");
    }
    if (keys.found("normalDamping"))
    {
        p.normalDamping = getNonNegative(dict, "normalDamping");
    }
    if (keys.found("tangentialDamping"))
    {
        p.tangentialDamping = getNonNegative(dict, "tangentialDamping");
    }
    if (keys.found("restitution"))
    {
        const scalar e = getInRange(dict, "restitution", 0, 1);
        if (e < 1e-3)
        {
            badEntry
            (
                dict,
                "restitution",
                "no finite damping gives less than 0.001: give 0.001 to 1"
            );
        }
        damp(dampingRatioOf(e, laws.pulling));
    }
    if (keys.found("dampingRatio"))
    {
        const scalar ratio = getInRange(dict, "dampingRatio", 0, 100, 1);
        damp(2*ratio/viscousPerRatio(isHertz));
    }
    readAttraction(dict, i, j, p);
    p.rollingDamping = getInRange(dict, "rollingDampingRatio", 0, 1, 1);
    p.torsionalDamping = getInRange(dict, "torsionalDampingRatio", 0, 1, 1);

    return p;
}


void Foam::dem::materials::readPairs
(
    const dictionary& dict,
    const contactLaws& laws
)
{
    const label n = names_.size();
    pairs_.setSize(n*n);

    DynamicList<word> allowed;
    for (label i = 0; i < n; ++i)
    {
        for (label j = 0; j < n; ++j)
        {
            allowed.append(names_[i] + '-' + names_[j]);
        }
    }
    checkKeys(dict, wordList(allowed));

    for (label i = 0; i < n; ++i)
    {
        for (label j = i; j < n; ++j)
        {
            word key = names_[i] + '-' + names_[j];
            const word turned = names_[j] + '-' + names_[i];
            if (!dict.found(key))
            {
                key = turned;
            }
            else if (i != j && dict.found(turned))
            {
                badEntry(dict, turned, "is the pair " + key + " once more");
            }

            if (dict.found(key))
            {
                pairs_[i*n + j] = readPair(dict.subDict(key), i, j, laws);
                pairs_[j*n + i] = pairs_[i*n + j];
            }
            else if (density_[i] > 0 || density_[j] > 0)
            {
                FatalIOErrorInFunction(dict)
                    << "The pair of materials " << names_[i] << " and "
                    << names_[j] << " is missing." << nl
                    << "    Add  " << names_[i] << '-' << names_[j]
                    << "  with the entries "
                    << listWords(laws.pairKeys()).c_str()
                    << exit(FatalIOError);
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::materials::materials
(
    const dictionary& dict,
    const contactLaws* laws
)
{
    if (laws)
    {
        laws_ = *laws;
    }
    readMaterials(dict.subDict("materials"));
    if (laws)
    {
        readPairs(dict.subDict("pairs"), *laws);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::dem::materials::find
(
    const dictionary& dict,
    const word& key
) const
{
    return names_.find(getChoice(dict, key, names_));
}


Foam::label Foam::dem::materials::findOfBody
(
    const dictionary& dict,
    const word& key
) const
{
    const label i = find(dict, key);
    if (density_[i] <= 0)
    {
        badEntry(dict, key, "a body needs a material with a density");
    }
    return i;
}


Foam::scalar Foam::dem::materials::reachPerRadius() const
{
    // R of a sphere at a wall is twice its radius, R* the radius itself
    scalar most = laws_.film.range;
    for (const pairProperties& p : pairs_)
    {
        most = max(most, 2*p.bridgeReach);
    }
    return most;
}


Foam::scalar Foam::dem::materials::reach() const
{
    scalar most = 0;
    for (const pairProperties& p : pairs_)
    {
        most = max(most, max(p.maxSeparation, p.chargeCutOff));
    }
    return most;
}


Foam::scalar Foam::dem::materials::rayleighTimePerRadius(const label i) const
{
    const scalar G = E_[i]/(2*(1 + nu_[i]));
    return
        constant::mathematical::pi*sqrt(density_[i]/G)
       /(0.1631*nu_[i] + 0.8766);
}


// ************************************************************************* //
