// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "particleForces.H"

#include "fvc.H"
#include "savedPart.H"
#include "savedState.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::volVectorField Foam::particleForces::density
(
    const fluidState& fluid,
    const bool onFluid
) const
{
    const fvMesh& mesh = fluid.U.mesh();
    volVectorField f
    (
        IOobject("particleForce", mesh.time().timeName(), mesh),
        mesh,
        dimensionedVector(dimForce/dimVolume, Zero),
        zeroGradientFvPatchVectorField::typeName
    );

    // all ranks alike: the listed forces, by what they are
    for (const forceModel& force : forces_)
    {
        // all ranks alike
        if (force.onFluid() == onFluid)
        {
            force.add(fluid, f.primitiveFieldRef());
        }
    }
    f.correctBoundaryConditions();

    return f;
}


void Foam::particleForces::damp
(
    volVectorField& density,
    const scalarField& part
)
{
    if (!(addedDensity_ > 0))
    {
        return;
    }

    const bool first = !sent_;
    // all ranks alike: made at the first exchange
    if (first)
    {
        sent_.reset
        (
            new volVectorField
            (
                IOobject
                (
                    "particleForceSent",
                    density.mesh().time().timeName(),
                    density.mesh(),
                    readState(density.mesh()),
                    IOobject::AUTO_WRITE
                ),
                density
            )
        );
    }
    // all ranks alike, and collective; a pair is saved ahead of this
    if (!first || hasSavedNumbers(density.mesh()))
    {
        vectorField& f = sent_->primitiveFieldRef();
        f += part*(density.primitiveField() - f);
        sent_->correctBoundaryConditions();
    }

    density == *sent_;
}


