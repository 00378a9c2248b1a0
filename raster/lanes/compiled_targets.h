// Which instruction sets Highway compiles the lanes for: include this before anything of Highway's. Plain C++ is among
// them, so that it can be compared with the others. GLASSBOX_FEW_TARGETS leaves the widest and the narrowest of them to other builds.
#pragma once

#define HWY_COMPILE_ALL_ATTAINABLE
#define GLASSBOX_NEVER (HWY_SSSE3 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#ifdef GLASSBOX_FEW_TARGETS
#define HWY_DISABLED_TARGETS (GLASSBOX_NEVER | HWY_SSE4 | HWY_AVX3 | HWY_AVX3_DL)
#else
#define HWY_DISABLED_TARGETS GLASSBOX_NEVER
#endif
