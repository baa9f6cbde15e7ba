// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

// The answer that is foreseen of a particle, and whether the exchange is stable
// with it, whatever the particle does in truth: one cell of unit volume, unit
// interval and unit fluid density.

#include "particleResponse.H"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>
#include <unsupported/Eigen/MatrixFunctions>

#include <cmath>
#include <initializer_list>
#include <vector>

using namespace Foam;

namespace
{

particleResponse::particle particleOf(const scalar K, const scalar m)
{
    particleResponse::particle q;
    q.K = K;
    q.mass = m;
    q.added = 0;
    q.velocity = vector(0.3, 0, -1);
    q.own = Zero;
    q.load = vector(0, 0, 0.4);
    q.mean = vector(0.1, 0, -0.7);
    q.impulse = vector(0.02, 0, 0.5);
    q.other = vector(0, 0, -2);
    q.fluid = Zero;
    q.push = Zero;
    q.touched = false;
    return q;
}


//- Mean velocity over T of m dv/dt = K (U - v) + F, by many small steps
vector marched
(
    const particleResponse::particle& q,
    const vector& U,
    const vector& F,
    const scalar T
)
{
    const label n = 200000;
    vector v(q.velocity), sum(Zero);
    for (label i = 0; i < n; ++i)
    {
        const vector middle(v + 0.5*T/n*(q.K*(U - v) + F)/q.mass);
        v += T/n*(q.K*(U - middle) + F)/q.mass;
        sum += middle;
    }
    return sum/n;
}


//- What a particle does in truth
enum class truth {free, plug, held, sprung};

//- Where the fluid's velocity is free, or tied to the particles
enum class velocityIs {across, along};

struct oneCell
{
    scalar x;       // K T/m
    scalar phi;     // solid fraction
    scalar ratio;   // of densities
    scalar added;   // added mass over that of the fluid displaced
    scalar spring;  // (omega T)^2 of those on springs
};


//- State: U, v0, mean velocity, impulse, other force, grad p, debt, place
constexpr int size = 8;

Eigen::Matrix<double, size, 1> interval
(
    const Eigen::Matrix<double, size, 1>& s,
    const oneCell& c,
    const truth what,
    const velocityIs where,
    const bool touched,
    const particleResponse::guess& inMomentum,
    const scalar pay
)
{
    const scalar n = 1 - c.phi, m = c.ratio*c.phi, V = c.phi;
    const scalar M = c.added*c.phi, K = c.x*(m + M);

    particleResponse::particle q(particleOf(K, m));
    q.load = Zero;
    q.velocity = vector(s[1], 0, 0);
    q.mean = vector(s[2], 0, 0);
    q.impulse = vector(s[3], 0, 0);
    q.other = vector(s[4], 0, 0);
    q.touched = touched;
    q.added = M;
    const auto a = particleResponse::foresee(q, 1, 1, inMomentum);
    const auto b = particleResponse::foresee
    (
        q, 1, 1, particleResponse::inContinuity(c.x)
    );

    // n (U - U0) = -(1 - V) P + K (va - U) + M dva + debt, and
    // n U + V vb = 0 or P = 0
    Eigen::Matrix2d A;
    Eigen::Vector2d r;
    A << n + K*(1 - a.s) - M*a.g, 1 - V + a.s*V + M*a.gByK*V, 0, 1;
    r << n*s[0] + K*a.b.x() + M*a.c.x() + pay*s[6], 0;
    if (where == velocityIs::along)
    {
        A(1, 0) = n + V*b.s;
        A(1, 1) = -V*V*b.sByK;
        r[1] = -V*b.b.x();
    }
    const Eigen::Vector2d solved(A.partialPivLu().solve(r));
    const scalar U = solved[0], P = solved[1];
    const scalar foreseen = a.b.x() + a.s*U - a.sByK*V*P;
    const scalar change = a.c.x() + a.g*U - a.gByK*V*P;

    // the truth: with its own mass, with five times that, not at all, or on a
    // spring from where it is at rest
    scalar mean = 0, end = 0;
    if (what == truth::sprung)
    {
        Eigen::Matrix3d rate;
        rate << -c.x, -c.spring, c.x*(U - V*P/K), 1, 0, 0, 0, 0, 0;
        const Eigen::Vector3d after
        (
            Eigen::Matrix3d(rate.exp())*Eigen::Vector3d(s[1], s[7], 1)
        );
        end = after[0];
        mean = after[1] - s[7];
    }
    else if (what != truth::held)
    {
        const scalar x = what == truth::plug ? c.x/5 : c.x;
        const scalar part = -std::expm1(-x)/x;
        const scalar pull = U - V*P/K;
        mean = part*s[1] + (1 - part)*pull;
        end = pull + (s[1] - pull)*std::exp(-x);
    }

    const scalar received = K*(U - mean) - V*P - M*(end - s[1]);
    const scalar given = V*P + K*(foreseen - U) + M*change + pay*s[6];

    Eigen::Matrix<double, size, 1> next;
    next << U, end, mean, received, m*(end - s[1]) - received, P,
        s[6] - received - given, s[7] + mean;
    return next;
}


//- Largest size of an eigenvalue of the map from one interval to the next
scalar growth
(
    const oneCell& c,
    const truth what,
    const velocityIs where,
    const bool touched,
    const particleResponse::guess& inMomentum = particleResponse::inMomentum(),
    const scalar pay = particleResponse::paid
)
{
    Eigen::Matrix<double, size, size> map;
    for (int i = 0; i < size; ++i)
    {
        map.col(i) = interval
        (
            Eigen::Matrix<double, size, 1>::Unit(i),
            c, what, where, touched, inMomentum, touched ? pay : 1
        );
    }
    // a place matters to springs alone
    const int n = what == truth::sprung ? size : size - 1;
    return map.topLeftCorner(n, n).eigenvalues().cwiseAbs().maxCoeff();
}


//- The largest of all cells
template<class Function>
scalar worst(const Function& of)
{
    scalar largest = 0;
    for (scalar decade = -3; decade < 5.1; decade += 0.5)
    for (const scalar phi : {0.02, 0.1, 0.3, 0.5, 0.6, 0.68})
    for (const scalar ratio : {0.05, 1.0, 2.65, 10.0})
    for (const scalar added : {0.0, 0.5, 2.0})
    for (const velocityIs where : {velocityIs::across, velocityIs::along})
    {
        const oneCell c{std::pow(10, decade), phi, ratio, added, 0};
        largest = std::max(largest, of(c, where));
    }
    return largest;
}

} // End anonymous namespace


