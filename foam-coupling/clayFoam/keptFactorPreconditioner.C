// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "keptFactorPreconditioner.H"

#include "FDICPreconditioner.H"
#include "cyclicLduInterface.H"
#include "objectRegistry.H"

#include <Eigen/SparseCholesky>

#include <memory>
#include <vector>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(keptFactorPreconditioner, 0);

    lduMatrix::preconditioner::
        addsymMatrixConstructorToTable<keptFactorPreconditioner>
        addKeptFactorPreconditionerSymMatrixConstructorToTable_;
}


struct Foam::keptFactorPreconditioner::factors
{
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> ldlt;

    //- Is the pattern known, are there factors
    bool analysed = false;
    bool made = false;

    //- Operations of an iteration and of making factors, and what iterations
    //  beyond two a solution have cost since
    double iteration = 0;
    double making = 0;
    double spent = 0;
};


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- The factors of an equation, kept by its mesh: they end with it
class keptFactors
:
    public regIOobject
{
public:

    TypeName("keptFactors");

    const std::shared_ptr<keptFactorPreconditioner::factors> content;

    explicit keptFactors(const IOobject& io)
    :
        regIOobject(io),
        content(std::make_shared<keptFactorPreconditioner::factors>())
    {}

    virtual bool writeData(Ostream& os) const
    {
        return os.good();
    }
};

defineTypeNameAndDebug(keptFactors, 0);


//- One for each mesh and equation; a mesh that has no place for them, as the
//  coarse ones of GAMG, keeps none
static std::shared_ptr<keptFactorPreconditioner::factors> kept
(
    const lduMesh& mesh,
    const word& equation
)
{
    if (!mesh.hasDb())
    {
        return std::make_shared<keptFactorPreconditioner::factors>();
    }
    const objectRegistry& db = mesh.thisDb();
    const word name("clayFoam:factors:" + equation);
    if (!db.foundObject<keptFactors>(name))
    {
        regIOobject::store
        (
            new keptFactors
            (
                IOobject
                (
                    name,
                    db.instance(),
                    db,
                    IOobject::NO_READ,
                    IOobject::NO_WRITE
                )
            )
        );
    }
    return db.lookupObject<keptFactors>(name).content;
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::keptFactorPreconditioner::factorise()
{
    const lduMatrix& matrix = solver_.matrix();
    const labelUList& l = matrix.lduAddr().lowerAddr();
    const labelUList& u = matrix.lduAddr().upperAddr();
    const scalarField& diag = matrix.diag();
    const scalarField& upper = matrix.upper();

    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(diag.size() + upper.size());
    forAll(diag, celli)
    {
        entries.emplace_back(celli, celli, diag[celli]);
    }
    forAll(upper, f)
    {
        entries.emplace_back(u[f], l[f], upper[f]);
    }

    // cells that are neighbours through periodic sides
    const lduInterfacePtrsList interfaces(matrix.mesh().interfaces());
    forAll(interfaces, i)
    {
        if (!interfaces.set(i) || !isA<cyclicLduInterface>(interfaces[i]))
        {
            continue;
        }
        const cyclicLduInterface& side =
            refCast<const cyclicLduInterface>(interfaces[i]);
        const labelUList& here = interfaces[i].faceCells();
        const labelUList& there =
            interfaces[side.neighbPatchID()].faceCells();
        const scalarField& coeffs = solver_.interfaceBouCoeffs()[i];
        forAll(here, k)
        {
            if (here[k] >= there[k])
            {
                entries.emplace_back(here[k], there[k], -coeffs[k]);
            }
        }
    }

    Eigen::SparseMatrix<double> A(diag.size(), diag.size());
    A.setFromTriplets(entries.begin(), entries.end());

    factors& f = *factors_;
    if (!f.analysed)
    {
        f.ldlt.analyzePattern(A);
        f.analysed = true;
    }
    f.ldlt.factorize(A);
    f.made = f.ldlt.info() == Eigen::Success;

    const auto& L = f.ldlt.matrixL().nestedExpression();
    f.making = 20.0*L.nonZeros();
    for (Eigen::Index col = 0; col < L.cols(); ++col)
    {
        const double n = L.outerIndexPtr()[col + 1] - L.outerIndexPtr()[col];
        f.making += 2*n*n;
    }
    f.iteration = 4.0*L.nonZeros() + 30.0*diag.size() + 8.0*upper.size();
    f.spent = 0;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::keptFactorPreconditioner::keptFactorPreconditioner
(
    const lduMatrix::solver& sol,
    const dictionary& controls
)
:
    lduMatrix::preconditioner(sol),
    iterations_(0)
{
    const label cells = sol.matrix().diag().size();
    if (cells == 0)
    {
        return;
    }
    if (cells > controls.lookupOrDefault<label>("maxCells", 20000))
    {
        other_.reset(new FDICPreconditioner(sol, controls));
        return;
    }

    factors_ = kept(sol.matrix().mesh(), sol.fieldName());
    if (!factors_->made || factors_->spent >= factors_->making)
    {
        factorise();
    }
    if (!factors_->made)
    {
        other_.reset(new FDICPreconditioner(sol, controls));
    }
}


// * * * * * * * * * * * * * * * * Destructor  * * * * * * * * * * * * * * * //

Foam::keptFactorPreconditioner::~keptFactorPreconditioner()
{
    if (factors_)
    {
        factors_->spent += max(iterations_ - 2, 0)*factors_->iteration;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::keptFactorPreconditioner::forget(const objectRegistry& db)
{
    for (const word& name : db.sortedNames<keptFactors>())
    {
        // stored there: it ends
        db.checkOut(name);
    }
}


void Foam::keptFactorPreconditioner::precondition
(
    solveScalarField& wA,
    const solveScalarField& rA,
    const direction cmpt
) const
{
    if (other_.valid())
    {
        other_->precondition(wA, rA, cmpt);
        return;
    }
    if (!factors_)
    {
        return;
    }
    ++iterations_;

    const Eigen::Map<const Eigen::VectorXd> r(rA.begin(), rA.size());
    Eigen::Map<Eigen::VectorXd> w(wA.begin(), wA.size());
    w = factors_->ldlt.solve(r);
}


// ************************************************************************* //
