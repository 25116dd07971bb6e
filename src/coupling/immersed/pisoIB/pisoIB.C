/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "pisoIB.H"
#include "allowedKeys.H"
#include "checkedEntry.H"
#include "addToRunTimeSelectionTable.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace coupling
{
    defineTypeNameAndDebug(pisoIB, 0);
    addToRunTimeSelectionTable(immersedMethod, pisoIB, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::coupling::pisoIB::cellsFound()
{
    // The force of the last step, in equal parts of the bodies that share a
    // cell; what they have left behind is gone. Cells beside the body have a
    // force of their own only by the law of cutCells share
    const auto has = [this](const bodyCell& bc)
    {
        return !whole_ || bc.beta > 0;
    };
    labelList sharers(mesh_.nCells(), 0);
    for (const auto& cells : cells_)
    {
        for (const bodyCell& bc : cells)
        {
            sharers[bc.cell] += has(bc);
        }
    }
    for (auto& cells : cells_)
    {
        for (bodyCell& bc : cells)
        {
            bc.push = has(bc) ? f_[bc.cell]/sharers[bc.cell] : vector(Zero);
        }
    }
}


void Foam::coupling::pisoIB::setForcing(const knownFlow&)
{
    // The cells have their f and no rate
    assemble();
    inEquation_ = source_;
}


Foam::vector Foam::coupling::pisoIB::corrected
(
    const label b,
    const bodyCell& bc,
    const knownFlow& flow
) const
{
    const scalar dt = mesh_.time().deltaTValue();
    const vector& U = flow.U[bc.cell];
    if (whole_)
    {
        const vector Ub = imposed_[b].at(bc.r);
        return bc.push + relaxation_*bc.beta/dt*(Ub - U);
    }
    bodyCell law(bc);
    law.push = Zero;
    setLaw(b, law, flow);
    return next(law, bc.push, U, relaxation_, dt);
}


void Foam::coupling::pisoIB::answered(const volVectorField& U)
{
    const knownFlow flow(sides_, U);

    lack_ = 0;
    f_.primitiveFieldRef() = Zero;
    forAll(cells_, b)
    {
        for (bodyCell& bc : cells_[b])
        {
            if (bc.beta >= 1)
            {
                lack_ = max(lack_, mag(U[bc.cell] - imposed_[b].at(bc.r)));
            }
            bc.push = corrected(b, bc, flow);
            f_[bc.cell] += bc.push;
        }
    }
    f_.correctBoundaryConditions();
    reduce(lack_, maxOp<scalar>());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::pisoIB::pisoIB
(
    const immersedScene& scene,
    const dictionary& dict
)
:
    immersedMethod(scene, dict),
    relaxation_(dem::getInRange(dict, "relaxation", SMALL, 0.9, 0.9)),
    whole_
    (
        dem::getChoice(dict, "cutCells", {"share", "whole"}, "share") == "whole"
    ),
    f_
    (
        IOobject
        (
            "immersedForce",
            mesh_.time().timeName(),
            mesh_,
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        ),
        mesh_,
        dimensionedVector("0", dimAcceleration, Zero),
        zeroGradientFvPatchVectorField::typeName
    )
{
    dem::checkKeys(dict, commonKeys({"relaxation", "cutCells"}));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::coupling::pisoIB::next
(
    const bodyCell& law,
    const vector& f,
    const vector& U,
    const scalar alpha,
    const scalar dt
)
{
    return
        f
      + alpha/(1 + law.K*dt)*(law.K*(law.target - U) + law.push - f);
}


void Foam::coupling::pisoIB::correctForcing(vectorField& H)
{
    assemble();
    H += (source_ - inEquation_)/mesh_.V().field();
}


Foam::scalar Foam::coupling::pisoIB::slip() const
{
    return max(immersedMethod::slip(), lack_);
}


// ************************************************************************* //
