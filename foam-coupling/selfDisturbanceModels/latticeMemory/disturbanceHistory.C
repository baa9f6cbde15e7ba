// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "disturbanceHistory.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// numbers of a map and of an entry
constexpr int mapSize = 15, entrySize = 5 + mapSize;

void put(std::vector<double>& to, const Foam::vector& v)
{
    to.insert(to.end(), {v.x(), v.y(), v.z()});
}

void put(std::vector<double>& to, const Foam::latticeMap& m)
{
    put(to, m.centre);
    put(to, m.h);
    for (const auto& axis : m.share)
    {
        to.insert(to.end(), axis.begin(), axis.end());
    }
}

Foam::vector takeVector(const double*& from)
{
    from += 3;
    return Foam::vector(from[-3], from[-2], from[-1]);
}

Foam::latticeMap takeMap(const double*& from)
{
    Foam::latticeMap m;
    m.centre = takeVector(from);
    m.h = takeVector(from);
    for (auto& axis : m.share)
    {
        std::copy(from, from + 3, axis.begin());
        from += 3;
    }
    return m;
}

}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::latticeWeights Foam::latticeMap::apart(const latticeMap& from) const
{
    latticeWeights w;
    for (int d = 0; d < 3; ++d)
    {
        const scalar x = (centre[d] - from.centre[d])/h[d];
        const scalar step = from.h[d]/h[d];
        for (int a = 0; a < 3; ++a)
        {
            for (int b = 0; b < 3; ++b)
            {
                const scalar weight = share[d][a]*from.share[d][b];
                if (weight != 0)
                {
                    w[d].add(x + (a - 1) - step*(b - 1), weight);
                }
            }
        }
    }
    return w;
}


Foam::latticeMap Foam::latticeMap::mean
(
    const latticeMap& a,
    const scalar wa,
    const latticeMap& b,
    const scalar wb
)
{
    latticeMap m;
    m.h = a.h;
    for (int d = 0; d < 3; ++d)
    {
        // all weights by layers from a's middle one
        latticeLine line;
        scalar sum = 0, moment = 0;
        const auto add = [&](const latticeMap& from, const scalar w)
        {
            for (int k = 0; k < 3; ++k)
            {
                const scalar x =
                    (from.centre[d] - a.centre[d] + (k - 1)*from.h[d])/a.h[d];
                if (from.share[d][k] != 0)
                {
                    line.add(x, w*from.share[d][k]);
                    sum += w*from.share[d][k];
                    moment += w*from.share[d][k]*x;
                }
            }
        };
        add(a, wa);
        add(b, wb);
        moment /= sum;

        const int middle = int(std::lround(moment));
        m.centre[d] = a.centre[d] + middle*a.h[d];
        if (line.lo < middle - 1 || line.hi > middle + 1)
        {
            // too wide: the two layers around the centre of the weights
            line = latticeLine();
            line.add(moment, sum);
        }
        for (int k = 0; k < 3; ++k)
        {
            const int o = middle + k - 1;
            m.share[d][k] =
                std::abs(o) <= latticeLine::half ? line(o)/sum : 0;
        }
        if (std::abs(middle) > latticeLine::half - 1)
        {
            m.share[d] = {0, 1, 0};
        }
    }
    return m;
}


Foam::point Foam::latticeMap::middle() const
{
    point x(centre);
    for (int d = 0; d < 3; ++d)
    {
        x[d] += (share[d][2] - share[d][0])*h[d];
    }
    return x;
}


void Foam::disturbanceHistory::move(const vector& by)
{
    last.centre += by;
    before.centre += by;
    for (entry& e : entries)
    {
        e.map.centre += by;
    }
}


void Foam::disturbanceHistory::add
(
    const scalar T,
    const vector& u,
    const vector& impulse
)
{
    for (entry& e : entries)
    {
        e.young += T;
        e.old += T;
        e.map.centre += T*u;
    }

    entry e{0, T, impulse, last};
    e.map.centre += 0.5*T*u;
    entries.insert(entries.begin(), e);

    // join what is old enough
    size_t to = 0;
    for (size_t k = 1; k < entries.size(); ++k)
    {
        entry& a = entries[to];
        const entry& b = entries[k];
        if (b.old - a.young <= 0.3*a.young)
        {
            const scalar wa = mag(a.impulse) + VSMALL;
            const scalar wb = mag(b.impulse) + VSMALL;
            a.map = latticeMap::mean(a.map, wa, b.map, wb);
            a.impulse += b.impulse;
            a.old = b.old;
        }
        else if (++to != k)
        {
            entries[to] = b;
        }
    }
    entries.resize(to + 1);
}


std::vector<double> Foam::disturbanceHistory::pack() const
{
    std::vector<double> to;
    put(to, last);
    put(to, before);
    put(to, sent);
    for (const entry& e : entries)
    {
        to.push_back(e.young);
        to.push_back(e.old);
        put(to, e.impulse);
        put(to, e.map);
    }
    return to;
}


Foam::disturbanceHistory Foam::disturbanceHistory::unpack
(
    const double* from,
    const double* end
)
{
    disturbanceHistory h;
    h.last = takeMap(from);
    h.before = takeMap(from);
    h.sent = takeVector(from);
    while (end - from >= entrySize)
    {
        entry e;
        e.young = *from++;
        e.old = *from++;
        e.impulse = takeVector(from);
        e.map = takeMap(from);
        h.entries.push_back(e);
    }
    return h;
}
