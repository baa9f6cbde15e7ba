// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "SchillerNaumann.H"
#include "checkedNumber.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dragModels
{
    defineTypeNameAndDebug(SchillerNaumann, 0);
    addToRunTimeSelectionTable(dragModel, SchillerNaumann, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dragModels::SchillerNaumann::SchillerNaumann(const dictionary& dict)
:
    dragModel(dict, typeName, {"newtonCd"}),
    newtonCd_(coeffs_.lookupOrDefault<scalar>("newtonCd", 0.44))
{
    numberAbove
    (
        dict, "SchillerNaumannCoeffs: newtonCd", newtonCd_, 0, ", such as 0.44"
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dragModels::SchillerNaumann::coefficient
(
    const scalar n,
    const scalar slip,
    const scalar d,
    const scalar nu,
    const scalar rho
) const
{
    return stokes(d, nu, rho)*sphere(reynolds(1, slip, d, nu), newtonCd_);
}
