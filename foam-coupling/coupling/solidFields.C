// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "solidFields.H"

#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

template<class Type>
static void make
(
    autoPtr<GeometricField<Type, fvPatchField, volMesh>>& field,
    const fvMesh& mesh,
    const word& name,
    const dimensionSet& dims
)
{
    field.reset
    (
        new GeometricField<Type, fvPatchField, volMesh>
        (
            IOobject
            (
                name,
                mesh.time().timeName(),
                mesh,
                IOobject::NO_READ,
                IOobject::AUTO_WRITE
            ),
            mesh,
            dimensioned<Type>(dims, Zero),
            zeroGradientFvPatchField<Type>::typeName
        )
    );
}


//- Sums of the particles' values by cell volume. Collective
template<class Type>
static void spread
(
    GeometricField<Type, fvPatchField, volMesh>& field,
    const dispersedParticles& p,
    const Field<Type>& values
)
{
    const scalarField& V = field.mesh().V();
    Field<Type>& cells = field.primitiveFieldRef();
    cells = Zero;
    forAll(values, i)
    {
        for (label e = p.offset[i]; e < p.offset[i + 1]; ++e)
        {
            const label celli = p.cellIndex[e];
            cells[celli] += (p.weight[e]/V[celli])*values[i];
        }
    }
    field.correctBoundaryConditions();
}

} // End namespace Foam


const Foam::wordList Foam::solidFields::known
({
    "Us", "exchangeCoefficient", "drag"
});


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::solidFields::solidFields(const fvMesh& mesh, const wordList& names)
{
    if (names.found("Us"))
    {
        make(Us_, mesh, "Us", dimVelocity);
    }
    if (names.found("exchangeCoefficient"))
    {
        make
        (
            exchange_,
            mesh,
            "exchangeCoefficient",
            dimDensity/dimTime
        );
    }
    if (names.found("drag"))
    {
        make(drag_, mesh, "drag", dimForce/dimVolume);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solidFields::update
(
    const dispersedParticles& p,
    const scalarField& K,
    const vectorField& u,
    const voidFractionModel::sharedSum& sumShared
)
{
    // all ranks alike: a setting
    if (Us_)
    {
        spread(*Us_, p, vectorField(p.volume*p.velocity));

        vectorField& Us = Us_->primitiveFieldRef();
        scalarField solid(Us.size(), Zero);
        forAll(p.volume, i)
        {
            for (label e = p.offset[i]; e < p.offset[i + 1]; ++e)
            {
                const label celli = p.cellIndex[e];
                solid[celli] +=
                    p.weight[e]*p.volume[i]/Us_->mesh().V()[celli];
            }
        }
        forAll(Us, celli)
        {
            Us[celli] /= max(solid[celli], VSMALL);
        }
        Us_->correctBoundaryConditions();
    }
    // all ranks alike: a setting
    if (exchange_)
    {
        spread(*exchange_, p, K);
    }
    // all ranks alike: a setting
    if (drag_)
    {
        vectorField force(p.size(), Zero);
        forAll(force, i)
        {
            if (p.owned[i])
            {
                force[i] = K[i]*(u[i] - p.velocity[i]);
            }
        }
        if (sumShared)
        {
            std::vector<double> parts(3*force.size());
            forAll(force, i)
            {
                std::copy(force[i].begin(), force[i].end(), &parts[3*i]);
            }
            sumShared(parts, 3);
            forAll(force, i)
            {
                const double* f = &parts[3*i];
                force[i] = vector(f[0], f[1], f[2]);
            }
        }
        spread(*drag_, p, force);
    }
}


// ************************************************************************* //
