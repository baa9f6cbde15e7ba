// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "caseInput.H"

#include "IFstream.H"
#include "IOobjectList.H"
#include "OSspecific.H"
#include "Time.H"
#include "couplingProperties.H"
#include "primitiveEntry.H"
#include "savedState.H"

#include <map>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- A dictionary of constant/, empty when there is none
static dictionary constantFile(const fvMesh& mesh, const word& name)
{
    const fileName file
    (
        mesh.time().globalPath()/mesh.time().constant()/name
    );
    IFstream is(file);
    return isFile(file) ? dictionary(is) : dictionary();
}


//- Refuses a file of constant/ in which some dictionary is active
static void refuseActive
(
    const fvMesh& mesh,
    const word& name,
    const char* what
)
{
    const dictionary dict(constantFile(mesh, name));
    for (const entry& e : dict)
    {
        if
        (
            e.isDict() && e.keyword() != "FoamFile"
         && e.dict().lookupOrDefault<bool>("active", true)
        )
        {
            FatalErrorInFunction
                << "constant/" << name << ": " << e.keyword() << ": " << what
                << " not computed; take it out, or set active no"
                << exit(FatalError);
        }
    }
}


//- Has nobody looked up that entry? Looking up leaves its stream at the end
static bool unread(const entry& e)
{
    const auto* stream = dynamic_cast<const ITstream*>(&e);
    return stream && stream->size() && stream->tokenIndex() == 0;
}


//- Words that differ by one or two letters
static bool alike(const word& a, const word& b)
{
    return a != b && letterChanges(a, b) <= 2;
}


static const wordList pimpleEntries
({
    "nOuterCorrectors", "nCorrectors", "nNonOrthogonalCorrectors",
    "momentumPredictor", "turbOnFinalIterOnly", "finalOnLastPimpleIterOnly",
    "residualControl", "outerCorrectorResidualControl", "pRefCell",
    "pRefPoint", "pRefValue", "correctorTolerance"
});

//- Read by OpenFOAM or this program, if at all; others may be a user's own
static const wordList controlEntries
({
    "startFrom", "startTime", "stopAt", "endTime", "deltaT", "writeControl",
    "writeInterval", "purgeWrite", "writeFormat", "writePrecision",
    "writeCompression", "timeFormat", "timePrecision", "runTimeModifiable",
    "adjustTimeStep", "maxCo", "maxDeltaT", "functions", "libs"
});

//- What each model of viscosity reads of its coefficients
static const std::map<word, wordList> viscosityCoeffs
({
    {"Newtonian", {"nu"}},
    {"HerschelBulkley", {"nu0", "tau0", "k", "n"}},
    {"powerLaw", {"k", "n", "nuMin", "nuMax"}},
    {"CrossPowerLaw", {"nu0", "nuInf", "m", "n"}},
    {"BirdCarreau", {"nu0", "nuInf", "k", "n", "a"}},
    {"Casson", {"m", "tau0", "nuMin", "nuMax"}},
    {"strainRateFunction", {"function"}}
});

//- Properties that other solvers read; other entries may be a user's own
static const wordList fluidProperties
({
    "nu", "mu", "sigma", "phases", "beta", "TRef", "Pr", "Prt", "DT", "Cp",
    "Cv", "kappa", "lambda", "pSat"
});

//- Files that OpenFOAM or this program reads from constant/
static const wordList constantFiles
({
    "g", "couplingProperties", "transportProperties", "turbulenceProperties",
    "fvOptions", "MRFProperties", "SRFProperties", "dynamicMeshDict",
    "porosityProperties", "cfg"
});

