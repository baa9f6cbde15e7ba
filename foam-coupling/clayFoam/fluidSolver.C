// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "fluidSolver.H"

#include "evaluateCoupled.H"
#include "keptFactorPreconditioner.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static Switch adjusts(const dictionary& control)
{
    return control.lookupOrDefault<Switch>("adjustTimeStep", true);
}

//- The step that a case asks for, where it leaves open that steps adapt [s]
static scalar longest(const dictionary& control)
{
    return min
    (
        control.lookupOrDefault<scalar>("maxDeltaT", GREAT),
        control.found("adjustTimeStep")
      ? GREAT
      : control.get<scalar>("deltaT")
    );
}

static scalar maxCo(const dictionary& control)
{
    return control.lookupOrDefault<scalar>("maxCo", 0.5);
}

//- A field of no conditions, but neighbours' values
template<class Type>
static tmp<GeometricField<Type, fvPatchField, volMesh>> scratch
(
    const fvMesh& mesh,
    const word& name,
    const dimensionSet& dims
)
{
    return tmp<GeometricField<Type, fvPatchField, volMesh>>::New
    (
        IOobject
        (
            name,
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh,
        dimensioned<Type>(dims, Zero)
    );
}

//- Refuses a field of other dimensions than the equations take it for
template<class Field>
static void checkDimensions
(
    const Field& field,
    const dimensionSet& dims,
    const char* what
)
{
    if (field.dimensions() != dims)
    {
        FatalErrorInFunction
            << field.time().timeName() << '/' << field.name()
            << ": dimensions " << field.dimensions() << " are not those of "
            << what << ", " << dims << "; give " << field.name()
            << " in these" << exit(FatalError);
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::fluidSolver::courantRate() const
{
    const labelUList& own = mesh_.owner();
    const labelUList& nei = mesh_.neighbour();
    scalarField sum(mesh_.nCells(), Zero);
    forAll(nei, f)
    {
        const scalar size = mag(phi_[f]);
        sum[own[f]] += size;
        sum[nei[f]] += size;
    }
    faces_.patches([&](const label patchi, const fvPatch& patch)
    {
        const labelUList& inside = patch.faceCells();
        forAll(inside, i)
        {
            sum[inside[i]] += mag(phi_.boundaryField()[patchi][i]);
        }
    });

    scalar largest = 0;
    forAll(sum, celli)
    {
        largest = max(largest, sum[celli]/mesh_.V()[celli]);
    }
    return 0.5*returnReduce(largest, maxOp<scalar>());
}


Foam::label Foam::fluidSolver::subSteps(const scalar interval) const
{
    const dictionary& dict = runTime_.controlDict();
    scalar dt = dict.get<scalar>("deltaT");

    // all ranks alike: read from controlDict
    if (adjusts(dict))
    {
        dt = min
        (
            longest(dict),
            maxCo(dict)/max(courantRate(), VSMALL)
        );
    }

    const scalar steps = interval/dt;
    if (!(steps < 1e6))
    {
        const label celli = findMax(magSqr(U_.primitiveField())());
        FatalErrorInFunction
            << "the coupling interval of " << interval << " s would need "
            << steps << " steps of the fluid at time " << runTime_.value()
            << " s: U is " << (celli < 0 ? vector::zero : U_[celli])
            << " m/s in cell " << celli << " at "
            << (celli < 0 ? vector::zero : mesh_.C()[celli])
            << " m; see deltaT, maxCo and maxDeltaT in system/controlDict"
            << exit(FatalError);
    }
    return max(1, label(ceil(steps - 1e-6)));
}


void Foam::fluidSolver::begin(const particleCoupling& coupling)
{
    const bool plain =
        turbulence_->type() == "Stokes"
     && viscosityLaw(transport_).newtonian()
     && fv::options::New(mesh_).optionList::empty();
    quiet_.reset
    (
        new quietFluid(plain ? coupling.properties().quietFluid() : 0)
    );

    const bool atStart = saved_.empty();
    // all ranks alike: savedNumbers() is
    if (atStart)
    {
        // n is that of the start
        nPhi_ = phi_*fvc::interpolate
        (
            coupling.n(),
            "interpolate(voidfraction)"
        );
        faces_.take(fvc::snGrad(p_)(), slope_);
        slope_ *= faces_.magSf();
    }
    else
    {
        quiet_->resume(saved_);
    }
}


void Foam::fluidSolver::save(stateWriter& to)
{
    to.faces("nPhi", nPhi_);
    surfaceScalarField slope("slope", nPhi_);
    faces_.put(slope_, slope);
    to.faces("pressureSlope", slope);
    if (quiet_)
    {
        quiet_->save(to.numbers());
    }
    keptFactorPreconditioner::forget(mesh_.thisDb());
}


bool Foam::fluidSolver::oneStep(const scalar time) const
{
    const dictionary& dict = runTime_.controlDict();
    // all ranks alike: settings
    return
        quiet_->active() && adjusts(dict)
     && time <= dict.lookupOrDefault<scalar>("maxDeltaT", GREAT)
     && time*courantRate() <= maxCo(dict);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fluidSolver::fluidSolver(Time& runTime, fvMesh& mesh)
:
    runTime_(runTime),
    mesh_(mesh),
    pimple_(mesh),
    p_
    (
        IOobject
        (
            "p",
            runTime.timeName(),
            mesh,
            IOobject::MUST_READ,
            IOobject::AUTO_WRITE
        ),
        mesh
    ),
    U_
    (
        IOobject
        (
            "U",
            runTime.timeName(),
            mesh,
            IOobject::MUST_READ,
            IOobject::AUTO_WRITE
        ),
        mesh
    ),
    phi_
    (
        IOobject
        (
            "phi",
            runTime.timeName(),
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        ),
        fvc::flux(evaluateCoupled(U_))
    ),
    transport_(U_, phi_),
    turbulenceN_
    (
        scratch<scalar>(mesh, "fluidFraction", dimless)
    ),
    turbulenceFlux_(IOobject("phi", runTime.timeName(), mesh), phi_),
    turbulence_
    (
        fluidTurbulence::New
        (
            turbulenceN_,
            U_,
            turbulenceFlux_,
            phi_,
            transport_
        )
    ),
    nPhi_("nPhi", phi_),
    pRefCell_(0),
    pRefValue_(0),
    correctorTolerance_
    (
        pimple_.dict().lookupOrDefault<scalar>("correctorTolerance", 0)
    ),
    correctors_(0),
    fresh_(true),
    saved_(savedNumbers(mesh)),
    faces_(mesh),
    carrying_(mesh),
    sourceFaces_(mesh.nFaces(), Zero),
    dragFaces_(mesh.nFaces(), Zero),
    nFaces_(mesh.nFaces(), 1),
    nPhiFaces_(mesh.nFaces(), Zero),
    shareFaces_(mesh.nFaces(), 1),
    mobilityFaces_(mesh.nFaces(), Zero),
    answerFaces_(mesh.nFaces(), Zero),
    slope_(mesh.nFaces(), Zero),
    yieldFaces_(mesh.nFaces(), 1),
    rDFaces_(mesh.nFaces(), 1),
    nrDFaces_(mesh.nFaces(), 1),
    inertiaFaces_(mesh.nFaces(), Zero),
    uncarried_(0),
    gradP_(scratch<vector>(mesh, "cellGradP", dimAcceleration)),
    scratch_(scratch<scalar>(mesh, "scratch", dimless)),
    stress_(scratch<scalar>(mesh, "stress", dimViscosity)),
    HbyA_(scratch<vector>(mesh, "HbyA", dimVelocity)),
    gradp_(scratch<vector>(mesh, "pressureGrad", dimAcceleration)),
    gradU_(scratch<tensor>(mesh, "velocityGrad", dimless/dimTime))
{
    checkDimensions(p_, dimPressure/dimDensity, "pressure over density");
    checkDimensions(U_, dimVelocity, "a velocity");

    const word ddtScheme(mesh_.ddtScheme("ddt(U)"));
    if (ddtScheme != "Euler")
    {
        FatalIOErrorInFunction(mesh_.schemesDict())
            << "ddtSchemes: ddt(U) " << ddtScheme << " is not supported; use"
            << " Euler" << exit(FatalIOError);
    }

    // all ranks alike: savedNumbers() is collective
    if (!saved_.empty())
    {
        nPhi_ = readFaces(mesh_, "nPhi");
        faces_.take(readFaces(mesh_, "pressureSlope")(), slope_);
    }
    // p, and what the turbulence model has read
    evaluateAllCoupled<scalar>(mesh_);
    evaluateAllCoupled<vector>(mesh_);
    setRefCell(p_, pimple_.dict(), pRefCell_, pRefValue_);
    mesh_.setFluxRequired(p_.name());
    turbulenceN_ == dimensionedScalar("one", dimless, 1);
    // made here, n of before is not overwritten in the first step: a field
    // that has none keeps its own value as the old one when it is set
    turbulenceN_.oldTime();
    turbulence_->validate();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::fluidSolver::march(particleCoupling& coupling)
{
    couplingStatistics& stats = coupling.statistics();
    stopwatch watch(stats.solving, &stats.solvingCpu);

    const scalar interval = coupling.interval();
    bool writeDue = false;

    // all ranks alike: the number of this call
    if (fresh_)
    {
        begin(coupling);
        fresh_ = false;
    }
    const vectorField before
    (
        quiet_->active()
          ? vectorField(U_.primitiveField())
          : vectorField()
    );

    if (coupling.response().active())
    {
        startSlope_ = slope_;
        faces_.take(phi_, startPhi_);
    }

    // what the particles feel is the mean over the interval
    bool several = false;
    vectorField gradP;
    scalarField slope;

    // a flow that grows within the interval gets shorter steps at once
    scalar left = interval, time = 0;
    // all ranks alike: late() and the number of steps are collective
    label n = quiet_->late() > 0 ? 1 : subSteps(left);
    // all ranks alike
    while (n > 0)
    {
        scalar dt = left/n;
        runTime_.setEndTime(GREAT);
        runTime_.setDeltaT(dt, false);
        runTime_.run();
        ++runTime_;
        if (n == 1)
        {
            // the sum of the steps, without their rounding
            runTime_.setTime(coupling.endOfInterval(), runTime_.timeIndex());
        }
        left -= dt;

        if (quiet_->late() > 0)
        {
            // one step over what was left out, too
            dt += quiet_->late();
            runTime_.setDeltaT(dt, false);
        }
        coupling.advance();
        // all ranks alike: settings, times, and what is collective itself
        if
        (
            !coupling.properties().frozenFluid()
         && n == 1 && time == 0 && !runTime_.writeTime()
         && oneStep(dt + interval)
         && quiet_->holds
            (
                U_, p_, coupling.n(), coupling.ddtN(), coupling.Sp(),
                coupling.source(), interval
            )
        )
        {
            // nothing is given: what the particles give is owed
            ++coupling.statistics().quietIntervals;
            return false;
        }
        // all ranks alike: a setting
        if (!coupling.properties().frozenFluid())
        {
            // the iterations of PIMPLE are said only when asked for
            const label level = messageStream::level;
            messageStream::level = coupling.properties().verbose() ? level : 0;
            step(coupling, min(dt, interval)/dt);
            messageStream::level = level;
            several = several || n > 1;
            if (several)
            {
                gradP.setSize(mesh_.nCells(), Zero);
                gradP += dt/interval*gradP_.primitiveField();
                slope.setSize(mesh_.nFaces(), Zero);
                slope += dt/interval*slope_;
            }
        }
        coupling.record();

        coupling.statistics().courantMax = max
        (
            coupling.statistics().courantMax,
            courantRate()*dt
        );
        time += dt;
        // all ranks alike
        n = n > 1 ? subSteps(left) : 0;
        writeDue = runTime_.writeTime() || writeDue;
    }
    // all ranks alike: the number of steps
    if (several)
    {
        gradP_.primitiveFieldRef() = gradP;
        coupling.setPressureGradient(gradP_);
        slope_ = slope;
    }
    quiet_->solved
    (
        before, U_, p_, coupling.Sp(), coupling.source(), time
    );

    return writeDue;
}


Foam::dictionary Foam::fluidSolver::settings() const
{
    dictionary dict;
    const dictionary& control = runTime_.controlDict();

    dict.add("adjustTimeStep", adjusts(control));
    dict.add("maxCo", maxCo(control));
    dict.add("maxDeltaT", "unlimited");
    for (const word& key : {"deltaT", "maxDeltaT", "writeInterval"})
    {
        const entry* e = control.findEntry(key);
        if (e)
        {
            dict.set(e->clone().ptr());
        }
    }
    dict.add("turbulence", turbulence_->type());
    dict.add("nCorrectors", pimple_.nCorrPISO());
    dict.add("correctorTolerance", correctorTolerance_);
    dict.add("correctors", correctors_);

    return dict;
}
