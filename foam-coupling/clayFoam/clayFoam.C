// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Application
    clayFoam

Description
    The CFD half of a coupled run: the volume-averaged equations of an
    incompressible fluid with particles, beside a DEM half in the same mpirun:

        mpirun -np 1 liggghts-clay -in in.liggghts : -np 1 clayFoam -case CFD

    Several ranks of this half need a case decomposed by decomposePar; the
    option -parallel is set by the program itself.
\*---------------------------------------------------------------------------*/

#include "caseInput.H"
#include "fluidSolver.H"
#include "runClock.H"
#include "startUp.H"

#include "exchange/world.h"

// what the wrappers of MPI split the world by
const clay::Half clay::programHalf = clay::Half::cfd;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{

//- Marches with the DEM half until the coupled run is over; collective
static void march(const argList& args)
{
    checkDecomposition(args);
    runClock runTime(controls(args), args.rootPath(), args.caseName());
    fvMesh mesh
    (
        IOobject
        (
            fvMesh::defaultRegion,
            runTime.timeName(),
            runTime,
            IOobject::MUST_READ
        )
    );

    runTime.resume(mesh);
    checkInput(mesh);
    fluidSolver fluid(runTime, mesh);
    particleCoupling coupling(fluid.U(), fluid.p(), fluid.transport());
    couplingStatistics& stats = coupling.statistics();

    sayUnread(mesh, fluid.transport(), fluid.turbulence(), stats);
    setSolverOutput(coupling.properties().verbose());

    // written once the particles have said what they received up to that time
    bool due = false, written = true;
    const auto write = [&]()
    {
        stopwatch watch(stats.output);
        runTime.writeNow();
        due = false;
        written = true;
    };

    noteStops();

    // all ranks alike: they hear the same
    while (coupling.next())
    {
        if (due)
        {
            write();
        }
        due = fluid.march(coupling);
        coupling.askStop(notedStop());
        coupling.solved();
        written = false;
    }

    if (!written)
    {
        write();
    }
    runTime.setEndTime(runTime.value());
    runTime.run();

    coupling.writeStatistics(fluid.settings());
    Info<< "clayFoam: end at time " << runTime.value() << " s, "
        << stats.exchanges << " exchanges, " << stats.steps
        << " fluid steps, largest momentum residual "
        << stats.momentumResidual << endl;
}

} // End namespace Foam


int main(int argc, char* argv[])
{
    Foam::startUp start(argc, argv);

    return start.guard([&]() { Foam::march(start.args()); });
}
