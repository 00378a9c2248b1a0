// The table of images/srgb.h in a form for vector look-ups: all data of a bucket (the floats with
// the same upper 16 bits) is in one entry.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include <glassbox/images/srgb.h>

namespace glassbox {

// For each bucket, the number to add to the lower half of a float's bits: the upper half of the sum
// is the float's sRGB code. It is the code of the bucket's lowest float, plus a number that makes a
// float at or above the bucket's threshold, if there is one, carry into the next code.
inline constexpr auto kSrgbCarry = [] {
  using namespace srgb_detail;
  static_assert(kBucketShift == 16);
  std::array<std::int32_t, kCodeOfBucket.size()> carries{};
  for (std::size_t i = 0; i < carries.size(); ++i) {
    const std::size_t code = kCodeOfBucket[i];
    carries[i] = std::int32_t(code << 16);
    if (code == 255) continue;
    const auto next = std::bit_cast<std::uint32_t>(kSrgbThreshold[code + 1]);
    if (next >> 16 == kFirstBucket + i) carries[i] += 0x10000 - std::int32_t(next & 0xffff);
  }
  return carries;
}();

}  // namespace glassbox
