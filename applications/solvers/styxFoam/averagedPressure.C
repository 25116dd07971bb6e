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
#include "fixedFluxPressureFvPatchScalarField.H"
#include "fixedValueFvPatchFields.H"
#include "fvm.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * * //

namespace
{

//- What one side of a face of area S gets from the other, times its volume: w
//  n n . difference, w = V1 V2/(2 (V1 + V2))
Foam::vector throughFace
(
    const Foam::vector& S,
    const Foam::scalar V1,
    const Foam::scalar V2,
    const Foam::vector& difference
)
{
    return 0.5*V1*V2/(V1 + V2)*(S & difference)/magSqr(S)*S;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::surfaceScalarField> Foam::averagedFluid::gammaf() const
{
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


Foam::tmp<Foam::volVectorField> Foam::averagedFluid::faceForce
(
    const tmp<surfaceScalarField>& flux
) const
{
    // The sum over all of a gradient by Gauss is that at the boundary
    tmp<volVectorField> force(isA() ? fvc::reconstruct(flux()) : fvc::grad(p_));
    return cloud_.exchanges() ? force + faceShift() : force;
}


Foam::tmp<Foam::volVectorField> Foam::averagedFluid::faceShift() const
{
    // With values beyond patches that are coupled
    const auto field = [this](const dimensionSet& d, auto values)
    {
        typedef typename decltype(values)::value_type Type;
        auto made = GeometricField<Type, fvPatchField, volMesh>::New
        (
            "values",
            mesh_,
            dimensioned<Type>("0", d, Zero),
            zeroGradientFvPatchField<Type>::typeName
        );
        made.ref().primitiveFieldRef() = values;
        made.ref().correctBoundaryConditions();
        return made;
    };
    const auto lost = field
    (
        push_.dimensions(),
        vectorField
        (
            resistance_.primitiveField()*U_.primitiveField()
          - push_.primitiveField()
        )
    );
    const auto volume = field(dimVolume, scalarField(mesh_.V()));

    const vectorField& f = lost().primitiveField();
    const scalarField& V = volume().primitiveField();
    auto shift = field(push_.dimensions(), vectorField(f.size(), Zero));
    vectorField& sum = shift.ref().primitiveFieldRef();

    const labelUList& owner = mesh_.owner();
    const labelUList& neighbour = mesh_.neighbour();
    const vectorField& S = mesh_.Sf().primitiveField();
    forAll(neighbour, i)
    {
        const label c = owner[i];
        const label n = neighbour[i];
        const vector moved = throughFace(S[i], V[c], V[n], f[n] - f[c]);
        sum[c] += moved/V[c];
        sum[n] -= moved/V[n];
    }
    forAll(mesh_.boundary(), patch)
    {
        const fvPatch& side = mesh_.boundary()[patch];
        if (!side.coupled())
        {
            continue;
        }
        const labelUList& cells = side.faceCells();
        const vectorField& Sp = mesh_.Sf().boundaryField()[patch];
        const vectorField fn
        (
            lost().boundaryField()[patch].patchNeighbourField()
        );
        const scalarField Vn
        (
            volume().boundaryField()[patch].patchNeighbourField()
        );
        forAll(cells, i)
        {
            const label c = cells[i];
            sum[c] += throughFace(Sp[i], V[c], Vn[i], fn[i] - f[c])/V[c];
        }
    }
    shift.ref().correctBoundaryConditions();
    return shift;
}


void Foam::averagedFluid::pushAtPatches(surfaceScalarField& flux)
{
    forAll(p_.boundaryField(), patch)
    {
        const fvPatchScalarField& p = p_.boundaryField()[patch];
        const scalarField& R = resistance_.boundaryField()[patch];
        const vectorField& U = U_.boundaryField()[patch];
        const vectorField& S = mesh_.Sf().boundaryField()[patch];
        if (Foam::isA<fixedFluxPressureFvPatchScalarField>(p))
        {
            // Through a wall go neither fluid nor bodies, and f is nothing
            const vectorField f(R*U - push_.boundaryField()[patch]);
            flux.boundaryFieldRef()[patch] -=
                mobility_->boundaryField()[patch]
               *pos(mag(U & S) - 1e-9*mag(U)*mag(S) - VSMALL)*(f & S);
        }
        else if (!toldInlet_ && Foam::isA<zeroGradientFvPatchScalarField>(p))
        {
            // Against what the flow itself brings into its first cells
            const scalarField V(mesh_.V(), mesh_.boundary()[patch].faceCells());
            toldInlet_ = gSum(V*R*(-U & S)) > 0.1*gSum(sqr(U & S));
            if (toldInlet_)
            {
                WarningInFunction
                    << "Bodies resist the flow right at its inlet, the patch "
                    << mesh_.boundary()[patch].name() << ", where p is "
                    << p.type() << '.' << nl
                    << "    The first cells see half of its gradient. Choose"
                    << " fixedFluxPressure for p there." << endl;
            }
        }
    }
}


Foam::tmp<Foam::volScalarField> Foam::averagedFluid::projectFlux()
{
    // Free where the pressure is
    wordList types
    (
        p_.boundaryField().size(),
        zeroGradientFvPatchScalarField::typeName
    );
    forAll(types, patch)
    {
        if (p_.boundaryField()[patch].fixesValue())
        {
            types[patch] = fixedValueFvPatchScalarField::typeName;
        }
    }
    tmp<volScalarField> made
    (
        new volScalarField
        (
            IOobject("projection", mesh_.time().timeName(), mesh_),
            mesh_,
            dimensionedScalar("0", p_.dimensions(), 0),
            types
        )
    );
    volScalarField& q = made.ref();
    mesh_.setFluxRequired(q.name());
    const dimensionedScalar& dt = mesh_.time().deltaT();
    while (pimple_.correctNonOrthogonal())
    {
        fvScalarMatrix qEqn(fvm::laplacian(dt, q) == fvc::div(phi_));
        qEqn.setReference(pRefCell_, 0);
        qEqn.solve(mesh_.solver(p_.select(true)));
        if (pimple_.finalNonOrthogonalIter())
        {
            phi_ -= qEqn.flux();
        }
    }
    return made;
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
    const volScalarField& A = *A_;
    const volScalarField rAU("rAU", 1/A);

    // Where the bodies begin both the resistance A and U jump, but alpha U
    // does not: faces have the mean of H - A/alpha alpha U
    const surfaceScalarField& mobility = *mobility_;
    const surfaceScalarField& af = alphaf_;
    tmp<volVectorField> H(UEqn_->H());
    cloud_.correctImmersed(H.ref().primitiveFieldRef());
    H.ref().correctBoundaryConditions();
    volVectorField HbyA(constrainHbyA(rAU*H, U_, p_));
    surfaceScalarField alphaPhiHbyA
    (
        "alphaPhiHbyA",
        mobility
       *(
            fvc::flux(A*HbyA) + af*fvc::ddtCorr(U_, phi_)
        )
    );
    if (forced_.valid())
    {
        // Not where a body forces the fluid in its cells: it is not a part of
        // the fluid in them that resists, and beside it the fluid is free
        alphaPhiHbyA += *forced_
           *(fvc::flux(alpha()*HbyA) + mobility*af*fvc::ddtCorr(U_, phi_)
          - alphaPhiHbyA);
    }
    if (p_.needReference())
    {
        // All that comes in goes out, but for what the bodies displace
        adjustPhi(alphaPhiHbyA, U_, p_);
    }
    pushAtPatches(alphaPhiHbyA);
    const surfaceScalarField conductivity
    (
        "conductivity",
        timesGamma(mobility)
    );
    constrainPressure
    (
        p_,
        U_,
        surfaceScalarField(alphaPhiHbyA/af),
        surfaceScalarField(conductivity/af)
    );

    tmp<surfaceScalarField> force;
    while (pimple_.correctNonOrthogonal())
    {
        fvScalarMatrix pEqn
        (
            fvm::laplacian(conductivity, p_)
         ==
            fvc::ddt(alpha()) + fvc::div(alphaPhiHbyA)
        );
        pEqn.setReference(pRefCell_, pRefValue_);
        pEqn.solve(mesh_.solver(p_.select(pimple_.finalInnerIter())));

        if (pimple_.finalNonOrthogonalIter())
        {
            force = pEqn.flux();
            alphaPhi_ = alphaPhiHbyA - force();
            phi_ = alphaPhi_/af;
        }
    }

    p_.relax();
    if (isA())
    {
        force.ref() /= mobility;
    }
    U_ = HbyA - rAU*faceForce(force);
    U_.correctBoundaryConditions();
    cloud_.correct(U_);
}


void Foam::averagedFluid::imposeBodies()
{
    const label times = pimple_.finalIter() ? cloud_.imposes() : 0;
    for (label k = 0; k < times; ++k)
    {
        const volVectorField free("free", U_);
        cloud_.impose(U_);
        phi_ += fvc::flux(U_ - free);

        const tmp<volScalarField> q(projectFlux());
        alphaPhi_ = alphaf_*phi_;
        U_ -= mesh_.time().deltaT()*fvc::grad(q());
        U_.correctBoundaryConditions();
        p_ += q;
        cloud_.correct(U_);
    }
}


// ************************************************************************* //
