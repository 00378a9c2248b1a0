// The mean of a pixel's samples, vectorised: mean_color.h computes it for one pixel. It is
// implemented a second time, because vector code looks light up in tables and sums doubles in
// half-vectors. tests/raster/lanes compares the two implementations.

#if defined(GLASSBOX_SAMPLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_SAMPLES_INL_H_
#undef GLASSBOX_SAMPLES_INL_H_
#else
#define GLASSBOX_SAMPLES_INL_H_
#endif

#include <bit>
#include <cstddef>
#include <cstdint>

#include <glassbox/raster/lanes/tile_buffer.h>
#include <glassbox/raster/lanes/transfer-inl.h>
#include <glassbox/raster/samples.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

// The stored colours of a block's samples.
struct SampleColors {
  std::int32_t* at(std::size_t sample) { return colors + sample * kBlockPixels; }
  const std::int32_t* at(std::size_t sample) const { return colors + sample * kBlockPixels; }

  HWY_ALIGN std::int32_t colors[std::size_t(kMaxSamples) * kBlockPixels];
};

template <int kShift>
HWY_INLINE Ints byte_at(Ints color) {
  return shifted_right<kShift>(color) & 255;
}

// The mean of bytes, (2 sum + count) / (2 count) rounded down, where count is a power of two. After
// a shift, bytes 0 and 2 of the colours are each in one half of a 32-bit lane, which has room for
// the sum of 16 bytes and the rounding.
template <int kShift>
HWY_INLINE Ints mean_bytes(const SampleColors& colors, std::size_t count, std::size_t k) {
  constexpr std::int32_t kTwoBytes = 0x00ff00ff;
  Ints sum = std::int32_t(count / 2) * 0x00010001;
  for (std::size_t s = 0; s < count; ++s) {
    sum = sum + (shifted_right<kShift>(load(colors.at(s) + k)) & kTwoBytes);
  }
  return shifted_right(sum, int(std::bit_width(unsigned(count)) - 1)) & kTwoBytes;
}

// The mean of light, encoded. The sum is exact in a double, and so is its quotient by `count`.
template <int kShift>
HWY_INLINE Ints mean_light(const SampleColors& colors, std::size_t count, std::size_t k) {
  Doubles sum = 0.0;
  for (std::size_t s = 0; s < count; ++s) {
    sum = sum + widened(decode(Transfer::kSrgb, byte_at<kShift>(load(colors.at(s) + k))));
  }
  return encode_srgb(rounded(sum * (1.0 / double(count))));
}

// The mean of the samples of pixels k .. k + kLanes - 1. The mean of equal colours is that colour.
HWY_INLINE Ints mean_color(Transfer transfer, const SampleColors& colors, std::size_t count,
                           std::size_t k) {
  const Ints first = load(colors.at(0) + k);
  IntMask differ = first != first;
  for (std::size_t s = 1; s < count; ++s) differ = differ || load(colors.at(s) + k) != first;
  if (none(differ)) return first;
  const Ints green_alpha = mean_bytes<8>(colors, count, k);
  if (transfer == Transfer::kNone) {
    return mean_bytes<0>(colors, count, k) | shifted_left<8>(green_alpha);
  }
  return mean_light<0>(colors, count, k) | shifted_left<8>(mean_light<8>(colors, count, k)) |
         shifted_left<16>(mean_light<16>(colors, count, k)) |
         shifted_left<8>(green_alpha & 0x00ff0000);
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
