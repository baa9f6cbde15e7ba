// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "pressureGradientForce.H"

#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace forceModels
{
    defineTypeNameAndDebug(pressureGradient, 0);
    addToRunTimeSelectionTable(forceModel, pressureGradient, dictionary);
}
}


void Foam::forceModels::pressureGradient::add
(
    const fluidState& fluid,
    vectorField& force
) const
{
    force -= fluid.rho*fluid.gradP.primitiveField();
}
