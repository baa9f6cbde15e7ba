// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "latticeHeat.H"

#include <cmath>
#include <vector>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::latticeHeat::set(const scalar x, const scalar a)
{
    constexpr int points = 512;
    static const std::vector<double> cosines = []()
    {
        std::vector<double> c(2*points);
        for (int m = 0; m < 2*points; ++m)
        {
            c[m] = std::cos(M_PI*m/points);
        }
        return c;
    }();

    // p_n = 1/pi int_0^pi cos(n k) exp(-2x (1 - cos k)) dk
    constexpr int needed = count + 3;
    double kernel[needed] = {};
    if (x > 0)
    {
        for (int m = 0; m <= points; ++m)
        {
            const double e =
                std::exp(-2*x*(1 - cosines[m]))
               *(m == 0 || m == points ? 0.5 : 1)/points;
            for (int n = 0; n < needed; ++n)
            {
                kernel[n] += e*cosines[(n*m) % (2*points)];
            }
        }
    }
    else
    {
        kernel[0] = 1;
    }

    const auto at = [&](const int n) { return kernel[std::abs(n)]; };
    const auto bent = [&](const int n)
    {
        return a*(2*at(n) - at(n - 1) - at(n + 1));
    };
    for (int n = 0; n < count; ++n)
    {
        p[n] = at(n);
        mean[n] = (at(n - 1) + 2*at(n) + at(n + 1))/4;
        curve[n] = bent(n);
        curve2[n] = a*(2*bent(n) - bent(n - 1) - bent(n + 1));
        // 1 - (s h)^2/4 is the mean's transform
        meanCurve[n] = (bent(n - 1) + 2*bent(n) + bent(n + 1))/4;
        slope[n] = std::sqrt(a)*(at(n + 1) - at(n - 1))/2;
    }
}
