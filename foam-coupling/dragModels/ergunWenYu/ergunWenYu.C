// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "ergunWenYu.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dragModels
{
    defineTypeNameAndDebug(ergunWenYu, 0);
    addToRunTimeSelectionTable(dragModel, ergunWenYu, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dragModels::ergunWenYu::ergunWenYu(const dictionary& dict)
:
    dragModel(dict, typeName)
{}


Foam::dragModels::ergunWenYu::ergunWenYu
(
    const dictionary& dict,
    const word& type,
    const wordList& entries
)
:
    dragModel(dict, type, entries)
{}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::dragModels::ergunWenYu::ergun
(
    const scalar n,
    const scalar slip,
    const scalar d,
    const scalar nu,
    const scalar rho
)
{
    return nu*rho/(d*d*n)*(150*(1 - n) + 1.75*reynolds(n, slip, d, nu));
}


Foam::scalar Foam::dragModels::ergunWenYu::wenYu
(
    const scalar n,
    const scalar slip,
    const scalar d,
    const scalar nu,
    const scalar rho
)
{
    return
        stokes(d, nu, rho)*pow(n, -2.7)
       *sphere(reynolds(n, slip, d, nu), 0.43);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dragModels::ergunWenYu::coefficient
(
    const scalar n,
    const scalar slip,
    const scalar d,
    const scalar nu,
    const scalar rho
) const
{
    return
        n < 0.8
      ? ergun(n, slip, d, nu, rho)
      : wenYu(n, slip, d, nu, rho);
}
