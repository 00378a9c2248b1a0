// Vectors with four integers of 16 bits in each lane, and functions that load such integers from
// tables.

#if defined(GLASSBOX_INT16X4_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_INT16X4_INL_H_
#undef GLASSBOX_INT16X4_INL_H_
#else
#define GLASSBOX_INT16X4_INL_H_
#endif

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include <glassbox/raster/lanes/loads-inl.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR
// With a single lane there are no narrower vectors, so the four integers are computed one by one.
struct Int16x4 {
  std::array<std::int16_t, 4> i;
};
template <class Operation>
HWY_INLINE Int16x4 apply_to_each(const Int16x4& a, const Int16x4& b, const Operation& operation) {
  Int16x4 results;
  for (std::size_t k = 0; k < 4; ++k) {
    results.i[k] = std::int16_t(operation(std::int32_t(a.i[k]), std::int32_t(b.i[k])));
  }
  return results;
}
HWY_INLINE Int16x4 operator+(const Int16x4& a, const Int16x4& b) {
  return apply_to_each(a, b, [](std::int32_t x, std::int32_t y) { return x + y; });
}
HWY_INLINE Int16x4 operator-(const Int16x4& a, const Int16x4& b) {
  return apply_to_each(a, b, [](std::int32_t x, std::int32_t y) { return x - y; });
}
HWY_INLINE Int16x4 times_fraction(const Int16x4& i, const Int16x4& f) {
  return apply_to_each(
      i, f, [](std::int32_t x, std::int32_t y) { return glassbox::times_fraction(x, y); });
}
HWY_INLINE Int16x4 select(FloatMask condition, const Int16x4& yes, const Int16x4& no) {
  return none(condition) ? no : yes;
}
template <int kBits>
HWY_INLINE Int16x4 shifted_right(const Int16x4& a) {
  return apply_to_each(a, a, [](std::int32_t x, std::int32_t) { return x >> kBits; });
}
HWY_INLINE Int16x4 int16x4_of(std::int16_t i) {
  return {{i, i, i, i}};
}
// Packs the lane's four integers, in [0, 255], into the bytes of one integer, the first in the
// lowest.
HWY_INLINE Ints bytes_of(const Int16x4& a) {
  return std::int32_t(unsigned(a.i[0]) | unsigned(a.i[1]) << 8 | unsigned(a.i[2]) << 16 |
                      unsigned(a.i[3]) << 24);
}
// Four copies of each lane's integer, which is in [0, 2^15).
HWY_INLINE Int16x4 four_copies(Ints i) {
  const auto one = std::int16_t(i.v.raw);
  return {{one, one, one, one}};
}
// Entry `at` of a table with four integers in each entry.
HWY_INLINE Int16x4 gather_int16x4(const std::int64_t* table, Ints at) {
  Int16x4 gathered;
  std::memcpy(gathered.i.data(), table + at.v.raw, sizeof(gathered.i));
  return gathered;
}
// Returns integer k of each lane, which must not be negative.
template <std::size_t k>
HWY_INLINE Ints int16_at(const Int16x4& integers) {
  return std::int32_t(integers.i[k]);
}
#else
using DS = hn::Repartition<std::int16_t, DF>;
using DW = hn::Repartition<std::int64_t, DF>;
inline constexpr DS kS;
inline constexpr DW kW;
inline constexpr hn::Half<DI> kHalfI;

