// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
// OpenFOAM's library reads its etc/controlDict while it is being loaded, from
// the folder that WM_PROJECT_DIR names. Without that variable, as a packaged
// OpenFOAM leaves it, the program starts itself anew with it, before any
// library's own start-up code.

#include <climits>
#include <cstring>

#include <alloca.h>
#include <unistd.h>

extern "C"
{

static void provideProjectDir(int, char** argv, char** env)
{
    static char projectDir[] = "WM_PROJECT_DIR=" CLAYFOAM_OPENFOAM_DIR;
    const size_t name = std::strlen("WM_PROJECT_DIR=");

    size_t n = 0;
    for (; env[n]; ++n)
    {
        if (std::strncmp(env[n], projectDir, name) == 0)
        {
            return;
        }
    }

    char** more = static_cast<char**>(alloca((n + 2)*sizeof(char*)));
    std::memcpy(more, env, n*sizeof(char*));
    more[n] = projectDir;
    more[n + 1] = nullptr;

    char program[PATH_MAX];
    const ssize_t length =
        readlink("/proc/self/exe", program, sizeof(program) - 1);
    if (length > 0)
    {
        program[length] = '\0';
        execve(program, argv, more);
    }
}

__attribute__((section(".preinit_array"), used))
static void (*const beforeLibraries)(int, char**, char**) = provideProjectDir;

}
