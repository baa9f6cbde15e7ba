// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

// The course of an exchange, and the momentum in it.

#include "particleCoupling.H"

#include "fvc.H"

#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

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
        smoothing_(),
        forces_.bothWays()
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
        part = ledger_.sums().follow
        (
            history_.mapped(),
            forces_.addedDensity(),
            ledger_.interval()
        );
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
    ledger_.sums().set
    (
        p,
        own.size() ? vectorField(p.velocity + own) : p.velocity,
        forces_.K,
        forces_.reacting,
        forces_.addedMass,
        smoothing_()
    );
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
                // a further run may ask for other fields
                answers_ = clay::Particles(session_->sends());
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

        // all ranks alike: the DEM half tells all the same
        const bool saves = session_->pair().number > 0;
        if (saves)
        {
            // what a restart finds for itself
            kept_.forget();
        }
        {
            stopwatch watch(stats_.mapping, &stats_.mappingCpu);
            take();
            map();
        }
        // all ranks alike: as above
        if (saves)
        {
            savePair();
        }
        {
            stopwatch watch(stats_.mapping, &stats_.mappingCpu);
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
            ddtType_,
            particles_,
            smoothing_(),
            solidVolume_,
            interval_,
            jump,
            properties_.get<scalar>("voidFractionMin")
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
            ledger_.sums().stiffness(n, interval_) > stiffLimit_
         || (
                properties_.has("pressureGradient")
             && ledger_.sums().pressureStiffness(n, interval_) > 1
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
