// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "magnusForce.H"

#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"
#include "modelCoeffs.H"

namespace Foam
{
namespace forceModels
{
    defineTypeNameAndDebug(magnus, 0);
    addToRunTimeSelectionTable(forceModel, magnus, dictionary);
}
}


Foam::forceModels::magnus::magnus(const dictionary& dict)
:
    finiteRe_
    (
        modelCoeffs(dict, typeName, {"finiteRe"})
       .lookupOrDefault<Switch>("finiteRe", true)
    )
{}


Foam::scalar Foam::forceModels::magnus::factor
(
    const scalar Re,
    const scalar ReSpin
)
{
    const scalar ratio = Re/ReSpin;

    return
        0.45*ratio
      + (1 - 0.45*ratio)*exp(-0.05684*pow(ReSpin, 0.4)*pow(Re, 0.3));
}


Foam::vector Foam::forceModels::magnus::lift
(
    const vector& slip,
    const vector& spin,
    const scalar d,
    const scalar nu,
    const scalar rho
) const
{
    const scalar s = mag(slip);
    const scalar w = mag(spin);
    if (s < VSMALL || w < VSMALL)
    {
        return Zero;
    }
    const scalar f = finiteRe_ ? factor(d*s/nu, sqr(d)*w/nu) : 1;

    return f*constant::mathematical::pi/8*rho*pow3(d)*(slip ^ spin);
}


void Foam::forceModels::magnus::act
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
                p.spin[i] - 0.5*around.vorticity[i],
                2*p.radius[i],
                around.nu[i],
                around.rho
            );
        }
    }
}
