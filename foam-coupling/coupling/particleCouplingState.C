// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

// The state that the DEM half has sent: its particles, and the void fraction
// that they make.

#include "particleCoupling.H"

#include <algorithm>
#include <cmath>
#include <sstream>

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


void Foam::particleCoupling::fitKernel()
{
    // all ranks alike: by the settings, and what was found for all of them
    if (!smoothing_->fits() || smoothing_->bandwidth() > 0)
    {
        return;
    }
    const dispersedParticles& p = particles_;
    scalar volume = 0, diameters = 0;
    forAll(p.owned, i)
    {
        if (p.owned[i])
        {
            volume += p.volume[i];
            diameters += p.volume[i]*2*p.radius[i];
        }
    }
    reduce(volume, sumOp<scalar>());
    reduce(diameters, sumOp<scalar>());
    // all ranks alike: the sum over them
    if (volume > 0)
    {
        const scalar bodies = session_->remoteTerms().bodyDiameter;
        kernelDiameter_ = bodies > 0 ? bodies : diameters/volume;
        smoothing_->fit(kernelDiameter_);

        const scalar longest =
            gSum(smoothingModel::length(mesh_)*mesh_.V())/gSum(mesh_.V());
        // all ranks alike: sums over them
        if (longest > 1.5*smoothing_->bandwidth())
        {
            std::ostringstream os;
            os  << "cells are " << longest << " m long in the mean, the"
                << " smoothing's bandwidth is " << smoothing_->bandwidth()
                << " m: the top of a suspension that settles along them hangs"
                << " on the mesh by a percent or two; shorter cells, or a"
                << " wider bandwidth, do not";
            stats_.warn(os.str());
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
        turnover_.rest();
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

    fitKernel();

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
            stats_.weightSumMin = min(stats_.weightSumMin, p.divisor[i]);
            stats_.weightSumMax = max(stats_.weightSumMax, p.divisor[i]);
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
