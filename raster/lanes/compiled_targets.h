// Which instruction sets Highway compiles the lanes for: include this before anything of Highway's. Plain C++ is among
// them, so that it can be compared with the others.
//
// A source is compiled for all of them at once, or for GLASSBOX_ONE_TARGET alone (raster/CMakeLists.txt).
#pragma once

#include <glassbox/base/little_endian.h>  // lanes take a colour's four bytes for one number

// Plain C++ is one lane at a time with every compiler. Highway's other way, arrays of 16 bytes,
// takes longest of all to compile.
#define HWY_BROKEN_EMU128 1

#ifdef GLASSBOX_ONE_TARGET
#define HWY_BASELINE_TARGETS GLASSBOX_ONE_TARGET
#define HWY_COMPILE_ONLY_STATIC
#else
#define HWY_COMPILE_ALL_ATTAINABLE
// Highway numbers the instruction sets of x86 by the lowest 15 bits. Three of them are compiled,
// one for each width of vectors; Highway 1.1 and later know others that are no wider (SSE2, those
// of Zen 4 and Sapphire Rapids), each of which would take as long to compile.
#define GLASSBOX_LEFT_OUT \
  ((0x7fffLL & ~(HWY_SSE4 | HWY_AVX2 | HWY_AVX3)) | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#ifdef GLASSBOX_FEW_TARGETS  // plain C++ and one other, whose source is that of all
#define HWY_DISABLED_TARGETS (GLASSBOX_LEFT_OUT | HWY_SSE4 | HWY_AVX3)
#else
#define HWY_DISABLED_TARGETS GLASSBOX_LEFT_OUT
#endif
#endif

// Those of the lanes, in what chooses among them: all that are compiled at once, unless it was
// told which are.
#ifndef GLASSBOX_LANES
#define GLASSBOX_LANES HWY_TARGETS
#endif
