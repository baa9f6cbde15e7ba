// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "voidFractionHistory.H"

#include "savedField.H"

#include "calculatedFvPatchFields.H"
#include "fixedValueFvPatchFields.H"
#include "fvc.H"
#include "savedState.H"
#include "wallFvPatch.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::voidFractionHistory::particleFlux
(
    const dispersedParticles& p,
    const smoothingModel& smoothing
)
{
    // zero on walls, inlets and outlets: particles cross none of them
    volVectorField flux
    (
        IOobject("particleFlux", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedVector(dimVelocity, Zero),
        calculatedFvPatchVectorField::typeName
    );
    vectorField& cells = flux.primitiveFieldRef();

    forAll(p.position, i)
    {
        for (label e = p.offset[i]; e < p.offset[i + 1]; ++e)
        {
            cells[p.cellIndex[e]] += p.weight[e]*p.volume[i]*p.velocity[i];
        }
    }
    cells /= mesh_.V();

    smoothing.smooth(cells);
    flux.correctBoundaryConditions();

    ddt_ = fvc::div(fvc::interpolate(flux, "interpolate(U)") & mesh_.Sf());
}


Foam::wordList Foam::voidFractionHistory::patchTypes(const volVectorField& U)
{
    wordList types
    (
        U.boundaryField().size(),
        zeroGradientFvPatchScalarField::typeName
    );
    forAll(types, patchi)
    {
        const fvPatchVectorField& Up = U.boundaryField()[patchi];
        if
        (
            Up.fixesValue() && !Up.assignable()
         && !isA<wallFvPatch>(Up.patch())
        )
        {
            types[patchi] = fixedValueFvPatchScalarField::typeName;
        }
    }
    return types;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::voidFractionHistory::voidFractionHistory(const volVectorField& U)
:
    mesh_(U.mesh()),
    n_
    (
        IOobject
        (
            "voidfraction",
            mesh_.time().timeName(),
            mesh_,
            readState(mesh_),
            IOobject::AUTO_WRITE
        ),
        mesh_,
        dimensionedScalar("one", dimless, 1),
        patchTypes(U)
    ),
    old_("voidfractionOld", n_),
    mapped_("voidfractionMapped", n_),
    start_(n_.primitiveField()),
    end_(n_.primitiveField()),
    ddt_
    (
        IOobject("ddtVoidfraction", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar(dimless/dimTime, Zero),
        calculatedFvPatchScalarField::typeName
    ),
    fresh_(!savedField<volScalarField>(mesh_, "voidfraction")),
    lastInterval_(0),
    solidVolume_(-1)
{
    const dictionary saved(savedNumbers(mesh_));
    saved.readIfPresent("voidFractionInterval", lastInterval_);
    saved.readIfPresent("solidVolume", solidVolume_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::voidFractionHistory::begin
(
    const couplingProperties::ddtType ddt,
    const dispersedParticles& p,
    const smoothingModel& smoothing,
    const scalar solidVolume,
    const scalar T,
    const scalarField& jump,
    const scalar nMin
)
{
    const scalarField& mapped = mapped_.primitiveField();

    const bool changed =
        solidVolume_ >= 0
     && mag(solidVolume - solidVolume_) > 1e-9*max(solidVolume, solidVolume_);

    if (fresh_ || (changed && jump.empty()))
    {
        start_ = mapped;
    }
    else if (jump.size())
    {
        // only what moved drives the fluid, also out of the cells that others
        // have come to; no cell has less than nMin unless it had before
        start_ =
            max(min(end_ + jump, scalar(1)), min(min(end_, mapped), nMin));
    }
    else
    {
        start_ = end_;
    }

    // all ranks alike: a setting, and the start of a run
    if (fresh_ && ddt == couplingProperties::ddtType::difference)
    {
        // the first interval has no other before it: what moves now has moved
        particleFlux(p, smoothing);
        start_ = mapped - T*ddt_.primitiveField();
    }

    // a short interval takes its share of the change, the rest comes later
    const scalar share = lastInterval_ > 0 ? min(1.0, T/lastInterval_) : 1;
    end_ = start_ + share*(mapped - start_);

    // all ranks alike: a setting
    switch (ddt)
    {
        case couplingProperties::ddtType::difference:
        {
            ddt_.primitiveFieldRef() = (end_ - start_)/T;
            break;
        }
        case couplingProperties::ddtType::particleFlux:
        {
            particleFlux(p, smoothing);
            break;
        }
        case couplingProperties::ddtType::none:
        {
            ddt_.primitiveFieldRef() = Zero;
            break;
        }
    }

    n_.primitiveFieldRef() = start_;
    n_.correctBoundaryConditions();

    fresh_ = false;
    lastInterval_ = T;
    solidVolume_ = solidVolume;

    return changed;
}


void Foam::voidFractionHistory::advance(const scalar s)
{
    old_ == n_;
    n_.primitiveFieldRef() = end_ - (1 - s)*(end_ - start_);
    n_.correctBoundaryConditions();
}


void Foam::voidFractionHistory::save(stateWriter& to)
{
    // n_ is what the interval ends with
    to.numbers().set("voidFractionInterval", lastInterval_);
    to.numbers().set("solidVolume", solidVolume_);
}
