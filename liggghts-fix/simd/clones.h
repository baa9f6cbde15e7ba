// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file clones.h
/// A function in front of which CLAY_CLONES stands is compiled for several
/// generations of processors; which one is taken is settled when the program starts.
/// What it calls in its loops has to be CLAY_INLINE, to become part of each.
/// Where the generations need loops of their own, a static function of one name stands
/// there three times, with CLAY_FOR_WIDEST (registers of 64 bytes), CLAY_FOR_WIDE (32)
/// and CLAY_FOR_ANY (16) in front, if CLAY_GENERATIONS is defined, else with none.
#pragma once

#if defined(CLAY_ONE_CLONE)
// one and the same everywhere, for counting instructions
#define CLAY_CLONES
#elif defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#if __GNUC__ >= 12
#define CLAY_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#define CLAY_FOR_WIDEST __attribute__((target("arch=x86-64-v4")))
#define CLAY_FOR_WIDE __attribute__((target("arch=x86-64-v3")))
#else
#define CLAY_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#define CLAY_FOR_WIDEST __attribute__((target("avx512f")))
#define CLAY_FOR_WIDE __attribute__((target("avx2,fma")))
#endif
#define CLAY_FOR_ANY __attribute__((target("default")))
#define CLAY_GENERATIONS
#else
#define CLAY_CLONES
#endif

#ifdef __GNUC__
#define CLAY_INLINE inline __attribute__((always_inline))
#else
#define CLAY_INLINE inline
#endif
