// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Description
    The void fraction over an interval and its rate, against spheres that move
    in a way that is known.
\*---------------------------------------------------------------------------*/

#include "voidFractionHistory.H"
#include "fixedValueFvPatchFields.H"
#include "mathematicalConstants.H"
#include "testMesh.H"
#include "voidFractionModel.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

typedef couplingProperties::ddtType ddtType;

const scalar R = 1e-3, h = 4e-3, period = 1e-3;
const scalar ball = 4.0/3*constant::mathematical::pi*pow3(R);

volVectorField velocity(const fvMesh& mesh, const word& patchType)
{
    return volVectorField
    (
        IOobject("U", mesh.time().timeName(), mesh),
        mesh,
        dimensionedVector(dimVelocity, Zero),
        patchType
    );
}

// a row of eight cells of side h with one sphere, and its n
class sphereInRow
{
    test::meshCase case_;
    volVectorField U_;
    autoPtr<smoothingModel> smoothing_;
    autoPtr<voidFractionModel> model_;

public:

    voidFractionHistory history;
    dispersedParticles p;

    explicit sphereInRow(const char* model = "exactOverlap")
    :
        case_(test::block({8, 1, 1}, Zero, {8*h, h, h})),
        U_(velocity(case_.mesh(), calculatedFvPatchVectorField::typeName)),
        smoothing_(smoothingModel::New(dictionary(), case_.mesh())),
        model_
        (
            voidFractionModel::New
            (
                test::settings
                (
                    std::string("voidFractionModel ") + model + ";"
                ),
                case_.mesh()
            )
        ),
        history(U_)
    {
        case_.mesh().fvSchemes::readOpt() = IOobject::MUST_READ;
        case_.mesh().fvSchemes::read();
    }

    // the sphere's state, and the interval that begins with it
    bool begin
    (
        const scalar x,
        const scalar v,
        const ddtType ddt,
        const scalar length = period,
        const scalar volume = ball,
        const scalarField& jump = scalarField()
    )
    {
        p.setSize(1);
        p.position[0] = point(x, h/2, h/2);
        p.velocity[0] = vector(v, 0, 0);
        p.radius = R;
        p.volume = volume;
        p.tag = 0;
        p.locate(case_.mesh());
        model_->map(p, nullptr, history.mapped());
        return history.begin(ddt, p, smoothing_(), volume, length, jump);
    }

    const smoothingModel& smoothing() const
    {
        return smoothing_();
    }

    // sum of x^k ddt(n) V
    scalar moment(const label k) const
    {
        const fvMesh& mesh = case_.mesh();
        return gSum
        (
            pow(mesh.C().primitiveField().component(0)(), scalar(k))
           *history.ddt().primitiveField()*mesh.V()
        );
    }

    scalar solid() const
    {
        return gSum((1 - history.n().primitiveField())*case_.mesh().V());
    }

    scalar solidIn(const label celli) const
    {
        return (1 - history.n()[celli])*pow3(h);
    }
};

}


// a run begins with the n of its particles, and makes no flow of that
TEST(voidFractionHistory, beginsWithWhatIsThere)
{
    sphereInRow one;
    EXPECT_FALSE(one.begin(1.5*h, 0, ddtType::difference));
    EXPECT_NEAR(one.solidIn(1)/ball, 1, 1e-12);
    EXPECT_EQ(one.moment(0), 0);
    EXPECT_EQ(one.history.ddt()[1], 0);
    one.history.advance(1);
    EXPECT_NEAR(one.solidIn(1)/ball, 1, 1e-12);
}


// of a sphere that moves when a run begins, the first interval has the flow
// that the later ones have
TEST(voidFractionHistory, theFirstIntervalHasAFlow)
{
    sphereInRow one;
    const scalar v = 0.05*h/period;
    one.begin(2*h, v, ddtType::difference);
    EXPECT_NEAR(one.moment(0)/(ball*v/h), 0, 1e-12);
    EXPECT_NEAR(one.moment(1)/(ball*v), -1, 1e-9);
    // at its end n is that of the sphere
    one.history.advance(1);
    EXPECT_NEAR(one.solidIn(1)/ball, 0.5, 1e-9);
    EXPECT_NEAR(one.solidIn(2)/ball, 0.5, 1e-9);
}


