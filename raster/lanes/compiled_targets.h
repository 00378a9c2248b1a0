// Which instruction sets Highway compiles the lanes for: include this before anything of Highway's. Plain C++ is among
// them, so that it can be compared with the others.
//
// A source is compiled for all of them at once, or for GLASSBOX_ONE_TARGET (raster/CMakeLists.txt), which takes a part of
// the time and as much in all.
#pragma once

// Plain C++ is one lane at a time with every compiler; Highway's other way, arrays of 16 bytes, takes g++ longest of all.
#define HWY_BROKEN_EMU128 1

#ifdef GLASSBOX_ONE_TARGET
#define HWY_BASELINE_TARGETS GLASSBOX_ONE_TARGET
#define HWY_COMPILE_ONLY_STATIC
#else
#define HWY_COMPILE_ALL_ATTAINABLE
#ifdef GLASSBOX_NEWER_HIGHWAY  // has these, too: no lanes are compiled for them
#define GLASSBOX_NEWER_TARGETS \
  (HWY_SSE2 | HWY_AVX3_DL | HWY_AVX3_ZEN4 | HWY_AVX3_SPR | HWY_NEON_WITHOUT_AES | HWY_NEON_BF16)
#else
#define GLASSBOX_NEWER_TARGETS 0
#endif
#ifdef GLASSBOX_FEW_TARGETS  // plain C++ and one other, whose source is that of all
#define HWY_DISABLED_TARGETS                                                         \
  (GLASSBOX_NEWER_TARGETS | HWY_SSSE3 | HWY_SSE4 | HWY_AVX3 | HWY_SVE | HWY_SVE2 | \
   HWY_SVE_256 | HWY_SVE2_128)
#else
#define HWY_DISABLED_TARGETS \
  (GLASSBOX_NEWER_TARGETS | HWY_SSSE3 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#endif
#endif

// Those of the lanes, in what chooses among them: all that are compiled at once, unless it was told which are.
#ifndef GLASSBOX_LANES
#define GLASSBOX_LANES HWY_TARGETS
#endif
