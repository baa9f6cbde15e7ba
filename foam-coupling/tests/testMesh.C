// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "testMesh.H"

#include <algorithm>
#include <array>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
using namespace Foam;

pointField grid(const Vector<label>& n, const point& lo, const point& hi)
{
    pointField points((n.x() + 1)*(n.y() + 1)*(n.z() + 1));
    label m = 0;
    for (label k = 0; k <= n.z(); ++k)
    for (label j = 0; j <= n.y(); ++j)
    for (label i = 0; i <= n.x(); ++i)
    {
        points[m++] = point
        (
            lo.x() + (hi.x() - lo.x())*i/n.x(),
            lo.y() + (hi.y() - lo.y())*j/n.y(),
            lo.z() + (hi.z() - lo.z())*k/n.z()
        );
    }
    return points;
}

// corner labels of each hexahedron, bit 0 in x, bit 1 in y, bit 2 in z
std::vector<std::array<label, 8>> hexahedra(const Vector<label>& n)
{
    std::vector<std::array<label, 8>> result;
    for (label k = 0; k < n.z(); ++k)
    for (label j = 0; j < n.y(); ++j)
    for (label i = 0; i < n.x(); ++i)
    {
        std::array<label, 8> corner;
        for (label c = 0; c < 8; ++c)
        {
            corner[c] =
                (i + (c & 1))
              + (n.x() + 1)
               *((j + (c >> 1 & 1)) + (n.y() + 1)*(k + (c >> 2 & 1)));
        }
        result.push_back(corner);
    }
    return result;
}
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::test::polyhedra::move(const std::function<point(const point&)>& to)
{
    for (point& p : points)
    {
        p = to(p);
    }
}


Foam::test::polyhedra Foam::test::block
(
    const Vector<label>& n,
    const point& lo,
    const point& hi
)
{
    polyhedra result;
    result.points = grid(n, lo, hi);
    static const label side[6][4] =
    {
        {0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
        {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}
    };

    for (const auto& corner : hexahedra(n))
    {
        std::vector<face> faces;
        for (const auto& s : side)
        {
            face f(4);
            for (label m = 0; m < 4; ++m)
            {
                f[m] = corner[s[m]];
            }
            faces.push_back(f);
        }
        result.cells.push_back(faces);
    }
    return result;
}


Foam::test::polyhedra Foam::test::tetBlock
(
    const Vector<label>& n,
    const point& lo,
    const point& hi
)
{
    polyhedra result;
    result.points = grid(n, lo, hi);

    // along the diagonal 0-7 by each order of the axes
    std::array<label, 3> axes{{0, 1, 2}};
    do
    {
        const label a = 1 << axes[0];
        const label b = a | 1 << axes[1];
        const bool even =
            (axes[1] - axes[0] + 3) % 3 == 1;

        for (const auto& corner : hexahedra(n))
        {
            std::array<label, 4> t
            {{
                corner[0], corner[even ? a : b],
                corner[even ? b : a], corner[7]
            }};
            static const label side[4][3] =
            {
                {0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}
            };
            std::vector<face> faces;
            for (const auto& s : side)
            {
                face f(3);
                for (label m = 0; m < 3; ++m)
                {
                    f[m] = t[s[m]];
                }
                faces.push_back(f);
            }
            result.cells.push_back(faces);
        }
    }
    while (std::next_permutation(axes.begin(), axes.end()));

    return result;
}


Foam::test::polyhedra Foam::test::cylinder
(
    const Vector<label>& n,
    const scalar R,
    const scalar H
)
{
    polyhedra result(block(n, point(-1, -1, 0), point(1, 1, 1)));
    result.move
    (
        [&](const point& p)
        {
            return point
            (
                R*p.x()*std::sqrt(1 - sqr(p.y())/2),
                R*p.y()*std::sqrt(1 - sqr(p.x())/2),
                H*p.z()
            );
        }
    );
    return result;
}


void Foam::test::shake
(
    polyhedra& cells,
    const scalar length,
    const unsigned seed,
    const bool sides
)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<scalar> by(-length, length);
    const boundBox box(cells.points, false);

    cells.move
    (
        [&](const point& p)
        {
            point q(p);
            for (direction axis = 0; axis < 3; ++axis)
            {
                const scalar step = by(random);
                const bool side =
                    mag(p[axis] - box.min()[axis]) < 1e-9
                 || mag(p[axis] - box.max()[axis]) < 1e-9;
                if (sides || !side)
                {
                    q[axis] += step;
                }
            }
            return q;
        }
    );
}
