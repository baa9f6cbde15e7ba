// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "SyamlalOBrien.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dragModels
{
    defineTypeNameAndDebug(SyamlalOBrien, 0);
    addToRunTimeSelectionTable(dragModel, SyamlalOBrien, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dragModels::SyamlalOBrien::SyamlalOBrien(const dictionary& dict)
:
    dragModel(dict, typeName)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dragModels::SyamlalOBrien::coefficient
(
    const scalar n,
    const scalar slip,
    const scalar d,
    const scalar nu,
    const scalar rho
) const
{
    const scalar Re = reynolds(1, slip, d, nu);
    const scalar A = pow(n, 4.14);
    const scalar B = n <= 0.85 ? 0.8*pow(n, 1.28) : pow(n, 2.65);
    const scalar x = 0.06*Re;
    const scalar Vr = 0.5*(A - x + sqrt(sqr(x) + 2*x*(2*B - A) + sqr(A)));

    // C_D |u - v|, finite at no slip
    const scalar CdSlip = sqr(0.63*sqrt(slip) + 4.8*sqrt(Vr*nu/d));

    return 0.75*n*rho*CdSlip/(sqr(Vr)*d);
}
