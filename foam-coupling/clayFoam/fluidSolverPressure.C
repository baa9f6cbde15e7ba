// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

/*---------------------------------------------------------------------------*\
The discrete equations. With the sums of flux over a cell's faces written out,
d(n)/dt + div(n U) = 0 makes the left side of the momentum equation
(n U - nOld UOld)/dt + div(n U U), so that a cell has

    A U = H + F - grad p,       A' = A - Sp

A: the diagonal by volume, Sp in it; H: neighbours' velocities and nOld UOld/dt.
F - Sp U - grad p is not taken in the cells, where n and Sp jump at the edge of
a bed: it is taken on the faces, with Sp U as (Sp/n) (n phi), since n phi is
smooth there. S is a face's area, an index f a linear interpolation. The cell's
equation, divided by A' and taken to the faces, gives the flux

    phi = (H/A')_f.S + (1/A')_f [F_f.S - (Sp/n)_f n_f phi - |S| snGrad p]

in which UOld's part of H is replaced by the flux of the step before (freeFlux):
(nOld/(dt A'))_f (phiOld - UOld_f.S) is added. Solved for phi,

    phi = y {(H/A')_f.S + ...} + rD [F_f.S - |S| snGrad p]
    y = 1/(1 + (1/A')_f (Sp/n)_f n_f),      rD = (1/A')_f y

    yieldFaces_: y      rDFaces_: rD     dragFaces_: (Sp/n)_f
    sourceFaces_: F_f.S     inertiaFaces_: (nOld/(dt A'))_f phiOld

y is what the drag leaves of a flux: 1 without particles, 0 where they hold the
fluid. Continuity, sum(n_f phi) = -V d(n)/dt, is the equation of p,

    sum(n_f rD |S| snGrad p) = sum(n_f phi*) + V d(n)/dt

phi* being phi without p. Back in the cells (balanced), with R the vectors that
have these fluxes on the faces of a cell (faceOperators::reconstruct),

    A U = H + R[F_f.S - (Sp/n)_f n_f phi - |S| snGrad p] + (Sp/n) R[n_f phi]

so that what balances on the faces leaves nothing in the cells.

Where the particles' answer is foreseen (particleResponse) they take a part of
grad p, which leaves l = 1 - pressure of it: F, Sp and A' are divided by l
ahead of the faces, and R[...] is multiplied by it. Their own flux goes with the
fluid's: the flux through a face is s phi + a - m |S| snGrad p, s = n_f + share.
\*---------------------------------------------------------------------------*/

#include "fluidSolver.H"

#include "fixedFluxExtrapolatedPressureFvPatchScalarField.H"
#include "fixedFluxPressureFvPatchScalarField.H"

#include <type_traits>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fluidSolver::prepareCorrectors
(
    const particleCoupling& coupling,
    const fvVectorMatrix& UEqn
)
{
    // without the drag, which acts on the faces
    const scalarField& Sp = coupling.Sp().primitiveField();
    const scalarField& nOld = coupling.nOld().primitiveField();
    A_ = UEqn.A()().primitiveField();
    rAU_.setSize(A_.size());
    inertia_.setSize(A_.size());
    forAll(A_, celli)
    {
        rAU_[celli] = 1/(A_[celli] - Sp[celli]);
        inertia_[celli] =
            rAU_[celli]*nOld[celli]/runTime_.deltaTValue();
    }

    const auto cells = [&](const scalarField& values) -> const volScalarField&
    {
        scratch_.primitiveFieldRef() = values;
        scratch_.correctBoundaryConditions();
        faces_.patches([&](const label patchi, const fvPatch& patch)
        {
            if (!patch.coupled())
            {
                patch.patchInternalField
                (
                    values,
                    scratch_.boundaryFieldRef()[patchi]
                );
            }
        });
        return scratch_;
    };

    // phi of the step before, instead of its cells' velocity
    faces_.interpolate(cells(inertia_), "interpolate(HbyA)", inertiaFaces_);
    scalarField old;
    faces_.take(phi_.oldTime(), old);
    inertiaFaces_ *= old;

    // at walls and inlets the flux is that of U; at an outlet its difference
    // from U's would keep the last cells' U as it is
    faces_.patches([&](const label, const fvPatch& patch)
    {
        if (!patch.coupled())
        {
            SubField<scalar>(inertiaFaces_, patch.size(), patch.start()) = 0;
        }
    });

    faces_.interpolate
    (
        cells(left_.size() ? scalarField(left_*rAU_) : rAU_),
        "interpolate(rAU)",
        rDFaces_
    );
    yieldFaces_.setSize(mesh_.nFaces());
    nrDFaces_.setSize(mesh_.nFaces());
    forAll(rDFaces_, f)
    {
        yieldFaces_[f] = 1/(1 + rDFaces_[f]*dragFaces_[f]*nFaces_[f]);
        rDFaces_[f] *= yieldFaces_[f];
        nrDFaces_[f] = shareFaces_[f]*rDFaces_[f] + mobilityFaces_[f];
    }
}


