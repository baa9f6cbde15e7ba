// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

// Saving a state for a pair of both halves, and going on from one.

#include "particleCoupling.H"

#include "exchange/saved_pair.h"
#include "exchange/world.h"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::particleCoupling::resume()
{
    const dictionary saved(savedNumbers(mesh_));
    // all ranks alike: savedNumbers() is collective
    if (saved.empty())
    {
        return;
    }
    saved.readEntry("pair", startPair_);
    saved.readEntry("exchangeTime", time_);
    saved.readEntry("interval", interval_);
    saved.readEntry("exchanges", stats_.exchanges);
    saved.readEntry("lastImpulse", lastImpulse_);
    saved.readEntry("momentumResidual", stats_.momentumResidual);
    response_.resume(saved.get<bool>("answerForeseen"));
    // those that are there now may be others than those it was found for
    saved.readIfPresent("kernelDiameter", kernelDiameter_);
    // all ranks alike: the number that each has read
    if (kernelDiameter_ > 0 && smoothing_->fits())
    {
        smoothing_->fit(kernelDiameter_);
    }
}


void Foam::particleCoupling::savePair()
{
    stopwatch watch(stats_.output);
    const clay::SavedPair& pair = session_->pair();
    const std::string& folder = session_->remoteTerms().pairs;
    std::string part = clay::unfinishedPair(folder, pair) + "/cfd";
    if (Pstream::parRun())
    {
        part += "/processor" + std::to_string(Pstream::myProcNo());
    }

    // an error is one of this rank, and no reason to end the run
    std::string why;
    try
    {
        stateWriter to(mesh_, part);
        to.numbers().set("pair", pair.number);
        savedPart::saveAll(to);
        to.finish();
        clay::writeSums(part, pair);
    }
    catch (const Foam::error& error)
    {
        why = error.message();
    }
    catch (const std::exception& error)
    {
        why = error.what();
    }

    List<string> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = why;
    Pstream::gatherList(all);
    Pstream::scatterList(all);
    why.clear();
    for (const string& text : all)
    {
        why = why.empty() ? std::string(text) : why;
    }
    if (Pstream::master())
    {
        try
        {
            if (why.empty())
            {
                clay::completePair(folder, pair);
            }
            else
            {
                clay::dropPair(folder, pair);
            }
        }
        catch (const std::exception& error)
        {
            why = error.what();
        }
    }
    bool good = why.empty();
    Pstream::scatter(good);
    // all ranks alike: the master's word
    if (good)
    {
        clay::setLastWords
        (
            "; the last saved state is that of step "
          + std::to_string(label(pair.step))
        );
    }
    else if (Pstream::master())
    {
        stats_.warn("no state was saved: " + why);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::particleCoupling::askStop(const label signal)
{
    const label any = returnReduce(signal, maxOp<label>());
    // all ranks alike: the largest of all
    if (any)
    {
        session_->askStop(any);
    }
}



void Foam::particleCoupling::save(stateWriter& to)
{
    dictionary& numbers = to.numbers();
    numbers.set("ranks", Pstream::nProcs());
    numbers.set("exchangeTime", time_);
    numbers.set("interval", interval_);
    numbers.set("exchanges", stats_.exchanges);
    numbers.set("lastImpulse", lastImpulse_);
    numbers.set("momentumResidual", stats_.momentumResidual);
    numbers.set("answerForeseen", response_.active());
    numbers.set("kernelDiameter", kernelDiameter_);
}


// ************************************************************************* //
