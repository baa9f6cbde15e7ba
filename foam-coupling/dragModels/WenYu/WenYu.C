// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "WenYu.H"
#include "checkedNumber.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dragModels
{
    defineTypeNameAndDebug(WenYu, 0);
    addToRunTimeSelectionTable(dragModel, WenYu, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dragModels::WenYu::WenYu(const dictionary& dict)
:
    dragModel(dict, typeName, {"exponent", "newtonCd"}),
    exponent_(coeffs_.lookupOrDefault<scalar>("exponent", -2.65)),
    newtonCd_(coeffs_.lookupOrDefault<scalar>("newtonCd", 0.44))
{
    numberAbove
    (
        dict, "WenYuCoeffs: newtonCd", newtonCd_, 0, ", such as 0.44"
    );
    numberFrom
    (
        dict, "WenYuCoeffs: exponent", exponent_, -10, 0, ", such as -2.65"
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dragModels::WenYu::coefficient
(
    const scalar n,
    const scalar slip,
    const scalar d,
    const scalar nu,
    const scalar rho
) const
{
    return
        stokes(d, nu, rho)*pow(n, exponent_)
       *sphere(reynolds(n, slip, d, nu), newtonCd_);
}
