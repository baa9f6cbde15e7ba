// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "momentumLedger.H"

#include "extrapolatedCalculatedFvPatchFields.H"
#include "savedState.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::momentumLedger::momentumLedger
(
    const fvMesh& mesh,
    const scalar rho,
    const bool weighted
)
:
    mesh_(mesh),
    rho_(rho),
    sums_(mesh, rho, weighted),
    owed_
    (
        IOobject
        (
            "couplingImpulse",
            mesh.time().timeName(),
            mesh,
            readState(mesh),
            IOobject::AUTO_WRITE
        ),
        mesh,
        dimensionedVector(dimForce*dimTime/dimVolume, Zero),
        zeroGradientFvPatchVectorField::typeName
    ),
    given_(mesh.nCells(), Zero),
    interval_(0),
    Sp_
    (
        IOobject("dragCoefficient", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimless/dimTime, Zero),
        extrapolatedCalculatedFvPatchScalarField::typeName
    ),
    F_
    (
        IOobject("particleSource", mesh.time().timeName(), mesh),
        mesh,
        dimensionedVector(dimAcceleration, Zero),
        zeroGradientFvPatchVectorField::typeName
    ),
    givenTotal_(Zero),
    buoyancyTotal_(Zero),
    impulseScale_(0),
    owedAtStart_(owed())
{
    const dictionary saved(savedNumbers(mesh));
    // all ranks alike: savedNumbers() is collective
    if (saved.empty())
    {
        return;
    }
    readCells(mesh, "couplingGiven", given_);
    saved.readEntry("ledgerInterval", interval_);
    saved.readEntry("givenTotal", givenTotal_);
    saved.readEntry("buoyancyTotal", buoyancyTotal_);
    saved.readEntry("impulseScale", impulseScale_);
    saved.readEntry("owedAtStart", owedAtStart_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::momentumLedger::settle
(
    const dispersedParticles& p,
    const vectorField& buoyancy,
    const smoothingModel& smoothing,
    const bool bothWays
)
{
    vectorField received(mesh_.nCells());
    sums_.spread(p, vectorField(p.impulse - buoyancy), received);
    sums_.smooth(smoothing, received);

    // what cells were given on lengths that smoothing does not let particles
    // see has damped differences there, and is not asked back; its sum is zero
    vectorField answered(given_);
    // all ranks alike: settings
    if (bothWays)
    {
        sums_.smooth(smoothing, answered);
    }

    owed_.primitiveFieldRef() -= received + answered;
    owed_.correctBoundaryConditions();

    vector given(gSum(given_*mesh_.V()));
    given_ = Zero;

    vector share(Zero);
    scalar scale = 0;
    forAll(p.owned, i)
    {
        if (p.owned[i])
        {
            share += buoyancy[i];
            scale += mag(p.impulse[i]);
        }
    }
    reduce(share, sumOp<vector>());
    reduce(scale, sumOp<scalar>());

    givenTotal_ += given;
    buoyancyTotal_ += share;
    impulseScale_ += scale;
}


void Foam::momentumLedger::settleGone
(
    const vector& impulse,
    const scalarField& gone,
    const smoothingModel& smoothing
)
{
    const scalar volume = gSum(gone);
    // all ranks alike: a sum over them
    if (volume > 0)
    {
        vectorField received(impulse*gone/(volume*mesh_.V()));
        sums_.smooth(smoothing, received);
        owed_.primitiveFieldRef() -= received;
        owed_.correctBoundaryConditions();
    }
}


void Foam::momentumLedger::begin(const scalar interval)
{
    interval_ = interval;
}


void Foam::momentumLedger::prepare(const scalar dt)
{
    scalarField& Sp = Sp_.primitiveFieldRef();
    vectorField& F = F_.primitiveFieldRef();
    const vectorField& owed = owed_.primitiveField();

    // of a step that is late, what acts now has this part, in time and size
    const scalar now = min(dt, interval_), part = now/dt;

    forAll(Sp, celli)
    {
        // K dt for K dt << m, m for K dt >> m
        const scalar m = sums_.mass(celli);
        Sp[celli] =
            m > VSMALL
          ? -m
             *std::expm1(-sums_.K(celli)*now/sums_.inertia(celli))
             /(rho_*dt)
          : 0;

        F[celli] =
            Sp[celli]*sums_.velocity(celli)
          + (part*sums_.reaction(celli) + owed[celli]/max(dt, interval_))/rho_;
    }

    Sp_.correctBoundaryConditions();
    F_.correctBoundaryConditions();
}


void Foam::momentumLedger::prepare
(
    const scalar dt,
    const particleResponse& response,
    const vectorField& gradP
)
{
    scalarField& Sp = Sp_.primitiveFieldRef();
    vectorField& F = F_.primitiveFieldRef();
    const vectorField& owed = owed_.primitiveField();
    const scalar now = min(dt, interval_), part = now/dt;

    forAll(Sp, celli)
    {
        Sp[celli] = part*response.drag()[celli]/rho_;
        F[celli] =
            part
           *(
                (response.source()[celli] + sums_.reaction(celli))/rho_
              - response.reaction()[celli]*gradP[celli]
            )
          + response.pay()[celli]*owed[celli]/(max(dt, interval_)*rho_);
    }

    Sp_.correctBoundaryConditions();
    F_.correctBoundaryConditions();
}


void Foam::momentumLedger::record
(
    const volVectorField& U,
    const scalar dt,
    const particleResponse& response,
    const vectorField& gradP
)
{
    const scalarField& Sp = Sp_.primitiveField();
    const vectorField& F = F_.primitiveField();
    const scalarField& off = response.pressure().primitiveField();

    forAll(given_, celli)
    {
        given_[celli] +=
            (F[celli] - Sp[celli]*U[celli] + off[celli]*gradP[celli])
           *(rho_*dt);
    }
}


void Foam::momentumLedger::record(const volVectorField& U, const scalar dt)
{
    const scalarField& Sp = Sp_.primitiveField();
    const vectorField& F = F_.primitiveField();

    forAll(given_, celli)
    {
        given_[celli] += (F[celli] - Sp[celli]*U[celli])*(rho_*dt);
    }
    sums_.approach(U, min(dt, interval_));
}


Foam::vector Foam::momentumLedger::owed() const
{
    return gSum(owed_.primitiveField()*mesh_.V());
}


Foam::scalar Foam::momentumLedger::residual(const vector& received) const
{
    const vector missing
    (
        received - buoyancyTotal_ + givenTotal_ + owed() - owedAtStart_
    );

    return impulseScale_ > VSMALL ? mag(missing)/impulseScale_ : 0;
}


void Foam::momentumLedger::save(stateWriter& to)
{
    to.cells("couplingGiven", given_);
    dictionary& numbers = to.numbers();
    numbers.set("ledgerInterval", interval_);
    numbers.set("givenTotal", givenTotal_);
    numbers.set("buoyancyTotal", buoyancyTotal_);
    numbers.set("impulseScale", impulseScale_);
    numbers.set("owedAtStart", owedAtStart_);
}
