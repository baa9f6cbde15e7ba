// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Description
    Numbers at the ends of their ranges and beyond, and what a refusal says.
\*---------------------------------------------------------------------------*/

#include "checkedNumber.H"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace Foam;

namespace
{

// what is said of the number; empty when it is taken
std::string said(const std::function<void(const dictionary&)>& check)
{
    try
    {
        check(dictionary());
    }
    catch (const Foam::IOerror& error)
    {
        return error.message();
    }
    return "";
}

}


TEST(checkedNumber, above)
{
    const auto of = [](const scalar x)
    {
        return said
        (
            [&](const dictionary& d) { numberAbove(d, "width", x, 2, " m"); }
        );
    };
    EXPECT_EQ(of(2.001), "");
    EXPECT_EQ(of(2), "width 2 must be above 2 m");
    EXPECT_NE(of(std::nan("")), "");
    EXPECT_EQ(numberAbove(dictionary(), "width", 3, 2), 3);
}


TEST(checkedNumber, from)
{
    const auto of = [](const scalar x)
    {
        return said
        (
            [&](const dictionary& d) { numberFrom(d, "n", x, -10, 0); }
        );
    };
    EXPECT_EQ(of(-10), "");
    EXPECT_EQ(of(0), "");
    EXPECT_EQ(of(0.5), "n 0.5 must be from -10 to 0");
    EXPECT_NE(of(-10.1), "");
    EXPECT_NE(of(std::nan("")), "");
}


TEST(checkedNumber, between)
{
    const auto of = [](const scalar x)
    {
        return said
        (
            [&](const dictionary& d) { numberBetween(d, "n", x, 0, 1); }
        );
    };
    EXPECT_EQ(of(0.5), "");
    EXPECT_EQ(of(1), "n 1 must lie between 0 and 1");
    EXPECT_NE(of(0), "");
    EXPECT_NE(of(std::nan("")), "");
}


TEST(checkedNumber, wholeNumbers)
{
    const auto of = [](const label k)
    {
        return said
        (
            [&](const dictionary& d) { wholeNumberFrom(d, "steps", k, 1, 9); }
        );
    };
    EXPECT_EQ(of(1), "");
    EXPECT_EQ(of(9), "");
    EXPECT_EQ(of(10), "steps 10 must be a whole number from 1 to 9");
    EXPECT_NE(of(0), "");
}
