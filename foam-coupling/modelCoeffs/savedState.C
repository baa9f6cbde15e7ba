// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "savedState.H"

#include "OSspecific.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Other Functions * * * * * * * * * * * * * * //

bool Foam::isSavedState(const fvMesh& mesh)
{
    // each rank writes its own
    const bool here =
        isFile(mesh.time().timePath()/"uniform"/"couplingState");
    return returnReduce(here, andOp<bool>());
}


Foam::IOobject::readOption Foam::readState(const fvMesh& mesh)
{
    return isSavedState(mesh) ? IOobject::READ_IF_PRESENT : IOobject::NO_READ;
}


Foam::autoPtr<Foam::IOdictionary> Foam::stateMark(const fvMesh& mesh)
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
    return mark;
}


// ************************************************************************* //
