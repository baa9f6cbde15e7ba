// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

// What the sums say of the coupling's stiffness.

#include "particleSums.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalarField Foam::particleSums::follow
(
    const volScalarField& n,
    const scalar addedDensity,
    const scalar T
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
            mass_[celli] + f*addedDensity + K_[celli]*T;

        if (mass_[celli] > VSMALL && answer > inertia)
        {
            part[celli] = inertia/answer;
        }
    }
    return part;
}


Foam::scalar Foam::particleSums::stiffness
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


Foam::scalar Foam::particleSums::pressureStiffness
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
