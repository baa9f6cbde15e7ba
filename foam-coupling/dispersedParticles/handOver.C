// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "handOver.H"

#include "DynamicList.H"
#include "PstreamBuffers.H"
#include "scalarList.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Appends tag, length and numbers
static void put
(
    DynamicList<scalar>& parcel,
    const label tag,
    const std::vector<scalar>& numbers
)
{
    parcel.append(scalar(tag));
    parcel.append(scalar(numbers.size()));
    for (const scalar x : numbers)
    {
        parcel.append(x);
    }
}


//- Takes a parcel apart
static void take(const scalarUList& parcel, particleNumbers& all)
{
    for (label k = 0; k < parcel.size();)
    {
        const label tag = label(parcel[k]), size = label(parcel[k + 1]);
        const scalar* from = parcel.cdata() + k + 2;
        all[tag].assign(from, from + size);
        k += 2 + size;
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Other Functions * * * * * * * * * * * * * * //

Foam::label Foam::officeOf(const label tag)
{
    return mag(tag) % Pstream::nProcs();
}


Foam::particleNumbers Foam::handOver
(
    const particleNumbers& given,
    const labelUList& wanted
)
{
    const label ranks = Pstream::nProcs();

    // to the offices
    PstreamBuffers toOffice(Pstream::commsTypes::nonBlocking);
    {
        List<DynamicList<scalar>> parcels(ranks);
        List<DynamicList<label>> questions(ranks);
        for (const auto& one : given)
        {
            put(parcels[officeOf(one.first)], one.first, one.second);
        }
        for (const label tag : wanted)
        {
            questions[officeOf(tag)].append(tag);
        }
        for (label rank = 0; rank < ranks; ++rank)
        {
            if (parcels[rank].size() || questions[rank].size())
            {
                UOPstream os(rank, toOffice);
                os << parcels[rank] << questions[rank];
            }
        }
    }
    labelList sizes;
    toOffice.finishedSends(sizes);

    particleNumbers here;
    List<labelList> asked(ranks);
    for (label rank = 0; rank < ranks; ++rank)
    {
        if (sizes[rank] > 0)
        {
            UIPstream is(rank, toOffice);
            const scalarList parcel(is);
            asked[rank] = labelList(is);
            take(parcel, here);
        }
    }

    // and back
    PstreamBuffers toOwner(Pstream::commsTypes::nonBlocking);
    for (label rank = 0; rank < ranks; ++rank)
    {
        DynamicList<scalar> parcel;
        for (const label tag : asked[rank])
        {
            const auto found = here.find(tag);
            if (found != here.end())
            {
                put(parcel, tag, found->second);
            }
        }
        if (parcel.size())
        {
            UOPstream os(rank, toOwner);
            os << parcel;
        }
    }
    toOwner.finishedSends(sizes);

    particleNumbers received;
    for (label rank = 0; rank < ranks; ++rank)
    {
        if (sizes[rank] > 0)
        {
            UIPstream is(rank, toOwner);
            take(scalarList(is), received);
        }
    }
    return received;
}
