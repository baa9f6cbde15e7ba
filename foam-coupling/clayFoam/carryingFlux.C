// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "carryingFlux.H"

#include "fvc.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::carryingFlux::carryingFlux(const fvMesh& mesh)
:
    mesh_(mesh),
    psi_
    (
        IOobject
        (
            "clayFoam:carrying",
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh,
        dimensionedScalar(dimArea/dimTime, Zero),
        zeroGradientFvPatchScalarField::typeName
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::surfaceScalarField> Foam::carryingFlux::operator()
(
    const surfaceScalarField& nPhi,
    const scalarField& rate
)
{
    const scalarField& V = mesh_.V();
    const surfaceScalarField& deltaCoeffs = mesh_.nonOrthDeltaCoeffs();
    scalarField missing(fvc::div(nPhi)().primitiveField() + rate);
    // what the domain as a whole gains is not carried between its cells
    missing -= gSum(missing*V)/gSum(V);

    // all ranks alike: all of them made it at the same step
    if (!matrix_ || mesh_.changing())
    {
        matrix_.reset(new fvScalarMatrix(psi_, dimVolume/dimTime));
        fvScalarMatrix& m = *matrix_;
        m.upper() =
           -deltaCoeffs.primitiveField()*mesh_.magSf().primitiveField();
        m.negSumDiag();
        forAll(psi_.boundaryField(), patchi)
        {
            const fvPatchScalarField& patch = psi_.boundaryField()[patchi];
            const scalarField& coeffs = deltaCoeffs.boundaryField()[patchi];
            const scalarField& area = mesh_.magSf().boundaryField()[patchi];
            const labelUList& inside = mesh_.boundary()[patchi].faceCells();
            m.internalCoeffs()[patchi] = Zero;
            m.boundaryCoeffs()[patchi] = Zero;
            if (patch.coupled())
            {
                m.internalCoeffs()[patchi] =
                   -area*patch.gradientInternalCoeffs(coeffs);
                m.boundaryCoeffs()[patchi] =
                    area*patch.gradientBoundaryCoeffs(coeffs);
                forAll(inside, i)
                {
                    m.diag()[inside[i]] += m.internalCoeffs()[patchi][i];
                }
            }
        }
        // one cell of all ranks' holds the level
        if (Pstream::master() && mesh_.nCells())
        {
            m.diag()[0] += mag(m.diag()[0]);
        }
    }
    fvScalarMatrix& m = *matrix_;

    dictionary controls;
    controls.add("solver", word("PCG"));
    controls.add("preconditioner", word("keptFactor"));
    controls.add("tolerance", 0.0);
    controls.add("relTol", tolerance);
    controls.add("maxIter", 1000);

    scalarField& psi = psi_.primitiveFieldRef();
    psi = Zero;
    // the solve of ldu alone: fvMatrix would leave a record of each in the mesh
    lduMatrix::solver::New
    (
        psi_.name(),
        m,
        m.boundaryCoeffs(),
        m.internalCoeffs(),
        psi_.boundaryField().scalarInterfaces(),
        controls
    )->solve(psi, scalarField(-V*missing));
    psi_.correctBoundaryConditions();

    auto tcarried = tmp<surfaceScalarField>::New("carryingFlux", nPhi);
    surfaceScalarField& carried = tcarried.ref();
    const labelUList& own = mesh_.owner();
    const labelUList& nei = mesh_.neighbour();
    forAll(nei, f)
    {
        carried[f] += m.upper()[f]*(psi[nei[f]] - psi[own[f]]);
    }
    forAll(psi_.boundaryField(), patchi)
    {
        const fvPatchScalarField& patch = psi_.boundaryField()[patchi];
        if (patch.coupled())
        {
            carried.boundaryFieldRef()[patchi] -=
                deltaCoeffs.boundaryField()[patchi]
               *mesh_.magSf().boundaryField()[patchi]
               *(patch.patchNeighbourField() - patch.patchInternalField());
        }
    }
    return tcarried;
}


// ************************************************************************* //
