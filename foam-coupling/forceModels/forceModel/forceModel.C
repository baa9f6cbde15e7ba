// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "forceModel.H"

namespace Foam
{
    defineTypeNameAndDebug(forceModel, 0);
    defineRunTimeSelectionTable(forceModel, dictionary);
}


Foam::autoPtr<Foam::forceModel> Foam::forceModel::New
(
    const word& name,
    const dictionary& dict
)
{
    auto cstrIter = dictionaryConstructorTablePtr_->cfind(name);

    if (!cstrIter.found())
    {
        FatalIOErrorInFunction(dict)
            << "forceModels: force " << name << " is not known; known are "
            << flatOutput(dictionaryConstructorTablePtr_->sortedToc())
            << exit(FatalIOError);
    }

    return cstrIter()(dict);
}
