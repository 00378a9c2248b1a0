// Depth at the pixels, and its codes as tiles keep them: depth.h over lanes.

#if defined(GLASSBOX_DEPTH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_DEPTH_INL_H_
#undef GLASSBOX_DEPTH_INL_H_
#else
#define GLASSBOX_DEPTH_INL_H_
#endif

#include <glassbox/raster/depth.h>
#include <glassbox/raster/lanes/lanes-inl.h>
#include <glassbox/raster/lanes/tile_buffer.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

HWY_INLINE VF clamped(VF z) {
  const VF at_most_one = hn::IfThenElse(hn::Lt(z, set(1.0f)), z, set(1.0f));
  return hn::IfThenElseZero(hn::Gt(z, hn::Zero(kF)), at_most_one);
}

struct FloatCode {
  explicit FloatCode(DepthFormat) {}
  HWY_INLINE VI operator()(VF z) const { return hn::BitCast(kI, clamped(z)); }
};

struct ReversedCode {
  explicit ReversedCode(DepthFormat) {}
  HWY_INLINE VI operator()(VF z) const {
    return hn::Sub(hn::BitCast(kI, set(1.0f)), hn::BitCast(kI, clamped(z)));
  }
};

struct UnormCode {
  explicit UnormCode(DepthFormat format)
      : steps(format == DepthFormat::kUnorm24 ? 0xffffff : 0xffff) {}
  double steps;

  HWY_INLINE VI operator()(VF z) const {
    const Doubles code = each_half(
        [this](VD v) HWY_ATTR {
          return hn::Floor(hn::Add(hn::Mul(v, hn::Set(kD, steps)), hn::Set(kD, 0.5)));
        },
        promote(clamped(z)));
    return hn::ConvertTo(kI, round_to_float(code));  // integers below 2^24: floats hold them
  }
};

// Calls work with the code of the format.
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

// d0 + (lambda_1 (d1 - d0) + lambda_2 (d2 - d0))
HWY_INLINE VF depth_at(VF d0, VF d1_less_d0, VF d2_less_d0, VF lambda1, VF lambda2) {
  return hn::Add(d0, hn::Add(hn::Mul(lambda1, d1_less_d0), hn::Mul(lambda2, d2_less_d0)));
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
