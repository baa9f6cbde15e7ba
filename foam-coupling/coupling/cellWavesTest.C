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
    const scalar thick_;
    const test::meshCase case_;
    volVectorField U_;
    dispersedParticles p_;
    cellWaves waves_;

public:

    // of cells of that height, wide as many cells
    explicit column
    (
        const scalar thick = h,
        const label wide = across,
        const label layers = high
    )
    :
        thick_(thick),
        case_
        (
            test::block
            (
                {wide, wide, layers},
                point(Zero),
                point(wide*h, wide*h, layers*thick)
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

    // states of that fraction(place in cells, number of the state), in each of
    // which the fastest particle crosses that many cells; the odd ones last
    // that much longer. How many of them end a window with a wave
    label run
    (
        const std::function<scalar(const point&, label)>& fraction,
        const vector& velocity,
        const label states = 8,
        const scalar crossing = 0.5,
        const scalar longer = 1
    )
    {
        label found = 0;
        for (label k = 0; k < states; ++k)
        {
            p_.clearRows();
            forAll(p_.volume, i)
            {
                const point& C = case_.mesh().C()[i];
                p_.volume[i] =
                    fraction(point(C.x()/h, C.y()/h, C.z()/thick_), k)
                   *case_.mesh().V()[i];
                p_.velocity[i] = velocity;
                p_.owned[i] = true;
                p_.append(i, 1);
                p_.endRow(i);
            }
            found += waves_.look(p_, U_, k % 2 ? longer : 1, crossing);
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


// a state counts by the time it stands for: of a wave that is there and one
// upside down, which would cancel, the one that lasts longer is seen
TEST(cellWaves, statesCountByTheirTime)
{
    const auto turns = [](const point& x, label k)
    {
        return k % 2 ? wave(x, 2) : 0.6 - wave(x, 2);
    };
    column c;
    EXPECT_EQ(c.run(turns, down), 0);
    EXPECT_EQ(c.run(turns, down, 8, 0.5, 3), 1);
    EXPECT_NEAR(c.waves().amplitude(), 0.5*0.05/0.3, 0.01);
}


// cells are counted by their thickness: flat ones are crossed sooner
TEST(cellWaves, flatCellsAreCrossedSooner)
{
    const auto layers = [](const point& x, label) { return wave(x, 2); };
    const scalar slender = std::cbrt(0.25)/0.25;
    column flat(0.25*h), cubes;
    EXPECT_EQ(flat.run(layers, down, 2, 2.1/slender), 1);
    EXPECT_EQ(cubes.run(layers, 2*down, 2, 2.1/slender), 0);
}


// a wave so low that it does not matter, and one in so few cells that grains
// at random may look alike
TEST(cellWaves, lowWavesAndThoseOfFewCellsAreNone)
{
    column c;
    EXPECT_EQ
    (
        c.run
        (
            [](const point& x, label) { return 0.24 + 0.2*wave(x, 2); }, down
        ),
        0
    );
    column few(h, 1, 10);
    EXPECT_EQ
    (
        few.run([](const point& x, label) { return wave(x, 2); }, down), 0
    );
    EXPECT_LT(few.waves().correlation(), -0.8);
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
