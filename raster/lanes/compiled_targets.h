// The instruction sets for which Highway compiles the lanes (vectorised code). Include this before
// any header of Highway. Plain C++ is one of them, so that its results can be compared with those
// of the others.
//
// A source is compiled for all of them at once, or for GLASSBOX_ONE_TARGET alone
// (raster/CMakeLists.txt).
#pragma once

#include <glassbox/base/little_endian.h>  // lanes treat a colour's four bytes as one number

// Plain C++ uses vectors of one lane with every compiler. Highway's other form of it, arrays of 16
// bytes, takes longer to compile than any instruction set.
#define HWY_BROKEN_EMU128 1

#ifdef GLASSBOX_ONE_TARGET
#define HWY_BASELINE_TARGETS GLASSBOX_ONE_TARGET
#define HWY_COMPILE_ONLY_STATIC
#else
#define HWY_COMPILE_ALL_ATTAINABLE
// Highway numbers the instruction sets of x86 by the lowest 15 bits. Three of them are compiled,
// one for each width of vectors. Highway 1.1 and later have others that are no wider (SSE2, those
// of Zen 4 and Sapphire Rapids), each of which would take as long to compile as one of the three.
#define GLASSBOX_LEFT_OUT \
  ((0x7fffLL & ~(HWY_SSE4 | HWY_AVX2 | HWY_AVX3)) | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
// With few targets, only plain C++ and one instruction set are left (on x86: AVX2).
#ifdef GLASSBOX_FEW_TARGETS
#define HWY_DISABLED_TARGETS (GLASSBOX_LEFT_OUT | HWY_SSE4 | HWY_AVX3)
#else
#define HWY_DISABLED_TARGETS GLASSBOX_LEFT_OUT
#endif
#endif

// The instruction sets of the lanes, for the code that chooses among them. By default these are all
// sets that one compilation of a source produces; a build that compiles each set alone lists them.
#ifndef GLASSBOX_LANES
#define GLASSBOX_LANES HWY_TARGETS
#endif
