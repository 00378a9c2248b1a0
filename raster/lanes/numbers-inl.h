// Many numbers at a time: what base/numbers.h has for one, over the vectors that the processor has, of 16 floats at most.
//
// Every operation is the IEEE one, so each lane has the bits that one number alone would have. No multiplication and addition
// in one, no approximate reciprocals.

#if defined(GLASSBOX_NUMBERS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_NUMBERS_INL_H_
#undef GLASSBOX_NUMBERS_INL_H_
#else
#define GLASSBOX_NUMBERS_INL_H_
#endif

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include <glassbox/base/numbers.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using DF = hn::CappedTag<float, 16>;
using DI = hn::RebindToSigned<DF>;
inline constexpr DF kF;
inline constexpr DI kI;
inline constexpr std::size_t kLanes = hn::MaxLanes(DF());

// ---- conditions ----

// What holds in some lanes.
template <class D>
struct MaskOf {
  hn::Mask<D> m;
};
using FloatMask = MaskOf<DF>;
using IntMask = MaskOf<DI>;

template <class D>
HWY_INLINE MaskOf<D> operator&&(MaskOf<D> a, MaskOf<D> b) {
  return {hn::And(a.m, b.m)};
}
template <class D>
HWY_INLINE MaskOf<D> operator||(MaskOf<D> a, MaskOf<D> b) {
  return {hn::Or(a.m, b.m)};
}
template <class D>
HWY_INLINE MaskOf<D> operator!(MaskOf<D> a) {
  return {hn::Not(a.m)};
}
template <class D>
HWY_INLINE bool none(MaskOf<D> a) {
  return hn::AllFalse(D(), a.m);
}

HWY_INLINE FloatMask float_mask(IntMask a) {
  return {hn::RebindMask(kF, a.m)};
}
HWY_INLINE IntMask int_mask(FloatMask a) {
  return {hn::RebindMask(kI, a.m)};
}
HWY_INLINE std::size_t count_of(IntMask a) {
  return hn::CountTrue(kI, a.m);
}
// Lanes 0 .. count - 1.
HWY_INLINE IntMask first_lanes(std::size_t count) {
  return {hn::FirstN(kI, count)};
}

// ---- floats ----

struct Floats {
  hn::Vec<DF> v;

  Floats() = default;
  HWY_INLINE Floats(hn::Vec<DF> lanes) : v(lanes) {}
  HWY_INLINE Floats(float x) : v(hn::Set(kF, x)) {}
};

template <class F>
concept Number = std::same_as<F, Floats>;

HWY_INLINE Floats operator+(Floats a, Floats b) {
  return hn::Add(a.v, b.v);
}
HWY_INLINE Floats operator-(Floats a, Floats b) {
  return hn::Sub(a.v, b.v);
}
HWY_INLINE Floats operator-(Floats a) {
  return hn::Neg(a.v);
}
HWY_INLINE Floats operator*(Floats a, Floats b) {
  return hn::Mul(a.v, b.v);
}
HWY_INLINE Floats operator/(Floats a, Floats b) {
  return hn::Div(a.v, b.v);
}
HWY_INLINE FloatMask operator<(Floats a, Floats b) {
  return {hn::Lt(a.v, b.v)};
}
HWY_INLINE FloatMask operator<=(Floats a, Floats b) {
  return {hn::Le(a.v, b.v)};
}
HWY_INLINE FloatMask operator>(Floats a, Floats b) {
  return {hn::Gt(a.v, b.v)};
}
HWY_INLINE FloatMask operator>=(Floats a, Floats b) {
  return {hn::Ge(a.v, b.v)};
}
HWY_INLINE FloatMask operator==(Floats a, Floats b) {
  return {hn::Eq(a.v, b.v)};
}
HWY_INLINE FloatMask operator!=(Floats a, Floats b) {
  return {hn::Ne(a.v, b.v)};
}
HWY_INLINE Floats select(FloatMask condition, Floats yes, Floats no) {
  return hn::IfThenElse(condition.m, yes.v, no.v);
}
HWY_INLINE Floats abs(Floats x) {
  return hn::Abs(x.v);
}
HWY_INLINE Floats floor(Floats x) {
  return hn::Floor(x.v);
}
HWY_INLINE Floats sqrt(Floats x) {
  return hn::Sqrt(x.v);
}

