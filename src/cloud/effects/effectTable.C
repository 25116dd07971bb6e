/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "effectTable.H"
#include "Ostream.H"

#include <iomanip>
#include <sstream>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::effectTable::add(const row& r)
{
    if (!find_.found(r.name))
    {
        find_.insert(r.name, rows_.size());
        rows_.append(r);
    }
    else if (r.share > rows_[find_[r.name]].share)
    {
        rows_[find_[r.name]] = r;
    }
}


void Foam::effectTable::judge(const effectLaw& law)
{
    for (const sceneNumbers& n : kinds_)
    {
        if (law.asked(n))
        {
            const scalar share = law.share(n, target_);
            add
            ({
                law.name,
                law.value(n),
                law.number,
                law.bar > 0 ? law.bar : target_,
                law.source,
                share,
                share > target_,
                law.cost
            });
        }
    }
}


void Foam::effectTable::follow
(
    const word& name,
    const bool on,
    const string& because,
    const string& cost
)
{
    const scalar share = on ? 1 : 0;
    add({name, share, because, target_, "follows", share, on, cost});
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::effectTable::effectTable
(
    const UList<sceneNumbers>& kinds,
    const scalar target
)
:
    target_(target),
    kinds_(kinds)
{
    bool fall = false;
    for (const sceneNumbers& n : kinds_)
    {
        fall = fall || n.g > 0;
    }
    for (const effectLaw& law : effectLaws::all())
    {
        judge(law);
    }

    const bool meet = on("contacts");
    follow("friction", meet, "contacts", "a force a contact");
    follow
    (
        "contactHistory", meet && fall, "bodies rest on each other",
        "a vector a contact"
    );
    follow
    (
        "rotation",
        meet || on("magnus") || on("rotationalDrag"),
        "friction, magnus or rotationalDrag",
        "nothing for spheres"
    );
    follow
    (
        "averaging", on("exchange"), "exchange",
        "a void fraction an exchange"
    );

    // Some fill cells, others are points
    scalar least = GREAT, most = 0;
    for (const sceneNumbers& n : kinds_)
    {
        if (n.inFluid() && n.cell > 0)
        {
            least = min(least, n.cellsOverDiameter());
            most = max(most, n.cellsOverDiameter());
        }
    }
    if (most > 0)
    {
        const bool both = least < sceneNumbers::fills
         && most >= sceneNumbers::fills;
        add
        ({
            "resolved", least, "fewest cells over d, of " + Foam::name(most),
            sceneNumbers::fills, "Uhlmann 2005", both ? 1.0 : 0.0, both,
            "a look at sizes each step"
        });
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::effectTable::writeNumbers(Ostream& os) const
{
    const int digits = os.precision();
    os.precision(3);
    for (const sceneNumbers& n : kinds_)
    {
        os  << "    body of " << n.d << " m, " << n.rhoP << " kg/m3";
        if (n.inFluid())
        {
            os  << "; densities " << 1/n.densityRatio() << " : 1, Re "
                << n.Re() << ", of the shear " << n.shearRe()
                << ", of the spin " << n.spinRe() << ", Stokes number "
                << n.impactStokes() << ", relaxation time "
                << n.relaxationTime() << " s, loading " << n.loading()
                << ", Bagnold number " << n.Bagnold();
            if (n.turbulent)
            {
                os  << ", turbulence of " << sqrt(2*n.k/3) << " m/s gives it "
                    << n.stirred() << " m/s";
            }
        }
        os  << "; void fraction " << 1 - n.fraction;
        if (n.cell > 0)
        {
            os  << ", " << n.cellsOverDiameter() << " cells over d";
            if (n.gap < GREAT)
            {
                os  << ", gap of " << n.gap/n.cell << " cells";
            }
        }
        os  << "; Bond number " << max(n.capillary, n.simplifiedJKR)
            << ", Hamaker number " << n.vanDerWaals
            << ", charge " << n.electrostatic << nl;
        if (n.inFluid() && !n.point() && !n.resolved())
        {
            os  << "    Warning: " << n.cellsOverDiameter() << " cells over"
                << " the diameter are too few to fill them, and too many for a"
                << " point: have 8, or less than 1." << nl;
        }
    }
    os.precision(digits);
}


void Foam::effectTable::write(Ostream& os) const
{
    std::ostringstream text;
    text.precision(3);
    const auto put = [&text](const std::string& s, const int width)
    {
        text << std::left << std::setw(width) << s << ' ';
    };
    const auto number = [](const scalar v)
    {
        std::ostringstream s;
        s.precision(3);
        s << v;
        return s.str();
    };
    text << "    ";
    put("effect", 17);
    put("", 3);
    put("share", 9);
    put("number", 35);
    put("", 9);
    put("bar", 7);
    put("source", 25);
    text << "costs\n";
    for (const row& r : rows_)
    {
        text << "    ";
        put(r.name, 17);
        put(r.on ? "on" : "off", 3);
        put(number(100*r.share) + '%', 9);
        put(r.number, 35);
        put(number(r.value), 9);
        put(number(r.bar), 7);
        put(r.source, 25);
        text << r.cost << '\n';
    }
    os  << text.str().c_str();
}


// ************************************************************************* //
