// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "exactOverlapVoidFraction.H"
#include "cellGeometry.H"
#include "cyclicPolyPatch.H"
#include "faceFacets.H"
#include "processorCyclicPolyPatch.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"

#include <algorithm>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace voidFractionModels
{
    defineTypeNameAndDebug(exactOverlap, 0);
    addToRunTimeSelectionTable(voidFractionModel, exactOverlap, dictionary);
}
}


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

Foam::List<Foam::vector> Foam::voidFractionModels::exactOverlap::periods
(
    const fvMesh& mesh
)
{
    // of a patch cut up over ranks each has its own part, with another's name
    DynamicList<vector> mine;
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if
        (
            !isA<cyclicPolyPatch>(patch)
         && !isA<processorCyclicPolyPatch>(patch)
        )
        {
            continue;
        }
        const auto& sides = refCast<const coupledPolyPatch>(patch);
        if (sides.size() && sides.parallel() && sides.separated())
        {
            mine.append(sides.separation()[0]);
        }
    }

    List<List<vector>> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = mine;
    Pstream::gatherList(all);
    Pstream::scatterList(all);

    // each of them once, whichever half saw it
    DynamicList<vector> found;
    for (const List<vector>& ways : all)
    {
        for (const vector& way : ways)
        {
            bool known = false;
            for (const vector& other : found)
            {
                known =
                    known
                 || min(mag(way - other), mag(way + other)) < 1e-6*mag(way);
            }
            if (!known)
            {
                found.append(way);
            }
        }
    }
    return List<vector>(std::move(found));
}


Foam::List<Foam::vector> Foam::voidFractionModels::exactOverlap::findImages
(
    const fvMesh& mesh
)
{
    DynamicList<vector> found(26);

    for (const vector& way : periods(mesh))
    {
        // with those there are already: through edges and corners
        for (label k = found.size() - 1; k >= 0; --k)
        {
            const vector other(found[k]);
            found.append(other + way);
            found.append(other - way);
        }
        found.append(way);
        found.append(-way);
    }

    return List<vector>(std::move(found));
}


void Foam::voidFractionModels::exactOverlap::next() const
{
    if (++sphere_ == labelMax)
    {
        // long runs come round
        cuts_ = cut{-1, sphereFacet::apart, 0, false, 0, false, 0};
        reached_ = -1;
        sphere_ = 0;
    }
    front_.clear();
}


void Foam::voidFractionModels::exactOverlap::append
(
    dispersedParticles& p,
    const faceFacets& facets,
    const point& centre,
    const scalar R,
    const label home
) const
{
    const scalar ball = 4.0/3*constant::mathematical::pi*pow3(R);

    for (const label celli : front_)
    {
        const scalar w = overlap(facets, celli, centre, R)/ball;
        if (w > 0 || celli == home)
        {
            p.append(celli, w);
        }
    }
}


bool Foam::voidFractionModels::exactOverlap::shared(const label facei) const
{
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    return patches[patches.whichPatch(facei)].coupled();
}


Foam::voidFractionModels::exactOverlap::cut&
Foam::voidFractionModels::exactOverlap::look
(
    const faceFacets& facets,
    const label facei,
    const point& centre,
    const scalar R
) const
{
    cut& c = cuts_[facei];
    if (c.sphere != sphere_)
    {
        c.sphere = sphere_;
        c.meets = sphereFacet::apart;
        c.distance = 0;
        c.measured = false;
        c.taken = false;
        facets.each(facei, centre, R, [&](const sphereFacet& facet, bool first)
        {
            c.meets = std::max(c.meets, facet.meets());
            c.distance = first ? facet.distance() : c.distance;
        });
    }
    return c;
}


Foam::scalar Foam::voidFractionModels::exactOverlap::pyramid
(
    const faceFacets& facets,
    const label facei,
    const point& centre,
    const scalar R
) const
{
    cut& c = look(facets, facei, centre, R);
    if (!c.measured)
    {
        c.measured = true;
        c.volume = 0;
        facets.each(facei, centre, R, [&](const sphereFacet& facet, bool)
        {
            c.volume += facet.volume();
        });
    }
    return c.volume;
}


Foam::scalar Foam::voidFractionModels::exactOverlap::takenOff
(
    const faceFacets& facets,
    const label facei,
    const point& centre,
    const scalar R
) const
{
    cut& c = cuts_[facei];
    if (!c.taken)
    {
        c.taken = true;
        c.takenOff =
            facets.against(facets.first(facei), centre, R).takenOff();
    }
    return c.takenOff;
}


