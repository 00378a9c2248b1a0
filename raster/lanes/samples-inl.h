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

// Stored colours of a quad's samples.
struct SampleColors {
  std::int32_t* at(std::size_t sample) { return colors + sample * kQuadPixels; }
  const std::int32_t* at(std::size_t sample) const { return colors + sample * kQuadPixels; }

  HWY_ALIGN std::int32_t colors[std::size_t(kMostSamples) * kQuadPixels];
};

template <int kShift>
HWY_INLINE Ints byte_at(Ints color) {
  return shifted_right<kShift>(color) & 255;
}

// (2 sum + count) / (2 count), of a power of two.
template <int kShift>
HWY_INLINE Ints mean_byte(const SampleColors& colors, std::size_t count, std::size_t k) {
  Ints sum = 0;
  for (std::size_t s = 0; s < count; ++s) sum = sum + byte_at<kShift>(load(colors.at(s) + k));
  return shifted_right(sum + sum + std::int32_t(count), int(std::bit_width(unsigned(count))));
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
  const bool is_light = transfer == Transfer::kSrgb;
  const Ints r = is_light ? mean_light<0>(colors, count, k) : mean_byte<0>(colors, count, k);
  const Ints g = is_light ? mean_light<8>(colors, count, k) : mean_byte<8>(colors, count, k);
  const Ints b = is_light ? mean_light<16>(colors, count, k) : mean_byte<16>(colors, count, k);
  return r | shifted_left<8>(g) | shifted_left<16>(b) |
         shifted_left<24>(mean_byte<24>(colors, count, k));
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
