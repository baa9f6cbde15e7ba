// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "DiFelice.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dragModels
{
    defineTypeNameAndDebug(DiFelice, 0);
    addToRunTimeSelectionTable(dragModel, DiFelice, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dragModels::DiFelice::DiFelice(const dictionary& dict)
:
    dragModel(dict, typeName)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dragModels::DiFelice::coefficient
(
    const scalar n,
    const scalar slip,
    const scalar d,
    const scalar nu,
    const scalar rho
) const
{
    const scalar Re = reynolds(n, slip, d, nu);

    // far below any Reynolds number of use chi is 3.7 to rounding
    const scalar x = 1.5 - log10(max(Re, 1e-30));
    const scalar chi = 3.7 - 0.65*exp(-0.5*x*x);

    return
        0.75*nu*rho/(d*d)*sqr(0.63*sqrt(Re) + 4.8)*pow(n, 1 - chi);
}
