// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

// The answer to a state: what the DEM half is sent, and, where drag is stiff,
// what the particles will make of it.

#include "particleCoupling.H"

#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::particleCoupling::shareOwned(vectorField& values) const
{
    if (!Pstream::parRun())
    {
        return;
    }
    std::vector<double> shared(3*values.size(), 0.0);
    forAll(values, i)
    {
        if (particles_.owned[i])
        {
            std::copy(values[i].begin(), values[i].end(), &shared[3*i]);
        }
    }
    sumShared_(shared, 3);
    forAll(values, i)
    {
        values[i] =
            vector(shared[3*i], shared[3*i + 1], shared[3*i + 2]);
    }
}


void Foam::particleCoupling::foreseeAnswer()
{
    const dispersedParticles& p = particles_;

    startGradP_ = gradP_.primitiveField();
    pressureForce_ = forces_.pressureForce(p, gradP_, rho_);
    shareOwned(pressureForce_);

    const vectorField& own = forces_.own();
    vectorField u(forces_.u);
    shareOwned(u);
    List<particleResponse::particle> all(p.size());
    forAll(all, i)
    {
        particleResponse::particle& q = all[i];
        q.K = forces_.K[i];
        q.mass = p.mass[i];
        q.added = forces_.addedMass.size() ? forces_.addedMass[i] : 0;
        q.velocity = p.velocity[i];
        q.own = own.size() ? own[i] : vector::zero;
        q.fluid = u[i] + q.own;
        q.push = pressureForce_[i];
        q.load =
            forces_.hydrostatic[i] + forces_.reacting[i] - pressureForce_[i];
        q.mean = p.meanVelocity[i];
        // of all that the fluid does, buoyancy among it
        q.impulse = p.impulse[i] + lastInterval_*forces_.hydrostatic[i];
        q.other = p.otherForce[i];
        q.touched = p.touched[i];
    }

    // all ranks alike: a setting
    if (forces_.addedDensity() > 0)
    {
        ledger_.sums().setReaction(p, forces_.reacting, smoothing_());
    }
    response_.foresee
    (
        p,
        all,
        interval_,
        lastInterval_,
        properties_.has("pressureGradient"),
        ddtType_,
        smoothing_()
    );
}


void Foam::particleCoupling::answer()
{
    using clay::Field;

    const dispersedParticles& p = particles_;
    answers_.resize(p.size());

    const auto put = [&](Field f, const label i, const vector& v)
    {
        if (session_->sends().has(f))
        {
            std::copy(v.begin(), v.end(), answers_[f] + 3*i);
        }
    };

    std::vector<char> owned(p.size());
    forAll(p.owned, i)
    {
        owned[i] = p.owned[i];
        if (session_->sends().has(Field::dragCoefficient))
        {
            answers_[Field::dragCoefficient][i] = forces_.K[i];
        }
        if (session_->sends().has(Field::voidFraction))
        {
            answers_[Field::voidFraction][i] = forces_.fraction[i];
        }
        put(Field::fluidVelocity, i, forces_.u[i]);
        put(Field::force, i, forces_.reacting[i] + forces_.hydrostatic[i]);
        if (forces_.addedMass.size())
        {
            answers_[Field::addedMass][i] = forces_.addedMass[i];
        }
        if (forces_.turn.size())
        {
            answers_[Field::turnCoefficient][i] = forces_.turn[i];
            put(Field::fluidSpin, i, forces_.fluidSpin[i]);
        }
    }

    session_->report(stats_.momentumResidual, late_);
    session_->answer(answers_, owned);
    pending_ = false;
}
