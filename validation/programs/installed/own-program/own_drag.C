// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
// A drag law of this project, in a program of one's own.
#include "dictionary.H"
#include "dragModel.H"
#include "IOstreams.H"

int main()
{
    Foam::dictionary dict;
    dict.add("dragModel", Foam::word("Stokes"));
    const Foam::autoPtr<Foam::dragModel> law(Foam::dragModel::New(dict));

    // 18 mu/d^2 of 1 mm in water
    Foam::Info<< "coefficient "
        << law->coefficient(1, 0, 1e-3, 1e-6, 1000) << Foam::endl;
    return 0;
}
