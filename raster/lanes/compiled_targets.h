// Which instruction sets Highway compiles the lanes for: include this before anything of Highway's. Plain C++ is among
// them, so that it can be compared with the others.
#pragma once

#define HWY_COMPILE_ALL_ATTAINABLE
// Highway numbers the instruction sets of x86 by the lowest 15 bits. Three of them are compiled, one for each width of vectors; Highway 1.1
// and later know others that are no wider (SSE2, those of Zen 4 and Sapphire Rapids), each of which would take as long to compile.
#define GLASSBOX_LEFT_OUT \
  ((0x7fffLL & ~(HWY_SSE4 | HWY_AVX2 | HWY_AVX3)) | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#ifdef GLASSBOX_FEW_TARGETS  // plain C++ and one other, whose source is that of all
#define HWY_DISABLED_TARGETS (GLASSBOX_LEFT_OUT | HWY_SSE4 | HWY_AVX3)
#else
#define HWY_DISABLED_TARGETS GLASSBOX_LEFT_OUT
#endif