// ---- integers of 32 bits ----

struct Ints {
  hn::Vec<DI> v;

  Ints() = default;
  HWY_INLINE Ints(hn::Vec<DI> lanes) : v(lanes) {}
  HWY_INLINE Ints(std::int32_t i) : v(hn::Set(kI, i)) {}
};

template <class I>
concept WholeNumber = std::same_as<I, Ints>;

HWY_INLINE Ints operator+(Ints a, Ints b) {
  return hn::Add(a.v, b.v);
}
HWY_INLINE Ints operator-(Ints a, Ints b) {
  return hn::Sub(a.v, b.v);
}
HWY_INLINE Ints operator*(Ints a, Ints b) {
  return hn::Mul(a.v, b.v);
}
HWY_INLINE Ints operator&(Ints a, Ints b) {
  return hn::And(a.v, b.v);
}
HWY_INLINE Ints operator|(Ints a, Ints b) {
  return hn::Or(a.v, b.v);
}
HWY_INLINE IntMask operator<(Ints a, Ints b) {
  return {hn::Lt(a.v, b.v)};
}
HWY_INLINE IntMask operator>(Ints a, Ints b) {
  return {hn::Gt(a.v, b.v)};
}
HWY_INLINE IntMask operator>=(Ints a, Ints b) {
  return {hn::Not(hn::Lt(a.v, b.v))};
}
HWY_INLINE IntMask operator==(Ints a, Ints b) {
  return {hn::Eq(a.v, b.v)};
}
HWY_INLINE IntMask operator!=(Ints a, Ints b) {
  return {hn::Ne(a.v, b.v)};
}
HWY_INLINE Ints select(IntMask condition, Ints yes, Ints no) {
  return hn::IfThenElse(condition.m, yes.v, no.v);
}
HWY_INLINE Ints one_where(IntMask condition) {
  return hn::IfThenElseZero(condition.m, hn::Set(kI, 1));
}
HWY_INLINE Ints one_where(FloatMask condition) {
  return one_where(int_mask(condition));
}
HWY_INLINE Ints abs(Ints i) {
  return hn::Abs(i.v);
}
HWY_INLINE Ints least(Ints a, Ints b) {
  return hn::Min(a.v, b.v);
}
HWY_INLINE Ints greatest(Ints a, Ints b) {
  return hn::Max(a.v, b.v);
}
template <int kBits>
HWY_INLINE Ints shifted_left(Ints i) {
  return hn::ShiftLeft<kBits>(i.v);
}
template <int kBits>
HWY_INLINE Ints shifted_right(Ints i) {
  return hn::ShiftRight<kBits>(i.v);
}

HWY_INLINE Ints shifted_right(Ints i, Ints bits) {
  return hn::Shr(i.v, bits.v);
}

// From and to memory that is aligned as the vectors are.
HWY_INLINE Floats load(const float* from) {
  return hn::Load(kF, from);
}
HWY_INLINE Ints load(const std::int32_t* from) {
  return hn::Load(kI, from);
}
HWY_INLINE void store(Floats x, float* to) {
  hn::Store(x.v, kF, to);
}
HWY_INLINE void store(Ints i, std::int32_t* to) {
  hn::Store(i.v, kI, to);
}

// ---- four integers of 16 bits in each lane ----

