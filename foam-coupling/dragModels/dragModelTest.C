// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "dragModel.H"
#include "testMesh.H"

#include <gtest/gtest.h>

#include <map>

using namespace Foam;

namespace
{

autoPtr<dragModel> law(const std::string& name, const std::string& more = "")
{
    return dragModel::New(test::settings("dragModel " + name + ";" + more));
}

// a fluid with rho = mu = d = 1: Re is n times slip
scalar coefficient(const dragModel& m, const scalar n, const scalar Re)
{
    return m.coefficient(n, Re/n, 1, 1, 1);
}

// low Re settling velocity in a closed column over that of a sphere alone
scalar settling(const dragModel& m, const scalar n)
{
    return n*n*18/coefficient(m, n, 1e-12);
}

}


TEST(dragModel, closedColumnTable)
{
    const auto wenYu = law("ergunWenYu");
    const auto blended = law("ergunWenYuBlended");
    const auto gidaspow = law("Gidaspow");
    const auto alone = law("WenYu");
    const auto bed = law("Ergun");
    const auto diFelice = law("DiFelice");
    const auto beetstra = law("Beetstra");
    const auto kochHill = law("KochHill");

    const auto rows = test::table("hindered_settling_by_drag_law_formula.csv");
    ASSERT_EQ(rows.size(), 16u);

    for (const auto& row : rows)
    {
        const auto value = [&](const int c) { return std::stod(row[c]); };
        const scalar phi = value(0);
        const scalar n = 1 - phi;
        // the table has five decimals
        const scalar eps = 1.1e-5;

        EXPECT_NEAR(settling(*alone, n), value(1), eps) << phi;
        EXPECT_NEAR(settling(*diFelice, n), value(2), eps) << phi;
        EXPECT_NEAR(settling(*bed, n), value(3), eps) << phi;
        EXPECT_NEAR(settling(*gidaspow, n), value(4), eps) << phi;
        EXPECT_NEAR(settling(*beetstra, n), value(5), eps) << phi;
        EXPECT_NEAR(settling(*kochHill, n), value(6), eps) << phi;

        if (n >= 0.8)
        {
            EXPECT_NEAR(settling(*wenYu, n), std::pow(n, 4.7), 1e-7) << phi;
            EXPECT_NEAR(settling(*gidaspow, n), value(1), eps) << phi;
        }
        else
        {
            EXPECT_NEAR(settling(*wenYu, n), value(3), eps) << phi;
        }
        if (n < 0.75 - 1e-9 || n > 0.85 + 1e-9)
        {
            EXPECT_DOUBLE_EQ(settling(*blended, n), settling(*wenYu, n));
        }
    }
}


TEST(dragModel, measuredSpheres)
{
    const auto rows = test::table("roos_willmarth1971_spheres.csv");
    ASSERT_EQ(rows.size(), 122u);

    const auto errors = [&](const dragModel& m, const scalar most)
    {
        scalar sum = 0, squares = 0;
        label n = 0;
        for (const auto& row : rows)
        {
            const scalar Re = std::stod(row[0]);
            if (Re <= most)
            {
                // C_D = 4/3 coefficient/(rho slip/d)
                const scalar Cd = 4.0/3*m.coefficient(1, Re, 1, 1, 1)/Re;
                const scalar error = Cd/std::stod(row[1]) - 1;
                sum += error;
                squares += error*error;
                ++n;
            }
        }
        return std::make_pair(mag(sum/n), std::sqrt(squares/n));
    };

    // the range the law was made for
    const auto usual = law("SchillerNaumann");
    EXPECT_LT(errors(*usual, 1000).first, 0.03);
    EXPECT_LT(errors(*usual, 1000).second, 0.07);
    // beyond it with the usual constant, and with one nearer to these data
    EXPECT_LT(errors(*usual, GREAT).first, 0.03);
    EXPECT_LT(errors(*usual, GREAT).second, 0.08);
    const auto fitted =
        law("SchillerNaumann", "SchillerNaumannCoeffs { newtonCd 0.46; }");
    EXPECT_LT(errors(*fitted, GREAT).first, 0.03);
    EXPECT_LT(errors(*fitted, GREAT).second, 0.07);
}


