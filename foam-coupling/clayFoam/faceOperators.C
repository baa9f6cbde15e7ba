// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "faceOperators.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- A scheme's words, one blank between
static string wordsOf(const tokenList& scheme)
{
    string text;
    for (const token& t : scheme)
    {
        if (!text.empty())
        {
            text += ' ';
        }
        text += t.isWord() ? string(t.wordToken()) : string("?");
    }
    return text;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::faceOperators::faceOperators(const fvMesh& mesh)
:
    mesh_(mesh),
    weights_(mesh.nFaces(), 1),
    Sf_(mesh.nFaces(), Zero),
    magSf_(mesh.nFaces(), Zero),
    normal_(mesh.nFaces(), Zero),
    deltaCoeffs_(mesh.nFaces(), Zero),
    inverse_(mesh.nCells(), Zero)
{
    take(mesh.weights(), weights_);
    take(mesh.Sf(), Sf_);
    take(mesh.magSf(), magSf_);
    take(mesh.nonOrthDeltaCoeffs(), deltaCoeffs_);

    const labelUList& own = mesh.owner();
    const labelUList& nei = mesh.neighbour();
    const auto add = [&](const label celli, const label f)
    {
        inverse_[celli] += normal_[f]*Sf_[f];
    };
    forAll(nei, f)
    {
        normal_[f] = Sf_[f]/magSf_[f];
        add(own[f], f);
        add(nei[f], f);
    }
    patches([&](const label, const fvPatch& patch)
    {
        forAll(patch, i)
        {
            const label f = patch.start() + i;
            normal_[f] = Sf_[f]/magSf_[f];
            add(patch.faceCells()[i], f);
        }
    });
    inverse_ = inv(tensorField(inverse_));

    take(mesh.nonOrthCorrectionVectors(), across_);
    scalar largest = 0;
    forAll(nei, f)
    {
        largest = max(largest, mag(across_[f]));
    }
    patches([&](const label, const fvPatch& patch)
    {
        forAll(patch, i)
        {
            largest = max(largest, mag(across_[patch.start() + i]));
        }
    });
    if (returnReduce(largest, maxOp<scalar>()) < 1e-9)
    {
        across_.clear();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::faceOperators::is
(
    const word& section,
    const word& name,
    const string& wanted
) const
{
    const string key(section + ' ' + name + ' ' + wanted);
    const auto found = known_.cfind(key);
    if (found.found())
    {
        return *found;
    }

    ITstream& scheme =
        section == "interpolationSchemes" ? mesh_.interpolationScheme(name)
      : section == "gradSchemes" ? mesh_.gradScheme(name)
      : section == "divSchemes" ? mesh_.divScheme(name)
      : section == "snGradSchemes" ? mesh_.snGradScheme(name)
      : mesh_.laplacianScheme(name);

    const bool same = wordsOf(scheme) == wanted;
    known_.insert(key, same);
    return same;
}


void Foam::faceOperators::flux
(
    const volVectorField& cells,
    const word& name,
    scalarField& faces
) const
{
    if (!is("interpolationSchemes", name, "linear"))
    {
        take
        (
            surfaceScalarField(fvc::interpolate(cells, name) & mesh_.Sf()),
            faces
        );
        return;
    }
    faces.setSize(mesh_.nFaces());

    const labelUList& own = mesh_.owner();
    const labelUList& nei = mesh_.neighbour();
    const vectorField& c = cells.primitiveField();
    forAll(nei, f)
    {
        const scalar w = weights_[f];
        faces[f] = Sf_[f] & (w*c[own[f]] + (1 - w)*c[nei[f]]);
    }

    patches([&](const label patchi, const fvPatch& patch)
    {
        const tmp<vectorField> tvalues(patchValues(cells, patchi));
        const vectorField& values = tvalues();
        forAll(values, i)
        {
            const label f = patch.start() + i;
            faces[f] = Sf_[f] & values[i];
        }
    });
}


void Foam::faceOperators::correction
(
    const volVectorField& gradient,
    scalarField& faces
) const
{
    faces.setSize(mesh_.nFaces());
    faces = Zero;
    if (orthogonal())
    {
        return;
    }

    const labelUList& own = mesh_.owner();
    const labelUList& nei = mesh_.neighbour();
    forAll(nei, f)
    {
        const scalar w = weights_[f];
        faces[f] =
            across_[f] & (w*gradient[own[f]] + (1 - w)*gradient[nei[f]]);
    }

    patches([&](const label patchi, const fvPatch& patch)
    {
        if (patch.coupled())
        {
            const tmp<vectorField> tvalues(patchValues(gradient, patchi));
            const vectorField& values = tvalues();
            forAll(values, i)
            {
                const label f = patch.start() + i;
                faces[f] = across_[f] & values[i];
            }
        }
    });
}


void Foam::faceOperators::reconstruct
(
    const scalarField& faces1,
    const scalarField& faces2,
    vectorField& cells1,
    vectorField& cells2
) const
{
    const labelUList& own = mesh_.owner();
    const labelUList& nei = mesh_.neighbour();

    cells1.setSize(mesh_.nCells());
    cells2.setSize(mesh_.nCells());
    cells1 = Zero;
    cells2 = Zero;
    forAll(nei, f)
    {
        const vector part1(normal_[f]*faces1[f]);
        const vector part2(normal_[f]*faces2[f]);
        cells1[own[f]] += part1;
        cells1[nei[f]] += part1;
        cells2[own[f]] += part2;
        cells2[nei[f]] += part2;
    }
    patches([&](const label, const fvPatch& patch)
    {
        const labelUList& inside = patch.faceCells();
        forAll(inside, i)
        {
            const label f = patch.start() + i;
            cells1[inside[i]] += normal_[f]*faces1[f];
            cells2[inside[i]] += normal_[f]*faces2[f];
        }
    });
    forAll(inverse_, celli)
    {
        cells1[celli] = inverse_[celli] & cells1[celli];
        cells2[celli] = inverse_[celli] & cells2[celli];
    }
}


void Foam::faceOperators::reconstruct
(
    const scalarField& faces,
    vectorField& cells
) const
{
    const labelUList& own = mesh_.owner();
    const labelUList& nei = mesh_.neighbour();

    cells.setSize(mesh_.nCells());
    cells = Zero;
    forAll(nei, f)
    {
        const vector part(normal_[f]*faces[f]);
        cells[own[f]] += part;
        cells[nei[f]] += part;
    }
    patches([&](const label, const fvPatch& patch)
    {
        const labelUList& inside = patch.faceCells();
        forAll(inside, i)
        {
            const label f = patch.start() + i;
            cells[inside[i]] += normal_[f]*faces[f];
        }
    });
    forAll(inverse_, celli)
    {
        cells[celli] = inverse_[celli] & cells[celli];
    }
}


// ************************************************************************* //
