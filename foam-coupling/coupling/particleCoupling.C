// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "particleCoupling.H"
#include "checkedNumber.H"

#include "savedField.H"

#include "OSspecific.H"
#include "OStringStream.H"
#include "savedState.H"
#include "turbulenceModel.H"
#include "zeroGradientFvPatchFields.H"


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- The fluid's density [kg/m3]
static scalar density(const dictionary& dict)
{
    const word name("rho");
    if (!dict.found(name))
    {
        FatalIOErrorInFunction(dict)
            << name << " is missing: the fluid's density [kg/m3], for water "
            << name << " 1000;" << exit(FatalIOError);
    }
    return numberAbove
    (
        dict, name, dimensionedScalar(name, dimDensity, dict).value(), 0
    );
}


//- Is there a file of that name in the start time's folder. Collective
static bool present(const fvMesh& mesh, const word& field)
{
    return returnReduce
    (
        isFile(mesh.time().timePath()/field),
        orOp<bool>()
    );
}


} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::voidFractionModel::sharedSum Foam::particleCoupling::sharedSum()
{
    if (!Pstream::parRun())
    {
        return nullptr;
    }
    return [this](std::vector<double>& values, int stride)
    {
        session_->sumShared(values, stride);
    };
}


Foam::tmp<Foam::volScalarField> Foam::particleCoupling::nuEff() const
{
    if (mesh_.foundObject<turbulenceModel>(turbulenceModel::propertiesName))
    {
        return mesh_.lookupObject<turbulenceModel>
        (
            turbulenceModel::propertiesName
        ).nuEff();
    }

    return tmp<volScalarField>::New
    (
        IOobject("nuEff", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar("nu", dimViscosity, nu_)
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::particleCoupling::particleCoupling
(
    const volVectorField& U,
    const volScalarField& p,
    const dictionary& transportProperties
)
:
    U_(U),
    p_(p),
    mesh_(U.mesh()),
    law_(transportProperties),
    nu_(law_.nu(0)),
    rho_(density(transportProperties)),
    properties_(mesh_.time()),
    mapping_(voidFractionModel::New(properties_, mesh_)),
    kept_(properties_.keepMapping()),
    smoothing_(smoothingModel::New(properties_, mesh_)),
    kernelDiameter_(0),
    ddtType_(properties_.ddt(mapping_->smooth() && !smoothing_->active())),
    sumShared_(sharedSum()),
    forces_
    (
        properties_,
        sumShared_,
        smoothing_(),
        rho_,
        {
            mesh_,
            mapping_->type(),
            properties_.interpolation(),
            nu_,
            rho_,
            smoothing_->spread(),
            ddtType_ == couplingProperties::ddtType::difference ? 1.0
          : ddtType_ == couplingProperties::ddtType::particleFlux ? 2.0 : 0.0,
            properties_.has("pressureGradient")
        }
    ),
    solids_(mesh_, properties_.writeFields()),
    ledger_(mesh_, rho_, forces_.addedDensity() > 0),
    response_(mesh_, rho_),
    history_(U_),
    gradP_
    (
        IOobject
        (
            "gradp",
            mesh_.time().timeName(),
            mesh_,
            readState(mesh_),
            IOobject::AUTO_WRITE
        ),
        mesh_,
        dimensionedVector(dimAcceleration, Zero),
        zeroGradientFvPatchVectorField::typeName
    ),
    gradPSet_(savedField<volVectorField>(mesh_, "gradp")),
    mark_
    (
        stateMark
        (
            mesh_,
            forces_.addedDensity() > 0
          ? wordList({"DUDt", "particleForceSent"}) : wordList()
        )
    ),
    startPair_(0),
    stressFraction_
    (
        IOobject("stressFraction", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar("one", dimless, 1),
        zeroGradientFvPatchScalarField::typeName
    ),
    gravity_(Zero),
    turnover_(mesh_),
    waves_(mesh_),
    lastImpulse_(Zero),
    solidVolume_(0),
    time_(mesh_.time().value() - properties_.timeOffset()),
    lastInterval_(0),
    interval_(0),
    marched_(0),
    pending_(false),
    late_(false)
{
    properties_.checkMesh(mesh_);
    checkSavedState(mesh_);

    if (!law_.newtonian() && properties_.get<word>("selfDisturbance") != "none")
    {
        FatalIOErrorInFunction(properties_)
            << "selfDisturbance " << properties_.get<word>("selfDisturbance")
            << " needs a Newtonian fluid; transportModel is " << law_.model()
            << exit(FatalIOError);
    }

    if (properties_.defaults().size())
    {
        Info<< "clayFoam: couplingProperties: defaults taken: "
            << properties_.defaults().c_str() << endl;
    }

    // every case of CFDEM's brings one
    for (const word field : {"voidfraction", "couplingImpulse"})
    {
        if (!isSavedState(mesh_) && present(mesh_, field))
        {
            stats_.warn
            (
                mesh_.time().timeName() + "/" + field + " is not read: its"
                " folder has no uniform/couplingState, the mark of a state"
                " that a coupled run has saved"
            );
        }
    }

    if
    (
        smoothing_->fits()
     && properties_.get<word>("selfDisturbance") != "none"
    )
    {
        FatalIOErrorInFunction(properties_)
            << "selfDisturbance " << properties_.get<word>("selfDisturbance")
            << " must know the kernel from the start: diffusionCoeffs:"
            << " bandwidth is auto, give it in m" << exit(FatalIOError);
    }

    resume();
    session_.reset(new clay::CfdSession(terms(), boxes()));
    received_ = clay::Particles(session_->receives());
    answers_ = clay::Particles(session_->sends());

    checkBuoyancy();

    // what is read where it is there: on all ranks or on none
    for (const word& name : {"couplingImpulse", "DUDt", "particleForceSent"})
    {
        savedField<volVectorField>(mesh_, name);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::particleCoupling::advance()
{
    const scalar dt = mesh_.time().deltaTValue();

    marched_ += dt;
    history_.advance(marched_/interval_ > 1 - 1e-9 ? 1 : marched_/interval_);
    // all ranks alike: from what is stiff on any of them
    if (response_.active())
    {
        ledger_.prepare(dt, response_, startGradP_);
    }
    else
    {
        ledger_.prepare(dt);
    }

    // model B, and particles that carry their share: the whole stress
    if (properties_.modelA() && !properties_.has("viscous"))
    {
        stressFraction_ == history_.n();
    }
}


void Foam::particleCoupling::record()
{
    const scalar dt = mesh_.time().deltaTValue();
    if (response_.active())
    {
        ledger_.record(U_, dt, response_, gradP_.primitiveField());
    }
    else
    {
        ledger_.record(U_, dt);
    }
    ++stats_.steps;
}


void Foam::particleCoupling::setPressureGradient(const volVectorField& gradP)
{
    gradP_.primitiveFieldRef() = gradP.primitiveField();
    gradP_.correctBoundaryConditions();
    gradPSet_ = true;
}


void Foam::particleCoupling::checkFields() const
{
    List<string> found(Pstream::nProcs());

    forAll(U_, celli)
    {
        const vector& u = U_[celli];
        if (!std::isfinite(u.x() + u.y() + u.z() + p_[celli]))
        {
            OStringStream os;
            os  << "the fluid is NaN or infinite at time "
                << mesh_.time().value() << " s, cell " << celli
                << " at " << mesh_.C()[celli] << " m: U " << u
                << ", p " << p_[celli]
                << "; a smaller maxCo or deltaT may help";
            found[Pstream::myProcNo()] = os.str();
            break;
        }
    }

    // all ranks stop for the same reason
    if (returnReduce(!found[Pstream::myProcNo()].empty(), orOp<bool>()))
    {
        Pstream::gatherList(found);
        Pstream::scatterList(found);
        for (const string& text : found)
        {
            if (!text.empty())
            {
                FatalErrorInFunction << text.c_str() << exit(FatalError);
            }
        }
    }
}


void Foam::particleCoupling::writeStatistics(const dictionary& solverSettings)
{
    dictionary settings(properties_);
    settings.merge(solverSettings);
    settings.add("nu", nu_);
    settings.add("rho", rho_);
    settings.add("meshCells", returnReduce(mesh_.nCells(), sumOp<label>()));
    settings.add("ranks", Pstream::nProcs());
    if (smoothing_->active())
    {
        settings.add("kernelBandwidth", smoothing_->bandwidth());
    }

    const clay::DemTerms& dem = session_->remoteTerms();
    settings.add("couplingInterval", dem.step*dem.interval, true);
    settings.add("gravity", gravity_);
    if (!dem.clumpDrag.empty())
    {
        settings.add("clumpDrag", word(dem.clumpDrag));
    }

    if (stats_.stiffExchanges > 0)
    {
        stats_.warn
        (
            "drag was stiff for the coupling interval in "
          + std::to_string(stats_.stiffExchanges) + " of "
          + std::to_string(stats_.exchanges)
          + " exchanges: there the fluid was solved first, the particles"
            " waited"
        );
    }
    warnOfInterval();
    if (stats_.outside > 0)
    {
        stats_.warn
        (
            "up to " + std::to_string(stats_.outside)
          + " particle centres lay outside the mesh; they count in the"
            " nearest cell"
        );
    }

    stats_.reynoldsMax = forces_.reynoldsMax();
    stats_.exchange = session_->timing().exchange;
    stats_.waiting = session_->timing().waiting;
    stats_.bytesSent = session_->timing().bytesSent;
    stats_.write
    (
        mesh_.time().rootPath()/mesh_.time().globalCaseName()/"cfd.json",
        settings
    );
}
