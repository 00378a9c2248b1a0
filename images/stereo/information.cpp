#include <glassbox/images/stereo/information.h>

#include <cmath>

#include <fmt/format.h>

#include <glassbox/images/stereo/eyes.h>

namespace glassbox {
namespace {

// In thousandths of a byte: exact.
int luma_of(const Rgba8& pixel) {
  return 299 * pixel.r + 587 * pixel.g + 114 * pixel.b;
}

}  // namespace

Result<StereoInformation> stereo_information(const Image<Rgba8>& left,
                                             const Image<float>& disparity,
                                             const InformationLimits& limits) {
  if (const auto checked = check_disparity(left, disparity); !checked) {
    return tl::unexpected(checked.error());
  }
  if (!(limits.gradient >= 0) || !(limits.disparity >= 0)) {
    return fail("stereo information",
                fmt::format("the limits {} and {} are not both numbers from 0 on", limits.gradient,
                            limits.disparity),
                "give bytes a pixel and pixels");
  }
  StereoInformation found;
  for (int y = 0; y < left.height; ++y) {
    for (int x = 1; x + 1 < left.width; ++x) {
      const double shift = double(disparity.at(x, y));
      if (!std::isfinite(shift)) continue;
      const int rise = luma_of(left.at(x + 1, y)) - luma_of(left.at(x - 1, y));
      const bool is_edge = std::abs(rise) > 2000 * limits.gradient;
      const bool is_displaced = std::abs(shift) > limits.disparity;
      ++found.pixels;
      found.edges += is_edge;
      found.displaced += is_displaced;
      found.score += is_edge && is_displaced;
    }
  }
  if (!left.pixels.empty()) found.share = double(found.score) / double(left.pixels.size());
  return found;
}

}  // namespace glassbox