// a sphere whose centre passes a face by s: the solid behind the face changes
// by pi (R^2 s - s^3/3), the void fraction at that rate over the interval
TEST(voidFractionHistory, followsAMovingSphere)
{
    const scalar s = 0.1*R;
    sphereInRow one;
    one.begin(2*h, s/period, ddtType::difference);
    one.history.advance(1);
    one.begin(2*h + s, s/period, ddtType::difference);

    const scalar passed = constant::mathematical::pi*(sqr(R)*s - pow3(s)/3);
    EXPECT_NEAR(-one.history.ddt()[2]*pow3(h)*period/passed, 1, 1e-9);
    EXPECT_NEAR(one.history.ddt()[1]*pow3(h)*period/passed, 1, 1e-9);
    EXPECT_NEAR(one.moment(0)*period/passed, 0, 1e-9);

    // half way through the interval half of it has passed
    EXPECT_NEAR(one.solidIn(2)/ball, 0.5, 1e-9);
    one.history.advance(0.5);
    EXPECT_NEAR((one.solidIn(2) - ball/2)/passed, 0.5, 1e-9);
    EXPECT_NEAR((1 - one.history.old()[2])*pow3(h)/ball, 0.5, 1e-9);
    one.history.advance(1);
    EXPECT_NEAR((one.solidIn(2) - ball/2)/passed, 1, 1e-9);
    EXPECT_NEAR
    (
        (1 - one.history.old()[2])*pow3(h) - ball/2, passed/2, 1e-9*passed
    );
    EXPECT_NEAR(one.solid()/ball, 1, 1e-12);
}


// what the continuity equation takes in over a run is what n has changed by,
// also when intervals are not equally long while the sphere passes a face
TEST(voidFractionHistory, losesNothing)
{
    sphereInRow one;
    scalar x = 1.6*h, given = 0, before = GREAT;
    for (const scalar part : {1.0, 1.0, 0.3, 1.0, 1.0, 0.5, 1.0, 1.0, 1.0, 1.0})
    {
        const scalar length = part*period;
        one.begin(x, 0.12*h/period, ddtType::difference, length);
        before = before == GREAT ? one.solidIn(2) : before;
        given -= one.history.ddt()[2]*pow3(h)*length;
        one.history.advance(0.4);
        one.history.advance(1);
        EXPECT_NEAR((before + given - one.solidIn(2))/ball, 0, 1e-12);
        x += 0.12*h*part;
    }
    // the first interval has a flow of its own, into a cell that the sphere has
    // not reached
    EXPECT_LT(before, 0);
    EXPECT_NEAR((before + given)/ball, 1, 1e-12);
}


// an interval of a third of the one before takes a third of the change, the
// rest comes with the next
TEST(voidFractionHistory, shortIntervalsTakeTheirShare)
{
    sphereInRow one;
    one.begin(1.5*h, 0, ddtType::difference);
    one.history.advance(1);
    one.begin(2.5*h, 0, ddtType::difference, period/3);
    one.history.advance(1);
    EXPECT_NEAR(one.solidIn(2)/ball, 1.0/3, 1e-9);
    one.begin(2.5*h, 0, ddtType::difference, period/3);
    one.history.advance(1);
    EXPECT_NEAR(one.solidIn(2)/ball, 1, 1e-9);
}


// the volume flux of a sphere that moves at v: no volume comes or goes, and
// the solid's centre moves at v, d/dt sum(x n V) = -V v
TEST(voidFractionHistory, fluxOfAMovingSphere)
{
    const scalar v = 0.7;
    for (const char* model : {"centre", "exactOverlap"})
    {
        sphereInRow one(model);
        one.begin(3.9*h, v, ddtType::particleFlux);
        EXPECT_NEAR(one.moment(0)/(ball*v/h), 0, 1e-12) << model;
        EXPECT_NEAR(one.moment(1)/(ball*v), -1, 1e-12) << model;
    }
}


