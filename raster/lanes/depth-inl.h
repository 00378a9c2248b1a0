// The depth codes that tiles store, for each depth format.

#if defined(GLASSBOX_DEPTH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_DEPTH_INL_H_
#undef GLASSBOX_DEPTH_INL_H_
#else
#define GLASSBOX_DEPTH_INL_H_
#endif

#include <glassbox/raster/depth.h>
#include <glassbox/raster/lanes/formulas-inl.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

struct FloatCode {
  explicit FloatCode(DepthFormat) {}
  HWY_INLINE Ints operator()(Floats depth) const { return float_depth_code(depth); }
};

struct ReversedCode {
  explicit ReversedCode(DepthFormat) {}
  HWY_INLINE Ints operator()(Floats depth) const { return reversed_depth_code(depth); }
};

struct UnormCode {
  explicit UnormCode(DepthFormat format) : steps(unorm_depth_steps(format)) {}
  HWY_INLINE Ints operator()(Floats depth) const { return unorm_depth_code(depth, steps); }
  double steps;
};

// Calls `work` with the code type of the format.
template <class Work>
HWY_INLINE void with_code(DepthFormat format, const Work& work) {
  switch (format) {
    case DepthFormat::kFloat32:
      return work(FloatCode(format));
    case DepthFormat::kFloat32Reversed:
      return work(ReversedCode(format));
    case DepthFormat::kUnorm24:
    case DepthFormat::kUnorm16:
      return work(UnormCode(format));
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
