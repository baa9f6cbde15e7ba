// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "Ergun.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dragModels
{
    defineTypeNameAndDebug(Ergun, 0);
    addToRunTimeSelectionTable(dragModel, Ergun, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dragModels::Ergun::Ergun(const dictionary& dict)
:
    dragModel(dict, typeName)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dragModels::Ergun::coefficient
(
    const scalar n,
    const scalar slip,
    const scalar d,
    const scalar nu,
    const scalar rho
) const
{
    return 150*(1 - n)*nu*rho/(n*d*d) + 1.75*rho*slip/d;
}


Foam::scalar Foam::dragModels::Ergun::hindrance
(
    const scalar n,
    const scalar slip,
    const scalar d,
    const scalar nu,
    const scalar rho
) const
{
    return
        coefficient(n, slip, d, nu, rho)
       /(stokes(d, nu, rho)*sphere(reynolds(1, slip, d, nu), 0.44));
}