TEST(ParticleResponse, aFreeOneIsForeseenExactly)
{
    const vector U(0.2, -0.1, 0.5);
    for (const scalar K : {0.01, 1.0, 30.0})
    {
        const auto q = particleOf(K, 1.3);
        const auto a = particleResponse::foresee(q, 0.7, 0.7, {0.4, 1, 1});
        const vector v(marched(q, U, vector(q.other + q.load), 0.7));
        EXPECT_NEAR(mag(a.b + a.s*U - v), 0, 1e-6) << "K " << K;
        EXPECT_NEAR(a.sByK*K, a.s, 1e-12);
    }
}


TEST(ParticleResponse, withoutDragOnlyForcesAct)
{
    for (const scalar K : {0.0, 1e-9})
    {
        const auto q = particleOf(K, 2);
        const auto a = particleResponse::foresee(q, 0.5, 0.5, {0.4, 1, 1});
        EXPECT_NEAR(a.s, 0, 1e-9);
        EXPECT_NEAR(a.sByK, 0.5*0.5/2, 1e-9);
        const vector v(q.velocity + 0.5*0.5*(q.other + q.load)/q.mass);
        EXPECT_NEAR(mag(a.b - v), 0, 1e-8);
    }
}


TEST(ParticleResponse, theSeriesMeetsTheExponential)
{
    // on both sides of x = 1e-4
    for (const bool touched : {false, true})
    {
        auto q = particleOf(0.9999e-4, 1), p = particleOf(1.0001e-4, 1);
        q.touched = p.touched = touched;
        const auto a = particleResponse::foresee(q, 1, 1, {0.4, 1, 1});
        const auto b = particleResponse::foresee(p, 1, 1, {0.4, 1, 1});
        EXPECT_NEAR(mag(a.b - b.b), 0, 1e-7);
        EXPECT_NEAR(b.s/a.s, 1.0002, 1e-6);
        EXPECT_NEAR(b.sByK/a.sByK, 1, 1e-6);
    }
}


TEST(ParticleResponse, aTouchedOneGoesOnAsItDid)
{
    // at rest under the same pull as before: it stays at rest
    for (const scalar K : {0.01, 1.0, 500.0})
    {
        auto q = particleOf(K, 1);
        const vector U(0.2, 0, 0.9);
        q.touched = true;
        q.velocity = q.mean = Zero;
        q.impulse = 0.3*(K*U + q.load);
        q.other = -(K*U + q.load);
        for (const scalar part : {0.4, 1.0})
        {
            const auto a = particleResponse::foresee(q, 0.3, 0.3, {part, 1, 1});
            EXPECT_NEAR(mag(a.b + a.s*U), 0, 1e-12) << "K " << K;
        }
    }
}


