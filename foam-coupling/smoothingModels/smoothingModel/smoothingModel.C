// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "smoothingModel.H"
#include "modelCoeffs.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(smoothingModel, 0);
    defineRunTimeSelectionTable(smoothingModel, dictionary);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::smoothingModel::smoothingModel
(
    const dictionary& dict,
    const fvMesh& mesh,
    const word& type,
    const wordList& entries
)
:
    mesh_(mesh),
    coeffs_(modelCoeffs(dict, type, entries))
{}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::smoothingModel> Foam::smoothingModel::New
(
    const dictionary& dict,
    const fvMesh& mesh
)
{
    const word type(dict.lookupOrDefault<word>("smoothingModel", "none"));

    auto cstrIter = dictionaryConstructorTablePtr_->cfind(type);

    if (!cstrIter.found())
    {
        FatalIOErrorInFunction(dict)
            << "smoothingModel " << type << " is not known; known are "
            << flatOutput(dictionaryConstructorTablePtr_->sortedToc())
            << exit(FatalIOError);
    }

    return cstrIter()(dict, mesh);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::smoothingModel::thickness
(
    const fvMesh& mesh
)
{
    auto result = tmp<scalarField>::New(mesh.nCells());
    forAll(mesh.cells(), celli)
    {
        scalar largest = 0;
        for (const label facei : mesh.cells()[celli])
        {
            largest = max(largest, mag(mesh.faceAreas()[facei]));
        }
        result.ref()[celli] = mesh.V()[celli]/largest;
    }
    return result;
}


Foam::tmp<Foam::scalarField> Foam::smoothingModel::length(const fvMesh& mesh)
{
    auto result = tmp<scalarField>::New(mesh.nCells());
    forAll(mesh.cells(), celli)
    {
        scalar smallest = VGREAT;
        for (const label facei : mesh.cells()[celli])
        {
            smallest = min(smallest, mag(mesh.faceAreas()[facei]));
        }
        result.ref()[celli] = mesh.V()[celli]/smallest;
    }
    return result;
}


void Foam::smoothingModel::smooth(volScalarField& field) const
{
    // all ranks alike: the model
    if (active())
    {
        smooth(static_cast<scalarField&>(field.primitiveFieldRef()));
        field.correctBoundaryConditions();
    }
}


void Foam::smoothingModel::smooth(volVectorField& field) const
{
    // all ranks alike: the model
    if (active())
    {
        smooth(static_cast<vectorField&>(field.primitiveFieldRef()));
        field.correctBoundaryConditions();
    }
}
