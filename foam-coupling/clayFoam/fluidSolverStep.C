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


void Foam::fluidSolver::onWalls
(
    surfaceScalarField& field,
    const volVectorField& source
) const
{
    forAll(p_.boundaryField(), patchi)
    {
        const fvPatchScalarField& pp = p_.boundaryField()[patchi];
        if (!pp.fixesValue() && !pp.coupled())
        {
            field.boundaryFieldRef()[patchi] ==
                (
                    source.boundaryField()[patchi].patchInternalField()
                  & pp.patch().Sf()
                );
        }
    }
}


void Foam::fluidSolver::offWalls(surfaceScalarField& field) const
{
    forAll(p_.boundaryField(), patchi)
    {
        const fvPatchScalarField& pp = p_.boundaryField()[patchi];
        if (!pp.fixesValue() && !pp.coupled())
        {
            field.boundaryFieldRef()[patchi] == 0;
        }
    }
}


Foam::surfaceScalarField Foam::fluidSolver::faceDrag
(
    const particleCoupling& coupling
) const
{
    surfaceScalarField drag
    (
        "faceDrag",
        fvc::interpolate
        (
            volScalarField(coupling.Sp()/coupling.n()),
            "interpolate(HbyA)"
        )
    );
    offWalls(drag);
    return drag;
}


Foam::fluidSolver::balance Foam::fluidSolver::balanced
(
    const particleCoupling& coupling,
    const surfaceScalarField& faceSource,
    const surfaceScalarField& faceDrag,
    surfaceScalarField& faceGradP
) const
{
    const volVectorField through("through", fvc::reconstruct(nPhi_));

    volVectorField net
    (
        "net",
        coupling.source() - (coupling.Sp()/coupling.n())*through
    );
    surfaceScalarField onFaces("netFaces", faceSource - faceDrag*nPhi_);
    onWalls(onFaces, net);
    onWalls(faceGradP, net);

    volVectorField residual
    (
        "residual",
        fvc::reconstruct(onFaces - faceGradP)
      + remainder(net, onFaces)
    );

    return balance
    {
        tmp<volVectorField>
        (
            new volVectorField
            (
                "force",
                residual + (coupling.Sp()/coupling.n())*through
            )
        ),
        tmp<volVectorField>(new volVectorField("gradP", net - residual))
    };
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

    tmp<surfaceScalarField> tphi
    (
        fvc::interpolate(inertia, "interpolate(HbyA)")*phi_.oldTime()
      - fvc::flux(inertia*U_.oldTime())
    );

    // at walls and inlets the flux is that of U; at an outlet its difference
    // from U's would keep the last cells' U as it is
    surfaceScalarField::Boundary& faces = tphi.ref().boundaryFieldRef();
    forAll(faces, patchi)
    {
        if (!faces[patchi].coupled())
        {
            faces[patchi] == 0;
        }
    }

    return tphi;
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
    const surfaceScalarField& faceDrag
)
{
    // without the drag, which acts on the faces
    const volScalarField A("A", UEqn.A());
    const volScalarField rAU("rAU", 1.0/(A - coupling.Sp()));
    const surfaceScalarField rAUf("rAUf", fvc::interpolate(rAU));
    const surfaceScalarField nf
    (
        "nf",
        fvc::interpolate(coupling.n(), "interpolate(voidfraction)")
    );
    const surfaceScalarField yields("yields", 1/(1 + rAUf*faceDrag*nf));
    const surfaceScalarField rDf("rDf", rAUf*yields);
    const surfaceScalarField nrDf("nrDf", nf*rDf);

    const volVectorField H(UEqn.H());
    const volVectorField HbyA(constrainHbyA(rAU*H, U_, p_));

    surfaceScalarField free(faceSource);
    offWalls(free);

    surfaceScalarField phiHbyA
    (
        "phiHbyA",
        yields*(fvc::flux(HbyA) + faceInertia(coupling, rAU)) + rDf*free
    );
    surfaceScalarField nPhiHbyA("nPhiHbyA", nf*phiHbyA);

    if (p_.needReference())
    {
        adjustPhi(nPhiHbyA, U_, p_);
    }

    constrainPressure(p_, U_, phiHbyA, rDf);

    surfaceScalarField faceGradP("faceGradP", faceSource);

    while (pimple_.correctNonOrthogonal())
    {
        fvScalarMatrix pEqn
        (
            fvm::laplacian(nrDf, p_, "laplacian((1|A(U)),p)")
         == fvc::div(nPhiHbyA) + ddtN
        );

        pEqn.setReference(pRefCell_, pRefValue_);
        pEqn.solve(mesh_.solver(p_.select(pimple_.finalInnerIter())));

        if (pimple_.finalNonOrthogonalIter())
        {
            const surfaceScalarField flux(pEqn.flux());
            nPhi_ = nPhiHbyA - flux;
            phi_ = nPhi_/nf;
            faceGradP = flux/nrDf;
        }
    }

    p_.relax();

    const balance b(balanced(coupling, faceSource, faceDrag, faceGradP));
    U_ = (H + b.force())/A;
    U_.correctBoundaryConditions();

    coupling.setPressureGradient(b.gradP());
}


void Foam::fluidSolver::step(particleCoupling& coupling)
{
    fv::options& fvOptions = fv::options::New(mesh_);

    const surfaceScalarField sources(faceSource(coupling.source()));
    const surfaceScalarField drag(faceDrag(coupling));

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

            solve
            (
                UEqn == balanced(coupling, sources, drag, faceGradP).force()
            );
            fvOptions.correct(U_);
        }

        while (pimple_.correct())
        {
            correctPressure(coupling, ddtN, UEqn, sources, drag);
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