TEST(ParticleResponse, aTouchedOnesMomentaryVelocityCountsWhereDragIsSlow)
{
    // the pull of the interval before goes on; what it does at the moment is
    // soon forgotten where K T >> m, and goes on where K T << m
    const scalar T = 0.3;
    for (const scalar x : {1e-3, 1e3})
    {
        auto q = particleOf(x/T, 1);
        q.touched = true;
        q.load = Zero;
        const vector pull(q.mean + q.impulse/(q.K*T));
        const auto a = particleResponse::foresee(q, T, T, {0.4, 1, 1});
        const vector wanted
        (
            x > 1
          ? q.mean
          : q.velocity + 0.5*T/q.mass*(q.other + q.impulse/T)
        );
        EXPECT_NEAR(mag(a.b + a.s*pull - wanted), 0, 4e-3) << "x " << x;
    }
}


TEST(ParticleResponse, itsOwnDisturbanceMovesItNot)
{
    for (const bool touched : {false, true})
    {
        auto q = particleOf(3, 1);
        q.touched = touched;
        const auto a = particleResponse::foresee(q, 0.3, 0.3, {0.4, 1, 1});
        q.own = vector(0.25, 0, 0);
        const auto b = particleResponse::foresee(q, 0.3, 0.3, {0.4, 1, 1});
        // the cells' velocity is higher by its own part
        EXPECT_NEAR(mag(b.b + b.s*q.own - a.b), 0, 1e-12);
    }
}


TEST(ParticleResponse, stableForFreeOnes)
{
    EXPECT_LE(worst([](const oneCell& c, const velocityIs where)
    {
        return growth(c, truth::free, where, false);
    }), 1 + 1e-9);
}


TEST(ParticleResponse, stableForTouchedOnesWhateverTheyDo)
{
    for (const truth what : {truth::free, truth::plug, truth::held})
    {
        EXPECT_LE(worst([&](const oneCell& c, const velocityIs where)
        {
            return growth(c, what, where, true);
        }), 1 + 1e-9) << "truth " << int(what);
    }
}


// whatever their stiffness, from weak ones on that creep back over many
// intervals; the springs have no damping of their own
TEST(ParticleResponse, stableForThoseOnSprings)
{
    const auto largest =
        [](const velocityIs where, scalar x, const scalar added, const scalar k)
    {
        // the last half period counts: steps of less than a radian
        std::vector<scalar> springs;
        for (scalar omega = 0.03; omega < 3e3; omega *= omega < 8 ? 1.06 : 1.5)
        {
            springs.push_back(omega*omega);
        }
        auto guess = particleResponse::inMomentum();
        guess.kept = k;
        scalar found = 0;
        for (; x < 1.1e5; x *= std::sqrt(10))
        for (const scalar spring : springs)
        for (const scalar phi : {0.1, 0.5, 0.68})
        for (const scalar ratio : {1.0, 2.65, 10.0})
        {
            const scalar g = growth
            (
                {x, phi, ratio, added, spring},
                truth::sprung, where, true, guess
            );
            found = std::max(found, g);
        }
        return found;
    };
    const scalar kept = particleResponse::inMomentum().kept;
    EXPECT_LE(largest(velocityIs::across, 1e-3, 0, kept), 1 + 1e-6);
    EXPECT_LE(largest(velocityIs::along, 2, 0, kept), 1 + 1e-6);
    EXPECT_LE(largest(velocityIs::along, 1e-3, 0, kept), 1.08);
    EXPECT_LE(largest(velocityIs::across, 1e-3, 0.5, kept), 1.01);
    // taken to go on as they did
    EXPECT_GT(largest(velocityIs::across, 1e-3, 0, 1), 1.1);
}


TEST(ParticleResponse, takenForFreeHeldOnesBurst)
{
    const scalar g =
        growth({50, 0.6, 2.65, 0, 0}, truth::held, velocityIs::across, false);
    EXPECT_GT(g, 5);
}


TEST(ParticleResponse, itsConstantsMatter)
{
    const oneCell stiff{1e4, 0.6, 2.65, 0, 0};

    // more than half of a free one's answer in the equation of momentum
    const scalar much = growth
    (
        stiff, truth::held, velocityIs::across, true, {0.6, 0.7, 1}
    );
    EXPECT_GT(much, 1.5);

    // the whole debt at once
    const scalar g = growth
    (
        stiff, truth::held, velocityIs::across, true,
        particleResponse::inMomentum(), 1
    );
    EXPECT_GT(g, 1.5);
}
