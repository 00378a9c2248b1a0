// The vectors that the stages run on: as many floats as the processor has, 16 at most, and as many integers.
//
// Every operation is the IEEE one, in the order in which the scalar stage writes it, so a lane has the bits that the scalar stage
// would give. No multiplication and addition in one, no approximate reciprocals.

#if defined(GLASSBOX_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_LANES_INL_H_
#undef GLASSBOX_LANES_INL_H_
#else
#define GLASSBOX_LANES_INL_H_
#endif

#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

#include <glassbox/raster/stages.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using DF = hn::CappedTag<float, 16>;
using DI = hn::RebindToSigned<DF>;
using DU = hn::RebindToUnsigned<DF>;
using VF = hn::Vec<DF>;
using VI = hn::Vec<DI>;
using VU = hn::Vec<DU>;
using MF = hn::Mask<DF>;
using MI = hn::Mask<DI>;
inline constexpr DF kF;
inline constexpr DI kI;
inline constexpr DU kU;

#if HWY_TARGET == HWY_SCALAR
using DD = hn::Rebind<double, DF>;
#else
using DD = hn::Repartition<double, DF>;
using DHalf = hn::Half<DF>;
inline constexpr DHalf kHalfF;
#endif
using VD = hn::Vec<DD>;
inline constexpr DD kD;

inline constexpr std::size_t kLanes = hn::MaxLanes(DF());

HWY_INLINE VF set(float x) {
  return hn::Set(kF, x);
}
HWY_INLINE VI set(std::int32_t x) {
  return hn::Set(kI, x);
}

HWY_INLINE VF to_float(VI x) {
  return hn::ConvertTo(kF, x);
}
HWY_INLINE MF as_float_mask(MI mask) {
  return hn::RebindMask(kF, mask);
}
HWY_INLINE MI as_int_mask(MF mask) {
  return hn::RebindMask(kI, mask);
}

// ---- doubles ----

// As many doubles as there are float lanes: those of the lower half, and those of the upper one. (A single lane has no halves:
// both are the same.)
struct Doubles {
  VD low, high;
};

#if HWY_TARGET == HWY_SCALAR
HWY_INLINE Doubles promote(VF v) {
  const VD d = hn::PromoteTo(kD, v);
  return {d, d};
}
HWY_INLINE VF round_to_float(const Doubles& d) {
  return hn::DemoteTo(kF, d.low);
}
#else
HWY_INLINE Doubles promote(VF v) {
  return {hn::PromoteTo(kD, hn::LowerHalf(kHalfF, v)), hn::PromoteTo(kD, hn::UpperHalf(kHalfF, v))};
}
// Each rounded once.
HWY_INLINE VF round_to_float(const Doubles& d) {
  return hn::Combine(kF, hn::DemoteTo(kHalfF, d.high), hn::DemoteTo(kHalfF, d.low));
}
#endif

// The same operations on both halves.
template <class Operation, class... Operands>
HWY_INLINE Doubles each_half(const Operation& operation, const Operands&... operands) {
  return {operation(operands.low...), operation(operands.high...)};
}

// ---- vectors of space ----

struct Vec3 {
  VF x, y, z;
};

HWY_INLINE VF dot(const Vec3& a, const Vec3& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
HWY_INLINE Vec3 scale(const Vec3& v, VF s) {
  return {hn::Mul(v.x, s), hn::Mul(v.y, s), hn::Mul(v.z, s)};
}
HWY_INLINE Vec3 add(const Vec3& a, const Vec3& b) {
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
HWY_INLINE Vec3 subtract(const Vec3& a, const Vec3& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}

HWY_INLINE MI at_least(VI a, VI b) {
  return hn::Not(hn::Lt(a, b));
}

// Lanes 0 .. count - 1.
HWY_INLINE MI first_lanes(std::size_t count) {
  return hn::FirstN(kI, count);
}

// ---- a quad's pixels ----

// Columns and rows of a quad's pixels i .. i + kLanes - 1 within the quad.
HWY_INLINE VI quad_columns(std::size_t i) {
  return hn::And(hn::Iota(kI, std::int32_t(i)), set(3));
}
HWY_INLINE VI quad_rows(std::size_t i) {
  return hn::ShiftRight<2>(hn::Iota(kI, std::int32_t(i)));
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
