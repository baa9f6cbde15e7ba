// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "diffusionSmoothing.H"
#include "checkedNumber.H"
#include "addToRunTimeSelectionTable.H"
#include "surfaceFields.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace smoothingModels
{
    defineTypeNameAndDebug(diffusion, 0);
    addToRunTimeSelectionTable(smoothingModel, diffusion, dictionary);
}
}


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

void Foam::smoothingModels::diffusion::makeMatrix() const
{
    const scalar tau = sqr(bandwidth_)/4/steps_;
    const surfaceScalarField& deltaCoeffs = mesh_.nonOrthDeltaCoeffs();

    matrix_.reset(new fvScalarMatrix(psi_, dimVolume));
    fvScalarMatrix& m = matrix_.ref();

    m.upper() =
       -tau*deltaCoeffs.primitiveField()*mesh_.magSf().primitiveField();
    m.negSumDiag();
    m.diag() += mesh_.V().field();

    forAll(psi_.boundaryField(), patchi)
    {
        const fvPatchScalarField& patch = psi_.boundaryField()[patchi];
        const scalarField& coeffs = deltaCoeffs.boundaryField()[patchi];
        const scalarField flux(-tau*mesh_.magSf().boundaryField()[patchi]);

        if (patch.coupled())
        {
            m.internalCoeffs()[patchi] =
                flux*patch.gradientInternalCoeffs(coeffs);
            m.boundaryCoeffs()[patchi] =
               -flux*patch.gradientBoundaryCoeffs(coeffs);
        }
        else
        {
            m.internalCoeffs()[patchi] = Zero;
            m.boundaryCoeffs()[patchi] = Zero;
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::smoothingModels::diffusion::diffusion
(
    const dictionary& dict,
    const fvMesh& mesh
)
:
    smoothingModel(dict, mesh, typeName, {"bandwidth", "steps"}),
    bandwidth_(coeffs_.lookupOrDefault<scalar>("bandwidth", -1)),
    steps_(coeffs_.lookupOrDefault<label>("steps", 6)),
    psi_
    (
        IOobject
        (
            "clayFoam:smoothed",
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh,
        dimensionedScalar(dimless, Zero),
        zeroGradientFvPatchScalarField::typeName
    )
{
    if (!coeffs_.found("bandwidth"))
    {
        FatalIOErrorInFunction(dict)
            << "diffusionCoeffs: bandwidth [m] must be given"
            << exit(FatalIOError);
    }
    numberAbove(dict, "diffusionCoeffs: bandwidth", bandwidth_, 0, " m");
    wholeNumberFrom(dict, "diffusionCoeffs: steps", steps_, 1, 1000);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::smoothingModels::diffusion::spread() const
{
    const scalar m = steps_;
    const scalar T = sqr(bandwidth_)/4;
    const scalar wide = exp(2*(std::lgamma(m) - std::lgamma(m - 0.5)))/m;

    // within a cell the steps make no difference
    const scalar cell = pow(gAverage(mesh_.V().field()), 2.0/3.0);
    return T*(1 - (1 - wide)*T/(T + 0.5*cell));
}


void Foam::smoothingModels::diffusion::smooth(scalarField& cells) const
{
    if (!matrix_.valid() || mesh_.changing())
    {
        makeMatrix();
    }

    const scalarField& V = mesh_.V().field();
    const scalar before = gSum(V*cells);

    dictionary controls;
    controls.add("solver", "PCG");
    controls.add("preconditioner", "DIC");
    controls.add("tolerance", 1e-14);
    controls.add("relTol", 1e-12);
    controls.add("maxIter", 1000);

    fvScalarMatrix& m = matrix_.ref();
    scalarField& psi = psi_.primitiveFieldRef();
    psi = cells;

    // the lone ldu solve: fvMatrix would leave a record of each in the mesh
    const scalarField diag(m.diag());
    forAll(psi_.boundaryField(), patchi)
    {
        const labelUList& faceCells = mesh_.boundary()[patchi].faceCells();
        const scalarField& coeffs = m.internalCoeffs()[patchi];
        forAll(coeffs, k)
        {
            m.diag()[faceCells[k]] += coeffs[k];
        }
    }

    autoPtr<lduMatrix::solver> solver
    (
        lduMatrix::solver::New
        (
            psi_.name(),
            m,
            m.boundaryCoeffs(),
            m.internalCoeffs(),
            psi_.boundaryField().scalarInterfaces(),
            controls
        )
    );

    // all ranks alike: a setting
    for (label step = 0; step < steps_; ++step)
    {
        const scalarField source(V*psi);
        solver->solve(psi, source);
    }

    m.diag() = diag;

    const scalar lost = before - gSum(V*psi);
    const scalar weight = gSum(V*mag(psi));
    cells = weight > 0 ? scalarField(psi + lost/weight*mag(psi)) : psi;
}
