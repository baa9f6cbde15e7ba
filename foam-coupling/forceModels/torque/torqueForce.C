// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "torqueForce.H"

#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"

namespace Foam
{
namespace forceModels
{
    defineTypeNameAndDebug(torque, 0);
    addToRunTimeSelectionTable(forceModel, torque, dictionary);
}
}


Foam::scalar Foam::forceModels::torque::turnCoefficient
(
    const scalar mu,
    const scalar d
) const
{
    return constant::mathematical::pi*mu*pow3(d);
}
