// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "dividedVoidFraction.H"
#include "checkedNumber.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"

#include <algorithm>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace voidFractionModels
{
    defineTypeNameAndDebug(divided, 0);
    addToRunTimeSelectionTable(voidFractionModel, divided, dictionary);
}
}


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

Foam::pointField Foam::voidFractionModels::divided::shells()
{
    pointField points(29);
    label m = 0;
    points[m++] = Zero;

    for (label shell = 0; shell < 2; ++shell)
    {
        const scalar a = cbrt((1 + 14.0*shell)/29);
        const scalar b = cbrt((15 + 14.0*shell)/29);
        const scalar r = 0.75*(pow4(b) - pow4(a))/(pow3(b) - pow3(a));

        for (direction axis = 0; axis < 3; ++axis)
        {
            for (const scalar side : {-1, 1})
            {
                points[m] = Zero;
                points[m++][axis] = side*r;
            }
        }
        for (label corner = 0; corner < 8; ++corner)
        {
            const vector direction
            (
                corner & 1 ? 1 : -1,
                corner & 2 ? 1 : -1,
                corner & 4 ? 1 : -1
            );
            points[m++] = r/std::sqrt(3.0)*direction;
        }
    }

    return points;
}


Foam::pointField Foam::voidFractionModels::divided::spread(const label n)
{
    // g^4 = g + 1
    const scalar g = 1.2207440846057596;
    pointField points(n);
    label m = 0;

    if (n % 2)
    {
        points[m++] = Zero;
    }

    const label pairs = n/2;
    for (label k = 0; k < pairs; ++k)
    {
        // shares of the volume in order, so that each radius is met once
        const scalar share = (n % 2 + 2*k + 1)/scalar(n);
        const scalar u = std::fmod(0.5 + (k + 1)/g, 1.0);
        const scalar v = std::fmod(0.5 + (k + 1)/(g*g), 1.0);

        const scalar r = cbrt(share);
        const scalar z = 1 - 2*u;
        const scalar s = std::sqrt(1 - z*z);
        const scalar a = constant::mathematical::twoPi*v;

        points[m] = r*vector(s*std::cos(a), s*std::sin(a), z);
        points[m + 1] = -points[m];
        m += 2;
    }

    return points;
}


Foam::label Foam::voidFractionModels::divided::meet
(
    const cellGeometry& geometry,
    const label celli,
    const point& x,
    const scalar R
) const
{
    forAll(met_, m)
    {
        if (met_[m].cell == celli)
        {
            return m;
        }
    }

    const label begin = planes_.size();
    slack_ = min(slack_, geometry.nearPlanes(celli, x, reach_*R, planes_));
    met_.append(met{celli, begin, planes_.size(), -1});

    return met_.size() - 1;
}


void Foam::voidFractionModels::divided::leave(const scalar R) const
{
    const label n = points_.size();
    const scalar* x = coordinates_.cdata();
    const scalar* y = x + n;
    const scalar* z = y + n;
    scalar* out = out_.data();
    scalar* through = through_.data();

    std::fill(out, out + n, -GREAT);
    std::fill(through, through + n, -1);
    for (label k = met_[0].begin; k < met_[0].end; ++k)
    {
        const scalar front = planes_[k].front, plane = k;
        const vector a(R*planes_[k].normal);
        for (label m = 0; m < n; ++m)
        {
            const scalar f = front + a.x()*x[m] + a.y()*y[m] + a.z()*z[m];
            const bool further = f > out[m];
            out[m] = further ? f : out[m];
            through[m] = further ? plane : through[m];
        }
        slack_ = min(slack_, -front);
    }
    scalar least = slack_;
    for (label m = 0; m < n; ++m)
    {
        const scalar a = out[m] < 0 ? -out[m] : out[m];
        least = a < least ? a : least;
    }
    slack_ = least;
}


Foam::label Foam::voidFractionModels::divided::walk
(
    const cellGeometry& geometry,
    const point& unit,
    const point& x,
    const scalar R,
    label from
) const
{
    for (label step = 0; step < 30; ++step)
    {
        const met& here = met_[from];
        scalar most = -GREAT;
        label across = -1;

        for (label k = here.begin; k < here.end; ++k)
        {
            const cellGeometry::nearPlane& p = planes_[k];
            const scalar front = p.front + R*(unit & p.normal);
            if (front > most)
            {
                most = front;
                across = p.across;
            }
        }

        if (most <= 1e-12*R)
        {
            slack_ = min(slack_, -most);
            return from;
        }
        if (across < 0)
        {
            break;
        }
        from = meet(geometry, across, x, R);
    }

    return -1;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::voidFractionModels::divided::divided
(
    const dictionary& dict,
    const fvMesh& mesh
)
:
    voidFractionModel(dict, mesh, typeName, {"points"}),
    reach_(0),
    slack_(0)
{
    const label n = wholeNumberFrom
    (
        dict,
        "dividedCoeffs: points",
        coeffs_.lookupOrDefault<label>("points", 29),
        1,
        100000
    );

    points_ = n == 29 ? shells() : spread(n);
    for (const point& x : points_)
    {
        reach_ = max(reach_, mag(x));
    }

    coordinates_.setSize(3*points_.size());
    forAll(points_, m)
    {
        for (direction axis = 0; axis < 3; ++axis)
        {
            coordinates_[axis*points_.size() + m] = points_[m][axis];
        }
    }
    out_.setSize(points_.size());
    through_.setSize(points_.size());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::voidFractionModels::divided::weights(dispersedParticles& p) const
{
    const cellGeometry& geometry = cellGeometry::New(mesh_);
    const scalar share = 1.0/points_.size();

    p.clearRows();

    for (label particle = 0; particle < p.size(); ++particle)
    {
        const point& x = p.position[particle];
        const label home = p.cell[particle];
        const label start = p.weight.size();
        const scalar R = p.radius[particle];

        planes_.clear();
        met_.clear();
        slack_ = GREAT;
        if (home >= 0)
        {
            p.append(home, 0);
            met_[meet(geometry, home, x, R)].entry = start;

            if (planes_.empty())
            {
                // all points are within
                p.weight.last() = 1;
                p.slack[particle] = max(slack_ - 1e-9*R, 0.0);
                p.endRow(particle);
                continue;
            }
            leave(R);
        }

        forAll(points_, i)
        {
            label m = -1;
            if (home >= 0)
            {
                if (out_[i] <= 1e-12*R)
                {
                    p.weight[start] += share;
                    continue;
                }
                const label across = planes_[label(through_[i])].across;
                if (across >= 0)
                {
                    m = meet(geometry, across, x, R);
                    m = walk(geometry, points_[i], x, R, m);
                }
            }
            if (m < 0)
            {
                // behind the boundary, around a corner or from nowhere
                slack_ = 0;
                scalar away;
                const label celli =
                    geometry.find(x + R*points_[i], 0, home, away);
                if (celli < 0)
                {
                    continue;
                }
                m = meet(geometry, celli, x, R);
            }

            if (met_[m].entry < 0)
            {
                met_[m].entry = p.weight.size();
                p.append(met_[m].cell, 0);
            }
            p.weight[met_[m].entry] += share;
        }
        // a plane touched within rounding is one that may be crossed
        p.slack[particle] = max(slack_ - 1e-9*R, 0.0);
        p.endRow(particle);
    }
}