// particles that come or go: n jumps, no flow is made of it
TEST(voidFractionHistory, noFlowOfComingAndGoing)
{
    sphereInRow one;
    one.begin(1.5*h, 0, ddtType::difference);
    one.history.advance(1);
    EXPECT_TRUE(one.begin(1.5*h, 0, ddtType::difference, period, 1.5*ball));
    EXPECT_NEAR(one.solidIn(1)/ball, 1.5, 1e-12);
    EXPECT_EQ(one.moment(0), 0);
    one.history.advance(1);
    EXPECT_FALSE(one.begin(1.5*h, 0, ddtType::difference, period, 1.5*ball));
}


// with the change of n by those that came or went only what moved besides makes
// a flow; n stays at 1 or below
TEST(voidFractionHistory, onlyWhatMovedDrives)
{
    sphereInRow one;
    one.begin(1.5*h, 0, ddtType::difference, period, 1.5*ball);
    one.history.advance(1);
    // a third of it goes, the rest moves halfway on
    scalarField jump(8, Zero);
    jump[1] = 0.5*ball/pow3(h);
    jump[4] = 0.3;
    EXPECT_TRUE(one.begin(2*h, 0, ddtType::difference, period, ball, jump));
    EXPECT_NEAR(one.solidIn(1)/ball, 1, 1e-9);
    EXPECT_EQ(one.solidIn(4), 0);
    EXPECT_NEAR(one.history.ddt()[1]*pow3(h)*period/ball, 0.5, 1e-9);
    EXPECT_NEAR(one.history.ddt()[2]*pow3(h)*period/ball, -0.5, 1e-9);
    one.history.advance(1);
    EXPECT_NEAR(one.solidIn(2)/ball, 0.5, 1e-9);
}


// one comes where another leaves: the flow is that of the one that moves
TEST(voidFractionHistory, comingAndMovingAreKeptApart)
{
    sphereInRow one;
    one.begin(1.5*h, 0, ddtType::difference);
    one.history.advance(1);

    // by now it is in the next cell, and one as large came in its place
    one.begin(1.5*h, 0, ddtType::difference);
    one.history.advance(1);
    scalarField both(8, 0.0), jump(8, 0.0);
    both[1] = both[2] = ball/pow3(h);
    jump[1] = -ball/pow3(h);
    one.history.mapped().primitiveFieldRef() = 1 - both;
    const smoothingModel& none = one.smoothing();
    EXPECT_TRUE
    (
        one.history.begin
        (
            ddtType::difference, one.p, none, 2*ball, period, jump
        )
    );
    EXPECT_NEAR(one.solidIn(1)/ball, 2, 1e-9);
    EXPECT_NEAR(one.history.ddt()[1]*pow3(h)*period/ball, 1, 1e-9);
    EXPECT_NEAR(one.history.ddt()[2]*pow3(h)*period/ball, -1, 1e-9);
    one.history.advance(1);

    // no cell is filled up by it
    both[1] = 2*ball/pow3(h);
    jump[1] = -0.9;
    one.history.mapped().primitiveFieldRef() = 1 - both;
    one.history.begin
    (
        ddtType::difference, one.p, none, 3*ball, period, jump, 0.5
    );
    EXPECT_NEAR(one.history.n()[1], 0.5, 1e-12);
}


TEST(voidFractionHistory, noRateWithout)
{
    sphereInRow one;
    one.begin(1.5*h, 0, ddtType::none);
    one.history.advance(1);
    one.begin(2.5*h, 1, ddtType::none);
    EXPECT_EQ(max(mag(one.history.ddt().primitiveField())), 0);
    one.history.advance(1);
    EXPECT_NEAR(one.solidIn(2)/ball, 1, 1e-12);
}


// on walls n is that of the cell, whatever U is there
TEST(voidFractionHistory, wallsTakeTheCellsValue)
{
    const test::meshCase c(test::block({2, 2, 2}, Zero, {h, h, h}));
    const volVectorField U
    (
        velocity(c.mesh(), fixedValueFvPatchVectorField::typeName)
    );
    const voidFractionHistory history(U);
    EXPECT_EQ(history.n().boundaryField()[0].type(), "zeroGradient");
    EXPECT_EQ(history.n()[0], 1);
}
