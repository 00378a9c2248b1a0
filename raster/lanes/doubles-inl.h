// Vectors of doubles, with as many elements as there are floats in a vector.

#if defined(GLASSBOX_DOUBLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_DOUBLES_INL_H_
#undef GLASSBOX_DOUBLES_INL_H_
#else
#define GLASSBOX_DOUBLES_INL_H_
#endif

#include <glassbox/raster/lanes/numbers-inl.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR
using DD = hn::Rebind<double, DF>;
#else
using DD = hn::Repartition<double, DF>;
inline constexpr hn::Half<DF> kHalfF;
#endif
inline constexpr DD kD;

// As many doubles as there are floats in a vector, in two vectors: the lower half and the upper
// half. (A single lane has no halves: both are the same.)
struct Doubles {
  hn::Vec<DD> low, high;

  Doubles() = default;
  HWY_INLINE Doubles(hn::Vec<DD> low_lanes, hn::Vec<DD> high_lanes)
      : low(low_lanes), high(high_lanes) {}
  HWY_INLINE Doubles(double x) : low(hn::Set(kD, x)), high(low) {}
};
struct DoubleMask {
  hn::Mask<DD> low, high;
};

HWY_INLINE Doubles operator+(const Doubles& a, const Doubles& b) {
  return {hn::Add(a.low, b.low), hn::Add(a.high, b.high)};
}
HWY_INLINE Doubles operator-(const Doubles& a, const Doubles& b) {
  return {hn::Sub(a.low, b.low), hn::Sub(a.high, b.high)};
}
HWY_INLINE Doubles operator*(const Doubles& a, const Doubles& b) {
  return {hn::Mul(a.low, b.low), hn::Mul(a.high, b.high)};
}
HWY_INLINE Doubles operator/(const Doubles& a, const Doubles& b) {
  return {hn::Div(a.low, b.low), hn::Div(a.high, b.high)};
}
HWY_INLINE DoubleMask operator>(const Doubles& a, const Doubles& b) {
  return {hn::Gt(a.low, b.low), hn::Gt(a.high, b.high)};
}
HWY_INLINE Doubles select(const DoubleMask& condition, const Doubles& yes, const Doubles& no) {
  return {hn::IfThenElse(condition.low, yes.low, no.low),
          hn::IfThenElse(condition.high, yes.high, no.high)};
}
HWY_INLINE Doubles floor(const Doubles& x) {
  return {hn::Floor(x.low), hn::Floor(x.high)};
}
HWY_INLINE Doubles sqrt(const Doubles& x) {
  return {hn::Sqrt(x.low), hn::Sqrt(x.high)};
}

#if HWY_TARGET == HWY_SCALAR
HWY_INLINE Doubles widened(Floats x) {
  const auto d = hn::PromoteTo(kD, x.v);
  return {d, d};
}
HWY_INLINE Floats rounded(const Doubles& x) {
  return hn::DemoteTo(kF, x.low);
}
#else
HWY_INLINE Doubles widened(Floats x) {
  return {hn::PromoteTo(kD, hn::LowerHalf(kHalfF, x.v)),
          hn::PromoteTo(kD, hn::UpperHalf(kHalfF, x.v))};
}
HWY_INLINE Floats rounded(const Doubles& x) {
  return hn::Combine(kF, hn::DemoteTo(kHalfF, x.high), hn::DemoteTo(kHalfF, x.low));
}
#endif
// x must hold integers below 2^24, which floats represent exactly.
HWY_INLINE Ints to_integer(const Doubles& x) {
  return to_integer(rounded(x));
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
