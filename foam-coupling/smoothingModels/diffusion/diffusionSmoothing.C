// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "diffusionSmoothing.H"
#include "checkedNumber.H"
#include "addToRunTimeSelectionTable.H"
#include "surfaceFields.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace smoothingModels
{
    defineTypeNameAndDebug(diffusion, 0);
    addToRunTimeSelectionTable(smoothingModel, diffusion, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

Foam::List<Foam::scalar> Foam::smoothingModels::chebyshevOfExp
(
    const scalar a,
    const scalar rest
)
{
    if (!(a > 1e-12))
    {
        return List<scalar>(1, 1.0);
    }

    // Miller's recurrence from far above, in proportion; e^-a times the sum
    // I_0 + 2 I_1 + 2 I_2 ... is one
    const label far = 20 + label(12*std::sqrt(a + 1));
    List<scalar> I(far + 2, Zero);
    I[far] = 1e-280;
    for (label k = far; k > 0; --k)
    {
        I[k - 1] = I[k + 1] + 2*k/a*I[k];
        if (I[k - 1] > 1e200)
        {
            for (label j = k - 1; j <= far; ++j)
            {
                I[j] *= 1e-200;
            }
        }
    }
    scalar all = I[0];
    for (label k = 1; k <= far; ++k)
    {
        all += 2*I[k];
    }

    label last = 0;
    scalar left = all - I[0];
    while (left > rest*all)
    {
        left -= 2*I[++last];
    }

    List<scalar> c(last + 1);
    forAll(c, k)
    {
        c[k] = (k ? 2 : 1)*(k % 2 ? -1 : 1)*I[k]/(all - left);
    }
    return c;
}


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

bool Foam::smoothingModels::diffusion::isAuto(const dictionary& coeffs)
{
    const entry* given = coeffs.findEntry("bandwidth");
    if (!given)
    {
        return true;
    }
    ITstream& is = given->stream();
    return is.size() == 1 && is[0].isWord() && is[0].wordToken() == "auto";
}


void Foam::smoothingModels::diffusion::prepare() const
{
    const labelUList& own = mesh_.faceOwner();
    const labelUList& nei = mesh_.faceNeighbour();
    const scalarField& V = mesh_.V();
    const surfaceScalarField& deltaCoeffs = mesh_.nonOrthDeltaCoeffs();

    diagonal_.setSize(mesh_.nCells());
    diagonal_ = Zero;
    start_.setSize(mesh_.nCells() + 1);
    start_ = Zero;
    forAll(nei, f)
    {
        const scalar g = deltaCoeffs[f]*mesh_.magSf()[f];
        diagonal_[own[f]] += g/V[own[f]];
        diagonal_[nei[f]] += g/V[nei[f]];
        ++start_[own[f] + 1];
        ++start_[nei[f] + 1];
    }

    coupled_ = false;
    behind_.setSize(mesh_.nFaces() - nei.size());
    behind_ = Zero;
    forAll(mesh_.boundary(), patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        if (patch.coupled())
        {
            coupled_ = true;
            forAll(patch, i)
            {
                const label f = patch.start() + i;
                const scalar out =
                    deltaCoeffs.boundaryField()[patchi][i]*patch.magSf()[i]
                   /V[own[f]];
                behind_[f - nei.size()] = out;
                diagonal_[own[f]] += out;
            }
        }
    }
    reduce(coupled_, orOp<bool>());

    // Gershgorin's bound
    bound_ = max(2*gMax(diagonal_), VSMALL);
    series_ = chebyshevOfExp(0.5*spread()*bound_, 1e-8);

    // row by row, as step() takes it
    const scalar scale = 4/bound_;
    forAll(diagonal_, celli)
    {
        diagonal_[celli] = scale*diagonal_[celli] - 2;
        start_[celli + 1] += start_[celli];
    }
    behind_ *= scale;
    column_.setSize(2*nei.size());
    weight_.setSize(2*nei.size());
    labelList filled(SubList<label>(start_, mesh_.nCells()));
    forAll(nei, f)
    {
        const scalar g = scale*deltaCoeffs[f]*mesh_.magSf()[f];
        const label mine = filled[own[f]]++;
        column_[mine] = nei[f];
        weight_[mine] = g/V[own[f]];
        const label theirs = filled[nei[f]]++;
        column_[theirs] = own[f];
        weight_[theirs] = g/V[nei[f]];
    }
    prepared_ = true;
}


template<class Type>
void Foam::smoothingModels::diffusion::step
(
    const Field<Type>& now,
    Field<Type>& last
) const
{
    const label* const column = column_.cdata();
    const scalar* const weight = weight_.cdata();
    const Type* const from = now.cdata();
    Type* const to = last.data();

    const label n = last.size();
    label k = 0;
    for (label celli = 0; celli < n; ++celli)
    {
        Type sum = diagonal_[celli]*from[celli] - to[celli];
        for (const label end = start_[celli + 1]; k < end; ++k)
        {
            sum -= weight[k]*from[column[k]];
        }
        to[celli] = sum;
    }

    // all ranks alike: found for all of them
    if (coupled_)
    {
        const labelUList& own = mesh_.faceOwner();
        auto& field = carrier(now);
        field.primitiveFieldRef() = now;
        field.correctBoundaryConditions();
        forAll(field.boundaryField(), patchi)
        {
            const auto& patch = field.boundaryField()[patchi];
            if (patch.coupled())
            {
                const Field<Type> beyond(patch.patchNeighbourField());
                const label start = patch.patch().start();
                forAll(beyond, i)
                {
                    last[own[start + i]] -=
                        behind_[start + i - mesh_.nInternalFaces()]*beyond[i];
                }
            }
        }
    }
}


template<class Type>
void Foam::smoothingModels::diffusion::spreadOut(Field<Type>& cells) const
{
    // all ranks alike: so is whether it was made
    if (!prepared_ || mesh_.changing())
    {
        prepare();
    }

    // T_0, and T_1 as half of what step() gives with nothing before
    Field<Type> last(cells), now(cells.size(), Zero);

    cells *= series_[0];
    const label terms = series_.size();
    // all ranks alike: by the bound of all of them
    for (label k = 1; k < terms; ++k)
    {
        // all ranks alike: a count
        if (k == 1)
        {
            step(last, now);
            now *= 0.5;
        }
        // all ranks alike: likewise
        else
        {
            step(now, last);
            last.swap(now);
        }
        const scalar c = series_[k];
        Type* const sum = cells.data();
        const Type* const term = now.cdata();
        const label n = cells.size();
        for (label celli = 0; celli < n; ++celli)
        {
            sum[celli] += c*term[celli];
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::smoothingModels::diffusion::diffusion
(
    const dictionary& dict,
    const fvMesh& mesh
)
:
    smoothingModel(dict, mesh, typeName, {"bandwidth"}),
    auto_(isAuto(coeffs_)),
    bandwidth_(auto_ ? 0 : coeffs_.get<scalar>("bandwidth")),
    prepared_(false),
    coupled_(false),
    bound_(0),
    scalars_
    (
        IOobject
        (
            "clayFoam:smoothed",
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh,
        dimensionedScalar(dimless, Zero),
        zeroGradientFvPatchScalarField::typeName
    ),
    vectors_
    (
        IOobject
        (
            "clayFoam:smoothedVectors",
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh,
        dimensionedVector(dimless, Zero),
        zeroGradientFvPatchVectorField::typeName
    )
{
    if (!auto_)
    {
        numberAbove
        (
            dict, "diffusionCoeffs: bandwidth", bandwidth_, 0, " m, or auto"
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::smoothingModels::diffusion::fit(const scalar diameter)
{
    const scalar cells =
        gSum(thickness(mesh_)*mesh_.V())/gSum(mesh_.V());

    // to four digits: the same whatever ranks have summed in which order
    const auto rounded = [](const scalar x)
    {
        const scalar unit = std::pow(10.0, std::floor(std::log10(x)) - 3);
        return unit*std::round(x/unit);
    };
    bandwidth_ = rounded(max(3.5*diameter, 2*cells));
    prepared_ = false;
    Info<< "smoothing: bandwidth " << bandwidth_
        << " m, the larger of 3.5 times the bodies' diameter, "
        << rounded(diameter) << " m, and twice the cells' thickness, "
        << rounded(cells) << " m" << endl;
}


void Foam::smoothingModels::diffusion::smooth(scalarField& cells) const
{
    spreadOut(cells);
}


void Foam::smoothingModels::diffusion::smooth(vectorField& cells) const
{
    spreadOut(cells);
}


// ************************************************************************* //
