// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "voidFractionModel.H"
#include "checkedNumber.H"
#include "modelCoeffs.H"
#include "smoothingModel.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(voidFractionModel, 0);
    defineRunTimeSelectionTable(voidFractionModel, dictionary);
}


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

void Foam::voidFractionModel::renew
(
    dispersedParticles& p,
    const labelList& moved
) const
{
    dispersedParticles some;
    some.setSize(moved.size());
    forAll(moved, k)
    {
        const label i = moved[k];
        some.position[k] = p.position[i];
        some.velocity[k] = p.velocity[i];
        some.radius[k] = p.radius[i];
        some.volume[k] = p.volume[i];
        some.mass[k] = p.mass[i];
        some.tag[k] = p.tag[i];
        some.cell[k] = p.cell[i];
        some.outside[k] = p.outside[i];
        some.owned[k] = p.owned[i];
    }
    weights(some);
    forAll(moved, k)
    {
        p.slack[moved[k]] = some.slack[k];
        p.divisor[moved[k]] = 1;
    }

    // moved is in ascending order
    const labelList offset(p.offset);
    DynamicList<label> cells;
    DynamicList<scalar> shares;
    cells.transfer(p.cellIndex);
    shares.transfer(p.weight);
    DynamicList<label>& newCells = p.cellIndex;
    DynamicList<scalar>& newShares = p.weight;
    newCells.reserve(cells.size() + some.weight.size());
    newShares.reserve(cells.size() + some.weight.size());
    label k = 0;
    for (label i = 0; i < p.size(); ++i)
    {
        const bool renewed = k < moved.size() && moved[k] == i;
        const label begin = renewed ? some.offset[k] : offset[i];
        const label end = renewed ? some.offset[k + 1] : offset[i + 1];
        p.offset[i] = newCells.size();
        for (label e = begin; e < end; ++e)
        {
            newCells.append(renewed ? some.cellIndex[e] : cells[e]);
            newShares.append(renewed ? some.weight[e] : shares[e]);
        }
        k += renewed;
    }
    p.offset[p.size()] = newCells.size();
}


void Foam::voidFractionModel::normalise
(
    dispersedParticles& p,
    const sharedSum& sumShared
) const
{
    std::vector<double> sums(p.size(), 0.0);

    // a rank may have kept what another has made anew: both as the model's
    for (label i = 0; i < p.size(); ++i)
    {
        for (label k = p.offset[i]; k < p.offset[i + 1]; ++k)
        {
            p.weight[k] *= p.divisor[i];
            sums[i] += p.weight[k];
        }
    }

    if (sumShared)
    {
        sumShared(sums, 1);
    }

    for (label i = 0; i < p.size(); ++i)
    {
        // a sphere in no cell at all belongs to the cell of its owner
        const bool lost = sums[i] < 1e-12;

        for (label k = p.offset[i]; k < p.offset[i + 1]; ++k)
        {
            p.weight[k] = lost ? 0 : p.weight[k]/sums[i];
        }
        p.divisor[i] = lost ? 0 : sums[i];
        if (lost && p.owned[i])
        {
            p.weight[p.offset[i]] = 1;
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::voidFractionModel::voidFractionModel
(
    const dictionary& dict,
    const fvMesh& mesh,
    const word& type,
    const wordList& entries
)
:
    clippedVolume_(0),
    excessVolume_(0),
    mesh_(mesh),
    coeffs_(modelCoeffs(dict, type, entries)),
    voidFractionMin_
    (
        numberBetween
        (
            dict,
            "voidFractionMin",
            dict.lookupOrDefault<scalar>("voidFractionMin", 0.2),
            0,
            1
        )
    )
{}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::voidFractionModel> Foam::voidFractionModel::New
(
    const dictionary& dict,
    const fvMesh& mesh
)
{
    const word type(dict.get<word>("voidFractionModel"));

    auto cstrIter = dictionaryConstructorTablePtr_->cfind(type);

    if (!cstrIter.found())
    {
        FatalIOErrorInFunction(dict)
            << "voidFractionModel " << type << " is not known; known are "
            << flatOutput(dictionaryConstructorTablePtr_->sortedToc())
            << exit(FatalIOError);
    }

    return cstrIter()(dict, mesh);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::voidFractionModel::map
(
    dispersedParticles& p,
    const sharedSum& sumShared,
    volScalarField& n,
    const smoothingModel* smoothing,
    const labelList* moved
)
{
    if (moved)
    {
        renew(p, *moved);
    }
    else
    {
        weights(p);
    }
    normalise(p, sumShared);

    scalarField alpha(mesh_.nCells(), 0.0);
    for (label i = 0; i < p.size(); ++i)
    {
        for (label k = p.offset[i]; k < p.offset[i + 1]; ++k)
        {
            alpha[p.cellIndex[k]] += p.weight[k]*p.volume[i];
        }
    }
    alpha /= mesh_.V();

    if (smoothing && smoothing->active())
    {
        smoothing->smooth(alpha);
    }
    limit(alpha);

    n.primitiveFieldRef() = 1 - alpha;
    n.correctBoundaryConditions();
}
