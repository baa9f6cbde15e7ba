// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "addedMassForce.H"
#include "checkedNumber.H"

#include "savedState.H"

#include "addToRunTimeSelectionTable.H"
#include "fvc.H"
#include "modelCoeffs.H"
#include "zeroGradientFvPatchFields.H"

namespace Foam
{
namespace forceModels
{
    defineTypeNameAndDebug(addedMass, 0);
    addToRunTimeSelectionTable(forceModel, addedMass, dictionary);
}
}


Foam::forceModels::addedMass::addedMass(const dictionary& dict)
:
    Cm_
    (
        modelCoeffs(dict, typeName, {"Cm"})
       .lookupOrDefault<scalar>("Cm", 0.5)
    ),
    lastTime_(0)
{
    numberAbove
    (
        dict, "addedMassCoeffs: Cm", Cm_, 0, "; a sphere alone has 0.5"
    );
}


void Foam::forceModels::addedMass::prepare(const fluidState& fluid)
{
    const fvMesh& mesh = fluid.U.mesh();
    const scalar now = mesh.time().value();

    if (!DUDt_)
    {
        DUDt_.reset
        (
            new volVectorField
            (
                IOobject
                (
                    "DUDt",
                    mesh.time().timeName(),
                    mesh,
                    readState(fluid.U.mesh()),
                    IOobject::AUTO_WRITE
                ),
                mesh,
                dimensionedVector(dimAcceleration, Zero),
                zeroGradientFvPatchVectorField::typeName
            )
        );
        lastTime_ = now;
        const dictionary saved(savedNumbers(mesh));
        // all ranks alike: savedNumbers() is collective
        if (!saved.empty())
        {
            readCells(mesh, "addedMassU", lastU_);
            saved.readEntry("addedMassTime", lastTime_);
        }
    }
    // all ranks alike: they share their time
    if (now > lastTime_)
    {
        DUDt_->primitiveFieldRef() =
            (fluid.U.primitiveField() - lastU_)/(now - lastTime_)
          + (fluid.U & fvc::grad(fluid.U))().primitiveField();
        DUDt_->correctBoundaryConditions();
    }

    lastU_ = fluid.U.primitiveField();
    lastTime_ = now;
}


void Foam::forceModels::addedMass::add
(
    const fluidState& fluid,
    vectorField& force
) const
{
    force += Cm_*fluid.rho*DUDt_->primitiveField();
}


void Foam::forceModels::addedMass::save(stateWriter& to)
{
    to.cells("addedMassU", lastU_);
    to.numbers().set("addedMassTime", lastTime_);
}
