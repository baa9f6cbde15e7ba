// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Description
    Runs the tests, on one rank or on all ranks of an mpirun. Fatal errors
    become exceptions.

\*---------------------------------------------------------------------------*/

#include "Pstream.H"
#include "error.H"

#include <gtest/gtest.h>

#include <cstdlib>

int main(int argc, char* argv[])
{
    const char* ranks = getenv("OMPI_COMM_WORLD_SIZE");
    if (!ranks)
    {
        ranks = getenv("PMI_SIZE");
    }
    const bool parallel = ranks && atoi(ranks) > 1;

    if (parallel)
    {
        Foam::UPstream::init(argc, argv, false);
    }

    Foam::FatalError.throwExceptions();
    Foam::FatalIOError.throwExceptions();

    testing::InitGoogleTest(&argc, argv);
    const int result = RUN_ALL_TESTS();

    if (parallel)
    {
        Foam::UPstream::exit(result);
    }
    return result;
}
