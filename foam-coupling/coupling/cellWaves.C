// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "cellWaves.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::cellWaves::add
(
    const dispersedParticles& p,
    const volVectorField& U
)
{
    if (fraction_.empty())
    {
        fraction_.setSize(mesh_.nCells(), Zero);
        slip_.setSize(mesh_.nCells(), Zero);
        way_.setSize(mesh_.nCells(), Zero);
    }

    scalarField solid(mesh_.nCells(), Zero);
    vectorField moved(mesh_.nCells(), Zero);
    for (label i = 0; i < p.size(); ++i)
    {
        for (label k = p.offset[i]; k < p.offset[i + 1]; ++k)
        {
            const scalar part = p.weight[k]*p.volume[i];
            solid[p.cellIndex[k]] += part;
            moved[p.cellIndex[k]] += part*p.velocity[i];
        }
    }

    const scalarField& V = mesh_.V();
    forAll(solid, celli)
    {
        if (solid[celli] > 0)
        {
            const vector v(moved[celli]/solid[celli]);
            fraction_[celli] += unseen_*solid[celli]/V[celli];
            slip_[celli] += unseen_*(v - U[celli]);
            way_[celli] += unseen_*mag(v)/thickness_[celli];
        }
    }
    time_ += unseen_;
    unseen_ = 0;
    pace_ = 0;
}


void Foam::cellWaves::judge()
{
    // all ranks alike: made at the end of the first window
    if (!wide_)
    {
        const scalar cell =
            gSum(thickness_*mesh_.V())/gSum(mesh_.V());
        dictionary coeffs;
        coeffs.add("bandwidth", 3*cell);
        dictionary dict;
        dict.add("smoothingModel", word("diffusion"));
        dict.add("diffusionCoeffs", coeffs);
        wide_ = smoothingModel::New(dict, mesh_);
    }

    scalarField counts(mesh_.nCells(), Zero);
    scalarField fraction(mesh_.nCells(), Zero);
    forAll(fraction_, celli)
    {
        const scalar mean = fraction_[celli]/time_;
        if (way_[celli] >= 1 && mean >= 0.05)
        {
            counts[celli] = 1;
            fraction[celli] = mean;
        }
    }
    scalarField around(fraction), near(counts);
    wide_->smooth(around);
    wide_->smooth(near);
    const scalarField a
    (
        counts*(fraction - around/max(near, scalar(SMALL)))
    );

    // faces, product, square, solid fraction; each by weight
    FixedList<scalar, 4> sums(Zero);
    for (label facei = 0; facei < mesh_.nInternalFaces(); ++facei)
    {
        const label own = mesh_.faceOwner()[facei];
        const label nei = mesh_.faceNeighbour()[facei];
        if (counts[own] > 0 && counts[nei] > 0)
        {
            const vector& S = mesh_.faceAreas()[facei];
            const vector s(slip_[own] + slip_[nei]);
            const scalar w = sqr(S & s)/max(magSqr(S)*magSqr(s), VSMALL);
            sums[0] += w;
            sums[1] += w*a[own]*a[nei];
            sums[2] += w*0.5*(sqr(a[own]) + sqr(a[nei]));
            sums[3] += w*0.5*(fraction[own] + fraction[nei]);
        }
    }
    // all ranks alike: four of them
    for (scalar& part : sums)
    {
        reduce(part, sumOp<scalar>());
    }

    fraction_ = Zero;
    slip_ = Zero;
    way_ = Zero;
    time_ = 0;
    crossed_ = 0;

    found_ = false;
    if (sums[0] > 1 && sums[2] > 0)
    {
        const scalar C = sums[1]/sums[2];
        const scalar amplitude = sqrt(sums[2]/sums[0])/(sums[3]/sums[0]);
        found_ = C < -0.5 - 2/sqrt(sums[0]) && amplitude > 0.05;
        if (amplitude > 0.05 && C < correlation_)
        {
            correlation_ = C;
            amplitude_ = amplitude;
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cellWaves::cellWaves(const fvMesh& mesh)
:
    mesh_(mesh),
    thickness_(smoothingModel::thickness(mesh)),
    slender_(gMax(cbrt(mesh.V())/thickness_)),
    time_(0),
    crossed_(0),
    pace_(0),
    unseen_(0),
    correlation_(0),
    amplitude_(0),
    found_(false)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::cellWaves::look
(
    const dispersedParticles& p,
    const volVectorField& U,
    const scalar interval,
    const scalar crossing
)
{
    unseen_ += interval;
    pace_ += crossing*slender_;
    crossed_ += crossing*slender_;

    // a state stands for a quarter of a cell
    if (pace_ < 0.25)
    {
        return false;
    }
    add(p, U);
    // all ranks alike: by the fastest particle of all
    if (crossed_ < 4)
    {
        return false;
    }
    judge();
    return found_;
}