#if HWY_TARGET == HWY_SCALAR
// There are no narrower ones in a single lane: they are computed one by one.
struct Shorts {
  std::array<std::int16_t, 4> i;
};
template <class Operation>
HWY_INLINE Shorts of_each(const Shorts& a, const Shorts& b, const Operation& operation) {
  Shorts results;
  for (std::size_t k = 0; k < 4; ++k) {
    results.i[k] = std::int16_t(operation(std::int32_t(a.i[k]), std::int32_t(b.i[k])));
  }
  return results;
}
HWY_INLINE Shorts operator+(const Shorts& a, const Shorts& b) {
  return of_each(a, b, [](std::int32_t x, std::int32_t y) { return x + y; });
}
HWY_INLINE Shorts operator-(const Shorts& a, const Shorts& b) {
  return of_each(a, b, [](std::int32_t x, std::int32_t y) { return x - y; });
}
HWY_INLINE Shorts times_fraction(const Shorts& i, const Shorts& f) {
  return of_each(i, f,
                 [](std::int32_t x, std::int32_t y) { return glassbox::times_fraction(x, y); });
}
HWY_INLINE Shorts select(FloatMask condition, const Shorts& yes, const Shorts& no) {
  return none(condition) ? no : yes;
}
template <int kBits>
HWY_INLINE Shorts shifted_right(const Shorts& a) {
  return of_each(a, a, [](std::int32_t x, std::int32_t) { return x >> kBits; });
}
HWY_INLINE Shorts shorts_of(std::int16_t i) {
  return {{i, i, i, i}};
}
// The lane's four, in [0, 255], as the bytes of one integer, the first in the lowest.
HWY_INLINE Ints bytes_of(const Shorts& a) {
  return std::int32_t(unsigned(a.i[0]) | unsigned(a.i[1]) << 8 | unsigned(a.i[2]) << 16 |
                      unsigned(a.i[3]) << 24);
}
// The lane's integer, which is in [0, 2^15), four times.
HWY_INLINE Shorts four_times(Ints i) {
  const auto one = std::int16_t(i.v.raw);
  return {{one, one, one, one}};
}
// Entry `at` of a table of four each.
HWY_INLINE Shorts gather_shorts(const std::int64_t* table, Ints at) {
  Shorts gathered;
  std::memcpy(gathered.i.data(), table + at.v.raw, sizeof(gathered.i));
  return gathered;
}
// The k-th of them, which is not negative.
template <std::size_t k>
HWY_INLINE Ints short_of(const Shorts& shorts) {
  return std::int32_t(shorts.i[k]);
}
#else
using DS = hn::Repartition<std::int16_t, DF>;
using DW = hn::Repartition<std::int64_t, DF>;
inline constexpr DS kS;
inline constexpr DW kW;
inline constexpr hn::Half<DI> kHalfI;

