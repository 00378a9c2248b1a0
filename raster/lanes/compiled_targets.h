// Which instruction sets Highway compiles the lanes for: include this before anything of Highway's. Plain C++ is among
// them, so that it can be compared with the others.
#pragma once

#define HWY_COMPILE_ALL_ATTAINABLE
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
