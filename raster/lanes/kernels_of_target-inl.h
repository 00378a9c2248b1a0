// The body of a function that returns the `kKernels` that were compiled for `target`. It is
// included between the function's braces.
#if HWY_ARCH_X86
static_assert((HWY_TARGETS & ~(HWY_AVX3 | HWY_AVX2 | HWY_SSE4 | HWY_SCALAR)) == 0,
              "compiled for an instruction set that is never asked for: "
              "raster/lanes/compiled_targets.h");
#endif
switch (target) {
#if (GLASSBOX_LANES & HWY_AVX3) != 0
  case Target::kAvx512:
    return N_AVX3::kKernels;
#endif
#if (GLASSBOX_LANES & HWY_AVX2) != 0
  case Target::kAvx2:
    return N_AVX2::kKernels;
#endif
#if (GLASSBOX_LANES & HWY_SSE4) != 0
  case Target::kSse4:
    return N_SSE4::kKernels;
#endif
#if (GLASSBOX_LANES & HWY_NEON) != 0
  case Target::kNeon:
    return N_NEON::kKernels;
#endif
  default:
    return N_SCALAR::kKernels;
}
