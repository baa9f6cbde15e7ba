// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "particleSums.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::particleSums::particleSums
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
    velocity_(mesh.nCells(), Zero)
{
    // all ranks alike: a setting, and hasSavedNumbers() is collective
    if (weighted_ && hasSavedNumbers(mesh))
    {
        readCells(mesh, "couplingDrag", K_);
        readCells(mesh, "couplingMass", mass_);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
void Foam::particleSums::spread
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


void Foam::particleSums::smooth
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


void Foam::particleSums::set
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


void Foam::particleSums::setReaction
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


void Foam::particleSums::approach(const volVectorField& U, const scalar time)
{
    forAll(velocity_, celli)
    {
        const vector& Uc = U[celli];
        if (mass_[celli] > VSMALL)
        {
            velocity_[celli] =
                Uc
              + (velocity_[celli] - Uc)*exp(-K_[celli]*time/inertia(celli));
        }
    }
}


void Foam::particleSums::save(stateWriter& to)
{
    // all ranks alike: a setting
    if (weighted_)
    {
        to.cells("couplingDrag", K_);
        to.cells("couplingMass", mass_);
    }
}


namespace Foam
{
template void particleSums::spread
(
    const dispersedParticles&, const vectorField&, vectorField&
) const;
}
