// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "particleTurnover.H"

#include "ListOps.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"

#include <cstdint>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- A number from 0 to 1 for a tag, by splitmix64's mixing: sums of it tell
//  sets of tags apart that have the same number and sum
static scalar scattered(const label tag)
{
    std::uint64_t x = std::uint64_t(tag)*0x9E3779B97F4A7C15u;
    x = (x ^ (x >> 30))*0xBF58476D1CE4E5B9u;
    x = (x ^ (x >> 27))*0x94D049BB133111EBu;
    return scalar((x ^ (x >> 31)) >> 11)/scalar(std::uint64_t(1) << 53);
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::labelHashSet Foam::particleTurnover::nowhere
(
    const labelList& asked,
    const labelHashSet& own
)
{
    List<labelList> lists(Pstream::nProcs());
    lists[Pstream::myProcNo()] = asked;
    Pstream::gatherList(lists);
    Pstream::scatterList(lists);

    labelHashSet found;
    for (const labelList& list : lists)
    {
        for (const label tag : list)
        {
            if (own.found(tag))
            {
                found.insert(tag);
            }
        }
    }

    List<labelList> founds(Pstream::nProcs());
    founds[Pstream::myProcNo()] = found.toc();
    Pstream::gatherList(founds);
    Pstream::scatterList(founds);

    labelHashSet missing(asked);
    for (const labelList& list : founds)
    {
        missing.unset(list);
    }
    return missing;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::particleTurnover::particleTurnover()
:
    signature_(Zero),
    first_(true)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::particleTurnover::compare
(
    const dispersedParticles& p,
    const label nCells
)
{
    vector signature(Zero);
    forAll(p.owned, i)
    {
        if (p.owned[i])
        {
            signature += vector(1, p.tag[i], scattered(p.tag[i]));
        }
    }
    reduce(signature, sumOp<vector>());
    const bool changed =
        !first_
     && (
            signature.x() != signature_.x() || signature.y() != signature_.y()
         || mag(signature.z() - signature_.z()) > 1e-6
        );

    came_.clear();
    gone_.clear();
    // all ranks alike: signatures are sums over them
    if (changed)
    {
        labelHashSet now, before;
        forAll(p.tag, i)
        {
            if (p.offset[i + 1] > p.offset[i])
            {
                now.insert(p.tag[i]);
            }
        }
        forAll(tag_, i)
        {
            if (offset_[i + 1] > offset_[i])
            {
                before.insert(tag_[i]);
            }
        }
        labelHashSet fresh(now), missing(before);
        fresh -= before;
        missing -= now;
        const labelHashSet came(nowhere(fresh.toc(), before));
        const labelHashSet gone(nowhere(missing.toc(), now));

        came_.setSize(nCells, Zero);
        gone_.setSize(nCells, Zero);
        forAll(p.tag, i)
        {
            if (came.found(p.tag[i]))
            {
                for (label e = p.offset[i]; e < p.offset[i + 1]; ++e)
                {
                    came_[p.cellIndex[e]] += p.weight[e]*p.volume[i];
                }
            }
        }
        forAll(tag_, i)
        {
            if (gone.found(tag_[i]))
            {
                for (label e = offset_[i]; e < offset_[i + 1]; ++e)
                {
                    gone_[cellIndex_[e]] += weight_[e]*volume_[i];
                }
            }
        }
        // all ranks alike: the sum over them
        if (gSum(gone_) > 0)
        {
            lastGone_ = gone_;
        }
    }

    tag_ = p.tag;
    volume_ = p.volume;
    offset_ = p.offset;
    cellIndex_ = p.cellIndex;
    weight_ = p.weight;
    signature_ = signature;
    first_ = false;
}
