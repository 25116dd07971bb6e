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
    const volScalarField A(UEqn_->A());
    const volScalarField rAU("rAU", 1/A);
    const volScalarField y(gamma());

    // Where the bodies begin both the resistance A and U jump, but neither
    // does alpha U nor what is left of the pressure's gradient: faces have the
    // mean of H/gamma - A/(gamma alpha) alpha U
    const surfaceScalarField af
    (
        fvc::interpolate(a, "interpolate(voidFraction)")
    );
    const surfaceScalarField mobility
    (
        "mobility",
        1/fvc::interpolate(A/(y*a), "interpolate(voidFraction)")
    );
    volVectorField HbyA(constrainHbyA(rAU*UEqn_->H(), U_, p_));
    surfaceScalarField alphaPhiHbyA
    (
        "alphaPhiHbyA",
        mobility
       *(
            fvc::flux((A/y)*HbyA)
          + fvc::interpolate(a/y, "interpolate(voidFraction)")
           *fvc::ddtCorr(U_, phi_)
        )
    );
    if (p_.needReference())
    {
        // All that comes in goes out, but for what the bodies displace
        adjustPhi(alphaPhiHbyA, U_, p_);
    }
    constrainPressure
    (
        p_,
        U_,
        surfaceScalarField(alphaPhiHbyA/af),
        surfaceScalarField(mobility/af)
    );

    while (pimple_.correctNonOrthogonal())
    {
        fvScalarMatrix pEqn
        (
            fvm::laplacian(mobility, p_)
         ==
            fvc::ddt(a) + fvc::div(alphaPhiHbyA)
        );
        pEqn.setReference(pRefCell_, pRefValue_);
        pEqn.solve(mesh_.solver(p_.select(pimple_.finalInnerIter())));

        if (pimple_.finalNonOrthogonalIter())
        {
            alphaPhi_ = alphaPhiHbyA - pEqn.flux();
            phi_ = alphaPhi_/af;
        }
    }

    p_.relax();
    U_ = HbyA - rAU*y*fvc::grad(p_);
    U_.correctBoundaryConditions();
    cloud_.correct(U_);
}


// ************************************************************************* //
