// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "dispersedParticles.H"
#include "cellGeometry.H"

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

Foam::label Foam::dispersedParticles::hint(const label i)
{
    if (i < lastTag_.size() && lastTag_[i] == tag[i])
    {
        return lastCell_[i];
    }

    // the order has changed
    if (lastByTag_.empty())
    {
        lastByTag_.resize(2*lastTag_.size() + 2);
        forAll(lastTag_, k)
        {
            lastByTag_.set(lastTag_[k], lastCell_[k]);
        }
    }

    const auto found = lastByTag_.cfind(tag[i]);
    return found.found() ? found.val() : -1;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dispersedParticles::setSize(const label n)
{
    position.setSize(n, Zero);
    velocity.setSize(n, Zero);
    impulse.setSize(n, Zero);
    radius.setSize(n, 0.0);
    volume.setSize(n, 0.0);
    mass.setSize(n, 0.0);
    tag.setSize(n, -1);
    body.setSize(n, -1);
    cell.setSize(n);
    cell = -1;
    outside.setSize(n);
    outside = GREAT;
    owned.setSize(n);
    owned = false;

    slack.setSize(n);
    slack = 0;
    offset.setSize(n + 1);
    offset = 0;
    cellIndex.clear();
    weight.clear();
    divisor.setSize(n);
    divisor = 1;
}


void Foam::dispersedParticles::locate(const fvMesh& mesh)
{
    const cellGeometry& geometry = cellGeometry::New(mesh);

    forAll(position, i)
    {
        const label last = hint(i);
        scalar away = GREAT;

        if (last >= 0 && last < mesh.nCells())
        {
            away = geometry.outside(last, position[i]);
        }

        if (away <= 0)
        {
            cell[i] = last;
        }
        else
        {
            ++searches_;
            cell[i] = geometry.find(position[i], radius[i], last, away);
        }

        outside[i] = cell[i] < 0 ? GREAT : max(away, 0.0);
        owned[i] = cell[i] >= 0;
    }

    lastTag_ = tag;
    lastCell_ = cell;
    lastByTag_.clear();
}


Foam::scalarField Foam::dispersedParticles::claims(const fvMesh&) const
{
    scalarField result(size(), 1e300);

    forAll(cell, i)
    {
        if (cell[i] >= 0)
        {
            result[i] = outside[i];
        }
    }

    return result;
}
