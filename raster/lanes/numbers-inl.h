// Vectors of numbers: the operations that base/numbers.h has for one number, on vectors as wide as
// the processor has, of at most 16 floats. A lane is one element of a vector.
//
// Every operation is the IEEE one, so each lane has the same bits as a single number would have.
// There are no fused multiply-adds and no approximate reciprocals.

#if defined(GLASSBOX_NUMBERS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_NUMBERS_INL_H_
#undef GLASSBOX_NUMBERS_INL_H_
#else
#define GLASSBOX_NUMBERS_INL_H_
#endif

#include <concepts>
#include <cstddef>
#include <cstdint>

#include <glassbox/base/numbers.h>
#include <glassbox/raster/lanes/lane_compaction.h>
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

// The result of a comparison: true or false in each lane.
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
// Returns an integer whose bit i is lane i.
HWY_INLINE std::uint64_t bits_of(IntMask a) {
  std::array<std::uint8_t, 8> bytes{};
  hn::StoreMaskBits(kI, a.m, bytes.data());
  return std::bit_cast<std::uint64_t>(bytes);
}
// True in lanes 0 .. count - 1.
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
// least() and greatest() of base/formulas/common.h: if two numbers are equal, or if one is a NaN,
// the result is the first argument. x86's instructions return the second operand then, so the
// operands are exchanged.
HWY_INLINE Floats least(Floats a, Floats b) {
#if HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
  return hn::Min(b.v, a.v);
#else
  return select(b < a, b, a);
#endif
}
HWY_INLINE Floats greatest(Floats a, Floats b) {
#if HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
  return hn::Max(b.v, a.v);
#else
  return select(a < b, b, a);
#endif
}
// Clamps x to [0, 1], like the function in base/formulas/common.h, in two instructions.
HWY_INLINE Floats in_unit_range(Floats x) {
  return least(Floats(1.0f), greatest(Floats(0.0f), x));
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

// Loads and stores need memory that is aligned for vectors.
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

// Stores only the lanes of `where`. AVX2 has an instruction for this, but AMD's processors split it
// into about 20 operations.
HWY_INLINE void store_where(IntMask where, Ints i, std::int32_t* to) {
#if HWY_TARGET == HWY_AVX2
  store(select(where, i, load(to)), to);
#else
  hn::BlendedStore(i.v, where.m, kI, to);
#endif
}
// Returns the kept lanes one after the other; the lanes after them are unspecified.
HWY_INLINE Ints first_kept(Ints i, IntMask keep) {
#if HWY_TARGET == HWY_AVX2
  // (With Highway 1.0.3 g++ copies the whole table to the stack for each call.)
  const auto* lanes = reinterpret_cast<const __m128i*>(&kCompactedLanes[bits_of(keep)]);
  const __m256i from = _mm256_cvtepu8_epi32(_mm_loadl_epi64(lanes));
  return hn::Vec<DI>{_mm256_permutevar8x32_epi32(i.v.raw, from)};
#else
  return hn::Compress(i.v, keep.m);
#endif
}
// The integers must be in [0, 2^16).
HWY_INLINE void store_int16(Ints i, std::uint16_t* to) {
  const hn::Rebind<std::uint16_t, DI> d;
  hn::StoreU(hn::DemoteTo(d, i.v), d, to);
}

// ---- two integers of 16 bits in each lane ----

HWY_INLINE Ints pair_of(Ints first, Ints second) {
  return (first & 0xffff) | shifted_left<16>(second);
}
HWY_INLINE Ints first_int16(Ints pair) {
  return shifted_right<16>(shifted_left<16>(pair));
}
HWY_INLINE Ints second_int16(Ints pair) {
  return shifted_right<16>(pair);
}
// The sum of the products of the first halves and of the second halves: a single instruction with
// x86 vectors.
HWY_INLINE Ints sum_of_products(Ints a, Ints b) {
#if HWY_TARGET == HWY_AVX3
  return hn::Vec<DI>{_mm512_madd_epi16(a.v.raw, b.v.raw)};
#elif HWY_TARGET == HWY_AVX2
  return hn::Vec<DI>{_mm256_madd_epi16(a.v.raw, b.v.raw)};
#elif HWY_TARGET == HWY_SSE4
  return hn::Vec<DI>{_mm_madd_epi16(a.v.raw, b.v.raw)};
#else
  return first_int16(a) * first_int16(b) + second_int16(a) * second_int16(b);
#endif
}

// ---- from one kind to another ----

HWY_INLINE Floats to_float(Ints i) {
  return hn::ConvertTo(kF, i.v);
}
// For an integer that is the same in all lanes.
HWY_INLINE float to_float(std::int32_t i) {
  return float(i);
}
// x must be within the range of the integers. (hn::ConvertTo() takes three more instructions, for
// values outside the range.)
HWY_INLINE Ints to_integer(Floats x) {
#if HWY_TARGET == HWY_AVX3
  return hn::Vec<DI>{_mm512_cvttps_epi32(x.v.raw)};
#elif HWY_TARGET == HWY_AVX2
  return hn::Vec<DI>{_mm256_cvttps_epi32(x.v.raw)};
#else
  return hn::ConvertTo(kI, x.v);
#endif
}
HWY_INLINE Ints bits_of(Floats x) {
  return hn::BitCast(kI, x.v);
}
HWY_INLINE Floats float_of(Ints bits) {
  return hn::BitCast(kF, bits.v);
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
