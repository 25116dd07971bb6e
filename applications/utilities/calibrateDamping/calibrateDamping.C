/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

Application
    calibrateDamping

Description
    Finds the coefficient of the damping law of a case for which the impacts
    of its bodies at a given speed return a wanted part of their velocity: of
    spheres, and of clumps in random orientations, on a plane or on each
    other. Prints the entries of the pair of materials, and what they reach
    with the steps of the case.

Usage
    \verbatim
    calibrateDamping -shape rock -material granite -restitution 0.6 -speed 2
    calibrateDamping -shape rock -material granite -with steel -plane \
        -restitution 0.6 -speed 2 -orientations 100
    \endverbatim

    See doc/utilities/calibrateDamping.md for the options.

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "checkedEntry.H"
#include "dampingRatio.H"
#include "IFstream.H"
#include "impactTrials.H"

using namespace Foam;
using namespace Foam::dem;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

void addOptions()
{
    argList::noParallel();
    argList::noFunctionObjects();
    argList::addNote
    (
        "Find the damping coefficient of a pair of materials for a wanted"
        " restitution."
    );
    argList::addOption("shape", "NAME", "Shape of the body");
    argList::addOption("material", "NAME", "Its material");
    argList::addOption
    (
        "with",
        "NAME",
        "Material of what it hits (default: its own)"
    );
    argList::addBoolOption
    (
        "plane",
        "It hits a plane (default: another body of the same shape)"
    );
    argList::addOption("restitution", "e", "Wanted, from 0.01 to 1");
    argList::addOption("speed", "u", "Closing velocity [m/s]");
    argList::addOption
    (
        "orientations",
        "N",
        "Number of impacts (default: 16 of spheres, 48 of clumps)"
    );
    argList::addOption("seed", "n", "Of the orientations (default: 1)");
}


scalar number
(
    const argList& args,
    const word& name,
    const scalar low,
    const scalar high
)
{
    const scalar x = args.get<scalar>(name);
    if (!(x >= low && x <= high))
    {
        FatalErrorInFunction
            << "Option -" << name << " is " << x << " but must be from "
            << low << " to " << high << exit(FatalError);
    }
    return x;
}


word choice(const argList& args, const word& name, const dictionary& among)
{
    const word x = args.get<word>(name);
    if (!among.found(x))
    {
        FatalErrorInFunction
            << "Option -" << name << " is " << x << ", but " << among.name()
            << " has" << among.sortedToc() << exit(FatalError);
    }
    return x;
}


//- Steps so small that the impact is as good as exact
dictionary fineSteps()
{
    dictionary d;
    d.add("type", word("hades"));
    d.add("contactSteps", 200);
    return d;
}


//- The coefficient of a law, and how the entries of a pair follow from it
struct coefficient
{
    //- Of the law, and whether more of it damps more
    word key;
    bool damps;

    //- Where to look first, and the least and largest that make sense
    scalar start, low, high;

    //- Tangential over normal coefficient of hades; 0 if it needs none
    scalar tangential = 0;

    //- What the pair has besides
    dictionary rest;

    dictionary pair(const scalar x) const
    {
        dictionary d(rest);
        d.set(key, x);
        if (tangential > 0)
        {
            d.set("tangentialDamping", tangential*x);
        }
        return d;
    }
};


coefficient coefficientOf(const impactSetting& setting)
{
    const contactLaws laws
    (
        setting.properties.found("contact")
      ? contactLaws(setting.properties.subDict("contact"))
      : contactLaws()
    );
    const dictionary& pairs = setting.properties.subDict("pairs");

    coefficient c;
    if (pairs.found(setting.pairKey()))
    {
        c.rest = pairs.subDict(setting.pairKey());
    }
    for
    (
        const char* key
      : {"restitution", "dampingRatio", "normalDamping", "tangentialDamping"}
    )
    {
        c.rest.remove(key);
    }
    if (laws.damping == "restitution")
    {
        c.key = "restitution";
        c.damps = false;
        c.start = 0.5;
        c.low = 0.001;
        c.high = 1;
    }
    else if (laws.damping == "critical")
    {
        c.key = "dampingRatio";
        c.damps = true;
        c.start = 0.2;
        c.low = 1e-6;
        c.high = 100;
    }
    else if (laws.damping == "hades")
    {
        c.key = "normalDamping";
        c.damps = true;
        c.start = 1;
        c.low = 1e-30;
        c.high = 1e30;
        if (laws.tangential == "mindlin")
        {
            c.tangential = 1;
        }
    }
    else
    {
        FatalIOErrorInFunction(setting.properties)
            << "damping " << laws.damping << " has nothing to find." << nl
            << "    Take restitution, critical or hades in the entry contact."
            << exit(FatalIOError);
    }
    return c;
}