void Foam::fluidSolver::freeFlux
(
    const fvVectorMatrix& UEqn,
    vectorField& H,
    scalarField& flux
)
{
    H = UEqn.H()().primitiveField();

    const vectorField& UOld = U_.oldTime().primitiveField();
    vectorField& cells = HbyA_.primitiveFieldRef();
    forAll(cells, celli)
    {
        cells[celli] = rAU_[celli]*H[celli] - inertia_[celli]*UOld[celli];
    }
    HbyA_.correctBoundaryConditions();
    faces_.patches([&](const label patchi, const fvPatch& patch)
    {
        const fvPatchVectorField& Up = U_.boundaryField()[patchi];
        if (patch.coupled())
        {
            return;
        }
        fvPatchVectorField& here = HbyA_.boundaryFieldRef()[patchi];
        const labelUList& inside = patch.faceCells();
        const bool stated =
            !Up.assignable()
         && !isA<fixedFluxExtrapolatedPressureFvPatchScalarField>
            (
                p_.boundaryField()[patchi]
            );
        forAll(here, i)
        {
            here[i] = stated ? Up[i] : rAU_[inside[i]]*H[inside[i]];
        }
    });
    faces_.flux(HbyA_, "flux(HbyA)", flux);

    // walls carry no source, unless their p has a gradient for it
    scalarField source(sourceFaces_);
    faces_.patches([&](const label patchi, const fvPatch& patch)
    {
        if (wall(patchi) && !carries(patchi))
        {
            SubField<scalar>(source, patch.size(), patch.start()) = 0;
        }
    });
    forAll(flux, f)
    {
        flux[f] =
            yieldFaces_[f]*(flux[f] + inertiaFaces_[f])
          + rDFaces_[f]*source[f];
    }
    // also on ranks that hold no face of the patch: it must be told
    forAll(mesh_.boundary(), patchi)
    {
        if (carries(patchi))
        {
            const fvPatch& patch = mesh_.boundary()[patchi];
            scalarField slope(patch.size());
            forAll(slope, i)
            {
                const label f = patch.start() + i;
                slope[i] =
                    (
                        flux[f]
                      - (faces_.Sf()[f] & U_.boundaryField()[patchi][i])
                    )/(faces_.magSf()[f]*rDFaces_[f]);
            }
            refCast<fixedFluxPressureFvPatchScalarField>
            (
                p_.boundaryFieldRef()[patchi]
            ).updateSnGrad(slope);
        }
    }

    // n times it, and what the particles do with it
    forAll(flux, f)
    {
        flux[f] = shareFaces_[f]*flux[f] + answerFaces_[f];
    }
    if (p_.needReference())
    {
        surfaceScalarField nPhi("nPhiHbyA", nPhi_);
        faces_.put(flux, nPhi);
        adjustPhi(nPhi, U_, p_);
        faces_.take(nPhi, flux);
    }
}


