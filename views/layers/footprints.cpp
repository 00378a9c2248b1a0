#include "views/layers/footprints.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

#include <glassbox/base/little_endian.h>

namespace glassbox::views {

namespace {

// The alpha at (dx, dy) from the splat's centre is 2^-shift. The shift is (r / radius)^2 for the
// distance r from the centre, rounded to the nearest whole number, and at most 2.
int shift_at(int dx, int dy, int radius) {
  const int squared = dx * dx + dy * dy, one = radius * radius;
  return std::min((2 * squared + one) / std::max(2 * one, 1), 2);
}

std::uint8_t blended(std::uint8_t below, std::uint8_t above, int shift) {
  const int whole = 1 << shift;
  return std::uint8_t((below * (whole - 1) + above + whole / 2) >> shift);
}

Rgba8 blended(const Rgba8& below, const Rgba8& above, int shift) {
  return {blended(below.r, above.r, shift), blended(below.g, above.g, shift),
          blended(below.b, above.b, shift), above.a};
}

}  // namespace

void paint_footprint(int x, int y, int side, SampleKey key, Rgba8 background,
                     const KeyCanvas& canvas) {
  const int radius = std::min(side, kLargestFootprint) / 2;
  const auto color = std::bit_cast<Rgba8>(std::uint32_t(key));
  for (int row = std::max(y - radius, 0); row <= std::min(y + radius, canvas.height - 1); ++row) {
    SampleKey* const pixels = canvas.keys + std::ptrdiff_t(row + 1) * canvas.stride() + 1;
    for (int at = std::max(x - radius, 0); at <= std::min(x + radius, canvas.width - 1); ++at) {
      const SampleKey before = pixels[at];
      const Rgba8 below = before == 0 ? background : std::bit_cast<Rgba8>(std::uint32_t(before));
      const int shift = shift_at(at - x, row - y, radius);
      pixels[at] = (key >> 32 << 32) | std::bit_cast<std::uint32_t>(blended(below, color, shift));
    }
  }
}

}  // namespace glassbox::views
