// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "Gidaspow.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dragModels
{
    defineTypeNameAndDebug(Gidaspow, 0);
    addToRunTimeSelectionTable(dragModel, Gidaspow, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dragModels::Gidaspow::Gidaspow(const dictionary& dict)
:
    dragModel(dict, typeName)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dragModels::Gidaspow::coefficient
(
    const scalar n,
    const scalar slip,
    const scalar d,
    const scalar nu,
    const scalar rho
) const
{
    if (n < 0.8)
    {
        return 150*(1 - n)*nu*rho/(n*d*d) + 1.75*rho*slip/d;
    }

    return
        stokes(d, nu, rho)*pow(n, -2.65)
       *sphere(reynolds(n, slip, d, nu), 0.44);
}
