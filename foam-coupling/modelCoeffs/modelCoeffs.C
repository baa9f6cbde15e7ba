// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "modelCoeffs.H"
#include "FlatOutput.H"

// * * * * * * * * * * * * * * * Other Functions * * * * * * * * * * * * * * //

Foam::dictionary Foam::modelCoeffs
(
    const dictionary& dict,
    const word& model,
    const wordList& known
)
{
    const dictionary coeffs(dict.subOrEmptyDict(model + "Coeffs"));

    for (const entry& e : coeffs)
    {
        if (!known.found(e.keyword()))
        {
            FatalIOErrorInFunction(dict)
                << model << "Coeffs: unknown entry " << e.keyword()
                << "; known are " << flatOutput(known)
                << exit(FatalIOError);
        }
    }

    return coeffs;
}
