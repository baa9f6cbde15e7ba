// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "liftForce.H"

#include "modelCoeffs.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::liftForce::liftForce(const dictionary& dict, const word& type)
:
    finiteRe_
    (
        modelCoeffs(dict, type, {"finiteRe"})
       .lookupOrDefault<Switch>("finiteRe", true)
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::liftForce::act
(
    const dispersedParticles& p,
    const particleSurroundings& around,
    vectorField& force
) const
{
    forAll(force, i)
    {
        if (p.owned[i])
        {
            force[i] += lift
            (
                around.u[i] - p.velocity[i],
                turning(p, around, i),
                2*p.radius[i],
                around.nu[i],
                around.rho
            );
        }
    }
}
