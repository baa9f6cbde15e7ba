// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file clones.h
/// A function in front of which CLAY_CLONES stands is compiled for several
/// generations of processors; which one is taken is settled when the program starts.
/// What it calls in its loops has to be CLAY_INLINE, to become part of each.
#pragma once

#if defined(CLAY_ONE_CLONE)
// one and the same everywhere, for counting instructions
#define CLAY_CLONES
#elif defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#if __GNUC__ >= 12
#define CLAY_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define CLAY_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#endif
#else
#define CLAY_CLONES
#endif

#ifdef __GNUC__
#define CLAY_INLINE inline __attribute__((always_inline))
#else
#define CLAY_INLINE inline
#endif
