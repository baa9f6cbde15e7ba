// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "fluidSolver.H"

#include "uncarriedForce.H"

#include "fixedFluxPressureFvPatchScalarField.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::fluidSolver::wall(const label patchi) const
{
    const fvPatchScalarField& pp = p_.boundaryField()[patchi];
    return !pp.fixesValue() && !pp.coupled();
}


bool Foam::fluidSolver::carries(const label patchi) const
{
    return isA<fixedFluxPressureFvPatchScalarField>
    (
        p_.boundaryField()[patchi]
    );
}


void Foam::fluidSolver::prepareFaces(const particleCoupling& coupling)
{
    faces_.take(nPhi_, nPhiFaces_);
    faces_.interpolate(coupling.n(), "interpolate(voidfraction)", nFaces_);

    const scalarField& Sp = coupling.Sp().primitiveField();
    const scalarField& n = coupling.n().primitiveField();
    scalarField& drag = scratch_.primitiveFieldRef();

    // where the particles take a part of grad p, all is divided by what they
    // leave of it: then source, drag and grad p balance on the faces
    const particleResponse& response = coupling.response();
    left_.clear();
    // all ranks alike: from what is stiff on any of them
    if (response.active())
    {
        left_ = 1 - response.pressure().primitiveField();

        volVectorField source("sourceByLeft", coupling.source());
        source.primitiveFieldRef() /= left_;
        source.correctBoundaryConditions();
        faces_.flux(source, "interpolate(HbyA)", sourceFaces_);

        const auto inside = [&](const volScalarField& cells, scalarField& faces)
        {
            faces_.interpolate(cells, "interpolate(voidfraction)", faces);
            faces_.patches([&](const label, const fvPatch& patch)
            {
                if (!patch.coupled())
                {
                    SubField<scalar>(faces, patch.size(), patch.start()) = 0;
                }
            });
        };
        inside(response.share(), shareFaces_);
        inside(response.mobility(), mobilityFaces_);
        faces_.flux(response.flux(), "interpolate(U)", answerFaces_);
        forAll(mobilityFaces_, f)
        {
            answerFaces_[f] +=
                mobilityFaces_[f]*startSlope_[f] - shareFaces_[f]*startPhi_[f];
            shareFaces_[f] += nFaces_[f];
        }
        faces_.patches([&](const label, const fvPatch& patch)
        {
            if (!patch.coupled())
            {
                SubField<scalar>
                (
                    answerFaces_,
                    patch.size(),
                    patch.start()
                ) = 0;
            }
        });
    }
    else
    {
        faces_.flux(coupling.source(), "interpolate(HbyA)", sourceFaces_);
        shareFaces_ = nFaces_;
        mobilityFaces_ = 0;
        answerFaces_ = 0;
    }
    forAll(drag, celli)
    {
        drag[celli] =
            Sp[celli]/(left_.size() ? left_[celli]*n[celli] : n[celli]);
    }
    forAll(scratch_.boundaryField(), patchi)
    {
        scratch_.boundaryFieldRef()[patchi] ==
            coupling.Sp().boundaryField()[patchi]
           /coupling.n().boundaryField()[patchi];
        if (response.active())
        {
            scratch_.boundaryFieldRef()[patchi] ==
                scratch_.boundaryField()[patchi]
               /(1 - response.pressure().boundaryField()[patchi]);
        }
    }
    faces_.interpolate(scratch_, "interpolate(HbyA)", dragFaces_);
    faces_.patches([&](const label patchi, const fvPatch& patch)
    {
        const labelUList& inside = patch.faceCells();
        if (carries(patchi))
        {
            // n is 1 on an inlet, but the drag that of the cell
            forAll(inside, i)
            {
                dragFaces_[patch.start() + i] = drag[inside[i]];
            }
        }
        else if (wall(patchi))
        {
            SubField<scalar>(dragFaces_, patch.size(), patch.start()) = 0;
        }
    });
}


void Foam::fluidSolver::balanced
(
    const particleCoupling& coupling,
    const scalarField& gradPFaces
)
{
    const scalarField& Sp = coupling.Sp().primitiveField();
    const scalarField& n = coupling.n().primitiveField();
    const vectorField& F = coupling.source().primitiveField();
    const scalarField& V = mesh_.V();

    vectorField through, residual, carried;
    faces_.reconstruct(nPhiFaces_, through);

    vectorField net(mesh_.nCells());
    forAll(net, celli)
    {
        net[celli] = F[celli] - (Sp[celli]/n[celli])*through[celli];
        if (left_.size())
        {
            net[celli] /= left_[celli];
        }
    }

    scalarField onFaces(mesh_.nFaces(), Zero), left(mesh_.nFaces(), Zero);
    forAll(onFaces, f)
    {
        onFaces[f] = sourceFaces_[f] - dragFaces_[f]*nPhiFaces_[f];
        left[f] = onFaces[f] - gradPFaces[f];
    }
    faces_.patches([&](const label patchi, const fvPatch& patch)
    {
        const labelUList& inside = patch.faceCells();
        if (wall(patchi))
        {
            forAll(inside, i)
            {
                const label f = patch.start() + i;
                onFaces[f] = net[inside[i]] & faces_.Sf()[f];
                left[f] = 0;
            }
        }
    });
    faces_.reconstruct(left, onFaces, residual, carried);

    // what the faces do not carry of the source stays with their cells
    vectorField unheld;
    scalar uncarried = uncarriedForce(mesh_, faces_, net, onFaces, unheld);
    scalar all = 0;
    forAll(net, celli)
    {
        all += V[celli]*mag(net[celli]);
    }
    reduce(uncarried, sumOp<scalar>());
    reduce(all, sumOp<scalar>());
    uncarried_ = all > VSMALL ? uncarried/all : 0;

    force_.setSize(mesh_.nCells());
    vectorField& gradP = gradP_.primitiveFieldRef();
    forAll(net, celli)
    {
        residual[celli] += unheld[celli]/V[celli];
        gradP[celli] = net[celli] - residual[celli];
        if (left_.size())
        {
            residual[celli] *= left_[celli];
        }
        force_[celli] =
            residual[celli] + (Sp[celli]/n[celli])*through[celli];
    }
}


