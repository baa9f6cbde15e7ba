// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "runClock.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::runClock::runClock
(
    const dictionary& controls,
    const fileName& rootPath,
    const fileName& caseName
)
:
    Time(controls, rootPath, caseName)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::runClock::resume(const fvMesh& mesh)
{
    const dictionary saved(savedNumbers(mesh));
    // all ranks alike: savedNumbers() is collective
    if (saved.empty())
    {
        return;
    }
    // the folder's name may have fewer digits
    value() = saved.get<scalar>("time");
    saved.readEntry("timeIndex", timeIndex_);
    // function objects start with the first step
    startTimeIndex_ = timeIndex_;
    saved.readEntry("startTime", startTime_);
    saved.readEntry("outputIndex", writeTimeIndex_);
}


void Foam::runClock::save(stateWriter& to)
{
    dictionary& numbers = to.numbers();
    numbers.set("time", value());
    numbers.set("timeIndex", timeIndex_);
    numbers.set("startTime", startTime_);
    numbers.set("outputIndex", writeTimeIndex_);
}


// ************************************************************************* //
