// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "centreVoidFraction.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace voidFractionModels
{
    defineTypeNameAndDebug(centre, 0);
    addToRunTimeSelectionTable(voidFractionModel, centre, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::voidFractionModels::centre::centre
(
    const dictionary& dict,
    const fvMesh& mesh
)
:
    voidFractionModel(dict, mesh, typeName)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::voidFractionModels::centre::weights(dispersedParticles& p) const
{
    p.clearRows();

    for (label i = 0; i < p.size(); ++i)
    {
        if (p.owned[i])
        {
            p.append(p.cell[i], 1);
        }
        p.endRow(i);
    }
}
