// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Description
    Solid fractions that go up and down from cell to cell, and others.
\*---------------------------------------------------------------------------*/

#include "cellWaves.H"
#include "testMesh.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

const label across = 4, high = 40;
const scalar h = 1e-3;

// a particle in each cell of a column, as large as the fraction there wants
class column
{
    const test::meshCase case_;
    volVectorField U_;
    dispersedParticles p_;
    cellWaves waves_;

public:

    column()
    :
        case_
        (
            test::block
            (
                {across, across, high},
                point(Zero),
                point(across*h, across*h, high*h)
            )
        ),
        U_
        (
            IOobject("U", case_.mesh().time().timeName(), case_.mesh()),
            case_.mesh(),
            dimensionedVector(dimVelocity, Zero)
        ),
        waves_(case_.mesh())
    {
        p_.setSize(case_.mesh().nCells());
    }

    const cellWaves& waves() const { return waves_; }

    // states of that fraction(place, number of the state), each half a cell
    // further; how many of them end a window with a wave
    label run
    (
        const std::function<scalar(const point&, label)>& fraction,
        const vector& velocity,
        const label states = 8
    )
    {
        label found = 0;
        for (label k = 0; k < states; ++k)
        {
            p_.clearRows();
            forAll(p_.volume, i)
            {
                p_.volume[i] =
                    fraction(case_.mesh().C()[i]/h, k)*case_.mesh().V()[i];
                p_.velocity[i] = velocity;
                p_.owned[i] = true;
                p_.append(i, 1);
                p_.endRow(i);
            }
            found += waves_.look(p_, U_, 1, 0.5);
        }
        return found;
    }
};

const vector down(0, 0, -0.5*h);

scalar wave(const point& x, const scalar cells)
{
    return
        0.3 + 0.05*std::cos(constant::mathematical::twoPi*(x.z() - 0.5)/cells);
}

// without order in space, fixed in it or another in each state
scalar grains(const point& x, const label state)
{
    std::mt19937 random
    (
        label(x.x()) + 10*(label(x.y()) + 10*label(x.z())) + 10000*state
    );
    return 0.3 + 0.1*std::uniform_real_distribution<scalar>(-1, 1)(random);
}

}


TEST(cellWaves, aWaveOfTwoCellsIsFound)
{
    column c;
    EXPECT_EQ
    (
        c.run([](const point& x, label) { return wave(x, 2); }, down), 1
    );
    EXPECT_LT(c.waves().correlation(), -0.9);
    EXPECT_NEAR(c.waves().amplitude(), 0.05/0.3, 0.02);
}


// in the half of a row of cells alone
TEST(cellWaves, oneInAPartOfTheColumnIsFound)
{
    column c;
    EXPECT_EQ
    (
        c.run
        (
            [](const point& x, label)
            {
                return x.z() < 0.5*high ? wave(x, 2) : 0.3;
            },
            down
        ),
        1
    );
}


TEST(cellWaves, longerWavesFrontsAndGrainsAtRandomAreNone)
{
    column c;
    EXPECT_EQ
    (
        c.run([](const point& x, label) { return wave(x, 6); }, down), 0
    );
    EXPECT_EQ
    (
        c.run
        (
            [](const point& x, label)
            {
                return x.z() < 10 ? 0.6 : x.z() < 30 ? 0.3 : 0.0;
            },
            down
        ),
        0
    );
    EXPECT_EQ(c.run(grains, down), 0);
    EXPECT_EQ
    (
        c.run([](const point& x, label) { return grains(x, 0); }, down), 0
    );
}


// what goes by with the particles is theirs: a wave of two cells that moves
TEST(cellWaves, whatMovesWithTheParticlesIsNone)
{
    column c;
    EXPECT_EQ
    (
        c.run
        (
            [](const point& x, label k)
            {
                return wave(x + point(0, 0, 0.5*k), 2);
            },
            down,
            16
        ),
        0
    );
    EXPECT_EQ(c.waves().correlation(), 0);
}


// layers of a bed that rests or is held, across the slip, or of few grains
TEST(cellWaves, othersDoNotCount)
{
    const auto layers = [](const point& x, label) { return wave(x, 2); };
    column c;
    EXPECT_EQ(c.run(layers, vector(Zero)), 0);
    EXPECT_EQ(c.run(layers, 1e-3*down), 0);
    EXPECT_EQ(c.run(layers, vector(0.5*h, 0, 0)), 0);
    EXPECT_EQ
    (
        c.run
        (
            [](const point& x, label) { return 0.1*wave(x, 2); }, down
        ),
        0
    );
    EXPECT_EQ(c.waves().correlation(), 0);
}


// a window begins anew after each
TEST(cellWaves, eachWindowIsJudgedByItself)
{
    column c;
    EXPECT_EQ(c.run([](const point&, label) { return 0.3; }, down, 8), 0);
    EXPECT_EQ
    (
        c.run([](const point& x, label) { return wave(x, 2); }, down, 16), 2
    );
}
