// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "noSmoothing.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace smoothingModels
{
    defineTypeNameAndDebug(none, 0);
    addToRunTimeSelectionTable(smoothingModel, none, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::smoothingModels::none::none(const dictionary& dict, const fvMesh& mesh)
:
    smoothingModel(dict, mesh, typeName)
{}
