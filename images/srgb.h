// Converts between stored bytes and light, either by the sRGB transfer function (IEC 61966-2-1),
// with exact tables, or as plain bytes, byte / 255.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include <glassbox/images/srgb_table.h>

namespace glassbox {

// The linear light of an sRGB byte: the float nearest to the true value, in [0, 1].
inline float decode_srgb(std::uint8_t byte) {
  return kLinearOfSrgb[byte];
}

namespace srgb_detail {

// Floats are sorted into buckets by their exponent and the first 7 bits of their mantissa. No
// bucket contains more than one threshold between two codes (67 codes in the densest octave, [1/2,
// 1), spread over 128 buckets, so that there are at most 0.66 in each), so the code of a bucket's
// lowest float and one comparison give the result. Below 2^-13 the code is 0.
inline constexpr int kBucketShift = 23 - 7;
inline constexpr std::uint32_t kFirstBucket =
    std::bit_cast<std::uint32_t>(0x1p-13f) >> kBucketShift;
inline constexpr std::uint32_t kEndBucket = std::bit_cast<std::uint32_t>(1.0f) >> kBucketShift;

inline constexpr auto kCodeOfBucket = [] {
  std::array<std::uint8_t, kEndBucket - kFirstBucket> codes{};
  std::size_t code = 0;
  for (std::uint32_t bucket = kFirstBucket; bucket < kEndBucket; ++bucket) {
    const float lowest = std::bit_cast<float>(bucket << kBucketShift);
    while (code < 255 && lowest >= kSrgbThreshold[code + 1]) ++code;
    codes[bucket - kFirstBucket] = std::uint8_t(code);
  }
  return codes;
}();

}  // namespace srgb_detail

// The sRGB byte nearest to 255 times the transfer function of `linear`, exactly. Values below 0 and
// NaN give 0, values above 1 give 255.
inline std::uint8_t encode_srgb(float linear) {
  if (!(linear >= kSrgbThreshold[1])) return 0;  // also NaN
  if (linear >= kSrgbThreshold[255]) return 255;
  const std::uint32_t bucket = std::bit_cast<std::uint32_t>(linear) >> srgb_detail::kBucketShift;
  const std::uint32_t code = srgb_detail::kCodeOfBucket[bucket - srgb_detail::kFirstBucket];
  return std::uint8_t(code + (linear >= kSrgbThreshold[code + 1]));
}

// byte / 255, correctly rounded.
inline float decode_unorm8(std::uint8_t byte) {
  return float(byte) / 255.0f;
}

// floor(255 value + 1/2), exactly: 255 value has 32 bits, so the product is exact in double, and so
// is the sum wherever it could reach the next integer. Values below 0 and NaN give 0, values above
// 1 give 255.
inline std::uint8_t encode_unorm8(float value) {
  if (!(value > 0.0f)) return 0;
  if (value >= 1.0f) return 255;
  return std::uint8_t(double(value) * 255.0 + 0.5);
}

}  // namespace glassbox
