// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "latticeMemory.H"
#include "testMesh.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

latticeWeights at(const scalar x, const scalar y, const scalar z)
{
    latticeWeights w;
    w[0].add(x, 1);
    w[1].add(y, 1);
    w[2].add(z, 1);
    return w;
}

}


// by sums over the wave numbers of a periodic lattice, far larger than reach
TEST(selfDisturbance, responseByFourier)
{
    const latticeResponse table(vector::one, 0.3);
    const int N = 48;

    for (const scalar theta : {0.0, 0.05, 0.7})
    {
        using offset = Vector<int>;
        for
        (
            const offset& o
          : {offset(0, 0, 0), offset(1, 0, 2), offset(-1, 2, 1)}
        )
        {
            symmTensor T(Zero), L(Zero);
            vector D(Zero);
            scalar H = 0;
            for (int a = 0; a < N; ++a)
            for (int b = 0; b < N; ++b)
            for (int c = 0; c < N; ++c)
            {
                const vector k(2*M_PI*a/N, 2*M_PI*b/N, 2*M_PI*c/N);
                vector s, m;
                for (int d = 0; d < 3; ++d)
                {
                    s[d] = 2*std::sin(k[d]/2);
                    m[d] = std::cos(k[d]/2);
                }
                const scalar s2 = magSqr(s);
                const scalar phase =
                    std::cos(k.x()*o.x() + k.y()*o.y() + k.z()*o.z())
                   /(scalar(N)*N*N);
                const symmTensor mm(sqr(m));
                symmTensor ss(Zero);
                if (s2 > 0)
                {
                    ss = sqr(vector(cmptMultiply(s, m)))/s2;
                }
                const symmTensor one
                (
                    mm.xx(), 0, 0, mm.yy(), 0, mm.zz()
                );
                T += phase*std::exp(-s2*theta)*(one - ss);
                D += phase*std::exp(-s2*theta)*cmptMultiply(s, s)/4;
                L += phase*std::exp(-s2*0.3)*ss;
                H += phase*std::exp(-s2*0.3);
            }
            const latticeWeights w(at(o.x(), o.y(), o.z()));
            // the periodic one lacks the mean of the infinite lattice's
            const auto both(table.mean(w, theta, theta));
            const symmTensor got(both.byFaces);
            EXPECT_NEAR(mag(both.byCells - D), 0, 1e-3) << theta;
            for (direction c = 0; c < 6; ++c)
            {
                EXPECT_NEAR(got[c], T[c], 1e-3) << theta << ' ' << int(c);
                EXPECT_NEAR(table.longitudinal(w)[c], L[c], 1e-3) << int(c);
            }
            EXPECT_NEAR(table.share(w), H, 1e-6);
        }
    }
}


TEST(selfDisturbance, meansAddUp)
{
    const latticeResponse table(vector(1, 2, 0.5), 0);
    const latticeWeights w(at(0.3, 0, -1));

    // one long interval against many short ones
    for (const scalar from : {0.0, 0.01, 1.0})
    {
        symmTensor sum(Zero);
        const int n = 4000;
        const scalar step = (10*from + 0.02)/n;
        for (int k = 0; k < n; ++k)
        {
            sum +=
                table.mean(w, from + k*step, from + (k + 1)*step).byFaces/n;
        }
        const symmTensor whole
        (
            table.mean(w, from, from + n*step).byFaces
        );
        for (direction c = 0; c < 6; ++c)
        {
            EXPECT_NEAR(sum[c], whole[c], 3e-3*mag(whole))
                << from << ' ' << int(c);
        }
    }
}


// the table goes over into the continuum's unsteady Stokeslet
TEST(selfDisturbance, farAndLate)
{
    const latticeResponse table(vector::one, 0);
    for (const scalar theta : {8.0, 30.0})
    {
        for
        (
            const vector& r
          : {vector(0, 0, 0), vector(3, 1, 0), vector(4, -4, 2)}
        )
        {
            const symmTensor lattice
            (
                table.mean(at(r.x(), r.y(), r.z()), theta, theta).byFaces
            );
            const symmTensor far(latticeResponse::far(r, theta + 0.15));
            for (direction c = 0; c < 6; ++c)
            {
                EXPECT_NEAR(far[c], lattice[c], 0.03*mag(lattice))
                    << theta << r;
            }
        }
    }
}


// a source of volume sends its flux through any box around it
TEST(selfDisturbance, sourceKeepsVolume)
{
    const latticeResponse table(vector::one, 0);
    scalar out = 0;
    for (int y = -4; y <= 4; ++y)
    {
        for (int z = -4; z <= 4; ++z)
        {
            // cells hold the mean of two faces; through one of six sides
            out +=
                0.5*
                (
                    table.source(at(4, y, z)).x()
                  + table.source(at(5, y, z)).x()
                );
        }
    }
    EXPECT_NEAR(6*out, 1, 0.02);
}


