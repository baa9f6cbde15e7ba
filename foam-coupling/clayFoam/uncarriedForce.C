// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "uncarriedForce.H"

#include "syncTools.H"

// * * * * * * * * * * * * * * * Other Functions * * * * * * * * * * * * * * //

Foam::scalar Foam::uncarriedForce
(
    const fvMesh& mesh,
    const faceOperators& faces,
    const vectorField& F,
    const scalarField& onFaces,
    vectorField& left
)
{
    const labelUList& own = mesh.owner();
    const labelUList& nei = mesh.neighbour();
    const scalarField& V = mesh.V();

    left.setSize(F.size());
    left = Zero;

    // what is missing of a cell's force by one of its faces
    const auto missing = [&](const label celli, const label f)
    {
        const vector& Sf = faces.Sf()[f];
        return vector
        (
            (V[celli]/faces.magSf()[f]*((Sf & F[celli]) - onFaces[f]))
           *(faces.inverse()[celli] & Sf)
        );
    };
    const auto share = [](const scalar mine, const scalar other)
    {
        return mine + other > VSMALL ? mine/(mine + other) : 0.5;
    };

    scalar size = 0;
    forAll(nei, f)
    {
        const label P = own[f], N = nei[f];
        const vector d(missing(P, f) + missing(N, f));
        const scalar part = share(V[P]*mag(F[P]), V[N]*mag(F[N]));
        left[P] += part*d;
        left[N] += (1 - part)*d;
        size += mag(d);
    }

    const label first = mesh.nInternalFaces();
    vectorField beyond(mesh.nFaces() - first, Zero);
    scalarField weight(beyond.size(), Zero);
    faces.patches([&](const label, const fvPatch& patch)
    {
        const labelUList& inside = patch.faceCells();
        forAll(inside, i)
        {
            const label f = patch.start() + i, celli = inside[i];
            beyond[f - first] = missing(celli, f);
            weight[f - first] = V[celli]*mag(F[celli]);
        }
    });
    const vectorField here(beyond);
    const scalarField mine(weight);
    syncTools::swapBoundaryFaceList(mesh, beyond);
    syncTools::swapBoundaryFaceList(mesh, weight);
    faces.patches([&](const label, const fvPatch& patch)
    {
        const labelUList& inside = patch.faceCells();
        forAll(inside, i)
        {
            const label b = patch.start() + i - first;
            if (patch.coupled())
            {
                const vector d(here[b] + beyond[b]);
                left[inside[i]] += share(mine[b], weight[b])*d;
                size += 0.5*mag(d);
            }
            else
            {
                left[inside[i]] += here[b];
                size += mag(here[b]);
            }
        }
    });
    return size;
}


// ************************************************************************* //
