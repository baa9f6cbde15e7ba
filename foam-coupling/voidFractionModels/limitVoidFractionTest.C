// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "voidFractionModel.H"
#include "testMesh.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

autoPtr<voidFractionModel> scheme
(
    const std::string& name,
    const fvMesh& mesh,
    const std::string& more = ""
)
{
    return voidFractionModel::New
    (
        test::settings("voidFractionModel " + name + ";" + more), mesh
    );
}

test::polyhedra box(const label n)
{
    return test::block({n, n, n}, Zero, {0.02, 0.02, 0.02});
}

scalar solids(const volScalarField& n)
{
    const scalarField& V = n.mesh().V();
    return sum(V*(1 - n.primitiveField()));
}

}


// particles heaped into one corner cell spread without loss
TEST(voidFraction, limit)
{
    const test::meshCase c(box(5));
    const scalar cell = pow3(4e-3);
    dispersedParticles p;
    p.setSize(100);
    p.position = point(1e-3, 1e-3, 1e-3);
    p.radius = 0.5e-3;
    p.volume = 0.06*cell;
    volScalarField n(c.field("n"));

    auto m = scheme("centre", c.mesh(), "voidFractionMin 0.4;");
    p.locate(c.mesh());
    m->map(p, nullptr, n);
    EXPECT_NEAR(m->clippedVolume(), 6*cell - 0.6*cell, 1e-6*cell);
    EXPECT_EQ(m->excessVolume(), 0);
    EXPECT_NEAR(solids(n)/sum(p.volume), 1, 1e-12);
    EXPECT_GE(gMin(n.primitiveField()), 0.4 - 1e-12);
    // near to where it came from: nothing in the far half
    EXPECT_EQ(n[124], 1);

    // nothing to move
    p.setSize(5);
    m->map(p, nullptr, n);
    EXPECT_EQ(m->clippedVolume(), 0);

    // more than the mesh can take: what has no room is told and kept
    p.setSize(2000);
    p.position = point(1e-3, 1e-3, 1e-3);
    p.radius = 0.5e-3;
    p.volume = 0.06*cell;
    p.locate(c.mesh());
    m->map(p, nullptr, n);
    EXPECT_NEAR(m->excessVolume(), (120 - 125*0.6)*cell, 1e-6*cell);
    EXPECT_NEAR(solids(n)/sum(p.volume), 1, 1e-12);
}


TEST(voidFraction, refusals)
{
    const test::meshCase c(box(2));
    try
    {
        scheme("gauss", c.mesh());
        FAIL() << "an unknown scheme was taken";
    }
    catch (const Foam::error& e)
    {
        const std::string text(e.message());
        EXPECT_NE(text.find("voidFractionModel gauss is not known"), text.npos);
        EXPECT_NE(text.find("exactOverlap"), text.npos) << text;
    }
    EXPECT_THROW
    (
        scheme("centre", c.mesh(), "voidFractionMin 1.2;"), Foam::error
    );
    EXPECT_THROW
    (
        scheme("divided", c.mesh(), "dividedCoeffs { points 0; }"),
        Foam::error
    );
}
