// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "heightProfile.H"

#include "addToRunTimeSelectionTable.H"
#include "volFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{

defineTypeNameAndDebug(heightProfile, 0);
addToRunTimeSelectionTable(functionObject, heightProfile, dictionary);

} // End namespace functionObjects
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::functionObjects::heightProfile::heightProfile
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    writeFile(mesh_, name, name, dict),
    levels_(1)
{
    read(dict);
    if (Pstream::master())
    {
        writeHeader(file(), "The fluid over height");
        writeCommented(file(), "time [s]");
        for (const char* column : {"z [m]", "n", "n Uz [m/s]", "p [m2/s2]"})
        {
            writeTabbed(file(), column);
        }
        file() << endl;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::heightProfile::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    writeFile::read(dict);
    levels_ = dict.get<label>("levels");
    if (levels_ < 1)
    {
        FatalIOErrorInFunction(dict)
            << "levels is " << levels_ << "; it must be 1 or more"
            << exit(FatalIOError);
    }
    return true;
}


bool Foam::functionObjects::heightProfile::execute()
{
    return true;
}


bool Foam::functionObjects::heightProfile::write()
{
    const volScalarField& n = lookupObject<volScalarField>("voidfraction");
    const volScalarField& p = lookupObject<volScalarField>("p");
    const volVectorField& U = lookupObject<volVectorField>("U");

    const scalar foot = mesh_.bounds().min().z();
    const scalar top = mesh_.bounds().max().z();
    scalarField V(levels_, Zero), z(V), space(V), flux(V), pressure(V);
    forAll(n, celli)
    {
        const scalar v = mesh_.V()[celli];
        const scalar height = mesh_.C()[celli].z() - foot;
        const label level =
            min(max(label(levels_*height/(top - foot)), 0), levels_ - 1);
        V[level] += v;
        z[level] += v*height;
        space[level] += v*n[celli];
        flux[level] += v*n[celli]*U[celli].z();
        pressure[level] += v*p[celli];
    }
    for (scalarField* sums : {&V, &z, &space, &flux, &pressure})
    {
        reduce(*sums, sumOp<scalarField>());
    }

    if (Pstream::master())
    {
        for (label level = 0; level < levels_; ++level)
        {
            if (V[level] > 0)
            {
                writeCurrentTime(file());
                for (const scalarField* sums : {&z, &space, &flux, &pressure})
                {
                    file() << token::TAB << (*sums)[level]/V[level];
                }
                file() << endl;
            }
        }
    }
    return true;
}


// ************************************************************************* //
