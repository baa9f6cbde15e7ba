// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "quietFluid.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::quietFluid::sameBoundary
(
    volVectorField& U,
    volScalarField& p,
    const scalar e,
    const scalar time
) const
{
    bool same = true;

    U.correctBoundaryConditions();
    forAll(U.boundaryField(), patchi)
    {
        const fvPatchVectorField& Up = U.boundaryField()[patchi];
        if (same && !Up.coupled())
        {
            same =
                Up.size() == boundaryU_[patchi].size()
             && (Up.empty() || max(mag(Up - boundaryU_[patchi])) <= e);
        }

        fvPatchScalarField& pp = p.boundaryFieldRef()[patchi];
        if (pp.fixesValue() && !pp.coupled())
        {
            // a change of p sets the next cell going
            pp.evaluate();
            const scalarField& was = boundaryP_[patchi];
            const scalarField& slope = pp.patch().deltaCoeffs();
            for (label i = 0; same && i < pp.size(); ++i)
            {
                same = mag(pp[i] - was[i])*slope[i]*time <= e;
            }
        }
    }
    return same;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::quietFluid::quietFluid(const scalar fraction)
:
    fraction_(fraction),
    largest_(0),
    rate_(-1),
    left_(0),
    late_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::quietFluid::holds
(
    volVectorField& U,
    volScalarField& p,
    const volScalarField& n,
    const volScalarField& ddtN,
    const volScalarField& Sp,
    const volVectorField& F,
    const scalar interval
)
{
    // the same on all ranks
    const scalar e = fraction_*largest_;
    const scalar time = late_ + interval;
    if
    (
        !active() || rate_ < 0 || left_ >= most
     || !(rate_*(time + interval) <= e)
    )
    {
        return false;
    }

    bool same = sameBoundary(U, p, e, time);
    for (label celli = 0; same && celli < U.size(); ++celli)
    {
        // Sp is the mean over the whole time, the drag of this interval only
        const vector source(F[celli] - Sp[celli]*U[celli]);
        same =
            mag(ddtN[celli])*interval <= 1e-9
         && Sp[celli]*sqr(time) <= n[celli]*interval
         && mag(source - source_[celli])*time <= e*n[celli];
    }

    if (returnReduce(same, andOp<bool>()))
    {
        ++left_;
        late_ = time;
        return true;
    }
    return false;
}


void Foam::quietFluid::solved
(
    const vectorField& before,
    const volVectorField& U,
    const volScalarField& p,
    const volScalarField& Sp,
    const volVectorField& F,
    const scalar time
)
{
    if (!active())
    {
        return;
    }

    scalar change = 0;
    source_.setSize(U.size());
    forAll(source_, celli)
    {
        largest_ = max(largest_, mag(U[celli]));
        change = max(change, mag(U[celli] - before[celli]));
        source_[celli] = F[celli] - Sp[celli]*U[celli];
    }
    reduce(largest_, maxOp<scalar>());
    reduce(change, maxOp<scalar>());
    rate_ = change/time;
    left_ = 0;
    late_ = 0;

    boundaryU_.setSize(U.boundaryField().size());
    boundaryP_.setSize(U.boundaryField().size());
    forAll(boundaryU_, patchi)
    {
        boundaryU_[patchi] = U.boundaryField()[patchi];
        boundaryP_[patchi] = p.boundaryField()[patchi];
    }
}


void Foam::quietFluid::save(dictionary& numbers)
{
    numbers.set("largestSpeed", largest_);
    numbers.set("timeLeftOut", late_);
    rate_ = -1;
    left_ = 0;
}


void Foam::quietFluid::resume(const dictionary& numbers)
{
    numbers.readIfPresent("largestSpeed", largest_);
    numbers.readIfPresent("timeLeftOut", late_);
}
