/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "averagedFluid.H"
#include "findRefCell.H"
#include "fvc.H"
#include "fvm.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::IOobject Foam::averagedFluid::fieldIO
(
    const word& name,
    const fvMesh& mesh
)
{
    return IOobject
    (
        name,
        mesh.time().timeName(),
        mesh,
        IOobject::MUST_READ,
        IOobject::AUTO_WRITE
    );
}


Foam::autoPtr<Foam::volScalarField> Foam::averagedFluid::allFluid() const
{
    if (cloud_.exchanges() || !cloud_.fillsCells())
    {
        return nullptr;
    }
    return autoPtr<volScalarField>
    (
        new volScalarField
        (
            IOobject("voidFraction", mesh_.time().timeName(), mesh_),
            mesh_,
            dimensionedScalar("1", dimless, 1),
            zeroGradientFvPatchScalarField::typeName
        )
    );
}


Foam::scalar Foam::averagedFluid::courantNumber() const
{
    const scalarField outflow
    (
        fvc::surfaceSum(mag(phi_))().primitiveField()/mesh_.V().field()
    );
    return 0.5*gMax(outflow)*mesh_.time().deltaTValue();
}


void Foam::averagedFluid::updateAlpha()
{
    alphaf_ = fvc::interpolate(alpha(), "interpolate(voidFraction)");
    alphaPhi_ = alphaf_*phi_;
}


void Foam::averagedFluid::balanceFlux()
{
    // What faces that are new have, between ranks as well, depends on the
    // order in which the mesh was cut
    allFluid_->correctBoundaryConditions();
    U_.correctBoundaryConditions();
    U_.oldTime().correctBoundaryConditions();
    p_.correctBoundaryConditions();
    updateAlpha();
    phi_ = fvc::flux(U_);
    projectFlux();
    phi_.oldTime() = phi_;
    alphaPhi_ = alphaf_*phi_;
}


void Foam::averagedFluid::checkScheme(const word& name) const
{
    const word scheme(mesh_.ddtScheme(name));
    if (scheme != "Euler")
    {
        FatalErrorInFunction
            << "styxFoam needs the scheme Euler for " << name << " in "
            << mesh_.time().system() << "/fvSchemes, not " << scheme << "."
            << nl << "    What the bodies take is an impulse over one step."
            << exit(FatalError);
    }
}


