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
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::surfaceScalarField> Foam::averagedFluid::gammaf() const
{
    if (!isA())
    {
        return tmp<surfaceScalarField>
        (
            new surfaceScalarField
            (
                IOobject("one", mesh_.time().timeName(), mesh_),
                mesh_,
                dimensionedScalar("one", dimless, 1)
            )
        );
    }

    // Weighed by the resistance, as its share over alpha is what the gradient
    // balances; where there is none, by nothing
    const volScalarField R
    (
        resistance_ + dimensionedScalar("small", dimless/dimTime, SMALL)
    );
    return
        fvc::interpolate(R, "interpolate(voidFraction)")
       /fvc::interpolate(R/alpha(), "interpolate(voidFraction)");
}


Foam::tmp<Foam::volVectorField> Foam::averagedFluid::pressureForce
(
    const surfaceScalarField& flux
) const
{
    // The sum over all of a gradient by Gauss is that at the boundary
    return isA() ? fvc::reconstruct(flux) : fvc::grad(p_);
}


Foam::tmp<Foam::volVectorField> Foam::averagedFluid::faceShift() const
{
    volVectorField lost(push_);
    lost.primitiveFieldRef() =
        resistance_.primitiveField()*U_.primitiveField()
      - push_.primitiveField();
    lost.correctBoundaryConditions();

    volScalarField perVolume
    (
        IOobject("perVolume", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar("0", dimless/dimVolume, 0),
        zeroGradientFvPatchScalarField::typeName
    );
    perVolume.primitiveFieldRef() = 1/mesh_.V().field();
    perVolume.correctBoundaryConditions();

    const surfaceVectorField n(mesh_.Sf()/mesh_.magSf());
    return fvc::surfaceIntegrate
    (
        0.25/linearInterpolate(perVolume)*n
       *(n & (fvc::snGrad(lost)/mesh_.nonOrthDeltaCoeffs()))
    );
}


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

    // Where the bodies begin both the resistance A and U jump, but alpha U
    // does not: faces have the mean of H - A/alpha alpha U
    const surfaceScalarField af
    (
        fvc::interpolate(a, "interpolate(voidFraction)")
    );
    const surfaceScalarField mobility
    (
        "mobility",
        1/fvc::interpolate(A/a, "interpolate(voidFraction)")
    );
    volVectorField HbyA(constrainHbyA(rAU*UEqn_->H(), U_, p_));
    surfaceScalarField alphaPhiHbyA
    (
        "alphaPhiHbyA",
        mobility
       *(
            fvc::flux(A*HbyA) + af*fvc::ddtCorr(U_, phi_)
        )
    );
    if (p_.needReference())
    {
        // All that comes in goes out, but for what the bodies displace
        adjustPhi(alphaPhiHbyA, U_, p_);
    }
    const surfaceScalarField yf(gammaf());
    constrainPressure
    (
        p_,
        U_,
        surfaceScalarField(alphaPhiHbyA/af),
        surfaceScalarField(mobility*yf/af)
    );
    surfaceScalarField force(yf*fvc::snGrad(p_)*mesh_.magSf());

    while (pimple_.correctNonOrthogonal())
    {
        fvScalarMatrix pEqn
        (
            fvm::laplacian(mobility*yf, p_)
         ==
            fvc::ddt(a) + fvc::div(alphaPhiHbyA)
        );
        pEqn.setReference(pRefCell_, pRefValue_);
        pEqn.solve(mesh_.solver(p_.select(pimple_.finalInnerIter())));

        if (pimple_.finalNonOrthogonalIter())
        {
            alphaPhi_ = alphaPhiHbyA - pEqn.flux();
            phi_ = alphaPhi_/af;
            force = pEqn.flux()/mobility;
        }
    }

    p_.relax();
    U_ = HbyA - rAU*(pressureForce(force) + faceShift());
    U_.correctBoundaryConditions();
    cloud_.correct(U_);
}


// ************************************************************************* //
