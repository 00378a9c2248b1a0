// The mean of a pixel's samples, over lanes: what mean_color.h has for one pixel. A second writing, because lanes look light up
// and take the sum of doubles in halves; tests/raster/lanes holds the two together.

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

// Stored colours of a block's samples.
struct SampleColors {
  std::int32_t* at(std::size_t sample) { return colors + sample * kBlockPixels; }
  const std::int32_t* at(std::size_t sample) const { return colors + sample * kBlockPixels; }

  HWY_ALIGN std::int32_t colors[std::size_t(kMostSamples) * kBlockPixels];
};

template <int kShift>
HWY_INLINE Ints byte_at(Ints color) {
  return shifted_right<kShift>(color) & 255;
}

// (2 sum + count) / (2 count), of a power of two: of the colours' bytes 0 and 2 after a shift, each in its half of the lane, where 16
// bytes and a half of them fit.
template <int kShift>
HWY_INLINE Ints mean_bytes(const SampleColors& colors, std::size_t count, std::size_t k) {
  constexpr std::int32_t kTwoBytes = 0x00ff00ff;
  Ints sum = std::int32_t(count / 2) * 0x00010001;
  for (std::size_t s = 0; s < count; ++s) {
    sum = sum + (shifted_right<kShift>(load(colors.at(s) + k)) & kTwoBytes);
  }
  return shifted_right(sum, int(std::bit_width(unsigned(count)) - 1)) & kTwoBytes;
}

// The sum is exact in a double, and so is its share.
template <int kShift>
HWY_INLINE Ints mean_light(const SampleColors& colors, std::size_t count, std::size_t k) {
  Doubles sum = 0.0;
  for (std::size_t s = 0; s < count; ++s) {
    sum = sum + widened(decode(Transfer::kSrgb, byte_at<kShift>(load(colors.at(s) + k))));
  }
  return encode_srgb(rounded(sum * (1.0 / double(count))));
}

// Of the samples of pixels k .. k + kLanes - 1. Equal colours have themselves as mean.
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
