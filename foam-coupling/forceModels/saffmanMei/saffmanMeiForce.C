// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "saffmanMeiForce.H"

#include "addToRunTimeSelectionTable.H"
#include "modelCoeffs.H"

namespace Foam
{
namespace forceModels
{
    defineTypeNameAndDebug(saffmanMei, 0);
    addToRunTimeSelectionTable(forceModel, saffmanMei, dictionary);
}
}


Foam::forceModels::saffmanMei::saffmanMei(const dictionary& dict)
:
    finiteRe_
    (
        modelCoeffs(dict, typeName, {"finiteRe"})
       .lookupOrDefault<Switch>("finiteRe", true)
    )
{}


Foam::scalar Foam::forceModels::saffmanMei::factor
(
    const scalar Re,
    const scalar b
)
{
    if (Re > 40)
    {
        return 0.0524*sqrt(b*Re);
    }
    const scalar g = 0.3314*sqrt(b);
    return (1 - g)*exp(-Re/10) + g;
}


Foam::vector Foam::forceModels::saffmanMei::lift
(
    const vector& slip,
    const vector& vorticity,
    const scalar d,
    const scalar nu,
    const scalar rho
) const
{
    const scalar s = mag(slip);
    const scalar w = mag(vorticity);
    if (s < VSMALL || w < VSMALL)
    {
        return Zero;
    }
    const scalar f = finiteRe_ ? factor(d*s/nu, 0.5*d*w/s) : 1;

    return 1.615*sqr(d)*rho*sqrt(nu/w)*f*(slip ^ vorticity);
}


void Foam::forceModels::saffmanMei::act
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
                around.vorticity[i],
                2*p.radius[i],
                around.nu[i],
                around.rho
            );
        }
    }
}
