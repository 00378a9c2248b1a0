// The table of images/srgb.h with entries that lanes can gather.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <glassbox/images/srgb.h>

namespace glassbox {

inline constexpr auto kCodeOfBucket32 = [] {
  std::array<std::int32_t, srgb_detail::kCodeOfBucket.size()> codes{};
  for (std::size_t i = 0; i < codes.size(); ++i) codes[i] = srgb_detail::kCodeOfBucket[i];
  return codes;
}();

}  // namespace glassbox