// The integers of the lower half of the lanes, and those of the upper half.
struct Int16x4 {
  hn::Vec<DS> low, high;
};
HWY_INLINE Int16x4 operator+(const Int16x4& a, const Int16x4& b) {
  return {hn::Add(a.low, b.low), hn::Add(a.high, b.high)};
}
HWY_INLINE Int16x4 operator-(const Int16x4& a, const Int16x4& b) {
  return {hn::Sub(a.low, b.low), hn::Sub(a.high, b.high)};
}
HWY_INLINE Int16x4 times_fraction(const Int16x4& i, const Int16x4& f) {
  return {hn::MulFixedPoint15(i.low, f.low), hn::MulFixedPoint15(i.high, f.high)};
}
template <int kBits>
HWY_INLINE Int16x4 shifted_right(const Int16x4& a) {
  return {hn::ShiftRight<kBits>(a.low), hn::ShiftRight<kBits>(a.high)};
}
HWY_INLINE Int16x4 int16x4_of(std::int16_t i) {
  return {hn::Set(kS, i), hn::Set(kS, i)};
}
// Packs the lane's four integers, in [0, 255], into the bytes of one integer, the first in the
// lowest.
HWY_INLINE Ints bytes_of(const Int16x4& a) {
  const hn::Rebind<std::uint8_t, DS> half;
  const hn::Twice<decltype(half)> whole;
  return hn::BitCast(kI, hn::Combine(whole, hn::DemoteTo(half, a.high), hn::DemoteTo(half, a.low)));
}
// Applies `of_words` to the lanes widened to words of 64 bits, half by half.
template <class OfWords>
HWY_INLINE Int16x4 int16x4_of_words(Ints i, const OfWords& of_words) {
  return {hn::BitCast(kS, of_words(hn::PromoteTo(kW, hn::LowerHalf(kHalfI, i.v)))),
          hn::BitCast(kS, of_words(hn::PromoteTo(kW, hn::UpperHalf(kHalfI, i.v))))};
}
// Four copies of each lane's integer, which is in [0, 2^15).
HWY_INLINE Int16x4 four_copies(Ints i) {
#if HWY_TARGET == HWY_AVX3
  // Integer 2k of 16 bits is the lower half of lane k.
  const auto lane = hn::ShiftLeft<1>(hn::ShiftRight<2>(hn::Iota(kS, 0)));
  return {hn::Vec<DS>{_mm512_permutexvar_epi16(lane.raw, i.v.raw)},
          hn::Vec<DS>{_mm512_permutexvar_epi16(hn::Add(lane, hn::Set(kS, std::int16_t(kLanes))).raw,
                                               i.v.raw)}};
#else
  return int16x4_of_words(i | shifted_left<16>(i), [](auto twice) HWY_ATTR {
    return hn::Or(twice, hn::ShiftLeft<32>(twice));
  });
#endif
}
// Entry `at` of a table with four integers in each entry.
HWY_INLINE Int16x4 gather_int16x4(const std::int64_t* table, Ints at) {
#if HWY_TARGET == HWY_AVX3
  // Single loads are no quicker on AMD's processors that have AVX-512; on Intel's this was not
  // measured.
  const auto half = [&](auto indices) HWY_ATTR {
    return hn::BitCast(kS, hn::Vec<DW>{_mm512_i32gather_epi64(indices.raw, table, 8)});
  };
  return {half(hn::LowerHalf(kHalfI, at.v)), half(hn::UpperHalf(kHalfI, at.v))};
#else
  const LaneIndices indices(at);
  const auto half = [&](int first) HWY_ATTR {
    return hn::BitCast(kS, combine_blocks([&](int block) HWY_ATTR {
                         const std::int32_t* at_two = indices.lane + first + block / 2;
                         return two_words<8>(table, at_two[0], at_two[1]);
                       }));
  };
  return {half(0), half(int(kLanes) / 2)};
#endif
}
HWY_INLINE Int16x4 select(FloatMask condition, const Int16x4& yes, const Int16x4& no) {
  const Ints all_bits = hn::VecFromMask(kI, int_mask(condition).m);
  const Int16x4 where = int16x4_of_words(all_bits, [](auto words) HWY_ATTR { return words; });
  return {hn::IfVecThenElse(where.low, yes.low, no.low),
          hn::IfVecThenElse(where.high, yes.high, no.high)};
}
// Returns integer k of each lane, which must not be negative.
template <std::size_t k>
HWY_INLINE Ints int16_at(const Int16x4& integers) {
  const auto low = hn::BitCast(kI, integers.low), high = hn::BitCast(kI, integers.high);
  const Ints two = k < 2 ? hn::ConcatEven(kI, high, low) : hn::ConcatOdd(kI, high, low);
  return k % 2 == 0 ? two & 0xffff : shifted_right<16>(two);
}
#endif

// ---- two of the four ----

// Two integers of 16 bits in each lane, the first in the lower half.
struct Int16x2 {
  Ints two;
};
#if HWY_TARGET == HWY_SCALAR
HWY_INLINE Int16x2 operator+(Int16x2 a, Int16x2 b) {
  return {
      pair_of(first_int16(a.two) + first_int16(b.two), second_int16(a.two) + second_int16(b.two))};
}
HWY_INLINE Int16x2 operator-(Int16x2 a, Int16x2 b) {
  return {
      pair_of(first_int16(a.two) - first_int16(b.two), second_int16(a.two) - second_int16(b.two))};
}
HWY_INLINE Int16x2 times_fraction(Int16x2 i, Int16x2 f) {
  const auto times = [](Ints x, Ints y) HWY_ATTR { return shifted_right<15>(x * y + 0x4000); };
  return {pair_of(times(first_int16(i.two), first_int16(f.two)),
                  times(second_int16(i.two), second_int16(f.two)))};
}
#else
HWY_INLINE hn::Vec<DS> int16_vector(Int16x2 a) {
  return hn::BitCast(kS, a.two.v);
}
HWY_INLINE Int16x2 operator+(Int16x2 a, Int16x2 b) {
  return {hn::BitCast(kI, hn::Add(int16_vector(a), int16_vector(b)))};
}
HWY_INLINE Int16x2 operator-(Int16x2 a, Int16x2 b) {
  return {hn::BitCast(kI, hn::Sub(int16_vector(a), int16_vector(b)))};
}
HWY_INLINE Int16x2 times_fraction(Int16x2 i, Int16x2 f) {
  return {hn::BitCast(kI, hn::MulFixedPoint15(int16_vector(i), int16_vector(f)))};
}
#endif
HWY_INLINE Int16x2 select(FloatMask condition, Int16x2 yes, Int16x2 no) {
  return {select(int_mask(condition), yes.two, no.two)};
}
// Two copies of each lane's integer, which is in [0, 2^15).
HWY_INLINE Int16x2 two_copies(Ints i) {
  return {i | shifted_left<16>(i)};
}
// Return the first and the second integer of each lane, which must not be negative.
HWY_INLINE Ints first_of(Int16x2 a) {
  return a.two & 0xffff;
}
HWY_INLINE Ints second_of(Int16x2 a) {
  return shifted_right<16>(a.two);
}
// Two of the four integers of table entry `at`, beginning with integer `first`, which is 0 or 1.
HWY_INLINE Int16x2 gather_int16x2(const std::int64_t* table, Ints at, std::size_t first) {
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX2
  const auto* const from =
      reinterpret_cast<const int*>(reinterpret_cast<const std::int16_t*>(table) + first);
#endif
#if HWY_TARGET == HWY_AVX3
  return {hn::Vec<DI>{_mm512_i32gather_epi32(at.v.raw, from, 8)}};
#elif HWY_TARGET == HWY_AVX2
  return {hn::Vec<DI>{_mm256_i32gather_epi32(from, at.v.raw, 8)}};
#else
  const Int16x4 four = gather_int16x4(table, at);
  return {first == 0 ? pair_of(int16_at<0>(four), int16_at<1>(four))
                     : pair_of(int16_at<1>(four), int16_at<2>(four))};
#endif
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
