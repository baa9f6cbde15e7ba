// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Description
    The flux that carries momentum: its divergence, and what it leaves alone.
\*---------------------------------------------------------------------------*/

#include "carryingFlux.H"
#include "testMesh.H"

#include "fvc.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

surfaceScalarField waves(const fvMesh& mesh)
{
    surfaceScalarField phi
    (
        IOobject("phi", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimVolume/dimTime, Zero)
    );
    forAll(phi, f)
    {
        phi[f] = 1e-6*std::sin(3.0*f);
    }
    return phi;
}

}


TEST(carryingFlux, hasTheRateAsItsDivergence)
{
    test::polyhedra cells(test::block({6, 5, 7}, Zero, {0.06, 0.05, 0.07}));
    test::shake(cells, 1e-3, 9, false);
    const test::meshCase c(cells);
    const fvMesh& mesh = c.mesh();
    const surfaceScalarField phi(waves(mesh));

    const scalarField& V = mesh.V();
    scalarField rate(V.size());
    forAll(rate, i)
    {
        rate[i] = std::cos(5.0*i);
    }
    rate -= sum(rate*V)/sum(V);

    carryingFlux carrying(mesh);
    // a second time with what is kept
    for (label turn = 0; turn < 2; ++turn)
    {
        const scalarField left
        (
            fvc::div(carrying(phi, rate))().primitiveField() + rate
        );
        const scalarField before(fvc::div(phi)().primitiveField() + rate);
        EXPECT_LT(sum(mag(left)*V), 2e-8*sum(mag(before)*V));
    }
}


// through sides that are one, too: a source in the first cell of a row and a
// sink in the last are carried across the sides that join them
TEST(carryingFlux, goesThroughPeriodicSides)
{
    const label n = 6;
    const test::meshCase c
    (
        test::block({n, 1, 1}, Zero, {0.06, 0.01, 0.01}),
        {"cyclic", "cyclic", "wall", "wall", "wall", "wall"}
    );
    const fvMesh& mesh = c.mesh();
    surfaceScalarField still(waves(mesh));
    still == dimensionedScalar(still.dimensions(), Zero);
    scalarField rate(n, Zero);
    rate[0] = 1;
    rate[n - 1] = -1;

    carryingFlux carrying(mesh);
    const surfaceScalarField carried(carrying(still, rate));
    const scalarField left(fvc::div(carried)().primitiveField() + rate);
    EXPECT_LT(max(mag(left)), 1e-7);

    // the potential falls by n steps around the ring: the short way bears
    // n - 1 parts of n, the long way one
    const scalar all = mesh.V()[0];
    forAll(carried, f)
    {
        EXPECT_NEAR(mag(carried[f])/all, 1.0/n, 1e-7) << f;
    }
    EXPECT_NEAR
    (
        mag(carried.boundaryField()[0][0])/all, (n - 1.0)/n, 1e-7
    );
}


// a flux that has it already stays as it is
TEST(carryingFlux, changesNothingThatIsRight)
{
    const test::meshCase c(test::block({4, 5, 6}, Zero, {0.04, 0.05, 0.06}));
    const surfaceScalarField phi(waves(c.mesh()));
    carryingFlux carrying(c.mesh());
    const surfaceScalarField same
    (
        carrying(phi, scalarField(-fvc::div(phi)().primitiveField()))
    );
    EXPECT_LT(max(mag(same.primitiveField() - phi.primitiveField())), 1e-18);
}


// what the domain gains as a whole can be carried nowhere
TEST(carryingFlux, leavesTheGainOfTheWhole)
{
    const test::meshCase c(test::block({4, 4, 4}, Zero, {1, 1, 1}));
    surfaceScalarField still(waves(c.mesh()));
    still.primitiveFieldRef() = 0;
    carryingFlux carrying(c.mesh());
    const surfaceScalarField same
    (
        carrying(still, scalarField(c.mesh().nCells(), 0.7))
    );
    EXPECT_LT(max(mag(same.primitiveField())), 1e-12);
}
