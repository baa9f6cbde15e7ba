// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

// The coupling interval: its length, and what it leaves unresolved.

#include "particleCoupling.H"

#include "mathematicalConstants.H"

#include <iomanip>
#include <sstream>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::particleCoupling::elapsed() const
{
    const scalar step = session_->remoteTerms().step;
    return std::round((session_->time() - time_)/step)*step;
}


void Foam::particleCoupling::foretell(const scalar interval)
{
    const dispersedParticles& p = particles_;
    scalar crossing = 0;
    forAll(p.owned, i)
    {
        if (!p.owned[i])
        {
            continue;
        }
        // weight without buoyancy = 3 pi mu d v (1 + 0.15 Re^0.687)
        const scalar d = 2*p.radius[i];
        const scalar stokes =
            mag(p.mass[i] - rho_*p.volume[i])
           *mag(p.gravity.size() ? p.gravity[i] : gravity_)
           /(3*constant::mathematical::pi*rho_*nu_*d);
        scalar v = stokes;
        for (label k = 0; k < 40; ++k)
        {
            v = sqrt(v*stokes/(1 + 0.15*pow(v*d/nu_, 0.687)));
        }
        crossing = max(crossing, v/cbrt(mesh_.V()[p.cell[i]]));
    }
    crossing = returnReduce(crossing, maxOp<scalar>())*interval;

    if (crossing > 1)
    {
        Info<< "clayFoam: warning: a particle that settles by itself crosses "
            << crossing << " cells in the coupling interval of " << interval
            << " s; " << interval/crossing << " s would be one" << endl;
    }
}


void Foam::particleCoupling::judgeInterval(const scalar interval)
{
    const dispersedParticles& p = particles_;
    const scalarField& K = forces_.K;

    if (stats_.exchanges == 1)
    {
        foretell(interval);
    }

    // by places in the list: a particle that has moved in it is passed over
    scalar change = 0, sum = 0, crossing = 0, relaxations = 0;
    forAll(K, i)
    {
        if (!p.owned[i])
        {
            continue;
        }
        if (i < oldTag_.size() && oldTag_[i] == p.tag[i])
        {
            change += mag(K[i] - oldK_[i]);
            sum += K[i];
        }
        // cubed: v^3/V
        const scalar v2 = magSqr(p.velocity[i]);
        crossing = max(crossing, v2*sqrt(v2)/mesh_.V()[p.cell[i]]);
        relaxations = max(relaxations, K[i]/p.mass[i]);
    }
    reduce(change, sumOp<scalar>());
    reduce(sum, sumOp<scalar>());
    crossing = cbrt(returnReduce(crossing, maxOp<scalar>()));
    reduce(relaxations, maxOp<scalar>());
    oldK_ = K;
    oldTag_ = p.tag;

    stats_.dragChange += change;
    stats_.dragSum += sum;
    stats_.crossing = max(stats_.crossing, crossing*interval);
    stats_.relaxations = max(stats_.relaxations, relaxations*interval);
}


void Foam::particleCoupling::warnOfInterval()
{
    const auto number = [](const scalar x)
    {
        std::ostringstream os;
        os << std::setprecision(2) << x;
        return os.str();
    };

    if (stats_.dragChange > 0.1*stats_.dragSum)
    {
        stats_.warn
        (
            "the drag coefficients change by "
          + number(100*stats_.dragChange/stats_.dragSum)
          + " % in a coupling interval on the mean, and are held in it: the"
            " drag is off by half of that; a shorter interval resolves it"
        );
    }
    if (stats_.crossing > 0.5)
    {
        stats_.warn
        (
            "particles cross up to " + number(stats_.crossing)
          + " cells in a coupling interval: void fraction and drag lag behind"
            " by as much"
        );
    }
    if (stats_.relaxations > 1)
    {
        stats_.warn
        (
            "the coupling interval is up to " + number(stats_.relaxations)
          + " times a particle's relaxation time: changes of the fluid's"
            " velocity within it reach the particle at its end"
        );
    }
}
