#include <glassbox/raster/lanes/compiled_targets.h>
#include <glassbox/raster/lanes/kernels.h>

#include <hwy/detect_targets.h>

namespace glassbox {

// kernels.cpp defines these constants, one for each instruction set that it is compiled for.
#if (GLASSBOX_LANES & HWY_AVX3) != 0
namespace N_AVX3 {
extern const Kernels kKernels;
}
#endif
#if (GLASSBOX_LANES & HWY_AVX2) != 0
namespace N_AVX2 {
extern const Kernels kKernels;
}
#endif
#if (GLASSBOX_LANES & HWY_SSE4) != 0
namespace N_SSE4 {
extern const Kernels kKernels;
}
#endif
#if (GLASSBOX_LANES & HWY_NEON) != 0
namespace N_NEON {
extern const Kernels kKernels;
}
#endif
namespace N_SCALAR {
extern const Kernels kKernels;
}

const Kernels& kernels(Target target) {
#include <glassbox/raster/lanes/kernels_of_target-inl.h>
}

}  // namespace glassbox
