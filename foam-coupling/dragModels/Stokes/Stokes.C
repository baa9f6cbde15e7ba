// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "Stokes.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dragModels
{
    defineTypeNameAndDebug(Stokes, 0);
    addToRunTimeSelectionTable(dragModel, Stokes, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dragModels::Stokes::Stokes(const dictionary& dict)
:
    dragModel(dict, typeName)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dragModels::Stokes::coefficient
(
    const scalar n,
    const scalar slip,
    const scalar d,
    const scalar nu,
    const scalar rho
) const
{
    return stokes(d, nu, rho);
}
