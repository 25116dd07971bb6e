/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "profileMeter.H"
#include "addToRunTimeSelectionTable.H"
#include "allowedKeys.H"
#include "checkedEntry.H"
#include "OStringStream.H"
#include "rankSum.H"
#include "sphereInBox.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dem
{
    defineTypeNameAndDebug(profileMeter, 0);
    addToRunTimeSelectionTable(meter, profileMeter, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dem::profileMeter::add
(
    const point& centre,
    const scalar radius,
    const scalar share,
    const vector& v
)
{
    labelVector first, last;
    for (direction d = 0; d < 3; ++d)
    {
        const scalar x = centre[d] - low_[d];
        if (x + radius <= 0 || x - radius >= high_[d] - low_[d])
        {
            return;
        }
        first[d] = max(label(std::floor((x - radius)/edge_[d])), 0);
        last[d] =
            min(label(std::floor((x + radius)/edge_[d])), number_[d] - 1);
    }

    labelVector w;
    for (w.z() = first.z(); w.z() <= last.z(); ++w.z())
    for (w.y() = first.y(); w.y() <= last.y(); ++w.y())
    for (w.x() = first.x(); w.x() <= last.x(); ++w.x())
    {
        const scalar volume = share*sphereInBox
        (
            centre,
            radius,
            corner(w),
            corner(w + labelVector(1, 1, 1))
        );
        const label i = w.x() + number_.x()*(w.y() + number_.y()*w.z());
        fraction_[i] += volume;
        velocity_[i] += volume*v;
    }
}


void Foam::dem::profileMeter::take(const demSolver& dem)
{
    const bodies& state = dem.state();
    fraction_ = List<scalar>(cmptProduct(number_), Zero);
    velocity_ = List<vector>(fraction_.size(), Zero);

    // What a clump's spheres have in common counts once
    List<scalar> shares(state.shapes().size());
    forAll(shares, k)
    {
        const shape& s = state.shapes()[k];
        scalar sum = 0;
        for (const scalar r : s.radii())
        {
            sum += 4.0/3.0*constant::mathematical::pi*pow3(r);
        }
        shares[k] = s.volume()/sum;
    }

    forAll(state.sphereX(), i)
    {
        const label b = state.sphereBody[i];
        const point& x = state.sphereX()[i];
        const scalar r = state.sphereR[i];
        const scalar share = shares[state.shapeI[b]];
        add(x, r, share, state.v[b]);
        period_.forEachImage
        (
            x,
            r,
            [&](const label image)
            {
                add(x + period_.shift(image), r, share, state.v[b]);
            }
        );
    }
    if (dem.group().shared())
    {
        sumOverRanks(fraction_);
        sumOverRanks(velocity_);
    }

    const scalar V = cmptProduct(edge_);
    forAll(fraction_, i)
    {
        velocity_[i] /= fraction_[i] + VSMALL;
        fraction_[i] /= V;
    }
}


Foam::string Foam::dem::profileMeter::columns() const
{
    OStringStream os;
    os  << "of each window, whose middles are at";
    labelVector w;
    for (w.z() = 0; w.z() < number_.z(); ++w.z())
    for (w.y() = 0; w.y() < number_.y(); ++w.y())
    for (w.x() = 0; w.x() < number_.x(); ++w.x())
    {
        os  << ' ' << corner(w) + 0.5*edge_;
    }
    os  << " m: part of its volume [-], velocity x y z [m/s]";
    return os.str();
}


void Foam::dem::profileMeter::writeRow(Ostream& os) const
{
    forAll(fraction_, i)
    {
        os  << ' ' << fraction_[i] << ' ' << velocity_[i].x() << ' '
            << velocity_[i].y() << ' ' << velocity_[i].z();
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dem::profileMeter::profileMeter
(
    const word& name,
    const dictionary& dict,
    const periodicity& period
)
:
    meter(name),
    period_(period)
{
    checkKeys(dict, {"type", "low", "high", "windows", "interval"});
    low_ = getFiniteVector(dict, "low");
    high_ = getFiniteVector(dict, "high");
    number_ = dict.get<labelVector>("windows");
    interval_ = getNonNegative(dict, "interval", 0);
    if (cmptMin(high_ - low_) <= 0)
    {
        badEntry(dict, "high", "must be above low in x, y and z");
    }
    scalar all = 1;
    for (direction d = 0; d < 3; ++d)
    {
        all *= number_[d];
    }
    if (cmptMin(number_) < 1 || all > 1e6)
    {
        badEntry
        (
            dict,
            "windows",
            "needs 1 or more along each axis, a million at most together"
        );
    }
    edge_ = cmptDivide(high_ - low_, vector(number_));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dem::profileMeter::end(const demSolver& dem, const scalar dt)
{
    // The step in which an interval ends, if not to the last digit
    since_ += dt;
    if (since_ < interval_ - 1e-6*dt)
    {
        fraction_.clear();
        velocity_.clear();
        return;
    }
    since_ = max(since_ - interval_, scalar(0));
    if (since_ >= interval_)
    {
        since_ = 0;
    }
    take(dem);
}


void Foam::dem::profileMeter::write(dictionary& dict) const
{
    dict.add("since", since_);
}


void Foam::dem::profileMeter::read(const dictionary& dict)
{
    since_ = getNonNegative(dict, "since");
}


// ************************************************************************* //
