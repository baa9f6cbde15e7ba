// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "fluidSolver.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::surfaceScalarField Foam::fluidSolver::faceSource
(
    const volVectorField& source
) const
{
    return surfaceScalarField
    (
        "faceSource",
        fvc::interpolate(source, "interpolate(HbyA)") & mesh_.Sf()
    );
}


Foam::tmp<Foam::volVectorField> Foam::fluidSolver::remainder
(
    const volVectorField& source,
    const surfaceScalarField& faceSource
) const
{
    tmp<volVectorField> tr
    (
        new volVectorField
        (
            "remainder",
            source - fvc::reconstruct(faceSource)
        )
    );
    volVectorField& r = tr.ref();

    const vector missing(gSum(r.primitiveField()*mesh_.V()));
    const scalarField size(mag(source.primitiveField()));
    const scalar total = gSum(size*mesh_.V());

    if (total > VSMALL)
    {
        r.primitiveFieldRef() = (size/total)*missing;
    }
    else
    {
        r.primitiveFieldRef() = Zero;
    }
    r.correctBoundaryConditions();

    return tr;
}


void Foam::fluidSolver::balanceOnWalls
(
    surfaceScalarField& faceGradP,
    const surfaceScalarField& faceSource
) const
{
    forAll(p_.boundaryField(), patchi)
    {
        const fvPatchScalarField& pp = p_.boundaryField()[patchi];
        if (!pp.fixesValue() && !pp.coupled())
        {
            faceGradP.boundaryFieldRef()[patchi] ==
                faceSource.boundaryField()[patchi];
        }
    }
}


Foam::tmp<Foam::surfaceScalarField> Foam::fluidSolver::faceInertia
(
    const particleCoupling& coupling,
    const volScalarField& rAU
) const
{
    const volScalarField inertia
    (
        "inertia",
        rAU*coupling.nOld()/runTime_.deltaT()
    );

    return
        fvc::interpolate(inertia, "interpolate(HbyA)")*phi_.oldTime()
      - fvc::flux(inertia*U_.oldTime());
}


Foam::tmp<Foam::fvVectorMatrix> Foam::fluidSolver::momentum
(
    const particleCoupling& coupling,
    const volScalarField& ddtN,
    fv::options& fvOptions
)
{
    const volScalarField stress
    (
        "stress",
        coupling.stressFraction()*turbulence_->nuEff()
    );

    // with ddtN = (n - nOld)/dt it is (n U - nOld UOld)/dt + div(n phi U): n U
    // is conserved although nPhi is that of the step before
    tmp<fvVectorMatrix> tUEqn
    (
        coupling.nOld()()*fvm::ddt(U_)
      + fvm::Sp(ddtN, U_)
      + fvm::div(nPhi_, U_, "div(phi,U)")
      - fvm::laplacian(stress, U_, "laplacian(nuEff,U)")
      - fvc::div
        (
            stress*dev2(T(fvc::grad(U_))),
            "div((nuEff*dev2(T(grad(U)))))"
        )
      + fvm::Sp(coupling.Sp(), U_)
     ==
        fvOptions(U_)
    );

    tUEqn.ref().relax();
    fvOptions.constrain(tUEqn.ref());

    return tUEqn;
}


void Foam::fluidSolver::correctPressure
(
    particleCoupling& coupling,
    const volScalarField& ddtN,
    const fvVectorMatrix& UEqn,
    const surfaceScalarField& faceSource,
    const volVectorField& remainder
)
{
    const volScalarField rAU("rAU", 1.0/UEqn.A());
    const surfaceScalarField rAUf("rAUf", fvc::interpolate(rAU));
    const surfaceScalarField nf
    (
        "nf",
        fvc::interpolate(coupling.n(), "interpolate(voidfraction)")
    );
    const surfaceScalarField nrAUf("nrAUf", nf*rAUf);

    const volVectorField HbyA(constrainHbyA(rAU*UEqn.H(), U_, p_));

    surfaceScalarField balanced(faceSource);
    forAll(p_.boundaryField(), patchi)
    {
        const fvPatchScalarField& pp = p_.boundaryField()[patchi];
        if (!pp.fixesValue() && !pp.coupled())
        {
            balanced.boundaryFieldRef()[patchi] == 0;
        }
    }

    surfaceScalarField phiHbyA
    (
        "phiHbyA",
        fvc::flux(HbyA)
      + faceInertia(coupling, rAU)
      + rAUf*balanced
    );
    surfaceScalarField nPhiHbyA("nPhiHbyA", nf*phiHbyA);

    if (p_.needReference())
    {
        adjustPhi(nPhiHbyA, U_, p_);
    }

    constrainPressure(p_, U_, phiHbyA, rAUf);

    surfaceScalarField faceGradP("faceGradP", faceSource);

    while (pimple_.correctNonOrthogonal())
    {
        fvScalarMatrix pEqn
        (
            fvm::laplacian(nrAUf, p_, "laplacian((1|A(U)),p)")
         == fvc::div(nPhiHbyA) + ddtN
        );

        pEqn.setReference(pRefCell_, pRefValue_);
        pEqn.solve(mesh_.solver(p_.select(pimple_.finalInnerIter())));

        if (pimple_.finalNonOrthogonalIter())
        {
            const surfaceScalarField flux(pEqn.flux());
            nPhi_ = nPhiHbyA - flux;
            phi_ = nPhi_/nf;
            faceGradP = flux/nrAUf;
        }
    }

    p_.relax();

    balanceOnWalls(faceGradP, faceSource);
    U_ = HbyA + rAU*(fvc::reconstruct(faceSource - faceGradP) + remainder);
    U_.correctBoundaryConditions();

    coupling.setPressureGradient(fvc::reconstruct(faceGradP));
}


void Foam::fluidSolver::step(particleCoupling& coupling)
{
    fv::options& fvOptions = fv::options::New(mesh_);

    const surfaceScalarField sources(faceSource(coupling.source()));
    const volVectorField rest(remainder(coupling.source(), sources));

    // a closed domain's n can not change as a whole
    volScalarField ddtN("ddtN", coupling.ddtN());
    if (p_.needReference())
    {
        ddtN.primitiveFieldRef() -=
            gSum(ddtN.primitiveField()*mesh_.V())/gSum(mesh_.V());
    }

    while (pimple_.loop())
    {
        const tmp<fvVectorMatrix> tUEqn(momentum(coupling, ddtN, fvOptions));
        const fvVectorMatrix& UEqn = tUEqn();

        if (pimple_.momentumPredictor())
        {
            surfaceScalarField faceGradP(fvc::snGrad(p_)*mesh_.magSf());
            balanceOnWalls(faceGradP, sources);

            solve
            (
                UEqn == fvc::reconstruct(sources - faceGradP) + rest
            );
            fvOptions.correct(U_);
        }

        while (pimple_.correct())
        {
            correctPressure(coupling, ddtN, UEqn, sources, rest);
            coupling.checkFields();
            fvOptions.correct(U_);
        }

        if (pimple_.turbCorr())
        {
            transport_.correct();
            turbulence_->correct();
        }
    }
}
