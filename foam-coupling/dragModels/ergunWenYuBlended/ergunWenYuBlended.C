// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "ergunWenYuBlended.H"
#include "checkedNumber.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dragModels
{
    defineTypeNameAndDebug(ergunWenYuBlended, 0);
    addToRunTimeSelectionTable(dragModel, ergunWenYuBlended, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dragModels::ergunWenYuBlended::ergunWenYuBlended(const dictionary& dict)
:
    ergunWenYu(dict, typeName, {"width"}),
    width_(coeffs_.lookupOrDefault<scalar>("width", 0.1))
{
    numberAbove(dict, "ergunWenYuBlendedCoeffs: width", width_, 0);
    numberFrom(dict, "ergunWenYuBlendedCoeffs: width", width_, 0, 0.4);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dragModels::ergunWenYuBlended::coefficient
(
    const scalar n,
    const scalar slip,
    const scalar d,
    const scalar nu,
    const scalar rho
) const
{
    const scalar x = (n - 0.8)/width_ + 0.5;

    if (x <= 0)
    {
        return ergun(n, slip, d, nu, rho);
    }
    if (x >= 1)
    {
        return wenYu(n, slip, d, nu, rho);
    }

    const scalar s = x*x*x*(10 - 15*x + 6*x*x);

    return
        (1 - s)*ergun(n, slip, d, nu, rho)
      + s*wenYu(n, slip, d, nu, rho);
}