Foam::tmp<Foam::fvScalarMatrix> Foam::fluidSolver::pressure
(
    const scalarField& divergence
)
{
    const word name("laplacian((1|A(U)),p)");

    if (!faces_.is("laplacianSchemes", name, "Gauss linear corrected"))
    {
        surfaceScalarField nrD
        (
            IOobject("nrDf", runTime_.timeName(), mesh_),
            mesh_,
            dimensionedScalar(dimTime, Zero)
        );
        faces_.put(nrDFaces_, nrD);
        tmp<fvScalarMatrix> tpEqn(fvm::laplacian(nrD, p_, name));
        tpEqn.ref().source() += divergence;
        return tpEqn;
    }

    tmp<fvScalarMatrix> tpEqn
    (
        new fvScalarMatrix(p_, dimTime*dimLength*p_.dimensions())
    );
    fvScalarMatrix& pEqn = tpEqn.ref();

    scalarField& upper = pEqn.upper();
    forAll(upper, f)
    {
        upper[f] = nrDFaces_[f]*faces_.magSf()[f]*faces_.deltaCoeffs()[f];
    }
    pEqn.negSumDiag();

    faces_.patches([&](const label patchi, const fvPatch& patch)
    {
        const fvPatchScalarField& pp = p_.boundaryField()[patchi];
        const scalarField g
        (
            SubField<scalar>(nrDFaces_, patch.size(), patch.start())
           *patch.magSf()
        );
        if (pp.coupled())
        {
            const scalarField d
            (
                SubField<scalar>
                (
                    faces_.deltaCoeffs(),
                    patch.size(),
                    patch.start()
                )
            );
            pEqn.internalCoeffs()[patchi] = g*pp.gradientInternalCoeffs(d);
            pEqn.boundaryCoeffs()[patchi] = -g*pp.gradientBoundaryCoeffs(d);
        }
        else
        {
            pEqn.internalCoeffs()[patchi] = g*pp.gradientInternalCoeffs();
            pEqn.boundaryCoeffs()[patchi] = -g*pp.gradientBoundaryCoeffs();
        }
    });

    pEqn.source() = divergence;
    if (!faces_.orthogonal())
    {
        scalarField across;
        faces_.grad(p_, gradp_);
        faces_.correction(gradp_, across);
        forAll(across, f)
        {
            across[f] *= nrDFaces_[f]*faces_.magSf()[f];
        }
        scalarField sum;
        faces_.sum(across, sum);
        pEqn.source() -= sum;

        // a plain pointer up to v2312, a unique_ptr from v2406 on
        using pointer = std::decay_t<decltype(pEqn.faceFluxCorrectionPtr())>;
        pEqn.faceFluxCorrectionPtr() = pointer
        (
            new surfaceScalarField
            (
                IOobject("across", runTime_.timeName(), mesh_),
                mesh_,
                dimensionedScalar(pEqn.dimensions(), Zero)
            )
        );
        faces_.put(across, *pEqn.faceFluxCorrectionPtr());
        pEqn.faceFluxCorrectionPtr()->setOriented();
    }
    return tpEqn;
}


void Foam::fluidSolver::correctPressure
(
    particleCoupling& coupling,
    const scalarField& ddtN,
    const fvVectorMatrix& UEqn
)
{
    vectorField H;
    scalarField flux, divergence, gradPFaces(mesh_.nFaces(), Zero);
    freeFlux(UEqn, H, flux);
    faces_.sum(flux, divergence);
    divergence += ddtN*mesh_.V();

    while (pimple_.correctNonOrthogonal())
    {
        const tmp<fvScalarMatrix> tpEqn(pressure(divergence));
        fvScalarMatrix& pEqn = tpEqn.constCast();

        pEqn.setReference(pRefCell_, pRefValue_);
        // with a tolerance each corrector may be the last
        const bool final =
            pimple_.finalInnerIter()
         || (
                correctorTolerance_ > 0
             && pimple_.finalNonOrthogonalIter()
            );
        pEqn.solve(mesh_.solver(p_.select(final)));

        if (pimple_.finalNonOrthogonalIter())
        {
            faces_.take(pEqn.flux()(), gradPFaces);
            scalarField phi(mesh_.nFaces(), Zero);
            forAll(nPhiFaces_, f)
            {
                if (left_.size())
                {
                    gradPFaces[f] /= nrDFaces_[f];
                    phi[f] =
                        (flux[f] - answerFaces_[f])/shareFaces_[f]
                      - rDFaces_[f]*gradPFaces[f];
                    nPhiFaces_[f] = nFaces_[f]*phi[f];
                    continue;
                }
                nPhiFaces_[f] = flux[f] - gradPFaces[f];
                phi[f] = nPhiFaces_[f]/nFaces_[f];
                gradPFaces[f] /= nrDFaces_[f];
            }
            slope_ = gradPFaces;
            faces_.put(nPhiFaces_, nPhi_);
            faces_.put(phi, phi_);
        }
    }

    p_.relax();

    balanced(coupling, gradPFaces);
    vectorField& U = U_.primitiveFieldRef();
    forAll(U, celli)
    {
        U[celli] = (H[celli] + force_[celli])/A_[celli];
    }
    U_.correctBoundaryConditions();
}


// ************************************************************************* //
