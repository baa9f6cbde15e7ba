// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "particleCoupling.H"

#include "fvc.H"

#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::particleCoupling::take()
{
    using clay::Field;

    dispersedParticles& p = particles_;
    p.setSize(received_.size());

    const auto vectors = [&](Field f, vectorField& to)
    {
        const double* x = received_[f];
        forAll(to, i)
        {
            to[i] = vector(x[3*i], x[3*i + 1], x[3*i + 2]);
        }
    };
    vectors(Field::position, p.position);
    vectors(Field::velocity, p.velocity);
    vectors(Field::impulse, p.impulse);
    if (received_.fields().has(Field::spin))
    {
        p.spin.setSize(p.size());
        vectors(Field::spin, p.spin);
    }

    if (received_.fields().has(Field::gravity))
    {
        p.gravity.setSize(p.size());
        vectors(Field::gravity, p.gravity);
    }

    const auto scalars = [&](Field f, scalarField& to)
    {
        if (received_.fields().has(f))
        {
            to.setSize(p.size());
            std::copy(received_[f], received_[f] + p.size(), to.begin());
        }
    };
    p.meanVelocity.setSize(p.size());
    vectors(Field::meanVelocity, p.meanVelocity);
    p.otherForce.setSize(p.size());
    vectors(Field::otherForce, p.otherForce);
    p.touched.setSize(p.size());
    scalars(Field::dragDiameter, p.dragDiameter);
    scalars(Field::dragFactor, p.dragFactor);

    forAll(p.tag, i)
    {
        p.radius[i] = received_[Field::radius][i];
        p.volume[i] = received_[Field::volume][i];
        p.mass[i] = received_[Field::mass][i];
        p.tag[i] = label(received_[Field::tag][i]);
        p.body[i] = -1;
        p.touched[i] = received_[Field::touched][i] != 0;

        const vector sum(p.position[i] + p.velocity[i] + p.impulse[i]);
        if
        (
            !std::isfinite(sum.x() + sum.y() + sum.z())
         || !(p.radius[i] > 0 && p.volume[i] > 0 && p.mass[i] > 0)
         || !std::isfinite(p.radius[i] + p.volume[i] + p.mass[i])
        )
        {
            FatalErrorInFunction
                << "particle " << p.tag[i]
                << " came with NaN or infinity at time "
                << session_->time() << " s: position " << p.position[i]
                << ", velocity " << p.velocity[i] << ", impulse "
                << p.impulse[i] << ", radius " << p.radius[i] << ", volume "
                << p.volume[i] << ", mass " << p.mass[i] << exit(FatalError);
        }
    }
}


void Foam::particleCoupling::map()
{
    dispersedParticles& p = particles_;
    kept_.restore(p);
    stats_.mapped += kept_.moved().size();
    if (!returnReduce(kept_.changed(), orOp<bool>()))
    {
        // n and the particles' volume are those of the exchange before
        ++stats_.keptMaps;
        return;
    }
    p.locate(mesh_);

    if (Pstream::parRun())
    {
        const scalarField claims(p.claims(mesh_));
        const std::vector<char> owned
        (
            session_->own({claims.begin(), claims.end()})
        );
        forAll(p.owned, i)
        {
            p.owned[i] = owned[i];
        }
    }

    volScalarField& n = history_.mapped();
    mapping_->map
    (
        p,
        sumShared_,
        n,
        smoothing_.operator->(),
        kept_.allMoved(p) ? nullptr : &kept_.moved()
    );
    kept_.keep(p);
    turnover_.compare(p, mesh_.nCells());

    scalar volume = 0;
    label outside = 0, larger = 0;
    forAll(p.owned, i)
    {
        if (p.owned[i])
        {
            volume += p.volume[i];
            outside += p.outside[i] > 1e-6*p.radius[i];
            larger += p.volume[i] > mesh_.V()[p.cell[i]];
        }
    }
    reduce(volume, sumOp<scalar>());
    reduce(outside, sumOp<label>());
    reduce(larger, sumOp<label>());

    // the largest count is warned of at the end
    if (outside > 0 && stats_.outside == 0)
    {
        Info<< "clayFoam: warning: at time " << session_->time() << " s "
            << outside << " particle centres lie outside the mesh" << endl;
    }
    stats_.outside = max(stats_.outside, outside);

    if (larger > 0 && mapping_->type() == "centre")
    {
        stats_.warn
        (
            "particles are larger than their cells; take voidFractionModel"
            " exactOverlap or larger cells"
        );
    }

    solidVolume_ = volume;
    // all ranks alike: the sum over them
    if (volume > 0)
    {
        const scalar mapped = gSum((1 - n.primitiveField())*mesh_.V());
        stats_.voidFractionError =
            max(stats_.voidFractionError, mag(mapped - volume)/volume);
    }
    stats_.clippedVolume =
        max(stats_.clippedVolume, mapping_->clippedVolume());
    if (mapping_->excessVolume() > 0)
    {
        stats_.warn
        (
            "more solid than voidFractionMin leaves room for; n is below it"
        );
    }
}