TEST(dragModel, ofABodyIsItsOwnWhenAloneAndHinderedAsASphere)
{
    for (const char* name : {"ergunWenYu", "SchillerNaumann", "Beetstra"})
    {
        const auto m = law(name);
        EXPECT_NEAR(m->bodyCoefficient(1.3, 1, 0.2, 2e-3, 1e-6, 1000)
           /(1.3*18*1e-3/4e-6), 1, 1e-14) << name;
        for (const scalar n : {0.5, 0.9})
        {
            EXPECT_NEAR
            (
                m->bodyCoefficient(1.3, n, 0.2, 2e-3, 1e-6, 1000)
               *m->coefficient(1, 0.2, 2e-3, 1e-6, 1000),
                1.3*18*1e-3/4e-6*m->coefficient(n, 0.2, 2e-3, 1e-6, 1000),
                1e-6*m->coefficient(n, 0.2, 2e-3, 1e-6, 1000)
            ) << name;
        }
    }
}


// Values worked out by hand (four to six figures) from the published formulas
// with rho = mu = d = 1.
TEST(dragModel, valuesByHand)
{
    struct entry
    {
        const char* name;
        scalar n, Re, value;
    };
    const entry entries[] =
    {
        // 1/n (150 (1 - n) + 1.75 Re)
        {"ergunWenYu", 0.5, 0, 150},
        {"ergunWenYu", 0.5, 100, 500},
        {"ergunWenYu", 0.79, 10, 62.0253},
        // 18 n^-2.7 (1 + 0.15 Re^0.687); 10^0.687 = 4.86407
        {"ergunWenYu", 0.9, 10, 41.3774},
        {"ergunWenYu", 1, 0, 18},
        // 3/4 0.43 Re n^-2.7 at Re 2000, 0.9^-2.7 = 1.329050
        {"ergunWenYu", 0.9, 2000, 857.237},
        // half of each at 0.8: (37.5 + 18 0.8^-2.7)/2, 0.8^-2.7 = 1.826639
        {"ergunWenYuBlended", 0.8, 0, 35.1898},
        // slip 100 in it, whatever n: Re 100, 100^0.687 = 23.6592
        {"SchillerNaumann", 0.5, 50, 81.8798},
        {"SchillerNaumann", 1, 100, 81.8798},
        // 3/4 0.44 Re
        {"SchillerNaumann", 1, 5000, 1650},
        // 150 (1 - n)/n + 1.75 Re/n
        {"Gidaspow", 0.5, 100, 500},
        // 18 n^-2.65 (1 + 0.15 Re^0.687), 0.9^-2.65 = 1.322067
        {"Gidaspow", 0.9, 10, 41.1600},
        // 3/4 0.44 Re n^-2.65
        {"Gidaspow", 0.9, 2000, 872.564},
        // 3/4 4.8^2
        {"DiFelice", 1, 0, 17.28},
        // Re 100: log 2, chi 3.7 - 0.65 exp(-1/8) = 3.126377,
        // (6.3 + 4.8)^2 = 123.21, 0.5^-2.126377 = 4.366196
        {"DiFelice", 0.5, 100, 403.469},
        {"DiFelice", 1, 100, 92.4075},
        // phi 0.5: F = 20 + 0.25 (1 + 1.5 sqrt 0.5) = 20.515165
        {"Beetstra", 0.5, 0, 184.6365},
        // Re 100, phi 0.5: 2 + 0.75 + 8.4 100^-0.343 (0.206063) = 4.480929
        // over 1 + 10^1.5 100^-1.5 = 1.0316228, times 41.3/6 = 6.883333
        {"Beetstra", 0.5, 100, 453.726},
        {"Beetstra", 1, 0, 18},
        // phi 0.5: F0 = 40, F3 = 0.0673 + 0.106 + 0.7424 = 0.9157
        {"KochHill", 0.5, 0, 180},
        {"KochHill", 0.5, 100, 386.0325},
        // phi 0.1: F0 = (1 + 3 sqrt 0.05 - 0.485670 + 1.614)
        //   /(1 + 0.0681 - 0.0848 + 0.00816) = 2.799150/0.99146 = 2.823260
        {"KochHill", 0.9, 0, 41.1627},
        // F3 = 0.0673 + 0.0212 + 0.0232/0.59049 = 0.127790, Re 10
        {"KochHill", 0.9, 10, 50.4785},
        {"KochHill", 1, 0, 18},
        // as Gidaspow's branches
        {"Ergun", 0.9, 10, 36.1111},
        {"Ergun", 0.5, 100, 500},
        {"WenYu", 0.9, 10, 41.1600},
        {"WenYu", 0.5, 0, 112.9801},
        {"Stokes", 0.5, 100, 18},
        // A 0.5^4.14 = 0.0567199 = V_r: 3/4 0.5 4.8^2/V_r
        {"SyamlalOBrien", 0.5, 0, 152.327},
        // V_r = 1: as Di Felice alone
        {"SyamlalOBrien", 1, 100, 92.4075},
        // slip 100 in it: B 0.329436,
        // V_r = (A - 6 + (36 + 12 (2 B - A) + A^2)^1/2)/2 = 0.3158,
        // 3/4 50 (0.63 + 4.8 (V_r/100)^1/2)^2/V_r^2
        {"SyamlalOBrien", 0.5, 50, 304.398}
    };

    for (const entry& e : entries)
    {
        const auto m = law(e.name);
        EXPECT_NEAR(coefficient(*m, e.n, e.Re), e.value, 2e-5*e.value)
            << e.name << " n " << e.n << " Re " << e.Re;
    }
}


