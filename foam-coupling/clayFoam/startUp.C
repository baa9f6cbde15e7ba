// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later

#include "startUp.H"

#include "IOstreams.H"
#include "SolverPerformance.H"
#include "fileOperation.H"
#include "foamVersion.H"
#include "vector.H"

#include "exchange/terms.h"
#include "exchange/world.h"

#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cctype>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <thread>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Text as one line
static std::string oneLine(const std::string& text)
{
    std::string line;
    for (const char c : text)
    {
        const bool space = std::isspace(static_cast<unsigned char>(c));
        if (!space)
        {
            line += c;
        }
        else if (!line.empty() && line.back() != ' ')
        {
            line += ' ';
        }
    }
    while (!line.empty() && line.back() == ' ')
    {
        line.pop_back();
    }
    return line;
}


static volatile std::sig_atomic_t stopSignal = 0;

extern "C" void noteStop(int signal)
{
    if (stopSignal)
    {
        ::_exit(128 + signal);
    }
    stopSignal = signal;
}


//- Ends OpenFOAM's access to files while there is MPI: a handler (collated)
//  gives back its communicator. Taken by nullptr where a version allows it
template<class None>
static auto endFiles(int) -> decltype(fileHandler(None()), void())
{
    fileHandler(None());
}

template<class None>
static void endFiles(long)
{
    autoPtr<fileOperation> none;
    fileHandler(none);
}


//- Ends both halves. The first rank speaks for an error that all ranks have
[[noreturn]] static void endBoth(const std::string& reason)
{
    if (clay::World::instance().rank() > 0)
    {
        std::this_thread::sleep_for(std::chrono::seconds(1));
    }
    clay::abandon(oneLine(reason));
}

} // End namespace Foam


void Foam::setSolverOutput(const bool on)
{
    SolverPerformance<scalar>::debug = on;
    SolverPerformance<vector>::debug = on;
}


void Foam::noteStops()
{
    for (const int signal : {SIGINT, SIGTERM, SIGUSR1})
    {
        std::signal(signal, noteStop);
    }
    // but nohup means what it says
    if (std::signal(SIGHUP, noteStop) == SIG_IGN)
    {
        std::signal(SIGHUP, SIG_IGN);
    }
}


int Foam::notedStop()
{
    return stopSignal;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::startUp::readArguments()
{
    if (foamVersion::api != OPENFOAM)
    {
        throw std::runtime_error
        (
            "refused: built for OpenFOAM v" + std::to_string(OPENFOAM)
          + ", but the library that runs is v"
          + std::to_string(foamVersion::api)
        );
    }

    FatalError.throwExceptions();
    FatalIOError.throwExceptions();

    argList::addNote
    (
        "The CFD half of a coupled run; see mpirun -np 1 liggghts-clay ... :"
        " -np 1 clayFoam -case CFD"
    );
    argList::noCheckProcessorDirectories();
    args_ = new argList(argc_, argvPtr_);

    if (!args_->checkRootCase())
    {
        throw std::runtime_error
        (
            "refused: no case at " + std::string(args_->path())
        );
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::startUp::startUp(int argc, char** argv)
:
    argc_(0),
    argvPtr_(nullptr),
    args_(nullptr)
{
    // the fields of a step are given back to this program, not to the system
    ::mallopt(M_MMAP_THRESHOLD, 32 << 20);
    ::mallopt(M_TRIM_THRESHOLD, 256 << 20);
    ::mallopt(M_TOP_PAD, 4 << 20);

    // a number that is none is found and named (particleCoupling), not trapped
    ::setenv("FOAM_SIGFPE", "false", 0);

    clay::World::init(argc, argv);

    words_.assign(argv, argv + argc);
    const auto parallel = std::find(words_.begin(), words_.end(), "-parallel");
    if (clay::World::instance().size() > 1)
    {
        if (parallel == words_.end())
        {
            words_.push_back("-parallel");
        }
    }
    else if (parallel != words_.end())
    {
        words_.erase(parallel);
    }

    for (std::string& word : words_)
    {
        argv_.push_back(&word[0]);
    }
    argc_ = int(argv_.size());
    argv_.push_back(nullptr);
    argvPtr_ = argv_.data();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

int Foam::startUp::guard(const std::function<void()>& run)
{
    int status = 0;
    try
    {
        readArguments();
        run();
    }
    catch (const clay::Refusal& refusal)
    {
        if (clay::World::instance().rank() == 0)
        {
            std::cerr
                << "clayFoam: refused: " << oneLine(refusal.what())
                << std::endl;
        }
        status = 1;
    }
    catch (const Foam::IOerror& error)
    {
        endBoth
        (
            "refused: " + error.message() + " ["
          + fileName(error.ioFileName()).name() + "]"
        );
    }
    catch (const Foam::error& error)
    {
        endBoth(error.message());
    }
    catch (const std::exception& error)
    {
        endBoth(error.what());
    }

    endFiles<std::nullptr_t>(0);
    MPI_Finalize();
    return status;
}