TEST(selfDisturbance, historyKeepsImpulse)
{
    disturbanceHistory h;
    h.last.share = {{{0.2, 0.8, 0}, {0, 1, 0}, {0, 0.5, 0.5}}};
    scalar t = 0;
    for (int k = 0; k < 3000; ++k)
    {
        h.last.centre.z() -= 1e-3;
        h.add(1e-3, vector(0.5, 0, 0), vector(1, 2, 3));
        t += 1e-3;
    }
    EXPECT_LT(h.entries.size(), 45u);

    vector sum(Zero);
    scalar young = 0;
    for (const auto& e : h.entries)
    {
        sum += e.impulse;
        EXPECT_NEAR(e.young, young, 1e-9);
        young = e.old;

        // given at the age's middle, carried along since then
        const scalar age = 0.5*(e.young + e.old);
        const point x(e.map.middle());
        EXPECT_NEAR(x.x(), 0.5*age - 0.2, 0.51e-3 + 0.02*age);
        EXPECT_NEAR(x.z(), -3 + age + 0.5, 1.1e-3 + 0.02*age);
    }
    EXPECT_NEAR(young, 3, 1e-9);
    EXPECT_NEAR(mag(sum - 3000*vector(1, 2, 3)), 0, 1e-6);

    const std::vector<double> numbers(h.pack());
    const disturbanceHistory copy
    (
        disturbanceHistory::unpack
        (
            numbers.data(), numbers.data() + numbers.size()
        )
    );
    EXPECT_EQ(copy.pack(), numbers);
}


TEST(selfDisturbance, excessOfSuspensions)
{
    typedef selfDisturbanceModels::latticeMemory model;
    EXPECT_DOUBLE_EQ(model::excess(0), 1);
    // by hand: 0.9^4/(1.2^2 - 0.0039), 0.6^4/(1.8^2 - 0.2304)
    EXPECT_NEAR(model::excess(0.1), 0.45686, 1e-5);
    EXPECT_NEAR(model::excess(0.4), 0.04306, 1e-5);
}


// a single sphere's steady drag in one cell, from the mesh's own response
TEST(selfDisturbance, steadyPointForce)
{
    const test::meshCase c
    (
        test::block({20, 20, 20}, point(-1, -1, -1), point(1, 1, 1))
    );
    const scalar h = 0.1, nu = 0.5, rho = 2;
    autoPtr<selfDisturbanceModel> model
    (
        selfDisturbanceModel::New
        (
            test::settings("selfDisturbance latticeMemory;"),
            {c.mesh(), "centre", "mapped", nu, rho, 0, 0, true}
        )
    );
    dispersedParticles p;
    p.setSize(1);
    p.position[0] = point(0.05, 0.05, 0.05);
    p.radius = 1e-4;
    p.volume = 1e-12;
    p.mass = 1;
    p.tag = 7;
    p.locate(c.mesh());

    const scalar T = 0.02*sqr(h)/nu;
    const vector F(0, 0, -3);
    vectorField velocity, force;
    scalarField solid;
    for (int k = 0; k < 2000; ++k)
    {
        p.impulse = k > 0 ? T*F : vector::zero;
        model->evaluate
        (
            p, T, vectorField(1, Zero), scalarField(1, 1.0),
            velocity, solid, force
        );
        model->sent(p, scalarField(1, 0.0), vectorField(1, Zero));
    }
    // steady: sum over a lattice's wave numbers of c_z^2 (1 - s_z^2/s^2)/s^2,
    // less the sum of what is older than 40 h^2/nu
    scalar steady = 0;
    const int N = 96;
    for (int a = 0; a < N; ++a)
    for (int b = 0; b < N; ++b)
    for (int e = 0; e < N; ++e)
    {
        const scalar s2 = 4*
        (
            sqr(std::sin(M_PI*(a + 0.5)/N)) + sqr(std::sin(M_PI*(b + 0.5)/N))
          + sqr(std::sin(M_PI*(e + 0.5)/N))
        );
        const scalar sz2 = 4*sqr(std::sin(M_PI*(e + 0.5)/N));
        steady += (1 - sz2/4)*(1 - sz2/s2)/s2*(1 - std::exp(-s2*40));
    }
    steady *= mag(F)/(rho*nu*h)/(scalar(N)*N*N);
    EXPECT_NEAR(velocity[0].z(), steady, 0.01*steady);
    EXPECT_NEAR(mag(velocity[0]), mag(velocity[0].z()), 1e-9);
    // a third of a force in one cell is longitudinal, less by the faces' means
    EXPECT_GT(force[0].z(), -3*1e-9);
}


// a sphere that leaves through a periodic side and comes in at the other takes
// its history along
TEST(selfDisturbance, throughPeriodicSides)
{
    const test::meshCase c
    (
        test::block({20, 20, 20}, point(-1, -1, -1), point(1, 1, 1))
    );
    const scalar h = 0.1, nu = 0.5, rho = 2, T = 0.02*sqr(h)/nu;
    const auto after = [&](const scalar from)
    {
        autoPtr<selfDisturbanceModel> model
        (
            selfDisturbanceModel::New
            (
                test::settings("selfDisturbance latticeMemory;"),
                {c.mesh(), "exactOverlap", "mapped", nu, rho, 0, 0, true}
            )
        );
        dispersedParticles p;
        p.setSize(1);
        p.radius = 0.02;
        p.volume = 1e-12;
        p.mass = 1;
        p.tag = 7;
        vectorField velocity, force;
        scalarField solid;
        scalar z = from;
        for (int k = 0; k < 100; ++k)
        {
            z -= 0.006;
            p.position[0] = point(0.05, 0.05, z < -1 ? z + 2 : z);
            p.locate(c.mesh());
            p.impulse = k > 0 ? vector(0, 0, -3*T) : vector::zero;
            model->evaluate
            (
                p, T, vectorField(1, Zero), scalarField(1, 1.0),
                velocity, solid, force
            );
            model->sent(p, scalarField(1, 0.0), vectorField(1, Zero));
        }
        return velocity[0];
    };
    const vector inside(after(0.53)), through(after(-0.47));
    EXPECT_GT(mag(inside), 0);
    EXPECT_NEAR(mag(through - inside), 0, 1e-6*mag(inside));
}
