// Which instruction sets Highway compiles the lanes for: include this before anything of Highway's. Plain C++ is among
// them, so that it can be compared with the others.
#pragma once

#include <glassbox/base/little_endian.h>  // lanes take a colour's four bytes for one number

#define HWY_COMPILE_ALL_ATTAINABLE
#ifdef GLASSBOX_FEW_TARGETS  // plain C++ and one other, whose source is that of all
#define HWY_DISABLED_TARGETS \
  (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#else
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#endif