//- Says what of the fluid's properties nobody reads
static void sayUnreadTransport
(
    const dictionary& transport,
    couplingStatistics& stats
)
{
    const word model
    (
        transport.lookupOrDefault<word>("transportModel", "Newtonian")
    );
    const word coeffs(model + "Coeffs");
    const wordList& own = viscosityCoeffs.at(model);
    const bool apart = transport.isDict(coeffs);
    // without a dictionary of their own coefficients stand beside the rest
    wordList known({"FoamFile", "transportModel", "rho", coeffs});
    if (!apart)
    {
        known.append(own);
    }
    const word file("constant/transportProperties: ");

    for (const entry& e : transport)
    {
        const word& key = e.keyword();
        if (known.found(key))
        {
            continue;
        }
        if (e.isDict() && key.endsWith("Coeffs"))
        {
            stats.warn
            (
                file + key + " is not read: transportModel is " + model
            );
        }
        else if (fluidProperties.found(key))
        {
            stats.warn
            (
                file + key + " is not read"
              + (apart ? "; " + coeffs + " is" : std::string())
            );
        }
    }
    if (!apart)
    {
        return;
    }
    for (const entry& e : transport.subDict(coeffs))
    {
        const word& key = e.keyword();
        if (!own.found(key))
        {
            stats.warn
            (
                file + coeffs + ": " + key + " is not read; the nearest entry"
                " that is: " + nearestWord(key, own)
            );
        }
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Other Functions * * * * * * * * * * * * * * //

Foam::dictionary Foam::controls(const argList& args)
{
    const fileName file
    (
        args.rootPath()/args.globalCaseName()/"system"/Time::controlDictName
    );
    IFstream is(file);
    dictionary dict(is);

    if
    (
        !dict.found("endTime")
     && dict.lookupOrDefault<word>("stopAt", "endTime") == "endTime"
    )
    {
        dict.remove("stopAt");
    }
    return dict;
}


void Foam::checkDecomposition(const argList& args)
{
    if (!Pstream::parRun())
    {
        return;
    }
    const fileName path(args.rootPath()/args.globalCaseName());
    const label ranks = Pstream::nProcs();
    if (isDir(path/"processors" + Foam::name(ranks)))
    {
        return;
    }
    const bool first = isDir(path/"processor0");
    const bool enough = isDir(path/"processor" + Foam::name(ranks - 1));
    const bool more = isDir(path/"processor" + Foam::name(ranks));
    if (enough && !more)
    {
        return;
    }
    FatalErrorInFunction
        << "the case is "
        << (first ? "decomposed for another number of ranks" : "not decomposed")
        << ", the CFD half has " << ranks << "; set numberOfSubdomains "
        << ranks << " in system/decomposeParDict and run decomposePar -force"
        << " -case " << path.name() << ", or start it on one rank"
        << exit(FatalError);
}


void Foam::checkInput(const fvMesh& mesh)
{
    refuseActive(mesh, "MRFProperties", "rotating zones are");
    refuseActive(mesh, "porosityProperties", "porous zones are");
    if (constantFile(mesh, "SRFProperties").size())
    {
        FatalErrorInFunction
            << "constant/SRFProperties: rotating frames are not computed; take"
            << " it out" << exit(FatalError);
    }
    const word moving
    (
        constantFile(mesh, "dynamicMeshDict").lookupOrDefault<word>
        (
            "dynamicFvMesh",
            "staticFvMesh"
        )
    );
    if (moving != "staticFvMesh")
    {
        FatalErrorInFunction
            << "constant/dynamicMeshDict: dynamicFvMesh " << moving << ": the"
            << " mesh does not move here; take it out, or name staticFvMesh"
            << exit(FatalError);
    }

    const dictionary& solution = mesh.solutionDict();
    for (const word algorithm : {"PISO", "SIMPLE"})
    {
        if (solution.found(algorithm) && !solution.found("PIMPLE"))
        {
            FatalIOErrorInFunction(solution)
                << algorithm << " is not read: the solver's dictionary is"
                << " PIMPLE; rename it (nOuterCorrectors 1 makes it PISO)"
                << exit(FatalIOError);
        }
    }
    const dictionary solvers(solution.subOrEmptyDict("solvers"));
    for (const word field : {"p", "pFinal", "U", "UFinal"})
    {
        if (!solvers.found(field, keyType::REGEX))
        {
            const word without(field.substr(0, 1));
            FatalIOErrorInFunction(solution)
                << "solvers has no " << field << "; add "
                << (
                       field == without
                     ? field + " { ... }, as for pimpleFoam"
                     : field + " { $" + without + "; relTol 0; }"
                   ).c_str()
                << exit(FatalIOError);
        }
    }
}


void Foam::sayUnread
(
    const fvMesh& mesh,
    const dictionary& transport,
    const word& turbulence,
    couplingStatistics& stats
)
{
    const Time& runTime = mesh.time();

    const dictionary& solution = mesh.solutionDict();
    for (const entry& e : solution.subOrEmptyDict("PIMPLE"))
    {
        if (!pimpleEntries.found(e.keyword()))
        {
            stats.warn
            (
                "system/fvSolution: PIMPLE: " + e.keyword() + " is not read;"
                " the nearest entry that is: "
              + nearestWord(e.keyword(), pimpleEntries)
            );
        }
    }
    for (const word algorithm : {"PISO", "SIMPLE"})
    {
        if (solution.found(algorithm))
        {
            stats.warn
            (
                "system/fvSolution: " + algorithm + " is not read, PIMPLE is"
            );
        }
    }

    for (const entry& e : runTime.controlDict())
    {
        const word& key = e.keyword();
        const word nearest(nearestWord(key, controlEntries));
        if (unread(e) && !controlEntries.found(key) && alike(key, nearest))
        {
            stats.warn
            (
                "system/controlDict: " + key + " is not read; " + nearest
              + " is"
            );
        }
    }

    sayUnreadTransport(transport, stats);

    const dictionary flow(constantFile(mesh, "turbulenceProperties"));
    const word kind(flow.lookupOrDefault<word>("simulationType", "laminar"));
    for (const entry& e : flow)
    {
        const word& key = e.keyword();
        if (e.isDict() && key != "FoamFile" && key != kind)
        {
            stats.warn
            (
                "constant/turbulenceProperties: " + key + " is not read:"
                " simulationType is " + kind
            );
        }
    }

    // what a step of given length has no use for
    const bool adjusts =
        runTime.controlDict().lookupOrDefault<Switch>("adjustTimeStep", true);
    for (const word key : {"maxCo", "maxDeltaT"})
    {
        if (!adjusts && runTime.controlDict().found(key))
        {
            stats.warn
            (
                "system/controlDict: " + key + " is not read: adjustTimeStep"
                " is no"
            );
        }
    }
    const word stopAt
    (
        runTime.controlDict().lookupOrDefault<word>("stopAt", "endTime")
    );
    if (stopAt != "endTime")
    {
        stats.warn
        (
            "system/controlDict: stopAt " + stopAt + " is not followed: the"
            " DEM half says when the run ends"
        );
    }

    // files that belong into the other folder
    for (const word& file : constantFiles)
    {
        if
        (
            file != "fvOptions" && file != "cfg"
         && isFile(runTime.globalPath()/runTime.system()/file)
        )
        {
            stats.warn
            (
                "system/" + file + " is not read, constant/" + file + " is"
            );
        }
    }

    // each rank has the case's constant/
    for
    (
        const fileName& file
      : readDir(runTime.globalPath()/runTime.constant(), fileName::FILE)
    )
    {
        if (!constantFiles.found(file) && !file.hasExt())
        {
            stats.warn("constant/" + file + " is not read");
        }
    }

    // fields that a model which is not chosen would read
    if (!isSavedState(mesh))
    {
        wordList fields
        (
            IOobjectList(mesh, runTime.timeName()).sortedNames()
        );
        Pstream::scatter(fields);
        for (const word& field : fields)
        {
            if
            (
                !mesh.foundObject<regIOobject>(field)
             && field != "voidfraction" && field != "couplingImpulse"
             && !field.endsWith("_0")
            )
            {
                stats.warn
                (
                    runTime.timeName() + "/" + field + " is not read"
                  + (turbulence == "Stokes" ? " (the flow is laminar)" : "")
                );
            }
        }
    }
}


// ************************************************************************* //
