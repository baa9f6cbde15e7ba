// This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
/// \file clones.h
/// A function in front of which CLAY_CLONES stands is compiled for several
/// generations of processors; which one is taken is settled when the program starts.
/// What it calls in its loops has to be CLAY_INLINE, to become part of each.
/// Where the generations need loops of their own, a static function of one name stands
/// there three times, with CLAY_FOR_WIDEST (registers of 64 bytes), CLAY_FOR_WIDE (32)
/// and CLAY_FOR_ANY (16) in front, if CLAY_GENERATIONS is defined, else once, with
/// CLAY_CLONES, for registers of CLAY_BYTES.
#pragma once

#if defined(CLAY_ONE_CLONE)
// one and the same everywhere, for counting instructions
#define CLAY_CLONES
#elif defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#if __GNUC__ >= 12
#define CLAY_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#define CLAY_WIDEST_NEEDS "x86-64-v4"
#define CLAY_WIDE_NEEDS "x86-64-v3"
#define CLAY_FOR_WIDEST __attribute__((target("arch=x86-64-v4")))
#define CLAY_FOR_WIDE __attribute__((target("arch=x86-64-v3")))
#else
#define CLAY_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#define CLAY_WIDEST_NEEDS "avx512f"
#define CLAY_WIDE_NEEDS "avx2"
#define CLAY_FOR_WIDEST __attribute__((target("avx512f")))
#define CLAY_FOR_WIDE __attribute__((target("avx2,fma")))
#endif
#define CLAY_FOR_ANY __attribute__((target("default")))
#if !defined(CLAY_ONLY_BYTES)
#define CLAY_GENERATIONS
#else
// one generation alone, named by the bytes of its registers, to be tested
#undef CLAY_CLONES
#if CLAY_ONLY_BYTES == 64
#define CLAY_CLONES CLAY_FOR_WIDEST
#elif CLAY_ONLY_BYTES == 32
#define CLAY_CLONES CLAY_FOR_WIDE
#else
#define CLAY_CLONES
#endif
#define CLAY_BYTES CLAY_ONLY_BYTES
#endif
#else
#define CLAY_CLONES
#endif

#if !defined(CLAY_BYTES)
#define CLAY_BYTES 16
#endif

#ifdef __GNUC__
#define CLAY_INLINE inline __attribute__((always_inline))
#else
#define CLAY_INLINE inline
#endif
