// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "buoyancyForce.H"

#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace forceModels
{
    defineTypeNameAndDebug(buoyancy, 0);
    addToRunTimeSelectionTable(forceModel, buoyancy, dictionary);
}
}


void Foam::forceModels::buoyancy::add
(
    const fluidState& fluid,
    vectorField& force
) const
{
    force -= fluid.rho*fluid.gravity;
}