// the same numbers in SI units: 1 mm, water
TEST(dragModel, units)
{
    for (const char* name :
        {
            "ergunWenYu", "ergunWenYuBlended", "SchillerNaumann", "Gidaspow",
            "DiFelice", "Beetstra", "KochHill", "WenYu", "Stokes",
            "SyamlalOBrien"
        })
    {
        const auto m = law(name);
        const scalar d = 1e-3, nu = 8.94e-7, rho = 1000, n = 0.83;
        const scalar slip = 0.05;
        const scalar Re = n*slip*d/nu;
        EXPECT_NEAR
        (
            m->coefficient(n, slip, d, nu, rho)*d*d/(nu*rho),
            coefficient(*m, n, Re),
            1e-9*coefficient(*m, n, Re)
        )   << name;
        EXPECT_NEAR
        (
            m->hindrance(n, slip, d, nu, rho),
            m->coefficient(n, slip, d, nu, rho)
           /m->coefficient(1, slip, d, nu, rho),
            1e-12
        )   << name;
        EXPECT_EQ(m->hindrance(1, slip, d, nu, rho), 1) << name;
    }
}


TEST(dragModel, jumpAndBlend)
{
    const auto sharp = law("ergunWenYu");
    const auto blended = law("ergunWenYuBlended");
    const scalar below = coefficient(*sharp, 0.8 - 1e-9, 0);
    const scalar above = coefficient(*sharp, 0.8, 0);
    EXPECT_NEAR(below, 37.5, 1e-6);
    EXPECT_NEAR(above/below, 0.8768, 1e-4);

    // no step, and no bend at the ends of the blend
    scalar last = coefficient(*blended, 0.7, 1);
    for (scalar n = 0.7; n < 0.9; n += 1e-4)
    {
        const scalar now = coefficient(*blended, n, 1);
        EXPECT_LT(std::abs(now - last), 0.04) << n;
        last = now;
    }
    for (const scalar n : {0.75, 0.85})
    {
        const scalar h = 1e-5;
        const scalar before =
            coefficient(*blended, n, 1) - coefficient(*blended, n - h, 1);
        const scalar after =
            coefficient(*blended, n + h, 1) - coefficient(*blended, n, 1);
        EXPECT_NEAR(before/h, after/h, 0.03) << n;
    }

    const auto wide = law
    (
        "ergunWenYuBlended", "ergunWenYuBlendedCoeffs { width 0.2; }"
    );
    EXPECT_NE(coefficient(*wide, 0.72, 1), coefficient(*sharp, 0.72, 1));
    EXPECT_EQ(coefficient(*blended, 0.72, 1), coefficient(*sharp, 0.72, 1));
}


TEST(dragModel, refusals)
{
    try
    {
        law("Newton");
        FAIL() << "an unknown law was taken";
    }
    catch (const Foam::error& e)
    {
        const std::string text(e.message());
        EXPECT_NE(text.find("dragModel Newton is not known"), text.npos);
        EXPECT_NE(text.find("ergunWenYuBlended"), text.npos) << text;
        EXPECT_NE(text.find("KochHill"), text.npos) << text;
    }
    EXPECT_THROW
    (
        law("ergunWenYuBlended", "ergunWenYuBlendedCoeffs { width 0; }"),
        Foam::error
    );
    try
    {
        law("ergunWenYuBlended", "ergunWenYuBlendedCoeffs { widht 0.1; }");
        FAIL() << "an unknown entry was taken";
    }
    catch (const Foam::error& e)
    {
        const std::string text(e.message());
        EXPECT_NE(text.find("unknown entry widht"), text.npos) << text;
        EXPECT_NE(text.find("width"), text.npos) << text;
    }
}