//- The coefficient that gives the restitution
scalar solve
(
    const coefficient& c,
    const impactTrials& trials,
    const scalar wanted
)
{
    // Grows with the coefficient
    const auto error = [&](const scalar logX)
    {
        const scalar e =
            trials.restitution(c.pair(std::exp(logX)), fineSteps(), 0.1).mean;
        Info<< "    " << c.key << ' ' << std::exp(logX) << "  restitution " << e
            << endl;
        return c.damps ? wanted - e : e - wanted;
    };

    scalar x = std::log(c.start), f = error(x);
    scalar low = x, high = x, fLow = f, fHigh = f;
    const scalar least = std::log(c.low), largest = std::log(c.high);
    for (scalar way = 0.7; f*fLow > 0 || low == high; way *= 2)
    {
        if ((f > 0 && x <= least) || (f < 0 && x >= largest))
        {
            FatalErrorInFunction
                << "No " << c.key << " from " << c.low << " to " << c.high
                << " gives a restitution of " << wanted << "; " << std::exp(x)
                << " gives " << wanted + (c.damps ? -f : f) << '.'
                << exit(FatalError);
        }
        (f > 0 ? high : low) = x;
        (f > 0 ? fHigh : fLow) = f;
        const bool down = f > 0;
        x = min(max(x + (down ? -way : way), least), largest);
        f = error(x);
        if ((f > 0) != down)
        {
            (f > 0 ? high : low) = x;
            (f > 0 ? fHigh : fLow) = f;
            break;
        }
    }

    // False position, and halves so that both ends move
    for (label n = 0; n < 40 && high - low > 1e-7; ++n)
    {
        x =
            n % 3 == 2
          ? 0.5*(low + high)
          : (low*fHigh - high*fLow)/(fHigh - fLow);
        f = error(x);
        if (mag(f) < 2e-4*wanted)
        {
            break;
        }
        (f > 0 ? high : low) = x;
        (f > 0 ? fHigh : fLow) = f;
    }
    return std::exp(x);
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    addOptions();
    const argList args(argc, argv);

    const fileName file(args.path()/"constant"/"demCloudProperties");
    IFstream is(file);
    if (!is.good())
    {
        FatalErrorInFunction
            << "Cannot read " << file << exit(FatalError);
    }
    const dictionary properties(is);

    const dictionary& materialDict = properties.subDict("materials");
    impactSetting setting
    {
        properties,
        args.path(),
        choice(args, "shape", properties.subDict("shapes")),
        choice(args, "material", materialDict),
        choice(args, args.found("with") ? "with" : "material", materialDict),
        args.found("plane"),
        number(args, "speed", 1e-9, 1e6),
        args.getOrDefault<label>("orientations", 0),
        args.getOrDefault<label>("seed", 1)
    };
    const scalar wanted = number(args, "restitution", 0.01, 1);

    coefficient c = coefficientOf(setting);
    const bool given = setting.nOrientations > 0;
    setting.nOrientations = given ? setting.nOrientations : 1;
    autoPtr<impactTrials> trials(new impactTrials(setting, c.pair(c.start)));
    if (!given)
    {
        setting.nOrientations = trials().ofSpheres ? 16 : 48;
        trials.reset(new impactTrials(setting, c.pair(c.start)));
    }

    if (c.key == "normalDamping")
    {
        c.start = 1/(trials().duration()*std::sqrt(trials().overlap()));
    }
    if (c.tangential > 0)
    {
        // The same part of the critical damping in both directions
        c.tangential = std::sqrt(trials().shearRatio());
    }

    Info<< nl << setting.nOrientations << " impacts of " << setting.shape
        << " of " << setting.material << " on "
        << (setting.isPlane ? "a plane" : "its like") << " of "
        << setting.with << " at " << setting.speed << " m/s, about "
        << trials().duration() << " s each" << endl;

    const scalar x = solve(c, trials(), wanted);
    const auto fine = trials().restitution(c.pair(x), fineSteps(), 0.1);
    const auto own = trials().restitution
    (
        c.pair(x), properties.subDict("stepControl"), 0.25
    );

    Info<< nl << setting.pairKey() << nl << c.pair(x) << nl
        << "restitution " << fine.mean << " (single impacts from "
        << fine.least << " to " << fine.largest << "), error "
        << 100*mag(fine.mean/wanted - 1) << " %" << nl
        << "with the steps of the case " << own.mean << ", error "
        << 100*mag(own.mean/wanted - 1) << " %" << nl;
    if (mag(own.mean/wanted - 1) > 0.02)
    {
        Info<< "More than 2 %: take smaller steps (stepControl)." << nl;
    }
    Info<< endl;
    return 0;
}


// ************************************************************************* //
