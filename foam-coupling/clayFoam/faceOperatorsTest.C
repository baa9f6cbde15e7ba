// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
// faceOperators against OpenFOAM's operators, and keptFactor against FDIC.

#include "faceOperators.H"
#include "keptFactorPreconditioner.H"
#include "testMesh.H"
#include "uncarriedForce.H"

#include "fixedValueFvPatchFields.H"
#include "fvm.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

test::polyhedra shaken()
{
    test::polyhedra cells(test::block({5, 4, 6}, Zero, {1, 1, 1.3}));
    test::shake(cells, 0.02, 7, false);
    return cells;
}


//- A case whose schemes are read
struct schemedCase
:
    test::meshCase
{
    explicit schemedCase(const test::polyhedra& cells)
    :
        test::meshCase(cells)
    {
        mesh().fvSchemes::readOpt() = IOobject::MUST_READ;
        mesh().fvSchemes::read();
    }
};


template<class Type>
GeometricField<Type, fvPatchField, volMesh> fixed
(
    const fvMesh& mesh,
    const word& name,
    const std::function<Type(const point&)>& value
)
{
    GeometricField<Type, fvPatchField, volMesh> f
    (
        IOobject(name, mesh.time().timeName(), mesh),
        mesh,
        dimensioned<Type>(dimless, Zero),
        fixedValueFvPatchField<Type>::typeName
    );
    forAll(f, celli)
    {
        f[celli] = value(mesh.C()[celli]);
    }
    forAll(f.boundaryField(), patchi)
    {
        const vectorField& at = mesh.Cf().boundaryField()[patchi];
        forAll(at, i)
        {
            f.boundaryFieldRef()[patchi][i] = value(at[i]);
        }
    }
    return f;
}


template<class Type>
scalar difference(const Field<Type>& a, const Field<Type>& b)
{
    return max(mag(a - b))/max(mag(b));
}

} // End namespace


TEST(faceOperators, areThoseOfOpenFOAM)
{
    schemedCase c(shaken());
    const fvMesh& mesh = c.mesh();
    const faceOperators faces(mesh);
    ASSERT_FALSE(faces.orthogonal());

    const auto p = fixed<scalar>
    (
        mesh, "p", [](const point& x) { return std::sin(3*x.x()) + sqr(x.z()); }
    );
    const auto U = fixed<vector>
    (
        mesh, "U",
        [](const point& x)
        {
            return vector(x.y(), std::cos(4*x.z()), sqr(x.x()));
        }
    );

    surfaceScalarField to("to", fvc::interpolate(p));
    scalarField onFaces, cells, expected;
    faces.interpolate(p, "interpolate(p)", onFaces);
    faces.take(to, expected);
    EXPECT_LE(difference(onFaces, expected), 1e-14);

    faces.flux(U, "flux(U)", onFaces);
    faces.take(fvc::flux(U)(), expected);
    EXPECT_LE(difference(onFaces, expected), 1e-13);

    faces.sum(onFaces, cells);
    const scalarField divergence(fvc::div(fvc::flux(U))().primitiveField());
    EXPECT_LE
    (
        difference(scalarField(cells/mesh.V()), divergence),
        1e-12
    );

    faces.put(onFaces, to);
    vectorField back, other;
    faces.reconstruct(onFaces, back);
    EXPECT_LE
    (
        difference(back, fvc::reconstruct(to)().primitiveField()),
        1e-13
    );
    vectorField both;
    faces.reconstruct(onFaces, scalarField(2*onFaces), other, both);
    EXPECT_LE(difference(both, vectorField(2*back)), 1e-14);

    volTensorField gradU("gradU", fvc::grad(U));
    const volTensorField expectedU("expectedU", gradU);
    gradU == dimensionedTensor(gradU.dimensions(), Zero);
    faces.grad(U, gradU);
    EXPECT_LE
    (
        difference(gradU.primitiveField(), expectedU.primitiveField()),
        1e-13
    );
    forAll(gradU.boundaryField(), patchi)
    {
        const tensorField& a = gradU.boundaryField()[patchi];
        const tensorField& b = expectedU.boundaryField()[patchi];
        EXPECT_LE(difference(a, b), 1e-12);
    }

    // the slope through skewed faces
    volVectorField gradp("gradp", fvc::grad(p));
    faces.grad(p, gradp);
    faces.correction(gradp, onFaces);
    surfaceScalarField slope("slope", fvc::snGrad(p));
    faces.take(slope, expected);
    forAll(mesh.owner(), f)
    {
        const scalar along =
            faces.deltaCoeffs()[f]
           *(p[mesh.neighbour()[f]] - p[mesh.owner()[f]]);
        EXPECT_NEAR(along + onFaces[f], expected[f], 1e-12);
    }
}


