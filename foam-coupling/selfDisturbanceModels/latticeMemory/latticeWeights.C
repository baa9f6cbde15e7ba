// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "latticeWeights.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::latticeLine::add(const scalar x, const scalar w)
{
    const scalar below = std::floor(x + 1e-9);
    const scalar above = max(0.0, x - below);
    const auto put = [&](const int o, const scalar v)
    {
        if (v != 0 && o >= -half && o <= half)
        {
            weight[o + half] += v;
            lo = std::min(lo, o);
            hi = std::max(hi, o);
        }
    };
    if (std::fabs(below) < 1e6)
    {
        put(int(below), w*(1 - above));
        put(int(below) + 1, above > 1e-9 ? w*above : 0);
    }
}
