// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "dragModel.H"
#include "modelCoeffs.H"
#include "ListOps.H"
#include "FlatOutput.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(dragModel, 0);
    defineRunTimeSelectionTable(dragModel, dictionary);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dragModel::dragModel
(
    const dictionary& dict,
    const word& type,
    const wordList& entries
)
:
    coeffs_(modelCoeffs(dict, type, entries))
{}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dragModel> Foam::dragModel::New(const dictionary& dict)
{
    const word type(dict.get<word>("dragModel"));

    auto cstrIter = dictionaryConstructorTablePtr_->cfind(type);

    if (!cstrIter.found())
    {
        FatalIOErrorInFunction(dict)
            << "dragModel " << type << " is not known; known are "
            << flatOutput(dictionaryConstructorTablePtr_->sortedToc())
            << exit(FatalIOError);
    }

    return cstrIter()(dict);
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::dragModel::sphere(const scalar Re, const scalar newtonCd)
{
    if (Re > 1000)
    {
        return newtonCd*Re/24;
    }

    return 1 + 0.15*pow(Re, 0.687);
}
