// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "cellGeometry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(cellGeometry, 0);
}


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

void Foam::cellGeometry::makePlanes()
{
    const cellList& cells = mesh_.cells();
    const vectorField& areas = mesh_.faceAreas();
    const pointField& centres = mesh_.faceCentres();
    const labelUList& owner = mesh_.faceOwner();
    const labelUList& neighbour = mesh_.faceNeighbour();

    start_.setSize(cells.size() + 1);
    start_[0] = 0;
    forAll(cells, celli)
    {
        start_[celli + 1] = start_[celli] + cells[celli].size();
    }

    planes_.setSize(start_[cells.size()]);
    label k = 0;

    forAll(cells, celli)
    {
        for (const label facei : cells[celli])
        {
            const bool own = owner[facei] == celli;
            const vector area = own ? areas[facei] : -areas[facei];

            plane& p = planes_[k++];
            p.normal = area/max(mag(area), VSMALL);
            p.centre = centres[facei];
            p.across =
                mesh_.isInternalFace(facei)
              ? (own ? neighbour[facei] : owner[facei])
              : -1;
        }
    }
}


void Foam::cellGeometry::makeBins()
{
    const cellList& cells = mesh_.cells();
    const faceList& faces = mesh_.faces();
    const pointField& points = mesh_.points();

    boxes_.setSize(cells.size());
    boundBox all;
    vector meanSpan(Zero);

    forAll(cells, celli)
    {
        boundBox& box = boxes_[celli];
        for (const label facei : cells[celli])
        {
            for (const label pointi : faces[facei])
            {
                box.add(points[pointi]);
            }
        }
        const vector margin(1e-9*box.mag()*vector::one);
        box.min() -= margin;
        box.max() += margin;
        all.add(box);
        meanSpan += box.span()/cells.size();
    }

    if (cells.empty())
    {
        all = boundBox(vector::zero, vector::one);
        meanSpan = vector::one;
    }

    low_ = all.min();
    label nBins = 1;
    for (direction axis = 0; axis < 3; ++axis)
    {
        const scalar span = max(all.span()[axis], VSMALL);
        bins_[axis] = max(1, min(512, label(span/meanSpan[axis] + 0.5)));
        perLength_[axis] = bins_[axis]/span;
        nBins *= bins_[axis];
    }

    // twice over the cells: count, then fill
    binStart_.setSize(nBins + 1);
    binStart_ = 0;
    labelList next;

    for (label pass = 0; pass < 2; ++pass)
    {
        forAll(boxes_, celli)
        {
            std::array<label, 3> lo, hi;
            for (direction axis = 0; axis < 3; ++axis)
            {
                lo[axis] = bin(boxes_[celli].min()[axis], axis);
                hi[axis] = bin(boxes_[celli].max()[axis], axis);
            }
            for (label i = lo[0]; i <= hi[0]; ++i)
            for (label j = lo[1]; j <= hi[1]; ++j)
            for (label k = lo[2]; k <= hi[2]; ++k)
            {
                const label b = (i*bins_[1] + j)*bins_[2] + k;
                if (pass == 0)
                {
                    ++binStart_[b + 1];
                }
                else
                {
                    binCells_[next[b]++] = celli;
                }
            }
        }

        if (pass == 0)
        {
            for (label b = 0; b < nBins; ++b)
            {
                binStart_[b + 1] += binStart_[b];
            }
            binCells_.setSize(binStart_[nBins]);
            next = binStart_;
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cellGeometry::cellGeometry(const fvMesh& mesh)
:
    MeshObject<fvMesh, Foam::GeometricMeshObject, cellGeometry>(mesh)
{
    makePlanes();
    makeBins();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::cellGeometry::walk
(
    const point& x,
    label celli,
    scalar& away
) const
{
    // a walk this long is slower than the bins
    for (label step = 0; step < 30; ++step)
    {
        away = -GREAT;
        scalar most = 0;
        label across = -1;

        for (label k = start_[celli]; k < start_[celli + 1]; ++k)
        {
            const plane& p = planes_[k];
            const scalar front = (x - p.centre) & p.normal;
            away = max(away, front);
            if (front > most && p.across >= 0)
            {
                most = front;
                across = p.across;
            }
        }

        if (across < 0)
        {
            break;
        }
        celli = across;
    }

    away = outside(celli, x);
    return celli;
}


Foam::label Foam::cellGeometry::find
(
    const point& x,
    const scalar reach,
    const label hint,
    scalar& away
) const
{
    label best = -1;
    away = GREAT;

    if (hint >= 0 && hint < boxes_.size())
    {
        best = walk(x, hint, away);
        if (away <= 0)
        {
            return best;
        }
    }

    DynamicList<label> candidates(64);

    // first the cells around the point, then those within reach
    for (const scalar r : {scalar(0), reach})
    {
        candidates.clear();
        near(x, r, candidates);

        for (const label celli : candidates)
        {
            const scalar d = outside(celli, x);
            if (d < away)
            {
                away = d;
                best = celli;
            }
        }
        if (away <= 0)
        {
            return best;
        }
    }

    return away < reach ? best : -1;
}


Foam::scalar Foam::cellGeometry::nearPlanes
(
    const label celli,
    const point& x,
    const scalar r,
    DynamicList<nearPlane>& planes
) const
{
    scalar spare = GREAT;
    for (label k = start_[celli]; k < start_[celli + 1]; ++k)
    {
        const plane& p = planes_[k];
        const scalar front = (x - p.centre) & p.normal;
        if (front > -r)
        {
            planes.append(nearPlane{p.normal, front, p.across});
        }
        else
        {
            spare = min(spare, -r - front);
        }
    }
    return spare;
}


void Foam::cellGeometry::near
(
    const point& x,
    const scalar r,
    DynamicList<label>& cells
) const
{
    const boundBox reach(x - r*vector::one, x + r*vector::one);
    std::array<label, 3> lo, hi;
    for (direction axis = 0; axis < 3; ++axis)
    {
        lo[axis] = bin(reach.min()[axis], axis);
        hi[axis] = bin(reach.max()[axis], axis);
    }

    for (label i = lo[0]; i <= hi[0]; ++i)
    for (label j = lo[1]; j <= hi[1]; ++j)
    for (label k = lo[2]; k <= hi[2]; ++k)
    {
        const label b = (i*bins_[1] + j)*bins_[2] + k;
        for (label m = binStart_[b]; m < binStart_[b + 1]; ++m)
        {
            const boundBox& box = boxes_[binCells_[m]];

            // a cell of several bins counts in the first it shares with reach
            if
            (
                i == max(lo[0], bin(box.min().x(), 0))
             && j == max(lo[1], bin(box.min().y(), 1))
             && k == max(lo[2], bin(box.min().z(), 2))
             && box.overlaps(x, r*r)
            )
            {
                cells.append(binCells_[m]);
            }
        }
    }
}