TEST(faceOperators, anEvenBlockIsOrthogonal)
{
    schemedCase c(test::block({5, 4, 6}, Zero, {1, 1, 1.3}));
    const faceOperators faces(c.mesh());
    EXPECT_TRUE(faces.orthogonal());
    EXPECT_TRUE(faces.is("interpolationSchemes", "any", "linear"));
    EXPECT_FALSE(faces.is("interpolationSchemes", "any", "upwind phi"));
}

// A force in one cell: on an even mesh the faces carry all of it; on an uneven
// one what they leave stays with that cell and its neighbours, and none is lost
TEST(uncarriedForce, staysWhereItIs)
{
    for (const bool even : {true, false})
    {
        const schemedCase here
        (
            even ? test::block({5, 5, 6}, Zero, {1, 1, 1.3}) : shaken()
        );
        const fvMesh& mesh = here.mesh();
        const faceOperators faces(mesh);
        const label middle = mesh.findNearestCell(point(0.5, 0.5, 0.6));

        vectorField F(mesh.nCells(), Zero);
        F[middle] = vector(1, 2, 3);
        scalarField onFaces(mesh.nFaces(), Zero);
        for (const label f : mesh.cells()[middle])
        {
            ASSERT_TRUE(mesh.isInternalFace(f));
            const scalar w = faces.weights()[f];
            onFaces[f] =
                (mesh.owner()[f] == middle ? w : 1 - w)
               *(F[middle] & faces.Sf()[f]);
        }

        vectorField left, carried;
        faces.reconstruct(onFaces, carried);
        const scalar size = uncarriedForce(mesh, faces, F, onFaces, left);

        const vector all(gSum(left)), missing
        (
            gSum(vectorField(mesh.V()*(F - carried)))
        );
        EXPECT_LT(mag(all - missing), 1e-14);
        EXPECT_EQ(size < 1e-14, even);
        if (!even)
        {
            EXPECT_GT(mag(missing), 1e-5);
        }
        forAll(left, celli)
        {
            const bool near =
                celli == middle || mesh.cellCells()[middle].found(celli);
            EXPECT_TRUE(near || mag(left[celli]) < 1e-16) << celli;
        }
    }
}


namespace
{

// iterations and solution of a Poisson equation whose coefficients go with t
std::pair<label, scalarField> solved
(
    const fvMesh& mesh,
    const word& preconditioner,
    const scalar t
)
{
    const auto x = [](const point& at) { return at.x() + sqr(at.y()); };
    auto p = fixed<scalar>(mesh, "p", x);
    p.primitiveFieldRef() = 0;
    const surfaceScalarField k
    (
        "k", fvc::interpolate(1 + t*fixed<scalar>(mesh, "x", x))
    );
    fvScalarMatrix equation(fvm::laplacian(k, p));
    dictionary controls;
    controls.add("solver", word("PCG"));
    controls.add("preconditioner", preconditioner);
    controls.add("tolerance", 1e-11);
    controls.add("relTol", 0);
    const label n = equation.solve(controls).nIterations();
    return {n, scalarField(p.primitiveField())};
}

}


TEST(keptFactor, solvesWhatChangesInFewIterations)
{
    schemedCase c(shaken());
    const fvMesh& mesh = c.mesh();

    EXPECT_LE(solved(mesh, "keptFactor", 0).first, 2);
    for (const scalar t : {0.01, 0.02, 0.05, 0.5, 5.0, 5.01})
    {
        const auto kept = solved(mesh, "keptFactor", t);
        const auto other = solved(mesh, "FDIC", t);
        EXPECT_LE(kept.first, other.first + 2);
        EXPECT_LE(difference(kept.second, other.second), 1e-9);
    }

    // it has noticed that it had become too far from the matrix
    EXPECT_LE(solved(mesh, "keptFactor", 5.01).first, 4);
}


// a mesh that comes after another, of another size, at the same place in memory
// perhaps: it has factors of its own
TEST(keptFactor, goesWithItsMesh)
{
    for (label turn = 0; turn < 20; ++turn)
    {
        const point end(0.03, 0.04, 0.05);
        schemedCase c(test::block({3 + turn % 3, 4, 5}, Zero, end));
        const fvMesh& mesh = c.mesh();
        const word name("clayFoam:factors:p");
        EXPECT_FALSE(mesh.foundObject<regIOobject>(name));
        const auto kept = solved(mesh, "keptFactor", 0.1);
        EXPECT_LE(kept.first, 2);
        EXPECT_TRUE(mesh.foundObject<regIOobject>(name));
        const auto other = solved(mesh, "FDIC", 0.1);
        EXPECT_LE(difference(kept.second, other.second), 1e-9) << turn;
    }
}
