// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "KochHill.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dragModels
{
    defineTypeNameAndDebug(KochHill, 0);
    addToRunTimeSelectionTable(dragModel, KochHill, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dragModels::KochHill::KochHill(const dictionary& dict)
:
    dragModel(dict, typeName)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dragModels::KochHill::coefficient
(
    const scalar n,
    const scalar slip,
    const scalar d,
    const scalar nu,
    const scalar rho
) const
{
    const scalar phi = max(1 - n, 0.0);
    const scalar Re = reynolds(n, slip, d, nu);

    scalar F0 = 1;

    if (phi > 0.4)
    {
        F0 = 10*phi/pow3(n);
    }
    else if (phi > 0)
    {
        F0 =
            (
                1 + 3*sqrt(phi/2) + (135.0/64)*phi*log(phi) + 16.14*phi
            )
           /(1 + phi*(0.681 + phi*(-8.48 + 8.16*phi)));
    }

    const scalar F3 = 0.0673 + 0.212*phi + 0.0232/pow5(n);

    return stokes(d, nu, rho)*sqr(n)*(F0 + 0.5*F3*Re);
}
