// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "viscousForce.H"

#include "addToRunTimeSelectionTable.H"
#include "fvc.H"

namespace Foam
{
namespace forceModels
{
    defineTypeNameAndDebug(viscous, 0);
    addToRunTimeSelectionTable(forceModel, viscous, dictionary);
}
}


void Foam::forceModels::viscous::add
(
    const fluidState& fluid,
    vectorField& force
) const
{
    force += fluid.rho*
    (
        fvc::laplacian(fluid.nuEff, fluid.U, "laplacian(nuEff,U)")
      + fvc::div
        (
            fluid.nuEff*dev2(T(fvc::grad(fluid.U))),
            "div((nuEff*dev2(T(grad(U)))))"
        )
    )().primitiveField();
}
