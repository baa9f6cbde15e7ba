// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "quietFluid.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::quietFluid::quietFluid(const scalar fraction)
:
    fraction_(fraction),
    largest_(0),
    change_(-1),
    left_(0),
    missed_(0),
    boundary_()
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::quietFluid::holds
(
    volVectorField& U,
    const volScalarField& n,
    const volScalarField& ddtN,
    const volScalarField& Sp,
    const volVectorField& F,
    const scalar interval
)
{
    if (!active() || change_ < 0)
    {
        return false;
    }

    // the same on all ranks
    const scalar e = fraction_*largest_;
    if (!(change_*most <= e - missed_) || left_ >= most)
    {
        return false;
    }

    bool same = true;
    for (label celli = 0; same && celli < U.size(); ++celli)
    {
        const vector source(F[celli] - Sp[celli]*U[celli]);
        same =
            mag(ddtN[celli])*interval <= 1e-9
         && mag(source)*interval <= e*n[celli];
    }

    U.correctBoundaryConditions();
    forAll(U.boundaryField(), patchi)
    {
        const fvPatchVectorField& Up = U.boundaryField()[patchi];
        if (same && !Up.coupled())
        {
            same =
                Up.size() == boundary_[patchi].size()
             && (Up.empty() || max(mag(Up - boundary_[patchi])) <= e);
        }
    }

    if (returnReduce(same, andOp<bool>()))
    {
        ++left_;
        missed_ += change_;
        return true;
    }
    return false;
}


void Foam::quietFluid::solved
(
    const vectorField& before,
    const volVectorField& U
)
{
    if (!active())
    {
        return;
    }

    const vectorField& cells = U.primitiveField();
    largest_ = max(largest_, gMax(mag(cells)()));
    change_ = gMax(mag(cells - before)());
    left_ = 0;
    if (change_ > fraction_*largest_)
    {
        // it moves: what it missed before is no part of this
        missed_ = 0;
    }

    boundary_.setSize(U.boundaryField().size());
    forAll(boundary_, patchi)
    {
        boundary_[patchi] = U.boundaryField()[patchi];
    }
}
