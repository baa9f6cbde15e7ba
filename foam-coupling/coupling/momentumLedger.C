// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "momentumLedger.H"

#include "extrapolatedCalculatedFvPatchFields.H"
#include "savedState.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type>
void Foam::momentumLedger::spread
(
    const dispersedParticles& p,
    const Field<Type>& values,
    Field<Type>& cells
) const
{
    const scalarField& V = mesh_.V();

    cells = Zero;
    forAll(values, i)
    {
        for (label e = p.offset[i]; e < p.offset[i + 1]; ++e)
        {
            const label celli = p.cellIndex[e];
            cells[celli] += (p.weight[e]/V[celli])*values[i];
        }
    }
}


void Foam::momentumLedger::smooth
(
    const smoothingModel& smoothing,
    vectorField& cells
) const
{
    if (!smoothing.active())
    {
        return;
    }

    const vector before(gSum(cells*mesh_.V()));
    smoothing.smooth(cells);
    const vector after(gSum(cells*mesh_.V()));
    cells += (before - after)/gSum(mesh_.V());
}


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
    weighted_(weighted),
    K_(mesh.nCells(), Zero),
    mass_(mesh.nCells(), Zero),
    reaction_(mesh.nCells(), Zero),
    added_(weighted ? mesh.nCells() : 0, Zero),
    velocity_(mesh.nCells(), Zero),
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
    if (weighted_)
    {
        readCells(mesh, "couplingDrag", K_);
        readCells(mesh, "couplingMass", mass_);
    }
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
    spread(p, vectorField(p.impulse - buoyancy), received);
    smooth(smoothing, received);

    // what cells were given on lengths that smoothing does not let particles
    // see has damped differences there, and is not asked back; its sum is zero
    vectorField answered(given_);
    // all ranks alike: settings
    if (bothWays)
    {
        smooth(smoothing, answered);
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
        smooth(smoothing, received);
        owed_.primitiveFieldRef() -= received;
        owed_.correctBoundaryConditions();
    }
}


void Foam::momentumLedger::setSources
(
    const dispersedParticles& p,
    const vectorField& velocity,
    const scalarField& K,
    const vectorField& force,
    const scalarField& added,
    const smoothingModel& smoothing
)
{
    spread(p, K, K_);
    spread(p, p.mass, mass_);
    if (weighted_)
    {
        spread(p, added, added_);
        spread(p, vectorField(p.mass/(p.mass + added)*force), reaction_);
    }
    else
    {
        spread(p, force, reaction_);
    }
    spread(p, vectorField(K*velocity), velocity_);

    if (smoothing.active())
    {
        smoothing.smooth(K_);
        smoothing.smooth(mass_);
        // all ranks alike: from the forces that are listed
        if (weighted_)
        {
            smoothing.smooth(added_);
        }
        smooth(smoothing, reaction_);
        smooth(smoothing, velocity_);
    }

    forAll(velocity_, celli)
    {
        if (K_[celli] > VSMALL)
        {
            velocity_[celli] /= K_[celli];
        }
        else
        {
            K_[celli] = 0;
            velocity_[celli] = Zero;
        }
    }
    reaction_ *= -1;
}


void Foam::momentumLedger::setReaction
(
    const dispersedParticles& p,
    const vectorField& force,
    const smoothingModel& smoothing
)
{
    spread(p, force, reaction_);
    smooth(smoothing, reaction_);
    reaction_ *= -1;
}


Foam::scalarField Foam::momentumLedger::follow
(
    const volScalarField& n,
    const scalar addedDensity
) const
{
    const scalar Cm = addedDensity/rho_;
    scalarField part(mass_.size(), 1);

    forAll(part, celli)
    {
        const scalar f = 1 - n[celli];
        const scalar answer =
            rho_*f*f/n[celli]*(1 + Cm/n[celli] + Cm);
        const scalar inertia =
            mass_[celli] + f*addedDensity + K_[celli]*interval_;

        if (mass_[celli] > VSMALL && answer > inertia)
        {
            part[celli] = inertia/answer;
        }
    }
    return part;
}


Foam::scalar Foam::momentumLedger::stiffness
(
    const volScalarField& n,
    const scalar T
) const
{
    scalar largest = 0;
    forAll(K_, celli)
    {
        largest = max(largest, K_[celli]*T/(rho_*n[celli]));
    }
    return returnReduce(largest, maxOp<scalar>());
}


Foam::scalar Foam::momentumLedger::pressureStiffness
(
    const volScalarField& n,
    const scalar T
) const
{
    scalar largest = 0;
    forAll(mass_, celli)
    {
        if (mass_[celli] > VSMALL)
        {
            const scalar f = 1 - n[celli];
            largest = max
            (
                largest,
                rho_*f*f/(n[celli]*(mass_[celli] + K_[celli]*T))
            );
        }
    }
    largest = returnReduce(largest, maxOp<scalar>());
    return weighted_ ? min(largest, 1) : largest;
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
        const scalar m = mass_[celli];
        Sp[celli] =
            m > VSMALL
          ? -m*std::expm1(-K_[celli]*now/inertia(celli))/(rho_*dt)
          : 0;

        F[celli] =
            Sp[celli]*velocity_[celli]
          + (part*reaction_[celli] + owed[celli]/max(dt, interval_))/rho_;
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
                (response.source()[celli] + reaction_[celli])/rho_
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
    const scalar now = min(dt, interval_);

    forAll(given_, celli)
    {
        const vector& Uc = U[celli];
        given_[celli] += (F[celli] - Sp[celli]*Uc)*(rho_*dt);

        if (mass_[celli] > VSMALL)
        {
            velocity_[celli] =
                Uc
              + (velocity_[celli] - Uc)*exp(-K_[celli]*now/inertia(celli));
        }
    }
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
    // all ranks alike: a setting
    if (weighted_)
    {
        to.cells("couplingDrag", K_);
        to.cells("couplingMass", mass_);
    }
    dictionary& numbers = to.numbers();
    numbers.set("ledgerInterval", interval_);
    numbers.set("givenTotal", givenTotal_);
    numbers.set("buoyancyTotal", buoyancyTotal_);
    numbers.set("impulseScale", impulseScale_);
    numbers.set("owedAtStart", owedAtStart_);
}
