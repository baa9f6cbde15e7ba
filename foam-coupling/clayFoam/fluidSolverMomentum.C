// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "fluidSolver.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::fluidSolver::plainStress() const
{
    return
        faces_.is
        (
            "laplacianSchemes",
            "laplacian(nuEff,U)",
            "Gauss linear corrected"
        )
     && faces_.is
        (
            "divSchemes",
            "div((nuEff*dev2(T(grad(U)))))",
            "Gauss linear"
        );
}


void Foam::fluidSolver::addStress(fvVectorMatrix& UEqn)
{
    scalarField gamma;
    faces_.linear(stress_, gamma);
    faces_.grad(U_, gradU_);

    // what does not run along the line of the cells, and the transposed part
    const labelUList& own = mesh_.owner();
    const labelUList& nei = mesh_.neighbour();
    const tensorField& grad = gradU_.primitiveField();
    const vectorField& Sf = faces_.Sf();

    tensorField transposed(mesh_.nCells());
    forAll(transposed, celli)
    {
        transposed[celli] = stress_[celli]*dev2(grad[celli].T());
    }

    scalarField& diag = UEqn.diag();
    scalarField& lower = UEqn.lower();
    scalarField& upper = UEqn.upper();
    vectorField& source = UEqn.source();
    const auto explicitly =
        [&](const label f, const label celli, const vector& v)
    {
        source[celli] += v;
        if (f < nei.size())
        {
            source[nei[f]] -= v;
        }
    };

    forAll(nei, f)
    {
        gamma[f] *= faces_.magSf()[f];
        const scalar g = gamma[f]*faces_.deltaCoeffs()[f];
        const label P = own[f], N = nei[f];
        diag[P] += g;
        diag[N] += g;
        lower[f] -= g;
        upper[f] -= g;

        const scalar w = faces_.weights()[f];
        explicitly
        (
            f,
            P,
            Sf[f] & (w*transposed[P] + (1 - w)*transposed[N])
        );
        if (!faces_.orthogonal())
        {
            explicitly
            (
                f,
                P,
                gamma[f]*(faces_.across()[f] & (w*grad[P] + (1 - w)*grad[N]))
            );
        }
    }

    faces_.patches([&](const label patchi, const fvPatch& patch)
    {
        const fvPatchVectorField& Up = U_.boundaryField()[patchi];
        const labelUList& inside = patch.faceCells();
        const label start = patch.start();

        const scalarField g
        (
            SubField<scalar>(gamma, patch.size(), start)*patch.magSf()
        );
        if (Up.coupled())
        {
            const scalarField d
            (
                SubField<scalar>(faces_.deltaCoeffs(), patch.size(), start)
            );
            UEqn.internalCoeffs()[patchi] -= g*Up.gradientInternalCoeffs(d);
            UEqn.boundaryCoeffs()[patchi] += g*Up.gradientBoundaryCoeffs(d);
        }
        else
        {
            UEqn.internalCoeffs()[patchi] -= g*Up.gradientInternalCoeffs();
            UEqn.boundaryCoeffs()[patchi] += g*Up.gradientBoundaryCoeffs();
        }

        const tmp<scalarField> tnu
        (
            Up.coupled()
          ? stress_.boundaryField()[patchi].patchNeighbourField()
          : tmp<scalarField>(stress_.boundaryField()[patchi])
        );
        const tmp<tensorField> tbeyond
        (
            Up.coupled()
          ? gradU_.boundaryField()[patchi].patchNeighbourField()
          : tmp<tensorField>(gradU_.boundaryField()[patchi])
        );
        forAll(inside, i)
        {
            const label f = start + i, P = inside[i];
            const tensor& beyond = tbeyond()[i];
            const scalar w = Up.coupled() ? faces_.weights()[f] : 0;
            explicitly
            (
                f,
                P,
                Sf[f]
              & (w*transposed[P] + (1 - w)*(tnu()[i]*dev2(beyond.T())))
            );
            if (Up.coupled() && !faces_.orthogonal())
            {
                explicitly
                (
                    f,
                    P,
                    g[i]*(faces_.across()[f] & (w*grad[P] + (1 - w)*beyond))
                );
            }
        }
    });
}


