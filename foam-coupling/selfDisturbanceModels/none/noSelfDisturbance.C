// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "noSelfDisturbance.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace selfDisturbanceModels
{
    defineTypeNameAndDebug(none, 0);
    addToRunTimeSelectionTable(selfDisturbanceModel, none, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::selfDisturbanceModels::none::none(const dictionary&, const setting&)
{}
