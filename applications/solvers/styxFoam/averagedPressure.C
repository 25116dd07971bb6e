/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "averagedFluid.H"
#include "adjustPhi.H"
#include "constrainHbyA.H"
#include "constrainPressure.H"
#include "fvc.H"
#include "fvm.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::averagedFluid::reportContinuity()
{
    const volScalarField error(fvc::ddt(alpha()) + fvc::div(alphaPhi_));
    const scalarField& V = mesh_.V();
    const scalar dt = mesh_.time().deltaTValue();
    const scalar all = gSum(V);
    const scalar local = dt*gSum(mag(error.primitiveField())*V)/all;
    const scalar global = dt*gSum(error.primitiveField()*V)/all;
    cumulativeError_ += global;
    Info<< "Volume of the fluid: error local " << local << ", global "
        << global << ", cumulative " << cumulativeError_ << endl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::averagedFluid::correctPressure()
{
    const volScalarField& a = alpha();
    const surfaceScalarField af
    (
        fvc::interpolate(a, "interpolate(voidFraction)")
    );
    const volScalarField rAU("rAU", 1/UEqn_->A());

    // What a unit of the pressure's gradient does to the velocity
    const surfaceScalarField mobility
    (
        "mobility",
        gammaf()*fvc::interpolate(rAU)
    );

    volVectorField HbyA(constrainHbyA(rAU*UEqn_->H(), U_, p_));
    surfaceScalarField phiHbyA
    (
        "phiHbyA",
        fvc::flux(HbyA)
      + af*fvc::interpolate(rAU)*fvc::ddtCorr(U_, phi_)
    );
    if (p_.needReference())
    {
        // All that comes in goes out, but for what the bodies displace
        surfaceScalarField all(af*phiHbyA);
        adjustPhi(all, U_, p_);
        phiHbyA = all/af;
    }
    constrainPressure(p_, U_, phiHbyA, mobility);

    while (pimple_.correctNonOrthogonal())
    {
        fvScalarMatrix pEqn
        (
            fvm::laplacian(af*mobility, p_)
         ==
            fvc::ddt(a) + fvc::div(af*phiHbyA)
        );
        pEqn.setReference(pRefCell_, pRefValue_);
        pEqn.solve(mesh_.solver(p_.select(pimple_.finalInnerIter())));

        if (pimple_.finalNonOrthogonalIter())
        {
            alphaPhi_ = af*phiHbyA - pEqn.flux();
            phi_ = alphaPhi_/af;
        }
    }

    p_.relax();
    U_ = HbyA - rAU*gamma()*fvc::grad(p_);
    U_.correctBoundaryConditions();
    cloud_.correct(U_);
}


// ************************************************************************* //
