// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "keptMapping.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::keptMapping::keptMapping(const scalar distance)
:
    distance_(distance),
    last_(),
    moved_(),
    known_(false)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::keptMapping::restore(dispersedParticles& p)
{
    known_ = distance_ > 0 && last_.size() == p.size();
    DynamicList<label> moved(p.size());

    for (label i = 0; i < p.size(); ++i)
    {
        if
        (
            !known_
         || last_.tag[i] != p.tag[i]
         || last_.radius[i] != p.radius[i]
         || last_.volume[i] != p.volume[i]
         || magSqr(last_.position[i] - p.position[i])
          > sqr(max(distance_*p.radius[i], last_.slack[i]))
        )
        {
            moved.append(i);
        }
    }
    moved_.transfer(moved);

    if (known_ && moved_.size() < p.size())
    {
        p.cell = last_.cell;
        p.outside = last_.outside;
        p.owned = last_.owned;
        p.slack = last_.slack;
        p.offset = last_.offset;
        p.cellIndex = last_.cellIndex;
        p.weight = last_.weight;
    }
}


void Foam::keptMapping::keep(const dispersedParticles& p)
{
    if (distance_ <= 0)
    {
        return;
    }
    if (allMoved(p))
    {
        last_.setSize(p.size());
        last_.position = p.position;
        last_.radius = p.radius;
        last_.volume = p.volume;
        last_.tag = p.tag;
    }
    else
    {
        for (const label i : moved_)
        {
            last_.position[i] = p.position[i];
            last_.radius[i] = p.radius[i];
            last_.volume[i] = p.volume[i];
            last_.tag[i] = p.tag[i];
        }
    }
    last_.cell = p.cell;
    last_.outside = p.outside;
    last_.owned = p.owned;
    last_.slack = p.slack;
    last_.offset = p.offset;
    last_.cellIndex = p.cellIndex;
    last_.weight = p.weight;
}
