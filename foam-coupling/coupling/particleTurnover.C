// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "particleTurnover.H"

#include "DynamicList.H"
#include "handOver.H"
#include "PstreamBuffers.H"
#include "PstreamReduceOps.H"

#include <cstdint>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- What a rank knows of a tag: held and owned at the last exchange and now
enum : label
{
    WAS_HELD = 1,
    WAS_OWN = 2,
    NOW = 4,
    IS_HELD = WAS_HELD*NOW,
    IS_OWN = WAS_OWN*NOW
};


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

Foam::vector Foam::particleTurnover::signature(const dispersedParticles& p)
{
    vector sum(Zero);
    forAll(p.owned, i)
    {
        if (p.owned[i])
        {
            sum += vector(1, p.tag[i], scattered(p.tag[i]));
        }
    }
    return returnReduce(sum, sumOp<vector>());
}


bool Foam::particleTurnover::same(const vector& signature) const
{
    return
        signature.x() == signature_.x() && signature.y() == signature_.y()
     && mag(signature.z() - signature_.z()) <= 1e-6;
}


Foam::Map<Foam::label> Foam::particleTurnover::changes
(
    const dispersedParticles& p
) const
{
    Map<label> states;
    forAll(p.tag, i)
    {
        if (p.offset[i + 1] > p.offset[i])
        {
            states.insert(p.tag[i], p.owned[i] ? IS_HELD + IS_OWN : IS_HELD);
        }
    }
    forAll(tag_, i)
    {
        if (offset_[i + 1] > offset_[i])
        {
            states(tag_[i], 0) += owned_[i] ? WAS_HELD + WAS_OWN : WAS_HELD;
        }
    }

    Map<label> changed;
    forAllConstIters(states, iter)
    {
        const label before = *iter & (WAS_HELD + WAS_OWN);
        const label now = *iter & (IS_HELD + IS_OWN);
        if (now != NOW*before)
        {
            changed.insert(iter.key(), *iter & (WAS_OWN + IS_OWN));
        }
    }
    return changed;
}


void Foam::particleTurnover::ask
(
    const Map<label>& changed,
    labelHashSet& came,
    labelHashSet& gone
)
{
    const label ranks = Pstream::nProcs();

    List<DynamicList<label>> tags(ranks), owners(ranks);
    forAllConstIters(changed, iter)
    {
        const label at = officeOf(iter.key());
        tags[at].append(iter.key());
        owners[at].append(*iter);
    }
    PstreamBuffers toOffice(Pstream::commsTypes::nonBlocking);
    for (label rank = 0; rank < ranks; ++rank)
    {
        if (tags[rank].size())
        {
            UOPstream os(rank, toOffice);
            os << tags[rank] << owners[rank];
        }
    }
    labelList sizes;
    toOffice.finishedSends(sizes);

    // one that goes from rank to rank was owned by one and is by another
    Map<label> whole;
    List<labelList> asked(ranks);
    told_ = changed.size();
    for (label rank = 0; rank < ranks; ++rank)
    {
        if (sizes[rank] > 0)
        {
            UIPstream is(rank, toOffice);
            asked[rank] = labelList(is);
            const labelList owned(is);
            forAll(owned, k)
            {
                whole(asked[rank][k], 0) |= owned[k];
            }
            told_ += owned.size();
        }
    }

    PstreamBuffers toAsker(Pstream::commsTypes::nonBlocking);
    for (label rank = 0; rank < ranks; ++rank)
    {
        DynamicList<label> cameThere, goneThere;
        for (const label tag : asked[rank])
        {
            if (whole[tag] == IS_OWN)
            {
                cameThere.append(tag);
            }
            if (whole[tag] == WAS_OWN)
            {
                goneThere.append(tag);
            }
        }
        if (cameThere.size() || goneThere.size())
        {
            UOPstream os(rank, toAsker);
            os << cameThere << goneThere;
        }
    }
    toAsker.finishedSends(sizes);
    for (label rank = 0; rank < ranks; ++rank)
    {
        if (sizes[rank] > 0)
        {
            UIPstream is(rank, toAsker);
            came.insert(labelList(is));
            gone.insert(labelList(is));
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::particleTurnover::particleTurnover()
:
    signature_(Zero),
    first_(true),
    saved_(false),
    told_(0)
{}


Foam::particleTurnover::particleTurnover(const fvMesh& mesh)
:
    particleTurnover()
{
    const dictionary saved(savedNumbers(mesh));
    // all ranks alike: savedNumbers() is collective, as what it holds is
    if (!saved.readIfPresent("particleSignature", signature_))
    {
        return;
    }
    saved_ = true;
    if (saved.get<bool>("particlesCameOrWent"))
    {
        came_.setSize(mesh.nCells());
        gone_.setSize(mesh.nCells());
        readCells(mesh, "particlesCame", came_);
        readCells(mesh, "particlesGone", gone_);
    }
    if (saved.get<bool>("particlesEverWent"))
    {
        lastGone_.setSize(mesh.nCells());
        readCells(mesh, "particlesLastGone", lastGone_);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::particleTurnover::compare
(
    const dispersedParticles& p,
    const label nCells
)
{
    const vector now(signature(p));
    const bool changed = !first_ && !same(now);

    // at the first exchange what a saved state holds is that of its particles
    if (!first_ || !saved_ || !same(now))
    {
        came_.clear();
        gone_.clear();
    }
    // all ranks alike: signatures are sums over them
    if (changed)
    {
        labelHashSet came, gone;
        ask(changes(p), came, gone);

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
    owned_ = p.owned;
    volume_ = p.volume;
    offset_ = p.offset;
    cellIndex_ = p.cellIndex;
    weight_ = p.weight;
    signature_ = now;
    first_ = false;
}


void Foam::particleTurnover::save(stateWriter& to)
{
    dictionary& numbers = to.numbers();
    numbers.set("particleSignature", signature_);
    numbers.set("particlesCameOrWent", any());
    numbers.set("particlesEverWent", lastGone_.size() > 0);
    // all ranks alike: so are both lists' being there
    if (any())
    {
        to.cells("particlesCame", came_);
        to.cells("particlesGone", gone_);
    }
    if (lastGone_.size())
    {
        to.cells("particlesLastGone", lastGone_);
    }
}
