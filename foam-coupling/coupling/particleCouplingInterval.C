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
            << " s; with " << interval/crossing << " s it is one" << endl;
    }
}


void Foam::particleCoupling::judgeModels()
{
    const dispersedParticles& p = particles_;
    const auto text = [](const scalar x)
    {
        std::ostringstream os;
        os << std::setprecision(2) << x;
        return os.str();
    };

    scalar size = 0, lightest = GREAT;
    forAll(p.owned, i)
    {
        if (p.owned[i])
        {
            size = max(size, 2*p.radius[i]/cbrt(mesh_.V()[p.cell[i]]));
            lightest = min(lightest, p.mass[i]/p.volume[i]);
        }
    }
    reduce(size, maxOp<scalar>());
    reduce(lightest, minOp<scalar>());

    if
    (
        size > 0.6 && mapping_->type() != "centre" && !smoothing_->active()
     && properties_.get<word>("selfDisturbance") == "none"
    )
    {
        stats_.warn
        (
            "spheres of " + text(size) + " cells: a sphere is mapped onto"
            " cells that hold little but itself and what it has set in motion:"
            " alone it settles 13 % too slowly in cells of 1 d at Re 150, 47 %"
            " too fast in cells of 2 d at low Re; take cells of at least 5 d,"
            " smoothingModel diffusion or selfDisturbance latticeMemory"
        );
    }
    if (lightest < 0.99*rho_ && !(forces_.addedDensity() > 0))
    {
        stats_.warn
        (
            "particles of " + text(lightest) + " kg/m3 are lighter than the"
            " fluid: without added mass they may swing, and sink where they"
            " should rise; list addedMass in forceModels"
        );
    }
    const scalar moved =
        solidVolume_ > 0 ? mapping_->clippedVolume()/solidVolume_ : 0;
    if (moved > 0.01)
    {
        stats_.warn
        (
            text(100*moved) + " % of the solid volume found no room in its own"
            " cells (voidFractionMin " + text(properties_.get<scalar>
            (
                "voidFractionMin"
            )) + ") and went to their neighbours: forces there are not those"
            " of the particles; the mesh must be thicker than the spheres, the"
            " cells larger"
        );
    }
}


void Foam::particleCoupling::judgeInterval(const scalar interval)
{
    const dispersedParticles& p = particles_;
    const scalarField& K = forces_.K;

    // all ranks alike: each counts every exchange
    if (stats_.exchanges == 1)
    {
        foretell(interval);
        judgeModels();
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

    if (waves_.look(p, U_, interval, crossing*interval))
    {
        stats_.warn
        (
            "the solid fraction goes up and down from cell to cell: a wave"
            " that the mesh makes, and speeds of settling with it; take"
            " smoothingModel diffusion with a bandwidth of two cells or auto."
            " How much is in cfd.json: cell_wave_correlation, -1"
            " for a pure wave, and cell_wave_amplitude, over the mean"
        );
    }
    stats_.waveCorrelation = waves_.correlation();
    stats_.waveAmplitude = waves_.amplitude();
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
