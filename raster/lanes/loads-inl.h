// Reads table entries at arbitrary indices by one load for each index. Gather instructions do the
// same, but AMD's processors split one into 20 to 80 operations, and a load fetches up to four
// words of an entry where a gather fetches one.

#if defined(GLASSBOX_LOADS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_LOADS_INL_H_
#undef GLASSBOX_LOADS_INL_H_
#else
#define GLASSBOX_LOADS_INL_H_
#endif

#include <cstddef>
#include <cstdint>

#include <glassbox/raster/lanes/numbers-inl.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

#if HWY_TARGET != HWY_SCALAR

// The table index of each lane, stored as an array.
struct LaneIndices {
  HWY_INLINE explicit LaneIndices(Ints at) { store(at, lane); }
  HWY_ALIGN std::int32_t lane[kLanes];
};

// In Highway a block is 128 bits: four lanes.
using DBlock = hn::FixedTag<std::int32_t, 4>;

// Loads four words of 32 bits, beginning at word `at` of a table.
HWY_INLINE hn::Vec<DBlock> four_words(const std::int32_t* table, std::int32_t at) {
  return hn::LoadU(DBlock(), table + at);
}
// Loads two words of 64 bits, at kBytes times `first` and kBytes times `second` bytes from the
// table's beginning.
template <int kBytes>
HWY_INLINE hn::Vec<DBlock> two_words(const void* table, std::int32_t first, std::int32_t second) {
  const auto word = [&](std::int32_t at) HWY_ATTR {
    return static_cast<const char*>(table) + std::ptrdiff_t(at) * kBytes;
  };
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_SSE4
  // (For hn::Combine g++ 12 generates two loads and a shuffle: scene S2 takes 2 % longer with
  // AVX2.)
  const __m128i low = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(word(first)));
  const auto* high = reinterpret_cast<const __m64*>(word(second));
  return hn::Vec<DBlock>{_mm_castps_si128(_mm_loadh_pi(_mm_castsi128_ps(low), high))};
#else
  const hn::FixedTag<std::int64_t, 1> d;
  const auto at = [&](std::int32_t place) HWY_ATTR {
    return hn::LoadU(d, reinterpret_cast<const std::int64_t*>(word(place)));
  };
  return hn::BitCast(DBlock(), hn::Combine(hn::Twice<decltype(d)>(), at(second), at(first)));
#endif
}

// Returns the vector whose block beginning with lane k is `of_lane`(k).
template <class OfLane>
HWY_INLINE hn::Vec<DI> combine_blocks(const OfLane& of_lane) {
  if constexpr (kLanes == 4) {
    return of_lane(0);
  } else if constexpr (kLanes == 8) {
    return hn::Combine(kI, of_lane(4), of_lane(0));
  } else {
    const hn::Half<DI> half;
    return hn::Combine(kI, hn::Combine(half, of_lane(12), of_lane(8)),
                       hn::Combine(half, of_lane(4), of_lane(0)));
  }
}

#endif  // HWY_TARGET != HWY_SCALAR

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
