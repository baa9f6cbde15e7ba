// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "Beetstra.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dragModels
{
    defineTypeNameAndDebug(Beetstra, 0);
    addToRunTimeSelectionTable(dragModel, Beetstra, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dragModels::Beetstra::Beetstra(const dictionary& dict)
:
    dragModel(dict, typeName)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dragModels::Beetstra::coefficient
(
    const scalar n,
    const scalar slip,
    const scalar d,
    const scalar nu,
    const scalar rho
) const
{
    const scalar phi = 1 - n;
    const scalar Re = reynolds(n, slip, d, nu);

    scalar F = 10*phi/sqr(n) + sqr(n)*(1 + 1.5*sqrt(max(phi, 0.0)));

    // below this the term in Re is less than 1e-12 of the rest
    if (Re > 1e-11)
    {
        F +=
            0.413*Re/(24*sqr(n))
           *(1/n + 3*n*phi + 8.4*pow(Re, -0.343))
           /(1 + pow(10, 3*phi)*pow(Re, -0.5*(1 + 4*phi)));
    }

    return stokes(d, nu, rho)*n*F;
}
