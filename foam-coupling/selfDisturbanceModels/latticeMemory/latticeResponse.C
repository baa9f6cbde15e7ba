// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "latticeResponse.H"
#include "mathematicalConstants.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::scalar;

// order of a symmTensor: xx xy xz yy yz zz
constexpr int first[6] = {0, 0, 0, 1, 1, 2}, second[6] = {0, 1, 2, 1, 2, 2};

}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

int Foam::latticeResponse::node(const scalar theta, scalar& share)
{
    const scalar k = perOctave_*std::log2(theta/thetaMin_);
    const int below = std::min(int(std::floor(k)), nodes_ - 2);
    share = std::min(k - below, 1.0);
    return below;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::latticeResponse::latticeResponse(const vector& h, const scalar spread)
:
    table_(size_t(nodes_ + 1)*offsets_*2*width_),
    instant_(size_t(offsets_)*10)
{
    const scalar unit = std::cbrt(h.x()*h.y()*h.z());
    const vector a
    (
        sqr(unit/h.x()), sqr(unit/h.y()), sqr(unit/h.z())
    );

    // from long to short theta: integrals from theta on of g (T: 6, L: 6,
    // A: 3, D: 3) and of theta g (T: 6, D: 3)
    constexpr int fine = 4, width = 27;
    constexpr int last = fine*perOctave_*21;
    std::vector<double> sum(size_t(offsets_)*width, 0.0), g(sum), before(sum);
    double thetaBefore = 0;
    std::array<latticeHeat, 3> lines;

    const auto keep = [&](const int k)
    {
        for (int o = 0; o < offsets_; ++o)
        {
            double* to = &table_[(size_t(k)*offsets_ + o)*2*width_];
            for (int c = 0; c < width_; ++c)
            {
                to[c] = sum[o*width + (c < 6 ? c : 9 + c)];
                to[width_ + c] = sum[o*width + 18 + c];   // finished below
            }
        }
    };

    for (int f = last; f >= -1; --f)
    {
        const double theta =
            f < 0 ? 0 : thetaMin_*std::exp2(f/double(fine*perOctave_));
        for (int d = 0; d < 3; ++d)
        {
            lines[d].set(a[d]*theta, a[d]);
        }

        const bool kept = f >= 0 && theta > spread;
        const std::vector<double> sumBefore(kept ? std::vector<double>() : sum);
        for (int o = 0; o < offsets_; ++o)
        {
            const int n[3] = {o % side_, (o/side_) % side_, o/(side_*side_)};
            double* go = &g[o*width];
            for (int c = 0; c < 6; ++c)
            {
                const int i = first[c], j = second[c], k = 3 - i - j;
                if (i == j)
                {
                    const int y = (i + 1) % 3, z = (i + 2) % 3;
                    const latticeHeat& lx = lines[i];
                    const latticeHeat& ly = lines[y];
                    const latticeHeat& lz = lines[z];
                    go[c] = lx.mean[n[i]]
                       *(ly.curve[n[y]]*lz.p[n[z]] + ly.p[n[y]]*lz.curve[n[z]]);
                    go[6 + c] = lx.meanCurve[n[i]]*ly.p[n[y]]*lz.p[n[z]];
                }
                else
                {
                    go[c] = lines[i].slope[n[i]]*lines[j].slope[n[j]]
                       *lines[k].p[n[k]];
                    go[6 + c] = -go[c];
                }
                go[18 + c] = theta*go[c];
            }
            for (int i = 0; i < 3; ++i)
            {
                const int y = (i + 1) % 3, z = (i + 2) % 3;
                go[12 + i] = -lines[i].slope[n[i]]
                   *lines[y].p[n[y]]*lines[z].p[n[z]];

                const latticeHeat& lx = lines[i];
                const latticeHeat& ly = lines[y];
                const latticeHeat& lz = lines[z];
                go[15 + i] = 0.25/a[i]*
                (
                    lx.curve2[n[i]]*ly.p[n[y]]*lz.p[n[z]]
                  + lx.curve[n[i]]
                   *(ly.curve[n[y]]*lz.p[n[z]] + ly.p[n[y]]*lz.curve[n[z]])
                );
                go[24 + i] = theta*go[15 + i];
            }
        }
        if (f < last)
        {
            // trapezoidal in log(theta); in theta from 0 to the first node
            for (size_t v = 0; v < sum.size(); ++v)
            {
                sum[v] +=
                    f < 0
                  ? 0.5*(g[v] + before[v])*thetaBefore
                  : 0.5*(g[v]*theta + before[v]*thetaBefore)
                   *(M_LN2/(fine*perOctave_));
            }
        }

        if (f < 0)
        {
            keep(nodes_);
        }
        else if (f % fine == 0 && f/fine < nodes_)
        {
            keep(f/fine);
        }

        // the responses without a time, at the spread
        if (theta <= spread && (thetaBefore > spread || f == last))
        {
            const double s =
                thetaBefore > theta
              ? (spread - theta)/(thetaBefore - theta) : 0;
            for (int o = 0; o < offsets_; ++o)
            {
                for (int c = 0; c < 9; ++c)
                {
                    const int from = o*width + 6 + c;
                    instant_[o*10 + c] =
                        (1 - s)*sum[from]
                      + s*(sumBefore.size() ? sumBefore[from] : sum[from]);
                }
            }
        }
        before.swap(g);
        thetaBefore = theta;
    }

    // integral of T from 0 to theta = theta T + int_0^theta theta g
    for (int k = 0; k < nodes_; ++k)
    {
        const double theta = thetaMin_*std::exp2(k/double(perOctave_));
        for (int o = 0; o < offsets_; ++o)
        {
            double* t = &table_[(size_t(k)*offsets_ + o)*2*width_];
            const double* zero =
                &table_[(size_t(nodes_)*offsets_ + o)*2*width_];
            for (int c = 0; c < width_; ++c)
            {
                t[width_ + c] = t[c] + (zero[width_ + c] - t[width_ + c])/theta;
            }
        }
    }
    for (int o = 0; o < offsets_; ++o)
    {
        double* zero = &table_[(size_t(nodes_)*offsets_ + o)*2*width_];
        std::copy(zero, zero + width_, zero + width_);
    }

    for (int d = 0; d < 3; ++d)
    {
        lines[d].set(a[d]*spread, a[d]);
    }
    for (int o = 0; o < offsets_; ++o)
    {
        instant_[o*10 + 9] =
            lines[0].p[o % side_]*lines[1].p[(o/side_) % side_]
           *lines[2].p[o/(side_*side_)];
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::latticeResponse::thetaMax()
{
    return thetaMin_*std::exp2((nodes_ - 1)/perOctave_);
}


namespace
{

// calls f(offset in the table, signs, weight) for all weights in reach
template<class Function>
void each(const Foam::latticeWeights& w, const Function& f)
{
    constexpr int reach = Foam::latticeResponse::reach;
    for (int z = std::max(w[2].lo, -reach); z <= std::min(w[2].hi, reach); ++z)
    {
        for
        (
            int y = std::max(w[1].lo, -reach);
            y <= std::min(w[1].hi, reach);
            ++y
        )
        {
            const scalar wyz = w[2](z)*w[1](y);
            for
            (
                int x = std::max(w[0].lo, -reach);
                x <= std::min(w[0].hi, reach);
                ++x
            )
            {
                const scalar weight = wyz*w[0](x);
                if (weight != 0)
                {
                    const scalar sign[3] =
                        {x < 0 ? -1. : 1., y < 0 ? -1. : 1., z < 0 ? -1. : 1.};
                    f
                    (
                        std::abs(x)
                      + (reach + 1)*(std::abs(y) + (reach + 1)*std::abs(z)),
                        sign,
                        weight
                    );
                }
            }
        }
    }
}

}


Foam::latticeResponse::values Foam::latticeResponse::mean
(
    const latticeWeights& w,
    const scalar theta0,
    const scalar theta1
) const
{
    // values to add up: node, column, factor
    struct term { const double* base; scalar factor; } terms[4];
    int n = 0;
    const auto add = [&](const scalar theta, const int column, const scalar f)
    {
        const auto at = [&](const int k)
        {
            return &table_[size_t(k)*offsets_*2*width_ + column];
        };
        if (theta < thetaMin_)
        {
            terms[n++] = {at(nodes_), f*(1 - theta/thetaMin_)};
            terms[n++] = {at(0), f*theta/thetaMin_};
        }
        else
        {
            scalar s;
            const int k = node(theta, s);
            terms[n++] = {at(k), f*(1 - s)};
            terms[n++] = {at(k + 1), f*s};
        }
    };

    if (theta1 - theta0 < 0.1*theta0 || theta1 < 1e-12)
    {
        add(0.5*(theta0 + theta1), 0, 1);
    }
    else
    {
        add(theta1, width_, theta1/(theta1 - theta0));
        if (theta0 > 0)
        {
            add(theta0, width_, -theta0/(theta1 - theta0));
        }
    }

    values sum{Zero, Zero};
    each
    (
        w,
        [&](const int o, const scalar* sign, const scalar weight)
        {
            double t[width_] = {};
            for (int m = 0; m < n; ++m)
            {
                const double* from = terms[m].base + o*2*width_;
                for (int c = 0; c < width_; ++c)
                {
                    t[c] += terms[m].factor*from[c];
                }
            }
            for (int c = 0; c < 6; ++c)
            {
                sum.byFaces[c] += weight*t[c]
                   *(
                        first[c] == second[c]
                      ? 1
                      : sign[first[c]]*sign[second[c]]
                    );
            }
            for (int d = 0; d < 3; ++d)
            {
                sum.byCells[d] += weight*t[6 + d];
            }
        }
    );
    return sum;
}


Foam::symmTensor Foam::latticeResponse::longitudinal
(
    const latticeWeights& w
) const
{
    symmTensor sum(Zero);
    each
    (
        w,
        [&](const int o, const scalar* sign, const scalar weight)
        {
            for (int c = 0; c < 6; ++c)
            {
                sum[c] += weight*instant_[o*10 + c]
                   *(
                        first[c] == second[c]
                      ? 1
                      : sign[first[c]]*sign[second[c]]
                    );
            }
        }
    );
    return sum;
}


Foam::vector Foam::latticeResponse::source(const latticeWeights& w) const
{
    vector sum(Zero);
    each
    (
        w,
        [&](const int o, const scalar* sign, const scalar weight)
        {
            for (int d = 0; d < 3; ++d)
            {
                sum[d] += weight*sign[d]*instant_[o*10 + 6 + d];
            }
        }
    );
    return sum;
}


Foam::scalar Foam::latticeResponse::share(const latticeWeights& w) const
{
    scalar sum = 0;
    each
    (
        w,
        [&](const int o, const scalar*, const scalar weight)
        {
            sum += weight*instant_[o*10 + 9];
        }
    );
    return sum;
}


Foam::symmTensor Foam::latticeResponse::far
(
    const vector& r,
    const scalar theta
)
{
    // H I + grad grad f, f = erf(r/sqrt(4 theta))/(4 pi r)
    const scalar R2 = magSqr(r);
    const scalar H =
        std::exp(-R2/(4*theta))
       /std::pow(4*constant::mathematical::pi*theta, 1.5);
    if (R2 < 1e-4*theta)
    {
        return (2.0/3)*H*symmTensor::I;
    }
    const scalar R = std::sqrt(R2);
    const scalar e = std::erf(R/std::sqrt(4*theta))
       /(4*constant::mathematical::pi*R2*R);
    // f'/r, and f'' = -H - 2 f'/r
    const scalar slope = 2*theta*H/R2 - e;
    return
        (H + slope)*symmTensor::I
      + ((-H - 3*slope)/R2)*sqr(r);
}