void Foam::averagedFluid::forceCells()
{
    fvVectorMatrix forcing(U_, dimVelocity/dimTime*dimVolume);
    cloud_.addImmersed(forcing);
    *UEqn_ -= forcing;

    // Any face of a cell that is filled in part
    volScalarField filled
    (
        IOobject("filled", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar("0", dimless, 0),
        zeroGradientFvPatchScalarField::typeName
    );
    forAll(filled, c)
    {
        filled[c] = forcing.diag()[c] < 0;
    }
    filled.correctBoundaryConditions();
    forced_.reset
    (
        new surfaceScalarField("forced", pos(linearInterpolate(filled) - SMALL))
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::averagedFluid::averagedFluid(dynamicFvMesh& mesh)
:
    mesh_(mesh),
    pimple_(mesh),
    p_(fieldIO("p", mesh), mesh),
    U_(fieldIO("U", mesh), mesh),
    phi_
    (
        IOobject
        (
            "phi",
            mesh.time().timeName(),
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        ),
        fvc::flux(U_)
    ),
    transport_(U_, phi_),
    cloud_(mesh, demCloud::fluidAccess::share),
    allFluid_(allFluid()),
    alphaPhi_("alphaPhi", phi_),
    alphaf_
    (
        "voidFractionf",
        fvc::interpolate(alpha(), "interpolate(voidFraction)")
    ),
    resistance_
    (
        IOobject("resistance", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar("0", dimless/dimTime, 0),
        zeroGradientFvPatchScalarField::typeName
    ),
    push_
    (
        IOobject("push", mesh.time().timeName(), mesh),
        mesh,
        dimensionedVector("0", dimAcceleration, Zero),
        zeroGradientFvPatchVectorField::typeName
    ),
    toldInlet_(false),
    pRefCell_(0),
    pRefValue_(0),
    cumulativeError_(0)
{
    updateAlpha();
    checkScheme("ddt(" + alpha().name() + ',' + U_.name() + ')');
    checkScheme("ddt(" + alpha().name() + ')');
    setRefCell(p_, pimple_.dict(), pRefCell_, pRefValue_);
    mesh.setFluxRequired(p_.name());
    turbulence_ = turbulenceModel::New
    (
        alpha(),
        U_,
        alphaPhi_,
        phi_,
        transport_
    );
    turbulence_->validate();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::averagedFluid::setDeltaT()
{
    cloud_.passed(ledger::writing);
    cloud_.passed(ledger::start);
    Time& time = const_cast<Time&>(mesh_.time());
    const dictionary& control = time.controlDict();
    const scalar Co = courantNumber();
    Info<< "Courant number max: " << Co << endl;
    if (!control.getOrDefault("adjustTimeStep", false))
    {
        return;
    }

    // A step grows by a fifth at most
    const scalar now = time.deltaTValue();
    const scalar byFlow = control.get<scalar>("maxCo")/(Co + SMALL)*now;
    const scalar byUser = control.getOrDefault<scalar>("maxDeltaT", GREAT);
    const scalar byBodies = cloud_.maxDeltaT();
    const scalar others = min(min(byFlow, byUser), 1.2*now);
    time.setDeltaT(min(others, byBodies));
    Info<< "deltaT = " << time.deltaTValue();
    if (byBodies < others)
    {
        Info<< ", bounded by " << cloud_.deltaTBound();
    }
    Info<< endl;
}


void Foam::averagedFluid::updateMesh()
{
    cloud_.passed(ledger::fluid);
    mesh_.update();
    cloud_.passed(ledger::mesh);
    if (mesh_.changing())
    {
        // Where faces are new, the flux of the pressure's last solution is
        // not there; that of the step follows from its own
        if (allFluid_.valid())
        {
            balanceFlux();
            return;
        }
        updateAlpha();
    }
}


void Foam::averagedFluid::advanceBodies()
{
    cloud_.beginStep();
    updateAlpha();
}


void Foam::averagedFluid::predictMomentum()
{
    fvVectorMatrix exchange
    (
        U_,
        dimVelocity/dimTime*dimVolume
    );
    cloud_.addExchange(exchange);
    resistance_.primitiveFieldRef() = -exchange.diag()/mesh_.V().field();
    resistance_.correctBoundaryConditions();
    push_.primitiveFieldRef() = -exchange.source()/mesh_.V().field();
    push_.correctBoundaryConditions();

    // The flux has yet to follow the void fraction: what it lacks is taken
    // from the equation such that the diagonal does not fall below half of
    // alpha/dt, old and new, however the bodies have jumped from cell to cell
    const volScalarField& a = alpha();
    UEqn_.reset
    (
        new fvVectorMatrix
        (
            fvm::ddt(a, U_)
          + fvm::div(alphaPhi_, U_)
          + fvm::SuSp(-(fvc::ddt(a) + fvc::div(alphaPhi_)), U_)
          + turbulence_->divDevRhoReff(U_)
         ==
            exchange
        )
    );
    if (cloud_.fillsCells())
    {
        forceCells();
    }
    UEqn_->relax();

    if (pimple_.momentumPredictor())
    {
        tmp<surfaceScalarField> flux;
        if (isA())
        {
            flux = gammaf()*fvc::snGrad(p_)*mesh_.magSf();
        }
        solve(*UEqn_ == -faceForce(flux));
    }

    A_.reset(new volScalarField(UEqn_->A()));
    mobility_.reset
    (
        new surfaceScalarField
        (
            "mobility",
            1/fvc::interpolate(*A_/a, "interpolate(voidFraction)")
        )
    );
    if (forced_.valid())
    {
        *mobility_ += *forced_
           *(fvc::interpolate(a/(*A_), "interpolate(voidFraction)")
          - *mobility_);
    }
}


void Foam::averagedFluid::correctTurbulence()
{
    if (pimple_.turbCorr())
    {
        transport_.correct();
        turbulence_->correct();
    }
}


void Foam::averagedFluid::report()
{
    reportContinuity();
    cloud_.endStep();
}


void Foam::averagedFluid::close()
{
    cloud_.passed(ledger::writing);
    cloud_.close();
}


// ************************************************************************* //
