// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "voidFractionModel.H"
#include "syncTools.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// The cells on both sides of each face: internal faces, then coupled ones with
// the neighbour's value from another rank
template<class Op>
void eachSide
(
    const Foam::fvMesh& mesh,
    const Op& op        // (cell, neighbour or -1, boundary face or -1)
)
{
    using namespace Foam;

    const labelUList& owner = mesh.faceOwner();
    const labelUList& neighbour = mesh.faceNeighbour();

    forAll(neighbour, facei)
    {
        op(owner[facei], neighbour[facei], -1);
        op(neighbour[facei], owner[facei], -1);
    }
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (patch.coupled())
        {
            forAll(patch, k)
            {
                op
                (
                    patch.faceCells()[k], -1,
                    patch.start() + k - mesh.nInternalFaces()
                );
            }
        }
    }
}

// a cell field with the values across the coupled faces
class sides
{
    const Foam::scalarField& here_;
    Foam::scalarField there_;

public:

    //- Collective.
    sides(const Foam::fvMesh& mesh, const Foam::scalarField& values)
    :
        here_(values)
    {
        Foam::syncTools::swapBoundaryCellList(mesh, values, there_);
    }

    Foam::scalar operator()(Foam::label neighbour, Foam::label face) const
    {
        return neighbour >= 0 ? here_[neighbour] : there_[face];
    }
};

}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

// In each round a cell that is too full hands its excess to the cells beside
// it: to those with room, in proportion to their room; where none has room, in
// equal shares to those nearer to a cell with room. Both sides of a processor
// face work from the same numbers, so that what leaves one rank reaches the
// other.
void Foam::voidFractionModel::limit(scalarField& alpha)
{
    const scalarField& V = mesh_.V();
    const scalar most = 1 - voidFractionMin_;
    const scalar unknown = 1e6;

    clippedVolume_ = 0;
    excessVolume_ = 0;

    // faces to the next cell with room, put right a little every round
    scalarField steps;

    // all ranks alike: left on sums over them
    for (label round = 0; round < 1000; ++round)
    {
        // rounding alone is no reason for a further round
        const scalarField excess(V*max(alpha - most*(1 + 1e-12), 0.0));
        excessVolume_ = gSum(excess);

        if (round == 0)
        {
            clippedVolume_ = excessVolume_;
            steps = scalarField(alpha.size(), unknown);
        }
        if (excessVolume_ <= 0)
        {
            break;
        }

        scalarField room(V*max(most - alpha, 0.0));
        room *= pos(room - 1e-9*most*V);
        if (gSum(room) <= 0)
        {
            break;
        }

        const sides farRoom(mesh_, room);
        {
            const sides farSteps(mesh_, steps);
            scalarField next(alpha.size(), unknown);
            eachSide
            (
                mesh_,
                [&](const label celli, const label nei, const label facei)
                {
                    next[celli] = min(next[celli], farSteps(nei, facei) + 1);
                }
            );
            forAll(steps, celli)
            {
                steps[celli] = room[celli] > 0 ? 0 : min(next[celli], unknown);
            }
        }
        const sides farSteps(mesh_, steps);

        scalarField roomBeside(alpha.size(), 0.0);
        scalarField ways(alpha.size(), 0.0);
        eachSide
        (
            mesh_,
            [&](const label celli, const label nei, const label facei)
            {
                roomBeside[celli] += farRoom(nei, facei);
                ways[celli] += farSteps(nei, facei) < steps[celli];
            }
        );

        // per unit of a neighbour's room, and for each way out [m3]
        scalarField perRoom(alpha.size(), 0.0);
        scalarField perWay(alpha.size(), 0.0);
        forAll(excess, celli)
        {
            if (excess[celli] > 0 && roomBeside[celli] > 0)
            {
                perRoom[celli] = excess[celli]/roomBeside[celli];
            }
            else if (excess[celli] > 0 && ways[celli] > 0)
            {
                perWay[celli] = excess[celli]/ways[celli];
            }
        }
        const sides farPerRoom(mesh_, perRoom);
        const sides farPerWay(mesh_, perWay);

        scalarField gained(alpha.size(), 0.0);
        eachSide
        (
            mesh_,
            [&](const label celli, const label nei, const label facei)
            {
                const scalar there = farSteps(nei, facei);
                gained[celli] +=
                    farPerRoom(nei, facei)*room[celli]
                  - perRoom[celli]*farRoom(nei, facei)
                  + farPerWay(nei, facei)*(steps[celli] < there)
                  - perWay[celli]*(there < steps[celli]);
            }
        );
        alpha += gained/V;
    }
}
