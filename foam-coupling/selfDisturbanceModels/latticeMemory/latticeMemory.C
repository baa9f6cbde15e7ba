// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "latticeMemory.H"
#include "addToRunTimeSelectionTable.H"
#include "PstreamReduceOps.H"
#include "handOver.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace selfDisturbanceModels
{
    defineTypeNameAndDebug(latticeMemory, 0);
    addToRunTimeSelectionTable(selfDisturbanceModel, latticeMemory, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vector Foam::selfDisturbanceModels::latticeMemory::sides
(
    const label celli
) const
{
    // a box's volume over the area that it shows along an axis
    const fvMesh& mesh = setting_.mesh;
    vector area(Zero);
    for (const label facei : mesh.cells()[celli])
    {
        area += cmptMag(mesh.faceAreas()[facei]);
    }
    const scalar V = mesh.cellVolumes()[celli];
    const vector h(2*V/area.x(), 2*V/area.y(), 2*V/area.z());
    return h*std::cbrt(V/(h.x()*h.y()*h.z()));
}


Foam::latticeMap Foam::selfDisturbanceModels::latticeMemory::map
(
    const dispersedParticles& p,
    const label i,
    const word& scheme
) const
{
    latticeMap m;
    m.centre = setting_.mesh.cellCentres()[p.cell[i]];
    m.h = sides(p.cell[i]);

    for (int d = 0; d < 3; ++d)
    {
        const scalar x = (p.position[i][d] - m.centre[d])/m.h[d];
        const scalar r = p.radius[i]/m.h[d];
        auto& share = m.share[d];

        if (scheme == "cell")
        {
            share = {0, 1, 0};
        }
        else if (scheme == "cellPoint")
        {
            const scalar s = min(mag(x), 1.0);
            share = {x < 0 ? s : 0, 1 - s, x < 0 ? 0 : s};
        }
        else
        {
            // share of a sphere's volume below a plane
            const auto below = [&](const scalar plane)
            {
                const scalar t = max(-1.0, min(1.0, (plane - x)/r));
                return (2 + 3*t - t*t*t)/4;
            };
            const scalar lo = below(-0.5), hi = below(0.5);
            share = {lo, hi - lo, 1 - hi};
        }
    }
    return m;
}


const Foam::latticeResponse&
Foam::selfDisturbanceModels::latticeMemory::response(const vector& h)
{
    const scalar unit = std::cbrt(h.x()*h.y()*h.z());
    const scalar spread =
        min(setting_.smoothing/sqr(unit), latticeResponse::thetaMax());

    // shapes within 1 % and spreads within 2 % share a table
    std::unique_ptr<latticeResponse>& found = responses_
    [{
        label(std::lround(100*std::log(h.x()/unit))),
        label(std::lround(100*std::log(h.y()/unit))),
        label(spread > 0 ? std::lround(50*std::log(spread)) : labelMin)
    }];
    if (!found)
    {
        found.reset(new latticeResponse(h, spread));
    }
    return *found;
}


void Foam::selfDisturbanceModels::latticeMemory::migrate
(
    const dispersedParticles& p
)
{
    std::unordered_map<label, disturbanceHistory> kept;
    DynamicList<label> wanted;
    kept.reserve(p.size());
    forAll(p.owned, i)
    {
        if (p.owned[i])
        {
            const auto found = histories_.find(p.tag[i]);
            if (found == histories_.end())
            {
                wanted.append(p.tag[i]);
            }
            else
            {
                kept[p.tag[i]] = std::move(found->second);
                histories_.erase(found);
            }
        }
    }

    // what is left is of particles gone, to another rank or for good
    if (Pstream::parRun() && returnReduce(!wanted.empty(), orOp<bool>()))
    {
        particleNumbers given;
        for (const auto& left : histories_)
        {
            given[left.first] = left.second.pack();
        }
        for (const auto& came : handOver(given, wanted))
        {
            const double* from = came.second.data();
            kept[came.first] =
                disturbanceHistory::unpack(from, from + came.second.size());
        }
    }
    histories_.swap(kept);
}


Foam::vector Foam::selfDisturbanceModels::latticeMemory::velocity
(
    const disturbanceHistory& history,
    const latticeMap& seen
)
{
    const latticeResponse& table = response(seen.h);
    const scalar V = seen.h.x()*seen.h.y()*seen.h.z();
    const scalar unit = std::cbrt(V);
    const scalar perTime = setting_.nu/sqr(unit);
    const scalar spread = setting_.smoothing/sqr(unit);

    // beyond it, or farther than that, as in a continuum
    const scalar late = 16;
    const scalar distant = latticeResponse::reach - 1.5;

    vector sum(Zero);
    for (const disturbanceHistory::entry& e : history.entries)
    {
        const scalar theta0 = perTime*e.young + spread;
        const scalar theta1 = perTime*e.old + spread;
        const vector r(seen.middle() - e.map.middle());

        if
        (
            0.5*(theta0 + theta1) > late
         || cmptMax(cmptMag(cmptDivide(r, seen.h))) > distant
        )
        {
            // the means of cells and faces widen it a little; two points
            const scalar middle = 0.5*(theta0 + theta1) + 0.15;
            const scalar half = 0.5*(theta1 - theta0)/std::sqrt(3.0);
            sum += 0.5*
            (
                (latticeResponse::far(r/unit, middle - half) & e.impulse)
              + (latticeResponse::far(r/unit, middle + half) & e.impulse)
            );
        }
        else
        {
            sum +=
                table.mean(seen.apart(e.map), theta0, theta1).byFaces
              & e.impulse;
        }
    }
    return sum/(-setting_.rho*V);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::selfDisturbanceModels::latticeMemory::latticeMemory
(
    const dictionary&,
    const setting& s
)
:
    setting_(s)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::selfDisturbanceModels::latticeMemory::excess
(
    const scalar phi
)
{
    const scalar x = max(0.0, min(0.74, phi));
    return pow4(1 - x)/(sqr(1 + 2*x) + pow3(x)*(x - 4));
}


void Foam::selfDisturbanceModels::latticeMemory::evaluate
(
    const dispersedParticles& p,
    const scalar T,
    const vectorField& u,
    const scalarField& n,
    vectorField& velocity,
    scalarField& solid,
    vectorField& pressureForce
)
{
    velocity.setSize(p.size());
    velocity = Zero;
    solid.setSize(p.size());
    solid = 0;
    pressureForce.setSize(p.size());
    pressureForce = Zero;

    migrate(p);

    const word given
    (
        setting_.voidFractionModel == "centre" ? "cell" : "mapped"
    );
    const word taken
    (
        setting_.interpolation == "mapped" ? given : setting_.interpolation
    );

    forAll(p.owned, i)
    {
        if (!p.owned[i])
        {
            continue;
        }
        const latticeMap now(map(p, i, given));
        const latticeMap seen(taken == given ? now : map(p, i, taken));
        const latticeResponse& table = response(seen.h);
        const scalar V = seen.h.x()*seen.h.y()*seen.h.z();
        const scalar fraction = p.volume[i]/V;

        solid[i] = fraction*table.share(seen.apart(now));
        const scalar S = excess(1 - n[i] - solid[i]);
        solid[i] *= S;

        const auto found = histories_.find(p.tag[i]);
        if (found == histories_.end())
        {
            disturbanceHistory& h = histories_[p.tag[i]];
            h.last = h.before = now;
            continue;
        }
        disturbanceHistory& h = found->second;

        // half the domain in an interval: through a periodic side
        const vector span(setting_.mesh.bounds().span());
        const vector way(now.middle() - h.last.middle());
        vector jump(Zero);
        for (direction d = 0; d < 3; ++d)
        {
            if (mag(way[d]) > 0.5*span[d])
            {
                jump[d] = sign(way[d])*span[d];
            }
        }
        if (jump != vector::zero)
        {
            h.move(jump);
        }

        if (T > 0)
        {
            const vector impulse(p.impulse[i] - T*h.sent);
            h.add(T, u[i], impulse);
            velocity[i] = S*this->velocity(h, seen);

            const latticeWeights w(seen.apart(h.last));
            const symmTensor along(table.longitudinal(w));
            if (setting_.pressure)
            {
                // the sharp gradient: all that does not pass the faces
                const scalar theta = min
                (
                    setting_.smoothing/pow(V, 2.0/3.0),
                    latticeResponse::thetaMax()
                );
                pressureForce[i] = (S*fraction/T)*
                (
                    (along & impulse)
                  + cmptMultiply(table.mean(w, theta, theta).byCells, impulse)
                );
            }

            // div U = d(phi)/dt + div(phi U)
            const vector carrier(u[i] - velocity[i]);
            vector displaced(along & carrier);
            if (setting_.displacement == 1 && lastT_ > 0)
            {
                displaced +=
                    (std::cbrt(V)/T)
                   *(table.source(w) - table.source(seen.apart(h.before)));
            }
            else if (setting_.displacement == 2)
            {
                displaced -= along & p.velocity[i];
            }
            velocity[i] += (S*fraction)*displaced;
        }
        h.before = h.last;
        h.last = now;
    }
    lastT_ = T;
}


void Foam::selfDisturbanceModels::latticeMemory::sent
(
    const dispersedParticles& p,
    const scalarField&,
    const vectorField& force
)
{
    forAll(p.owned, i)
    {
        const auto found = histories_.find(p.tag[i]);
        if (p.owned[i] && found != histories_.end())
        {
            found->second.sent = force[i];
        }
    }
}