Foam::tmp<Foam::fvVectorMatrix> Foam::fluidSolver::momentum
(
    const particleCoupling& coupling,
    const scalarField& continuityRate,
    fv::options& fvOptions
)
{
    const scalarField& V = mesh_.V();
    const scalarField& nOld = coupling.nOld().primitiveField();
    const scalar rate = 1/runTime_.deltaTValue();

    tmp<surfaceScalarField> carried(nPhi_);
    scalarField ddtN(continuityRate);
    // all ranks alike: a setting
    if (coupling.ddtType() == couplingProperties::ddtType::particleFlux)
    {
        ddtN = (coupling.n().primitiveField() - nOld)*rate;
        carried = carrying_(nPhi_, ddtN);
    }

    tmp<fvVectorMatrix> tUEqn(fvm::div(carried(), U_, "div(phi,U)"));
    fvVectorMatrix& UEqn = tUEqn.ref();

    // with ddtN = (n - nOld)/dt it is (n U - nOld UOld)/dt + div(n phi U): n U
    // is conserved although nPhi is that of the step before
    const scalarField& Sp = coupling.Sp().primitiveField();
    const vectorField& UOld = U_.oldTime().primitiveField();
    scalarField& diag = UEqn.diag();
    vectorField& source = UEqn.source();
    forAll(diag, celli)
    {
        const scalar inertia = V[celli]*nOld[celli]*rate;
        diag[celli] += inertia + V[celli]*(ddtN[celli] + Sp[celli]);
        source[celli] += inertia*UOld[celli];
    }

    {
        const tmp<volScalarField> tnu(turbulence_->nuEff());
        const volScalarField& share = coupling.stressFraction();
        stress_.primitiveFieldRef() =
            share.primitiveField()*tnu().primitiveField();
        forAll(stress_.boundaryField(), patchi)
        {
            stress_.boundaryFieldRef()[patchi] ==
                share.boundaryField()[patchi]*tnu().boundaryField()[patchi];
        }
    }
    // all ranks alike: schemes
    if (plainStress())
    {
        addStress(UEqn);
    }
    else
    {
        UEqn -= fvm::laplacian(stress_, U_, "laplacian(nuEff,U)");
        UEqn -= fvc::div
        (
            stress_*dev2(T(fvc::grad(U_))),
            "div((nuEff*dev2(T(grad(U)))))"
        );
    }

    if (!fvOptions.optionList::empty())
    {
        // by the fluid's volume, as all of this equation
        UEqn -= coupling.n()*fvOptions(U_);
    }
    UEqn.relax();
    fvOptions.constrain(UEqn);

    return tUEqn;
}


void Foam::fluidSolver::sayForcesAtWalls
(
    particleCoupling& coupling,
    fv::options& fvOptions
)
{
    // all ranks alike: a setting, and what was found on all
    if (forcesSeen_ || fvOptions.optionList::empty())
    {
        return;
    }
    const tmp<fvVectorMatrix> tEqn(fvOptions(U_));
    const vectorField force(tEqn().source()/mesh_.V());
    const scalar largest = gMax(mag(force)());
    forcesSeen_ = largest > 0;

    const label nPatches = mesh_.boundaryMesh().nNonProcessor();
    // all ranks alike: the patches that all of them have
    for (label patchi = 0; patchi < nPatches; ++patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        scalar against = 0;
        forAll(patch, i)
        {
            const label f = patch.start() + i;
            const vector& a = force[patch.faceCells()[i]];
            against = max(against, mag(a & faces_.Sf()[f])/faces_.magSf()[f]);
        }
        reduce(against, maxOp<scalar>());
        if (wall(patchi) && against > 1e-3*largest)
        {
            coupling.statistics().warn
            (
                "a force of system/fvOptions pushes with "
              + Foam::name(against) + " m/s2 against patch '" + patch.name()
              + "', where p has no gradient that carries it: the velocity is"
                " wrong in the cells there; end the force some cells before it"
            );
        }
    }
}


// ************************************************************************* //
