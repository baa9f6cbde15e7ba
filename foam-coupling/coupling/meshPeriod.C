// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "meshPeriod.H"

#include "cyclicPolyPatch.H"
#include "FixedList.H"
#include "PstreamReduceOps.H"
#include "SubField.H"
#include "polyMesh.H"
#include "processorCyclicPolyPatch.H"

std::array<double, 3> Foam::meshPeriod(const polyMesh& mesh)
{
    vector length(Zero);
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (isA<cyclicPolyPatch>(patch) || isA<processorCyclicPolyPatch>(patch))
        {
            const auto& pair = refCast<const coupledPolyPatch>(patch);
            if (pair.size() && pair.parallel() && pair.separated())
            {
                length = max(length, cmptMag(pair.separation()[0]));
            }
        }
    }
    reduce(length, maxOp<vector>());

    // no flow across a mesh of one cell between empty patches
    const Vector<label>& flows = mesh.geometricD();
    const scalar small = 1e-9*mesh.bounds().mag();
    std::array<double, 3> period;
    for (direction k = 0; k < 3; ++k)
    {
        period[k] = flows[k] < 0 ? -1 : length[k] > small ? length[k] : 0;
    }
    return period;
}


std::array<bool, 6> Foam::openSides(const polyMesh& mesh)
{
    const boundBox box(mesh.points(), true);
    const scalar small = 1e-6*box.mag();
    FixedList<bool, 6> open(false);
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (patch.type() != polyPatch::typeName)
        {
            continue;
        }
        const vectorField centres(patch.faceCentres());
        for (const point& x : centres)
        {
            for (direction k = 0; k < 3; ++k)
            {
                open[2*k] = open[2*k] || mag(x[k] - box.min()[k]) < small;
                open[2*k + 1] =
                    open[2*k + 1] || mag(x[k] - box.max()[k]) < small;
            }
        }
    }
    std::array<bool, 6> sides;
    // all ranks alike: six sides
    for (direction k = 0; k < 6; ++k)
    {
        sides[k] = returnReduce(open[k], orOp<bool>());
    }
    return sides;
}
