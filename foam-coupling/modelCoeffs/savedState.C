// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "savedState.H"

#include "IFstream.H"
#include "OSspecific.H"
#include "PstreamReduceOps.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- What every run goes on with
static const wordList stateParts
({
    "U", "p", "phi", "voidfraction", "gradp", "couplingImpulse"
});

} // End namespace Foam


// * * * * * * * * * * * * * * * Other Functions * * * * * * * * * * * * * * //

bool Foam::isSavedState(const fvMesh& mesh)
{
    // each rank writes its own
    const bool here =
        isFile(mesh.time().timePath()/"uniform"/"couplingState");
    return returnReduce(here, andOp<bool>());
}


void Foam::checkSavedState(const fvMesh& mesh)
{
    if (!isSavedState(mesh))
    {
        return;
    }
    const fileName folder(mesh.time().timePath());
    IFstream is(folder/"uniform"/"couplingState");
    wordList parts
    (
        dictionary(is).lookupOrDefault<wordList>("parts", stateParts)
    );
    // all ranks look for the same
    Pstream::scatter(parts);

    wordList missing;
    // all ranks alike: the master's list
    for (const word& part : parts)
    {
        const bool here = isFile(folder/part);
        if (!returnReduce(here, andOp<bool>()))
        {
            missing.append(part);
        }
    }
    if (missing.size())
    {
        string names;
        for (const word& part : missing)
        {
            names += (names.empty() ? "" : ", ") + part;
        }
        FatalErrorInFunction
            << "the saved state of time " << mesh.time().timeName()
            << " lacks " << names.c_str() << ", of the parts that"
            << " uniform/couplingState lists; bring them back, or take"
            << " uniform/couplingState away to start from U and p alone"
            << exit(FatalError);
    }
}


Foam::IOobject::readOption Foam::readState(const fvMesh& mesh)
{
    return isSavedState(mesh) ? IOobject::READ_IF_PRESENT : IOobject::NO_READ;
}


Foam::autoPtr<Foam::IOdictionary> Foam::stateMark
(
    const fvMesh& mesh,
    const wordList& more
)
{
    auto mark = autoPtr<IOdictionary>::New
    (
        IOobject
        (
            "couplingState",
            mesh.time().timeName(),
            "uniform",
            mesh.time(),
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        )
    );
    mark->add("writtenBy", word("clayFoam"));
    wordList parts(stateParts);
    parts.append(more);
    mark->add("parts", parts);
    return mark;
}


// ************************************************************************* //