// Those of the lower half of the lanes, and those of the upper one.
struct Shorts {
  hn::Vec<DS> low, high;
};
HWY_INLINE Shorts operator+(const Shorts& a, const Shorts& b) {
  return {hn::Add(a.low, b.low), hn::Add(a.high, b.high)};
}
HWY_INLINE Shorts operator-(const Shorts& a, const Shorts& b) {
  return {hn::Sub(a.low, b.low), hn::Sub(a.high, b.high)};
}
HWY_INLINE Shorts times_fraction(const Shorts& i, const Shorts& f) {
  return {hn::MulFixedPoint15(i.low, f.low), hn::MulFixedPoint15(i.high, f.high)};
}
template <int kBits>
HWY_INLINE Shorts shifted_right(const Shorts& a) {
  return {hn::ShiftRight<kBits>(a.low), hn::ShiftRight<kBits>(a.high)};
}
HWY_INLINE Shorts shorts_of(std::int16_t i) {
  return {hn::Set(kS, i), hn::Set(kS, i)};
}
// The lane's four, in [0, 255], as the bytes of one integer, the first in the lowest.
HWY_INLINE Ints bytes_of(const Shorts& a) {
  const hn::Rebind<std::uint8_t, DS> half;
  const hn::Twice<decltype(half)> whole;
  return hn::BitCast(kI, hn::Combine(whole, hn::DemoteTo(half, a.high), hn::DemoteTo(half, a.low)));
}
// What `of_words` makes of the lanes as words of 64 bits, half by half.
template <class OfWords>
HWY_INLINE Shorts shorts_of_words(Ints i, const OfWords& of_words) {
  return {hn::BitCast(kS, of_words(hn::PromoteTo(kW, hn::LowerHalf(kHalfI, i.v)))),
          hn::BitCast(kS, of_words(hn::PromoteTo(kW, hn::UpperHalf(kHalfI, i.v))))};
}
// The lane's integer, which is in [0, 2^15), four times.
HWY_INLINE Shorts four_times(Ints i) {
#if HWY_TARGET == HWY_AVX3
  // Short 2k of the lanes is lane k's.
  const auto lane = hn::ShiftLeft<1>(hn::ShiftRight<2>(hn::Iota(kS, 0)));
  return {hn::Vec<DS>{_mm512_permutexvar_epi16(lane.raw, i.v.raw)},
          hn::Vec<DS>{_mm512_permutexvar_epi16(hn::Add(lane, hn::Set(kS, std::int16_t(kLanes))).raw,
                                               i.v.raw)}};
#else
  return shorts_of_words(i | shifted_left<16>(i), [](auto twice) HWY_ATTR {
    return hn::Or(twice, hn::ShiftLeft<32>(twice));
  });
#endif
}
// Words of 64 bits, `kBytes` times `at` bytes from the table's beginning.
template <int kBytes>
HWY_INLINE hn::Vec<DW> gather_words(const std::int64_t* table, hn::Vec<hn::Half<DI> > at) {
#if HWY_TARGET == HWY_AVX3
  return hn::Vec<DW>{_mm512_i32gather_epi64(at.raw, table, kBytes)};
#elif HWY_TARGET == HWY_AVX2
  return hn::Vec<DW>{
      _mm256_i32gather_epi64(reinterpret_cast<const long long*>(table), at.raw, kBytes)};
#else
  constexpr int kShift = std::countr_zero(unsigned(kBytes));
  return hn::GatherOffset(kW, table, hn::ShiftLeft<kShift>(hn::PromoteTo(kW, at)));
#endif
}
// Entry `at` of a table of four each.
HWY_INLINE Shorts gather_shorts(const std::int64_t* table, Ints at) {
  return {hn::BitCast(kS, gather_words<8>(table, hn::LowerHalf(kHalfI, at.v))),
          hn::BitCast(kS, gather_words<8>(table, hn::UpperHalf(kHalfI, at.v)))};
}
HWY_INLINE Shorts select(FloatMask condition, const Shorts& yes, const Shorts& no) {
  const Ints all_bits = hn::VecFromMask(kI, int_mask(condition).m);
  const Shorts where = shorts_of_words(all_bits, [](auto words) HWY_ATTR { return words; });
  return {hn::IfVecThenElse(where.low, yes.low, no.low),
          hn::IfVecThenElse(where.high, yes.high, no.high)};
}
// The k-th of them, which is not negative.
template <std::size_t k>
HWY_INLINE Ints short_of(const Shorts& shorts) {
  const auto low = hn::BitCast(kI, shorts.low), high = hn::BitCast(kI, shorts.high);
  const Ints two = k < 2 ? hn::ConcatEven(kI, high, low) : hn::ConcatOdd(kI, high, low);
  return k % 2 == 0 ? two & 0xffff : shifted_right<16>(two);
}
#endif

// ---- from one kind to another ----

HWY_INLINE Floats to_float(Ints i) {
  return hn::ConvertTo(kF, i.v);
}
// Of all lanes.
HWY_INLINE float to_float(std::int32_t i) {
  return float(i);
}
HWY_INLINE Ints to_integer(Floats x) {
  return hn::ConvertTo(kI, x.v);
}
HWY_INLINE Ints bits_of(Floats x) {
  return hn::BitCast(kI, x.v);
}
HWY_INLINE Floats float_of(Ints bits) {
  return hn::BitCast(kF, bits.v);
}

// ---- doubles ----

#if HWY_TARGET == HWY_SCALAR
using DD = hn::Rebind<double, DF>;
#else
using DD = hn::Repartition<double, DF>;
inline constexpr hn::Half<DF> kHalfF;
#endif
inline constexpr DD kD;

// As many doubles as there are floats: those of the lower half, and those of the upper one. (A single lane has no halves: both are
// the same.)
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
// x holds integers below 2^24, which floats hold.
HWY_INLINE Ints to_integer(const Doubles& x) {
  return to_integer(rounded(x));
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