void Foam::particleCoupling::exchangeMomentum()
{
    dispersedParticles& p = particles_;
    const volScalarField nuEffective(nuEff());

    // all ranks alike: savedField() and the solver's call are collective
    if (!gradPSet_)
    {
        gradP_.primitiveFieldRef() = fvc::grad(p_)().primitiveField();
        gradP_.correctBoundaryConditions();
    }
    const fluidState fluid{U_, gradP_, nuEffective, rho_, gravity_};

    ledger_.settle
    (
        p,
        vectorField(p.size(), Zero),    // impulses come without buoyancy
        smoothing_()
    );

    const auto impulse = session_->impulse();
    const vector total(impulse[0], impulse[1], impulse[2]);
    vector known(Zero);
    scalar scale = 0;
    forAll(p.owned, i)
    {
        if (p.owned[i])
        {
            known += p.impulse[i];
            scale += mag(p.impulse[i]);
        }
    }
    reduce(known, sumOp<vector>());
    reduce(scale, sumOp<scalar>());

    // one that has gone had half a step's impulse after it was found gone
    const vector gone(total - lastImpulse_ - known);
    // all ranks alike: sums over them
    if (mag(gone) > 1e-11*scale)
    {
        ledger_.settleGone(gone, turnover_.lastGone(), smoothing_());
    }
    lastImpulse_ = total;
    stats_.momentumResidual = max
    (
        stats_.momentumResidual,
        ledger_.residual(total)
    );

    // with the answer foreseen no lag of the pressure is left to be damped
    const bool added = forces_.addedDensity() > 0;
    scalarField part(added ? mesh_.nCells() : 0, 1.0);
    if (added && !response_.active())
    {
        part = ledger_.follow(history_.mapped(), forces_.addedDensity());
    }
    forces_.evaluate
    (
        p,
        fluid,
        history_.mapped(),
        law_,
        elapsed(),
        part
    );

    vectorField& own = forces_.own();

    // the owner tells the other ranks that hold a part of the particle
    if (Pstream::parRun())
    {
        const int width = own.size() ? 7 : 4;
        std::vector<double> shared(width*p.size(), 0.0);
        forAll(p.owned, i)
        {
            if (p.owned[i])
            {
                double* s = &shared[width*i];
                s[0] = forces_.K[i];
                for (direction d = 0; d < 3; ++d)
                {
                    s[1 + d] = forces_.reacting[i][d];
                    if (width > 4)
                    {
                        s[4 + d] = own[i][d];
                    }
                }
            }
        }
        sumShared_(shared, width);
        forAll(p.owned, i)
        {
            const double* s = &shared[width*i];
            forces_.K[i] = s[0];
            forces_.reacting[i] = vector(s[1], s[2], s[3]);
            if (width > 4)
            {
                own[i] = vector(s[4], s[5], s[6]);
            }
        }
    }

    solids_.update(p, forces_.K, forces_.u, sumShared_);

    // the cells show the particles' own part besides: K (v + own - U)
    ledger_.setSources
    (
        p,
        own.size() ? vectorField(p.velocity + own) : p.velocity,
        forces_.K,
        forces_.reacting,
        forces_.addedMass,
        smoothing_()
    );
}


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
        ledger_.setReaction(p, forces_.reacting, smoothing_());
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


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::particleCoupling::next()
{
    while (true)
    {
        switch (session_->next(received_))
        {
            case clay::CfdSession::Event::closed:
            {
                return false;
            }
            case clay::CfdSession::Event::resumed:
            {
                checkBuoyancy();
                continue;
            }
            case clay::CfdSession::Event::state:
            {
                break;
            }
        }
        const clay::DemTerms& dem = session_->remoteTerms();

        if (mag(session_->time() - time_ - interval_) > 0.5*dem.step)
        {
            FatalErrorInFunction
                << "the DEM half sent its state of time " << session_->time()
                << " s, the fluid is at " << time_ + interval_ << " s of it"
                << exit(FatalError);
        }

        {
            stopwatch watch(stats_.mapping, &stats_.mappingCpu);
            take();
            map();
            exchangeMomentum();
        }
        ++stats_.exchanges;
        pending_ = true;

        lastInterval_ = stats_.exchanges > 1 ? elapsed() : 0;
        time_ = session_->time();
        const scalar remaining =
            std::round((dem.endTime - time_)/dem.step)*dem.step;
        interval_ =
            session_->last() ? 0 : min(dem.step*dem.interval, remaining);
        marched_ = 0;

        if (!(interval_ > 0.5*dem.step))
        {
            interval_ = 0;
            answer();
            continue;
        }

        scalarField jump;
        // all ranks alike: any() is that of all of them
        if (turnover_.any())
        {
            jump = (turnover_.gone() - turnover_.came())/mesh_.V();
            smoothing_().smooth(jump);
        }
        const bool changed = history_.begin
        (
            ddtType_, particles_, smoothing_(), solidVolume_, interval_, jump
        );
        if (changed)
        {
            stats_.warn
            (
                "particles were inserted or deleted: no flow is made of their"
                " volume"
            );
        }
        ledger_.begin(interval_);
        judgeInterval(interval_);

        const volScalarField& n = history_.mapped();
        // all ranks alike: so is each of these
        const bool stiff =
            ledger_.stiffness(n, interval_) > stiffLimit_
         || (
                properties_.has("pressureGradient")
             && ledger_.pressureStiffness(n, interval_) > 1
            );
        late_ = stiff || !properties_.overlap();
        // all ranks alike: the largest stiffness of all
        if (stiff)
        {
            foreseeAnswer();
            if (properties_.overlap() && stats_.stiffExchanges++ == 0)
            {
                Info<< "clayFoam: warning: at time " << time_
                    << " s drag is stiff for the coupling interval of "
                    << interval_
                    << " s: the fluid is solved first in such intervals"
                    << endl;
            }
        }
        else
        {
            response_.leave();
        }
        if (!late_)
        {
            answer();
        }
        return true;
    }
}


void Foam::particleCoupling::solved()
{
    checkFields();

    // all ranks alike: from settings and what is stiff on any of them
    if (pending_)
    {
        forces_.velocity(particles_, U_);
        // all ranks alike, too
        if (response_.active())
        {
            vectorField now(forces_.pressureForce(particles_, gradP_, rho_));
            shareOwned(now);
            forces_.reacting += now - pressureForce_;
        }
        answer();
    }
    if (properties_.verbose())
    {
        Info<< "clayFoam: time " << endOfInterval() << " s, particles "
            << returnReduce(particles_.size(), sumOp<label>())
            << ", owed to the fluid " << ledger_.owed()
            << " N s, largest momentum residual "
            << stats_.momentumResidual << endl;
    }
}