Foam::scalar Foam::voidFractionModels::exactOverlap::overlap
(
    const faceFacets& facets,
    const label celli,
    const point& centre,
    const scalar R
) const
{
    const cell& faces = mesh_.cells()[celli];
    const labelUList& owner = mesh_.faceOwner();

    if (facets.convex(celli))
    {
        if (facets.reach(celli) + mag(mesh_.C()[celli] - centre) <= R)
        {
            return mesh_.V()[celli];
        }

        bool inside = true;
        bool clear = true;
        for (const label facei : faces)
        {
            const cut& c = look(facets, facei, centre, R);
            inside = inside && (c.distance > 0) == (owner[facei] == celli);
            clear =
                clear
             && (c.meets == sphereFacet::apart || mag(c.distance) > 0.01*R);
        }

        if (clear)
        {
            scalar rest =
                inside ? 4.0/3*constant::mathematical::pi*pow3(R) : 0;
            for (const label facei : faces)
            {
                if (cuts_[facei].meets != sphereFacet::apart)
                {
                    const scalar part = takenOff(facets, facei, centre, R);
                    rest += owner[facei] == celli ? part : -part;
                }
            }
            return max(rest, 0.0);
        }
    }

    scalar sum = 0;
    for (const label facei : faces)
    {
        const scalar part = pyramid(facets, facei, centre, R);
        sum += owner[facei] == celli ? part : -part;
    }
    return max(sum, 0.0);
}


void Foam::voidFractionModels::exactOverlap::reach(const label celli) const
{
    if (reached_[celli] != sphere_)
    {
        reached_[celli] = sphere_;
        front_.append(celli);
    }
}


bool Foam::voidFractionModels::exactOverlap::spread
(
    const faceFacets& facets,
    const label celli,
    const point& centre,
    const scalar R
) const
{
    bool leaves = false;

    for (const label facei : mesh_.cells()[celli])
    {
        if (look(facets, facei, centre, R).meets == sphereFacet::apart)
        {
            continue;
        }

        if (mesh_.isInternalFace(facei))
        {
            const label own = mesh_.faceOwner()[facei];
            reach(own == celli ? mesh_.faceNeighbour()[facei] : own);
        }
        else
        {
            leaves = leaves || shared(facei);
        }
    }

    return leaves;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::voidFractionModels::exactOverlap::exactOverlap
(
    const dictionary& dict,
    const fvMesh& mesh
)
:
    voidFractionModel(dict, mesh, typeName),
    sphere_(0),
    cuts_(mesh.nFaces(), cut{-1, sphereFacet::apart, 0, false, 0, false, 0}),
    reached_(mesh.nCells(), -1),
    images_(findImages(mesh))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::voidFractionModels::exactOverlap::weights
(
    dispersedParticles& p
) const
{
    const cellGeometry& geometry = cellGeometry::New(mesh_);
    const faceFacets& facets = faceFacets::New(mesh_);

    p.clearRows();

    for (label i = 0; i < p.size(); ++i)
    {
        const point& x = p.position[i];
        const scalar R = p.radius[i];
        const label home = p.cell[i];

        next();

        if
        (
            home >= 0
         && geometry.outside(home, x) + facets.warp(home) <= -R
        )
        {
            p.append(home, 1);
            p.endRow(i);
            continue;
        }

        // with its centre outside the sphere may come in from anywhere
        bool leaves = home < 0 || p.outside[i] > 0;
        if (home >= 0)
        {
            reach(home);
        }
        for (label k = 0; k < front_.size(); ++k)
        {
            leaves = spread(facets, front_[k], x, R) || leaves;
        }
        if (leaves)
        {
            nearby_.clear();
            geometry.near(x, R, nearby_);
            for (const label celli : nearby_)
            {
                reach(celli);
            }
        }

        append(p, facets, x, R, home);

        for (const vector& way : images_)
        {
            const point y(x + way);
            nearby_.clear();
            if (mesh_.bounds().overlaps(y, sqr(R)))
            {
                geometry.near(y, R, nearby_);
            }
            if (nearby_.size())
            {
                next();
                for (const label celli : nearby_)
                {
                    reach(celli);
                }
                append(p, facets, y, R, -1);
            }
        }
        p.endRow(i);
    }
}
