// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "keptMapping.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::keptMapping::keptMapping(const scalar distance)
:
    distance_(distance),
    known_(false)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::keptMapping::restore(dispersedParticles& p)
{
    known_ = distance_ > 0 && tag_.size() == p.size();
    DynamicList<label> moved(p.size());

    for (label i = 0; i < p.size(); ++i)
    {
        if
        (
            !known_
         || tag_[i] != p.tag[i]
         || radius_[i] != p.radius[i]
         || volume_[i] != p.volume[i]
         || magSqr(position_[i] - p.position[i])
          > sqr(max(distance_*p.radius[i], mapping_.slack[i]))
        )
        {
            moved.append(i);
        }
    }
    moved_.transfer(moved);

    if (known_ && moved_.size() < p.size())
    {
        static_cast<particleMapping&>(p) = mapping_;
    }
}


void Foam::keptMapping::keep(const dispersedParticles& p)
{
    if (distance_ <= 0)
    {
        return;
    }

    position_.setSize(p.size());
    radius_.setSize(p.size());
    volume_.setSize(p.size());
    tag_.setSize(p.size());
    for (const label i : moved_)
    {
        position_[i] = p.position[i];
        radius_[i] = p.radius[i];
        volume_[i] = p.volume[i];
        tag_[i] = p.tag[i];
    }
    mapping_ = p;
}
