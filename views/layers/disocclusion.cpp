#include "views/layers/disocclusion.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace glassbox::views {

namespace {

// The depth that a depth code stores.
float depth_of_code(DepthFormat format, std::uint32_t code) {
  constexpr std::uint32_t kOne = std::bit_cast<std::uint32_t>(1.0f);
  switch (format) {
    case DepthFormat::kFloat32:
      return std::bit_cast<float>(code);
    case DepthFormat::kFloat32Reversed:
      return std::bit_cast<float>(kOne - code);
    case DepthFormat::kUnorm24:
    case DepthFormat::kUnorm16:
      break;
  }
  return float(code / unorm_depth_steps(format));
}

// px of parallax: a surface whose parallax differs by at least this much is a different surface.
// Smaller differences are also found between two samples of one surface.
constexpr float kOtherSurface = 1;

// Finds for each pixel in a row of the second picture the column of the first picture that it comes
// from, and the pixels where a deeper surface may be visible. These are the holes, and the pixels
// that come from farther left than some pixel to their left: its surface has passed in front of
// theirs. Returns whether there is any such pixel.
bool find_uncovered_columns(const EyeShift& shift, int width, const EyeTarget& to,
                            DisocclusionBuffers& buffers) {
  buffers.from.resize(std::size_t(width));
  buffers.next.resize(std::size_t(width) + 1);
  float most = -1;
  bool any = false;
  for (int q = 0; q < width; ++q) {
    const std::uint32_t near = to.nearness[q];
    const float nearness = near == 0 ? 0 : std::bit_cast<float>(near - 1);
    const float from = near == 0 ? -1 : float(q) + 0.5f + shift.by_nearness * nearness;
    buffers.from[std::size_t(q)] = from;
    const bool opens = near == 0 || from < most - kOtherSurface;
    buffers.next[std::size_t(q)] = opens ? q : -1;
    any = any || opens;
    most = std::max(most, from);
  }
  int after = width;
  buffers.next[std::size_t(width)] = width;
  for (int q = width; q-- > 0;) {
    if (buffers.next[std::size_t(q)] < 0) {
      buffers.next[std::size_t(q)] = after;
    } else {
      after = q;
    }
  }
  return any;
}

}  // namespace

bool find_disocclusions(const EyeShift& shift, const std::uint32_t* last, int width,
                        const EyeTarget& to, DisocclusionBuffers& buffers, std::uint32_t* behind) {
  std::fill(behind, behind + width, kEmptyDepth);
  if (!find_uncovered_columns(shift, width, to, buffers)) return false;
  bool any = false;
  for (int x = 0; x < width; ++x) {
    if (last[x] == kEmptyDepth) continue;
    const float nearness = shift.offset + shift.slope * depth_of_code(shift.format, last[x]);
    const float infinity = float(x) + 0.5f + shift.at_infinity;
    const float least = infinity - shift.by_nearness * nearness + kOtherSurface;
    const float end = std::min(infinity, float(width));
    if (!(least < end)) continue;
    int q = buffers.next[std::size_t(std::max(least, 0.0f))];
    while (float(q) < end && buffers.from[std::size_t(q)] >= infinity - kOtherSurface)
      q = buffers.next[std::size_t(q) + 1];
    if (!(float(q) < end)) continue;
    // Begins one pixel to the left of pixel q, because the pixel between two samples is a mixture
    // of both.
    const float place = std::max(least, float(q) - 1);
    const float limit = (infinity - place) / shift.by_nearness;
    behind[x] = depth_code(shift.format, (limit - shift.offset) / shift.slope);
    any = true;
  }
  return any;
}

}  // namespace glassbox::views
