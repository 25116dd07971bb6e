/*---------------------------------------------------------------------------*\
  Styx: rigid particles in OpenFOAM flows
  Copyright (C) 2026 The Styx founders
-------------------------------------------------------------------------------
License
    This file is part of Styx, which is free software: GPL-3.0-or-later,
    without any warranty. See the file COPYING.

\*---------------------------------------------------------------------------*/

#include "solidFields.H"
#include "checkedEntry.H"
#include "contactForces.H"
#include "StringStream.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type>
void Foam::coupling::solidFields::make
(
    autoPtr<GeometricField<Type, fvPatchField, volMesh>>& field,
    const wordList& named,
    const word& name,
    const dimensionSet& dimensions
)
{
    if (!named.found(name))
    {
        return;
    }
    field.reset
    (
        new GeometricField<Type, fvPatchField, volMesh>
        (
            IOobject
            (
                name,
                mesh_.time().timeName(),
                mesh_,
                IOobject::NO_READ,
                IOobject::AUTO_WRITE
            ),
            mesh_,
            dimensioned<Type>("0", dimensions, Zero),
            zeroGradientFvPatchField<Type>::typeName
        )
    );
}


template<class Type>
void Foam::coupling::solidFields::set
(
    GeometricField<Type, fvPatchField, volMesh>& field,
    const Field<Type>& values
)
{
    field.primitiveFieldRef() = values;
    field.correctBoundaryConditions();
}


Foam::symmTensorField Foam::coupling::solidFields::spread
(
    const UList<symmTensor>& ofBodies
) const
{
    List<vector> normal(ofBodies.size()), shear(ofBodies.size());
    forAll(ofBodies, b)
    {
        const symmTensor& s = ofBodies[b];
        normal[b] = vector(s.xx(), s.yy(), s.zz());
        shear[b] = vector(s.xy(), s.xz(), s.yz());
    }
    const vectorField n(exchanged_.spread(normal));
    const vectorField t(exchanged_.spread(shear));
    symmTensorField sum(n.size());
    forAll(sum, c)
    {
        sum[c] = symmTensor
        (
            n[c].x(), t[c].x(), t[c].y(),
            n[c].y(), t[c].z(),
            n[c].z()
        );
    }
    return sum;
}


Foam::List<Foam::symmTensor> Foam::coupling::solidFields::contacts() const
{
    const dem::bodies& state = dem_.state();
    List<symmTensor> sum(state.size(), symmTensor(Zero));
    for (const dem::contactForce& c : dem_.contacts())
    {
        const vector arm = state.x[c.a] - c.p;
        sum[c.a] += symm(arm*c.force);
        if (c.b >= 0)
        {
            // The other, or its image, has the opposite force
            sum[c.b] += symm((c.branch - arm)*c.force);
        }
    }
    return sum;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupling::solidFields::solidFields
(
    const fvMesh& mesh,
    const dem::demSolver& dem,
    momentumExchange& exchanged,
    const dictionary& dict
)
:
    mesh_(mesh),
    dem_(dem),
    exchanged_(exchanged)
{
    const word key("solidFields");
    const wordList all
    ({
        "solidFraction", "solidVelocity", "granularTemperature",
        "solidStress", "solidVolumeError"
    });
    const wordList named(dict.get<wordList>(key));
    for (const word& name : named)
    {
        if (!all.found(name))
        {
            OStringStream allowed;
            allowed << flatOutput(all);
            dem::badEntry
            (
                dict,
                key,
                "names " + name + ", which is none of " + allowed.str()
            );
        }
    }

    make(fraction_, named, all[0], dimless);
    make(velocity_, named, all[1], dimVelocity);
    make(temperature_, named, all[2], sqr(dimVelocity));
    make(stress_, named, all[3], dimPressure);
    make(volumeError_, named, all[4], dimless);
    if (volumeError_.valid())
    {
        exchanged_.keepMoved();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::coupling::solidFields::update()
{
    const dem::bodies& state = dem_.state();
    if (fraction_.valid())
    {
        set(*fraction_, scalarField(1 - exchanged_.alpha().primitiveField()));
    }
    if (volumeError_.valid() && exchanged_.moved().size() == mesh_.nCells())
    {
        set(*volumeError_, exchanged_.moved());
    }
    if (!velocity_.valid() && !temperature_.valid() && !stress_.valid())
    {
        return;
    }

    List<vector> momentum(state.size());
    forAll(momentum, b)
    {
        momentum[b] = state.mass[b]*state.v[b];
    }
    const scalarField m(exchanged_.spread(state.mass.list()));
    vectorField u(exchanged_.spread(momentum));
    forAll(u, c)
    {
        u[c] = m[c] > 0 ? u[c]/m[c] : vector(Zero);
    }
    if (velocity_.valid())
    {
        set(*velocity_, u);
    }
    if (!temperature_.valid() && !stress_.valid())
    {
        return;
    }

    // The variance is the mean square less the square of the mean; a velocity
    // that all have in common would leave little but round-off
    vector common(gSum(m*u*mesh_.V().field()));
    common /= max(gSum(m*mesh_.V().field()), VSMALL);
    List<symmTensor> moving(state.size());
    forAll(moving, b)
    {
        moving[b] = state.mass[b]*sqr(state.v[b] - common);
    }
    const symmTensorField motion(spread(moving) - m*sqr(u - common));
    if (temperature_.valid())
    {
        scalarField theta(m.size(), 0);
        forAll(theta, c)
        {
            theta[c] = m[c] > 0 ? tr(motion[c])/(3*m[c]) : 0;
        }
        set(*temperature_, theta);
    }
    if (stress_.valid())
    {
        set(*stress_, symmTensorField(motion + spread(contacts())));
    }
}


// ************************************************************************* //