void Foam::particleForces::evaluateMore
(
    const dispersedParticles& p,
    const fluidState& fluid,
    const scalarField& nu
)
{
    vectorField vorticity;
    // all ranks alike: what the listed forces need
    if (vorticity_)
    {
        volVectorField curl("vorticity", fvc::curl(fluid.U));
        curl.correctBoundaryConditions();
        vorticity = sample(curl, p);
    }

    const particleSurroundings around
    {
        u, fraction, vorticity, nu, fluid.rho
    };
    for (const forceModel& force : forces_)
    {
        force.act(p, around, reacting);
    }

    if (addedDensity_ > 0)
    {
        addedMass = addedDensity_*p.volume;
    }

    if (turn_)
    {
        turn.setSize(p.size());
        turn = 0;
        for (const forceModel& force : forces_)
        {
            forAll(turn, i)
            {
                turn[i] += force.turnCoefficient
                (
                    nu[i]*fluid.rho,
                    2*p.radius[i]
                );
            }
        }
        fluidSpin = 0.5*vorticity;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::particleForces::particleForces
(
    const couplingProperties& properties,
    const voidFractionModel::sharedSum& sumShared,
    const smoothingModel& smoothing,
    const scalar rho,
    const selfDisturbanceModel::setting& self
)
:
    properties_(properties),
    sumShared_(sumShared),
    smoothing_(smoothing),
    drag_(dragModel::New(properties)),
    forces_(properties.forces().size()),
    self_(selfDisturbanceModel::New(properties, self)),
    vorticity_(false),
    spin_(false),
    turn_(false),
    addedDensity_(0),
    reynoldsMax_(0)
{
    forAll(forces_, i)
    {
        forces_.set(i, forceModel::New(properties.forces()[i], properties));

        const forceModel& force = forces_[i];
        vorticity_ = vorticity_ || force.needsVorticity();
        spin_ = spin_ || force.needsSpin();
        turn_ = turn_ || force.turnCoefficient(1, 1) > 0;
        addedDensity_ += force.addedDensity(rho);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::particleForces::bothWays() const
{
    return
        smoothing_.active()
     && properties_.interpolation() == "mapped"
     && !self_->active();
}


void Foam::particleForces::velocity
(
    const dispersedParticles& p,
    const volVectorField& U
)
{
    u = sample(U, p);
    if (own_.size())
    {
        u -= own_;
    }
}


Foam::tmp<Foam::vectorField> Foam::particleForces::pressureForce
(
    const dispersedParticles& p,
    const volVectorField& gradP,
    const scalar rho
) const
{
    if (!properties_.has("pressureGradient"))
    {
        return tmp<vectorField>::New(p.size(), Zero);
    }
    return -rho*p.volume*sample(gradP, p);
}


Foam::tmp<Foam::scalarField> Foam::particleForces::viscosity
(
    const dispersedParticles& p,
    const fluidState& fluid,
    const viscosityLaw& law
) const
{
    scalarField rate(p.size(), Zero);
    // all ranks alike: a setting
    if (!law.newtonian())
    {
        volScalarField strain
        (
            "strainRate",
            sqrt(2.0)*mag(symm(fvc::grad(fluid.U)))
        );
        rate = sample(strain, p);
    }

    auto tnu = tmp<scalarField>::New(p.size(), law.nu(0));
    scalarField& nu = tnu.ref();
    forAll(nu, i)
    {
        if (p.owned[i] && !law.newtonian())
        {
            nu[i] = law.around
            (
                rate[i],
                mag(u[i] - p.velocity[i]),
                2*p.radius[i]
            );
        }
    }
    return tnu;
}


void Foam::particleForces::evaluate
(
    const dispersedParticles& p,
    const fluidState& fluid,
    const volScalarField& n,
    const viscosityLaw& law,
    const scalar T,
    const scalarField& part
)
{
    // all ranks alike: the listed forces
    for (forceModel& force : forces_)
    {
        force.prepare(fluid);
    }
    u = sample(fluid.U, p);
    // the particles' volume has been smoothed already; all ranks alike: a
    // setting
    fraction =
        properties_.interpolation() == "mapped"
      ? mean(n.primitiveField(), p)
      : sample(n, p);
    vectorField ownForce;
    // all ranks alike: the model
    if (self_->active())
    {
        scalarField ownSolid;
        self_->evaluate(p, T, u, fraction, own_, ownSolid, ownForce);
        u -= own_;
        fraction += ownSolid;
    }
    const scalarField nu(viscosity(p, fluid, law));

    K.setSize(p.size());
    K = 0;
    forAll(K, i)
    {
        if (p.owned[i])
        {
            const scalar slip = mag(u[i] - p.velocity[i]);
            const scalar factor = p.dragFactor.size() ? p.dragFactor[i] : 0;
            const scalar d = factor > 0 ? p.dragDiameter[i] : 2*p.radius[i];

            K[i] =
                p.volume[i]
               *(
                    factor > 0
                  ? drag_->bodyCoefficient
                    (
                        factor, fraction[i], slip, d, nu[i], fluid.rho
                    )
                  : drag_->coefficient
                    (
                        fraction[i], slip, d, nu[i], fluid.rho
                    )
                );
            if (!properties_.modelA())
            {
                K[i] /= fraction[i];
            }
            reynoldsMax_ = max(reynoldsMax_, fraction[i]*d*slip/nu[i]);
        }
    }

    bool anyReacting = false;
    for (const forceModel& force : forces_)
    {
        anyReacting = anyReacting || force.onFluid();
    }
    // all ranks alike: from the listed forces
    if (anyReacting)
    {
        volVectorField f(density(fluid, true));
        damp(f, part);
        reacting = p.volume*sample(f, p);
    }
    else
    {
        reacting.setSize(p.size());
        reacting = Zero;
    }
    hydrostatic = hydrostaticForces(p, fluid);

    // all ranks alike: what the listed forces need
    if (vorticity_ || turn_ || addedDensity_ > 0)
    {
        evaluateMore(p, fluid, nu);
    }

    if (self_->active())
    {
        reacting -= ownForce;
        self_->sent(p, K, reacting);
    }
}


Foam::tmp<Foam::vectorField> Foam::particleForces::hydrostaticForces
(
    const dispersedParticles& p,
    const fluidState& fluid
) const
{
    vectorField one(1, Zero);
    const auto byVolume = [&](const fluidState& around)
    {
        one[0] = Zero;
        // all ranks alike: the listed forces, by what they are
        for (const forceModel& force : forces_)
        {
            // all ranks alike
            if (!force.onFluid())
            {
                force.add(around, one);
            }
        }
        return one[0];
    };

    if (p.gravity.empty())
    {
        return p.volume*byVolume(fluid);
    }

    auto total = tmp<vectorField>::New(p.size());
    fluidState around(fluid);
    forAll(p.gravity, i)
    {
        around.gravity = p.gravity[i];
        total.ref()[i] = p.volume[i]*byVolume(around);
    }
    return total;
}
