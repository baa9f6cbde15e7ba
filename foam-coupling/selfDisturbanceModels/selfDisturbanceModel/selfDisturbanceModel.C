// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "selfDisturbanceModel.H"
#include "FlatOutput.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(selfDisturbanceModel, 0);
    defineRunTimeSelectionTable(selfDisturbanceModel, dictionary);
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::selfDisturbanceModel> Foam::selfDisturbanceModel::New
(
    const dictionary& dict,
    const setting& s
)
{
    const word type(dict.lookupOrDefault<word>("selfDisturbance", "none"));

    auto cstrIter = dictionaryConstructorTablePtr_->cfind(type);

    if (!cstrIter.found())
    {
        FatalIOErrorInFunction(dict)
            << "selfDisturbance " << type << " is not known; known are "
            << flatOutput(dictionaryConstructorTablePtr_->sortedToc())
            << exit(FatalIOError);
    }

    return cstrIter()(dict, s);
}
