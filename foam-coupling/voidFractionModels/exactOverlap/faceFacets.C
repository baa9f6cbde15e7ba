// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "faceFacets.H"
#include "volFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(faceFacets, 0);

    // of a face's size: what counts as plane
    static const scalar planeTolerance = 1e-12;
}


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

void Foam::faceFacets::addEdges
(
    const UList<point>& polygon,
    const vector& normal
)
{
    facets_.append
    (
        facet{normal, polygon[0], edges_.size(), polygon.size()}
    );

    forAll(polygon, i)
    {
        sphereFacet::edge e;
        e.start = polygon[i];
        e.along = polygon[polygon.fcIndex(i)] - polygon[i];
        e.length = mag(e.along);
        e.along /= max(e.length, VSMALL);
        e.outward = e.along ^ normal;
        edges_.append(e);
    }
}


bool Foam::faceFacets::add
(
    const UList<point>& polygon,
    const scalar tolerance
)
{
    vector area(Zero);
    for (label i = 2; i < polygon.size(); ++i)
    {
        area +=
            0.5*((polygon[i - 1] - polygon[0]) ^ (polygon[i] - polygon[0]));
    }
    const vector normal(area/max(mag(area), VSMALL));

    forAll(polygon, i)
    {
        const point& next = polygon[polygon.fcIndex(i)];
        const point& last = polygon[polygon.rcIndex(i)];

        if (std::abs((polygon[i] - polygon[0]) & normal) > tolerance)
        {
            return false;
        }
        if
        (
            (((polygon[i] - last) ^ (next - polygon[i])) & normal)
          < -tolerance*mag(next - last)
        )
        {
            return false;
        }
    }

    addEdges(polygon, normal);
    return true;
}


void Foam::faceFacets::addTriangle
(
    const point& a,
    const point& b,
    const point& c
)
{
    const FixedList<point, 3> corners({a, b, c});
    const vector area((b - a) ^ (c - a));
    const scalar size = mag(area);

    // nothing to see of a triangle without area
    if (size > VSMALL)
    {
        addEdges(List<point>(corners), area/size);
    }
}


void Foam::faceFacets::addFace(const label facei)
{
    const pointField polygon(mesh_.faces()[facei].points(mesh_.points()));
    const point mean = average(polygon);

    scalar size = 0;
    for (const point& p : polygon)
    {
        size = max(size, mag(p - mean));
    }

    if (add(polygon, planeTolerance*size))
    {
        return;
    }

    forAll(polygon, i)
    {
        addTriangle(mean, polygon[i], polygon[polygon.fcIndex(i)]);
    }

    const vector normal
    (
        mesh_.faceAreas()[facei]/max(mag(mesh_.faceAreas()[facei]), VSMALL)
    );
    scalar warp = 0;
    for (const point& p : polygon)
    {
        warp = max(warp, mag((p - mesh_.faceCentres()[facei]) & normal));
    }
    warp = max(warp, mag((mean - mesh_.faceCentres()[facei]) & normal));

    const label own = mesh_.faceOwner()[facei];
    warp_[own] = max(warp_[own], warp);
    if (mesh_.isInternalFace(facei))
    {
        const label nei = mesh_.faceNeighbour()[facei];
        warp_[nei] = max(warp_[nei], warp);
    }
}


bool Foam::faceFacets::isConvex(const label celli) const
{
    const labelList points(mesh_.cellPoints(celli));
    const scalar tolerance = 1e-10*cbrt(mesh_.V()[celli]);

    for (const label facei : mesh_.cells()[celli])
    {
        if (last(facei) - first(facei) != 1)
        {
            return false;
        }

        const facet& f = facets_[first(facei)];
        const vector out
        (
            mesh_.faceOwner()[facei] == celli ? f.normal : -f.normal
        );

        for (const label pointi : points)
        {
            if (((mesh_.points()[pointi] - f.start) & out) > tolerance)
            {
                return false;
            }
        }
    }

    return true;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::faceFacets::faceFacets(const fvMesh& mesh)
:
    MeshObject<fvMesh, Foam::GeometricMeshObject, faceFacets>(mesh),
    start_(mesh.nFaces() + 1),
    convex_(mesh.nCells()),
    warp_(mesh.nCells(), 0.0),
    reach_(mesh.nCells(), 0.0)
{
    for (label facei = 0; facei < mesh.nFaces(); ++facei)
    {
        start_[facei] = facets_.size();
        addFace(facei);
    }
    start_[mesh.nFaces()] = facets_.size();

    for (label celli = 0; celli < mesh.nCells(); ++celli)
    {
        convex_[celli] = isConvex(celli);
        for (const label pointi : mesh.cellPoints(celli))
        {
            reach_[celli] = max
            (
                reach_[celli], mag(mesh.points()[pointi] - mesh.C()[celli])
            );
        }
    }
}
