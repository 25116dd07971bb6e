/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "forceTable.H"
#include "OSspecific.H"
#include "Pstream.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::autoPtr<Foam::OFstream> Foam::forceTable::open
(
    const fileName& directory,
    const word& quantity,
    const word& unit
)
{
    autoPtr<OFstream> table(new OFstream(directory/quantity + ".dat"));
    table->precision(12);
    *table
        << "# " << quantity << " on each body [" << unit.c_str() << "]" << nl
        << "# Time\tbody\tfluid_(x y z)\tcontact_(x y z)"
        << "\tlubrication_(x y z)\tpressure_(x y z)\tviscous_(x y z)" << endl;
    return table;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::forceTable::forceTable(const fileName& directory)
{
    if (Pstream::master())
    {
        mkDir(directory);
        force_ = open(directory, "force", "N");
        torque_ = open(directory, "torque", "Nm");
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::forceTable::write
(
    const scalar t,
    const scalar dt,
    const dem::demSolver& bodies,
    const coupling::immersedMethod& immersed
)
{
    if (!Pstream::master())
    {
        return;
    }
    const labelList& id = bodies.state().id;
    forAll(id, b)
    {
        if (!immersed.acts(b))
        {
            continue;
        }
        const Pair<vector> films = bodies.filmImpulse(b);
        const vector filmF = films.first()/dt, filmT = films.second()/dt;
        const vector F = immersed.fluidForce(b);
        const vector& viscousF = immersed.frictionForce(b);
        *force_
            << t << tab << id[b] << tab << F
            << tab << immersed.contactForce(b) - filmF << tab << filmF
            << tab << F - viscousF << tab << viscousF << nl;
        const vector T = immersed.fluidTorque(b);
        const vector& viscousT = immersed.frictionTorque(b);
        *torque_
            << t << tab << id[b] << tab << T
            << tab << immersed.contactTorque(b) - filmT << tab << filmT
            << tab << T - viscousT << tab << viscousT << nl;
    }
    force_->flush();
    torque_->flush();
}


// ************************************************************************* //