void Foam::fluidSolver::predict
(
    const particleCoupling& coupling,
    fvVectorMatrix& UEqn
)
{
    scalarField slope;
    faces_.take(fvc::snGrad(p_)(), slope);
    slope *= faces_.magSf();
    balanced(coupling, slope);

    const vectorField source(UEqn.source());
    forAll(source, celli)
    {
        UEqn.source()[celli] += mesh_.V()[celli]*force_[celli];
    }
    UEqn.solve();
    UEqn.source() = source;
}


Foam::scalar Foam::fluidSolver::neighbours(const fvVectorMatrix& UEqn) const
{
    const labelUList& own = mesh_.owner();
    const labelUList& nei = mesh_.neighbour();
    const scalarField& lower = UEqn.lower();
    const scalarField& upper = UEqn.upper();

    scalarField sum(mesh_.nCells(), Zero);
    forAll(nei, f)
    {
        sum[own[f]] += mag(upper[f]);
        sum[nei[f]] += mag(lower[f]);
    }
    faces_.patches([&](const label patchi, const fvPatch& patch)
    {
        if (patch.coupled())
        {
            const labelUList& inside = patch.faceCells();
            forAll(inside, i)
            {
                sum[inside[i]] +=
                    cmptMax(cmptMag(UEqn.boundaryCoeffs()[patchi][i]));
            }
        }
    });

    scalar largest = 0;
    forAll(sum, celli)
    {
        largest = max(largest, sum[celli]/(mesh_.V()[celli]*A_[celli]));
    }
    return returnReduce(largest, maxOp<scalar>());
}


bool Foam::fluidSolver::settled
(
    const vectorField& before,
    const scalar spread
) const
{
    const vectorField& U = U_.primitiveField();
    scalar change = 0, largest = 0;
    forAll(U, celli)
    {
        change = max(change, magSqr(U[celli] - before[celli]));
        largest = max(largest, magSqr(U[celli]));
    }
    reduce(change, maxOp<scalar>());
    reduce(largest, maxOp<scalar>());

    return spread*sqrt(change) <= correctorTolerance_*sqrt(largest);
}


void Foam::fluidSolver::correctViscosity
(
    const particleCoupling& coupling,
    const scalarField& ddtN
)
{
    transport_.correct();

    if (turbulence_->type() != "Stokes")
    {
        // the change of n that n phi has: a field carried by it stays uniform
        turbulenceN_.oldTime() == coupling.nOld();
        turbulenceN_ == coupling.n();
        turbulenceN_.primitiveFieldRef() =
            max
            (
                coupling.nOld().primitiveField()
              + runTime_.deltaTValue()*ddtN,
                0.1*coupling.n().primitiveField()
            );
        turbulenceFlux_ == nPhi_;
    }
    turbulence_->correct();
}


void Foam::fluidSolver::step(particleCoupling& coupling, const scalar part)
{
    fv::options& fvOptions = fv::options::New(mesh_);

    prepareFaces(coupling);
    sayForcesAtWalls(coupling, fvOptions);

    // a closed domain's n can not change as a whole
    scalarField ddtN(coupling.ddtN().primitiveField());
    if (p_.needReference())
    {
        ddtN -= gSum(ddtN*mesh_.V())/gSum(mesh_.V());
    }

    while (pimple_.loop())
    {
        tmp<fvVectorMatrix> tUEqn
        (
            momentum(coupling, scalarField(part*ddtN), fvOptions)
        );
        fvVectorMatrix& UEqn = tUEqn.ref();

        if (pimple_.momentumPredictor())
        {
            predict(coupling, UEqn);
            fvOptions.correct(U_);
        }

        prepareCorrectors(coupling, UEqn);
        // all ranks alike: a setting
        const scalar spread = correctorTolerance_ > 0 ? neighbours(UEqn) : 0;
        bool enough = false;
        while (pimple_.correct())
        {
            // all ranks alike: settled() is collective
            if (enough)
            {
                continue;
            }
            const vectorField before
            (
                correctorTolerance_ > 0
              ? vectorField(U_.primitiveField())
              : vectorField()
            );
            correctPressure(coupling, ddtN, UEqn);
            coupling.statistics().uncarried =
                max(coupling.statistics().uncarried, uncarried_);
            coupling.checkFields();
            fvOptions.correct(U_);
            // all ranks alike: a setting
            enough = correctorTolerance_ > 0 && settled(before, spread);
            ++correctors_;
        }
        coupling.setPressureGradient(gradP_);

        if (pimple_.turbCorr())
        {
            correctViscosity(coupling, ddtN);
        }
    }
}


// ************************************************************************* //
