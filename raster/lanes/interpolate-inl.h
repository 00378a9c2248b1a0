// Perspective-correct weights, and attributes at the pixels: interpolate.h over lanes.

#if defined(GLASSBOX_INTERPOLATE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_INTERPOLATE_INL_H_
#undef GLASSBOX_INTERPOLATE_INL_H_
#else
#define GLASSBOX_INTERPOLATE_INL_H_
#endif

#include <glassbox/raster/lanes/blocks-inl.h>
#include <glassbox/raster/lanes/setup-inl.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

// What a Fragment has of use for shading.
struct FragmentLanes {
  VF weight1, weight2;
  VF inverse_w;
};

HWY_INLINE FragmentLanes perspective(VF lambda0, VF lambda1, VF lambda2,
                                     const Triple<VF>& inverse_w) {
  const VF share1 = hn::Mul(lambda1, inverse_w.v1), share2 = hn::Mul(lambda2, inverse_w.v2);
  const VF q = hn::Add(hn::Add(hn::Mul(lambda0, inverse_w.v0), share1), share2);
  const VF w = hn::Div(set(1.0f), q);
  return {hn::Mul(share1, w), hn::Mul(share2, w), q};
}

// Of triangles some of which may have the same w everywhere: perspective changes nothing there.
HWY_INLINE FragmentLanes fragment_from(VF lambda0, VF lambda1, VF lambda2,
                                       const Triple<VF>& inverse_w) {
  const MF affine = hn::And(hn::Eq(inverse_w.v0, inverse_w.v1), hn::Eq(inverse_w.v1, inverse_w.v2));
  const FragmentLanes seen = perspective(lambda0, lambda1, lambda2, inverse_w);
  return {hn::IfThenElse(affine, lambda1, seen.weight1),
          hn::IfThenElse(affine, lambda2, seen.weight2),
          hn::IfThenElse(affine, inverse_w.v0, seen.inverse_w)};
}

HWY_INLINE VF interpolate(const FragmentLanes& at, VF a0, VF a1, VF a2) {
  return hn::Add(
      a0, hn::Add(hn::Mul(at.weight1, hn::Sub(a1, a0)), hn::Mul(at.weight2, hn::Sub(a2, a0))));
}
HWY_INLINE VF interpolate(const FragmentLanes& at, const Triple<VF>& a) {
  return interpolate(at, a.v0, a.v1, a.v2);
}

using Vec3Triple = Triple<Vec3>;
HWY_INLINE Vec3 interpolate(const FragmentLanes& at, const Vec3Triple& a) {
  return {interpolate(at, a.v0.x, a.v1.x, a.v2.x), interpolate(at, a.v0.y, a.v1.y, a.v2.y),
          interpolate(at, a.v0.z, a.v1.z, a.v2.z)};
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
