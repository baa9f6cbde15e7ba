// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#ifndef faceOperatorsTemplates_C
#define faceOperatorsTemplates_C

#include "faceOperators.H"

#include "fvc.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type>
Foam::tmp<Foam::Field<Type>> Foam::faceOperators::patchValues
(
    const GeometricField<Type, fvPatchField, volMesh>& cells,
    const label patchi
) const
{
    const fvPatchField<Type>& values = cells.boundaryField()[patchi];
    if (!values.coupled())
    {
        return values;
    }

    const labelUList& own = values.patch().faceCells();
    auto tfaces = tmp<Field<Type>>::New(values.patchNeighbourField());
    Field<Type>& faces = tfaces.ref();
    forAll(faces, i)
    {
        const scalar w = weights_[values.patch().start() + i];
        faces[i] = w*cells[own[i]] + (1 - w)*faces[i];
    }
    return tfaces;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Function>
void Foam::faceOperators::patches(const Function& f) const
{
    forAll(mesh_.boundary(), patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        if (patch.size())
        {
            f(patchi, patch);
        }
    }
}


template<class Type>
void Foam::faceOperators::take
(
    const GeometricField<Type, fvsPatchField, surfaceMesh>& field,
    Field<Type>& faces
) const
{
    faces.setSize(mesh_.nFaces());
    std::copy(field.cbegin(), field.cend(), faces.begin());
    patches([&](const label patchi, const fvPatch& patch)
    {
        const auto& values = field.boundaryField()[patchi];
        std::copy(values.begin(), values.end(), faces.begin() + patch.start());
    });
}


template<class Type>
void Foam::faceOperators::put
(
    const Field<Type>& faces,
    GeometricField<Type, fvsPatchField, surfaceMesh>& field
) const
{
    Field<Type>& inner = field.primitiveFieldRef();
    std::copy(faces.begin(), faces.begin() + inner.size(), inner.begin());
    auto& outer = field.boundaryFieldRef();
    patches([&](const label patchi, const fvPatch& patch)
    {
        const auto from = faces.begin() + patch.start();
        std::copy(from, from + patch.size(), outer[patchi].begin());
    });
}


template<class Type>
void Foam::faceOperators::interpolate
(
    const GeometricField<Type, fvPatchField, volMesh>& cells,
    const word& name,
    Field<Type>& faces
) const
{
    if (!is("interpolationSchemes", name, "linear"))
    {
        take(fvc::interpolate(cells, name)(), faces);
        return;
    }
    linear(cells, faces);
}


template<class Type>
void Foam::faceOperators::linear
(
    const GeometricField<Type, fvPatchField, volMesh>& cells,
    Field<Type>& faces
) const
{
    faces.setSize(mesh_.nFaces());

    const labelUList& own = mesh_.owner();
    const labelUList& nei = mesh_.neighbour();
    const Field<Type>& c = cells.primitiveField();
    forAll(nei, f)
    {
        faces[f] = weights_[f]*c[own[f]] + (1 - weights_[f])*c[nei[f]];
    }
    patches([&](const label patchi, const fvPatch& patch)
    {
        const tmp<Field<Type>> tvalues(patchValues(cells, patchi));
        std::copy
        (
            tvalues().begin(),
            tvalues().end(),
            faces.begin() + patch.start()
        );
    });
}


template<class Type>
void Foam::faceOperators::sum
(
    const Field<Type>& faces,
    Field<Type>& cells
) const
{
    const labelUList& own = mesh_.owner();
    const labelUList& nei = mesh_.neighbour();

    cells.setSize(mesh_.nCells());
    cells = Zero;
    forAll(nei, f)
    {
        cells[own[f]] += faces[f];
        cells[nei[f]] -= faces[f];
    }
    patches([&](const label, const fvPatch& patch)
    {
        const labelUList& inside = patch.faceCells();
        forAll(inside, i)
        {
            cells[inside[i]] += faces[patch.start() + i];
        }
    });
}


template<class Type>
void Foam::faceOperators::grad
(
    const GeometricField<Type, fvPatchField, volMesh>& cells,
    GeometricField
    <
        typename outerProduct<vector, Type>::type,
        fvPatchField,
        volMesh
    >& gradient
) const
{
    typedef typename outerProduct<vector, Type>::type GradType;

    if (!is("gradSchemes", "grad(" + cells.name() + ')', "Gauss linear"))
    {
        gradient = fvc::grad(cells);
        return;
    }

    const labelUList& own = mesh_.owner();
    const labelUList& nei = mesh_.neighbour();
    const Field<Type>& c = cells.primitiveField();
    Field<GradType>& g = gradient.primitiveFieldRef();
    g = Zero;
    forAll(nei, f)
    {
        const GradType part
        (
            Sf_[f]*(weights_[f]*c[own[f]] + (1 - weights_[f])*c[nei[f]])
        );
        g[own[f]] += part;
        g[nei[f]] -= part;
    }

    patches([&](const label patchi, const fvPatch& patch)
    {
        const tmp<Field<Type>> tvalues(patchValues(cells, patchi));
        const Field<Type>& values = tvalues();
        const labelUList& inside = patch.faceCells();
        forAll(inside, i)
        {
            g[inside[i]] += Sf_[patch.start() + i]*values[i];
        }
    });
    const scalarField& V = mesh_.V();
    forAll(g, celli)
    {
        g[celli] /= V[celli];
    }

    // neighbours' values on coupled patches; along the normal, the boundary's
    // own elsewhere
    gradient.correctBoundaryConditions();
    patches([&](const label patchi, const fvPatch& patch)
    {
        const fvPatchField<Type>& values = cells.boundaryField()[patchi];
        if (values.coupled())
        {
            return;
        }
        const tmp<Field<Type>> tslope(values.snGrad());
        const Field<Type>& slope = tslope();
        const labelUList& inside = patch.faceCells();
        fvPatchField<GradType>& at = gradient.boundaryFieldRef()[patchi];
        forAll(at, i)
        {
            const vector& n = normal_[patch.start() + i];
            const GradType& in = g[inside[i]];
            at[i] = in + n*(slope[i] - (n & in));
        }
    });
}


// ************************************************************************* //

#endif
